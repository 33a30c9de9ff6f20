#include "calibration/range_finders/association.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "calibration/range_finders/pin_homography.h"
#include "calibration/range_finders/picture_match.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
// What two cameras may say differently of one plate, for all that is wrong with the drawing.
constexpr double kLooseTurn = 14 * kDegree, kLooseMm = 60;
// From here on other orders of the cameras are tried; one that agrees that much better is the true one.
constexpr double kSuspiciousTurn = 4 * kDegree;
constexpr double kClearer = 2.5;

using Order = std::array<int, kCameraCount>;
using Matches = std::array<std::optional<PictureMatch>, kCameraCount>;

Point2 middleOf(const PinPlate& plate) {
  Point2 middle(0, 0);
  for (const Pin& pin : plate.pins) middle += pin.centreMm / static_cast<double>(plate.pins.size());
  return middle;
}

double between(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// The pictures of one placement.
class Placement {
 public:
  Placement(RigInputs& inputs, PlacementLines& lines, const AssociationSettings& settings)
      : inputs_(inputs), lines_(lines), settings_(settings) {}
  void associate();

 private:
  [[nodiscard]] PinPicture& picture(int camera) { return lines_.pictures[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] const Intrinsics& intrinsics(int camera) const {
    return inputs_.cameras[static_cast<std::size_t>(camera)].intrinsics;
  }
  [[nodiscard]] const Extrinsics& drawing(int camera) const {
    return settings_.drawing.rangeFinders[static_cast<std::size_t>(camera)].cameraFromWorld;
  }
  [[nodiscard]] PictureMatch match(int camera, int standingAs, const PinPlate& plate);
  /// The picture of `camera`, seen from where `standingAs` is drawn. Worked out once.
  const PictureMatch& known(int camera, int standingAs);
  /// Largest difference of turns between pictures, if all cameras stand as `order` has it; none if they contradict.
  [[nodiscard]] std::optional<double> disagreement(const Order& order);
  bool refuseIfSwapped();
  void refuseOddOnes();
  bool refuseIfMirrored();
  void withoutDrawing();
  void refuseUnmatched(int camera);

  RigInputs& inputs_;
  PlacementLines& lines_;
  const AssociationSettings& settings_;
  std::array<std::array<std::optional<PictureMatch>, kCameraCount>, kCameraCount> known_;
};

PictureMatch Placement::match(int camera, int standingAs, const PinPlate& plate) {
  const PlaneCircles circles = planeCircles(picture(camera), intrinsics(camera), drawing(standingAs), plate);
  return matchPicture(circles, intrinsics(camera), drawing(standingAs), plate, settings_);
}

const PictureMatch& Placement::known(int camera, int standingAs) {
  auto& slot = known_[static_cast<std::size_t>(camera)][static_cast<std::size_t>(standingAs)];
  if (!slot) slot = match(camera, standingAs, inputs_.plate);
  return *slot;
}

std::optional<double> Placement::disagreement(const Order& order) {
  std::vector<const PatternMatch*> answers;
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable() || !known(c, c).found) continue;
    const PictureMatch& m = known(c, order[static_cast<std::size_t>(c)]);
    if (!m.found) return {};
    answers.push_back(&m.match);
  }
  const Point2 middle = middleOf(inputs_.plate);
  double largest = 0;
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Transform2 &a = answers[i]->planeFromPlate, &b = answers[k]->planeFromPlate;
      if ((a * middle - b * middle).norm() > kLooseMm) return {};
      largest = std::max(largest, between(a.angleRad, b.angleRad));
    }
  return largest;
}

