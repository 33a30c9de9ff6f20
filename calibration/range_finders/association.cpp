#include "calibration/range_finders/association.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "calibration/range_finders/picture_match.h"
#include "calibration/range_finders/pin_homography.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
// How far a camera may stand from where it is drawn: what counts as one unit of doubt.
constexpr double kDoubtRad = 2 * kDegree, kDoubtMm = 10;
// A camera further off does not look at the plate that the others see.
constexpr double kImpossibleRad = 20 * kDegree, kImpossibleMm = 150;
// Another order of the cameras must explain their poses by so much better, in units of doubt squared a camera.
constexpr double kClearer = 4;

using Order = std::array<int, kCameraCount>;

Point2 middleOf(const PinPlate& plate) {
  Point2 middle(0, 0);
  for (const Pin& pin : plate.pins) middle += pin.centreMm / static_cast<double>(plate.pins.size());
  return middle;
}

/// How far a pose is from another.
struct Deviation {
  double rad = 0, mm = 0;
  [[nodiscard]] double doubt() const { return std::pow(rad / kDoubtRad, 2) + std::pow(mm / kDoubtMm, 2); }
};

/// The pictures of one placement.
class Placement {
 public:
  Placement(RigInputs& inputs, PlacementLines& lines, const AssociationSettings& settings)
      : inputs_(inputs), lines_(lines), settings_(settings), middle_(middleOf(inputs.plate)) {}
  void associate();

 private:
  [[nodiscard]] PinPicture& picture(int camera) { return lines_.pictures[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] const Intrinsics& intrinsics(int camera) const {
    return inputs_.cameras[static_cast<std::size_t>(camera)].intrinsics;
  }
  [[nodiscard]] const Extrinsics& drawing(int camera) const {
    return settings_.drawing.rangeFinders[static_cast<std::size_t>(camera)].cameraFromWorld;
  }
  [[nodiscard]] PictureMatch& match(int camera) { return matches_[static_cast<std::size_t>(camera)]; }
  void matchAll();
  /// Where the plate stands if the picture of `camera` was taken from where `standingAs` is drawn.
  [[nodiscard]] Transform2 plateBy(int camera, int standingAs) const;
  [[nodiscard]] Deviation deviation(int camera, int standingAs, const Transform2& worldFromPlate) const;
  /// The plate's place that leaves the least doubt of all cameras, and that doubt.
  [[nodiscard]] std::pair<Transform2, double> bestPlate(const Order& order) const;
  bool refuseIfSwapped();
  void refuseOddOnes();
  bool refuseIfMirrored();
  void withoutDrawing();
  void refuseUnmatched(int camera);

  RigInputs& inputs_;
  PlacementLines& lines_;
  const AssociationSettings& settings_;
  Point2 middle_;
  std::array<PictureMatch, kCameraCount> matches_;
  std::vector<int> matched_;
};

void Placement::matchAll() {
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable()) continue;
    match(c) = matchPicture(picture(c), intrinsics(c), drawing(c), inputs_.plate, settings_);
    // A camera at another's place may see what does not look like the plate from its own.
    for (int other = 0; !match(c).found && other < kCameraCount; ++other) {
      if (other == c) continue;
      PictureMatch there = matchPicture(picture(c), intrinsics(c), drawing(other), inputs_.plate, settings_);
      if (there.found) match(c) = there;
    }
    if (match(c).found) matched_.push_back(c);
  }
}

Transform2 Placement::plateBy(int camera, int standingAs) const {
  const Extrinsics &pose = matches_[static_cast<std::size_t>(camera)].cameraFromPlate, &drawn = drawing(standingAs);
  const Eigen::Matrix3d turn = drawn.rotation.transpose() * pose.rotation;
  const Eigen::Vector3d middle(middle_.x(), middle_.y(), 0);
  const Eigen::Vector3d at = drawn.rotation.transpose() * (pose.rotation * middle + pose.translationMm -
                                                           drawn.translationMm);
  Transform2 plate{0, 0, std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1))};
  const Point2 shift = Point2(at.head<2>()) - plate.rotate(middle_);
  plate.xMm = shift.x();
  plate.yMm = shift.y();
  return plate;
}