/// Cameras that look at each other's pictures: another order makes all of one mind.
bool Placement::refuseIfSwapped() {
  Order own{};
  std::iota(own.begin(), own.end(), 0);
  const std::optional<double> asIs = disagreement(own);
  if (asIs && *asIs < kSuspiciousTurn) return false;
  Order order = own, best = own;
  double least = asIs.value_or(2 * std::numbers::pi);
  const double mustBeat = asIs && *asIs < kLooseTurn ? *asIs / kClearer : kLooseTurn;
  while (std::next_permutation(order.begin(), order.end())) {
    const std::optional<double> there = disagreement(order);
    if (there && *there < least && *there < mustBeat) {
      least = *there;
      best = order;
    }
  }
  if (best == own) return false;
  for (int c = 0; c < kCameraCount; ++c) {
    const int stands = best[static_cast<std::size_t>(c)];
    if (stands == c || !picture(c).usable() || !known(c, c).found) continue;
    picture(c).refusal = "refused, because the cameras look swapped: the picture of camera " + std::to_string(c + 1) +
                         " fits where camera " + std::to_string(stands + 1) +
                         " stands; put the cables or the files in order";
  }
  return true;
}

/// One that sees the plate where the others do not.
void Placement::refuseOddOnes() {
  const Point2 middle = middleOf(inputs_.plate);
  const auto agree = [&](int a, int b) {
    const Transform2 &x = known(a, a).match.planeFromPlate, &y = known(b, b).match.planeFromPlate;
    return between(x.angleRad, y.angleRad) < kLooseTurn && (x * middle - y * middle).norm() < kLooseMm;
  };
  std::vector<int> matched;
  for (int c = 0; c < kCameraCount; ++c)
    if (picture(c).usable() && known(c, c).found) matched.push_back(c);
  const auto friends = [&](int c) {
    return std::count_if(matched.begin(), matched.end(), [&](int other) { return other != c && agree(c, other); });
  };
  std::ptrdiff_t most = 0;
  for (const int c : matched) most = std::max(most, friends(c));
  for (const int c : matched)
    if (friends(c) < most || (most == 0 && matched.size() > 1))
      picture(c).refusal = "refused, because camera " + std::to_string(c + 1) +
                           " sees the plate turned or shifted against the other cameras; check that all pictures are "
                           "of one placement and that the camera stands as drawn";
}

bool Placement::refuseIfMirrored() {
  PinPlate mirrored = inputs_.plate;
  for (Pin& pin : mirrored.pins) pin.centreMm.x() = -pin.centreMm.x();
  int tried = 0, fitting = 0;
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable() || known(c, c).found) continue;
    ++tried;
    const PictureMatch other = match(c, c, mirrored);
    if (other.found && other.match.pairs.size() > known(c, c).match.pairs.size() + 1) ++fitting;
  }
  if (fitting == 0 || 2 * fitting < tried) return false;
  for (int c = 0; c < kCameraCount; ++c)
    if (picture(c).usable() && !known(c, c).found)
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
  const PictureMatch& m = known(camera, camera);
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
    p.refusal = "refused, because the pins do not stand as the plate's file has them (" +
                std::to_string(m.match.pairs.size()) + " of " + std::to_string(m.circles) +
                " agree); give the file of this plate";
  }
}

void Placement::associate() {
  if (!settings_.useDrawing) {
    withoutDrawing();
    return;
  }
  int usable = 0, matched = 0;
  for (int c = 0; c < kCameraCount; ++c) {
    usable += picture(c).usable() ? 1 : 0;
    matched += picture(c).usable() && known(c, c).found ? 1 : 0;
  }
  if (matched < usable && refuseIfMirrored()) return;
  if (!refuseIfSwapped()) refuseOddOnes();
  for (int c = 0; c < kCameraCount; ++c) {
    if (!picture(c).usable()) continue;
    const PictureMatch& m = known(c, c);
    if (!m.found) {
      refuseUnmatched(c);
      continue;
    }
    picture(c).cameraFromPlate = m.cameraFromPlate;
    assignArcs(picture(c), intrinsics(c), inputs_.plate);
  }
}

}  // namespace

void associate(RigInputs& inputs, const AssociationSettings& settings) {
  for (PlacementLines& placement : inputs.placements) Placement(inputs, placement, settings).associate();
}

}  // namespace vignole