Deviation Placement::deviation(int camera, int standingAs, const Transform2& worldFromPlate) const {
  const Extrinsics &pose = matches_[static_cast<std::size_t>(camera)].cameraFromPlate, &drawn = drawing(standingAs);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(worldFromPlate.angleRad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d shift(worldFromPlate.xMm, worldFromPlate.yMm, 0);
  const Eigen::Matrix3d rotation = pose.rotation * turn.transpose();  // cameraFromWorld
  const Eigen::Vector3d centre = turn * cameraCentre(pose) + shift;
  return {std::abs(Eigen::AngleAxisd(rotation * drawn.rotation.transpose()).angle()),
          (centre - cameraCentre(drawn)).norm()};
}

std::pair<Transform2, double> Placement::bestPlate(const Order& order) const {
  std::pair<Transform2, double> best{{}, 1e300};
  for (const int by : matched_) {
    const Transform2 plate = plateBy(by, order[static_cast<std::size_t>(by)]);
    double doubt = 0;
    for (const int c : matched_) doubt += deviation(c, order[static_cast<std::size_t>(c)], plate).doubt();
    if (doubt < best.second) best = {plate, doubt};
  }
  return best;
}

/// Cameras that look at each other's pictures: another order puts all of them about where they are drawn.
bool Placement::refuseIfSwapped() {
  if (matched_.size() < 2) return false;
  Order own{};
  std::iota(own.begin(), own.end(), 0);
  const double asIs = bestPlate(own).second;
  Order order = own, best = own;
  double least = asIs - kClearer * static_cast<double>(matched_.size());
  while (std::next_permutation(order.begin(), order.end()))
    if (const double there = bestPlate(order).second; there < least) {
      least = there;
      best = order;
    }
  if (best == own) return false;
  for (const int c : matched_) {
    const int stands = best[static_cast<std::size_t>(c)];
    if (stands == c) continue;
    picture(c).refusal = "refused, because the cameras look swapped: the picture of camera " + std::to_string(c + 1) +
                         " fits where camera " + std::to_string(stands + 1) +
                         " stands; put the cables or the files in order";
  }
  return true;
}

/// One that sees the plate where it cannot be for the others.
void Placement::refuseOddOnes() {
  Order own{};
  std::iota(own.begin(), own.end(), 0);
  const auto impossible = [&](int c, const Transform2& plate) {
    const Deviation d = deviation(c, c, plate);
    return d.rad > kImpossibleRad || d.mm > kImpossibleMm;
  };
  // The place of the plate that most cameras can live with.
  std::ptrdiff_t fewest = kCameraCount + 1;
  Transform2 plate;
  for (const int by : matched_) {
    const Transform2 there = plateBy(by, by);
    const auto odd = std::count_if(matched_.begin(), matched_.end(), [&](int c) { return impossible(c, there); });
    if (odd < fewest) {
      fewest = odd;
      plate = there;
    }
  }
  for (const int c : matched_)
    if (impossible(c, plate))
      picture(c).refusal = "refused, because camera " + std::to_string(c + 1) +
                           " sees the plate turned or shifted against the other cameras; check that all pictures are "
                           "of one placement and that the camera stands as drawn";
}

bool Placement::refuseIfMirrored() {
  PinPlate mirrored = inputs_.plate;
  for (Pin& pin : mirrored.pins) pin.centreMm.x() = -pin.centreMm.x();
  int tried = 0, fitting = 0;
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable() || match(c).found) continue;
    ++tried;
    if (matchPicture(picture(c), intrinsics(c), drawing(c), mirrored, settings_).found) ++fitting;
  }
  if (fitting == 0 || 2 * fitting < tried) return false;
  for (int c = 0; c < kCameraCount; ++c)
    if (picture(c).usable() && !match(c).found)
      picture(c).refusal =
          "refused, because the plate is the mirror image of its file; turn the plate over or take the minus off its "
          "x_mm";
  return true;
}

void Placement::withoutDrawing() {
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable()) continue;
    const auto pose = poseByHomography(picture(c), intrinsics(c), inputs_.plate, settings_);
    if (!pose) {
      picture(c).refusal = pose.error().what;
      continue;
    }
    picture(c).cameraFromPlate = *pose;
    assignArcs(picture(c), intrinsics(c), inputs_.plate);
  }
}

void Placement::refuseUnmatched(int camera) {
  PinPicture& p = picture(camera);
  const PictureMatch& m = match(camera);
  const auto saturated =
      std::count_if(p.arcs.begin(), p.arcs.end(), [](const PinArc& arc) { return arc.reason == "saturated"; });
  if (2 * saturated > static_cast<std::ptrdiff_t>(p.arcs.size())) {
    p.refusal = "refused, because most of the pins are saturated; shorten the exposure";
  } else if (m.circles < settings_.fewestPins) {
    p.refusal = "refused, because only " + std::to_string(m.circles) + " pins are seen and " +
                std::to_string(settings_.fewestPins) +
                " are needed; check the laser, the exposure and what stands in its way";
  } else if (m.ambiguous) {
    p.refusal = "refused, because the pins fit the plate's file in more than one way; use a plate without symmetry";
  } else {
    p.refusal = "refused, because the pins do not stand as the plate's file has them (" + std::to_string(m.pins) +
                " of " + std::to_string(m.circles) + " agree); give the file of this plate";
  }
}

void Placement::associate() {
  if (!settings_.useDrawing) {
    withoutDrawing();
    return;
  }
  matchAll();
  const auto usable = std::count_if(lines_.pictures.begin(), lines_.pictures.end(),
                                    [](const PinPicture& p) { return p.usable(); });
  if (static_cast<std::ptrdiff_t>(matched_.size()) < usable && refuseIfMirrored()) return;
  if (!refuseIfSwapped()) refuseOddOnes();
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable()) continue;
    if (!match(c).found) {
      refuseUnmatched(c);
      continue;
    }
    picture(c).cameraFromPlate = match(c).cameraFromPlate;
    assignArcs(picture(c), intrinsics(c), inputs_.plate);
  }
}

}  // namespace

void associate(RigInputs& inputs, const AssociationSettings& settings) {
  for (PlacementLines& placement : inputs.placements) Placement(inputs, placement, settings).associate();
}

}  // namespace vignole
