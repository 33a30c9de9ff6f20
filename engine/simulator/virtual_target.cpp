#include "engine/simulator/virtual_target.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/optics/camera_model.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/lens_blur.h"
#include "engine/simulator/printed_target.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/sensor.h"

namespace vignole {

using namespace simulator;  // the room's own parts

namespace {

constexpr double kFocusMm = 400;
constexpr double kLampWavelengthMm = 550e-6;
constexpr double kSurroundingsShare = 0.4;              // of what black print reflects: the room behind the board
constexpr double kLampWithLaser = 0.12;                 // the lamp is dimmed so that the line stands out
constexpr int kSubPixels = 4;                           // a side, where a border crosses the pixel
constexpr double kUsualSheetSigmaMm = 0.35;             // where the calibration does not know it
constexpr std::array<double, 2> kBrightest{0.8, -0.6};  // where the lamp stands: a unit vector in the picture

/// The target's plane as a camera sees it: pixel -> place on the target, distance of that place along the optical axis.
class TargetPlane {
 public:
  TargetPlane(const RangeFinderCalibration& finder, const Extrinsics& cameraFromTarget)
      : lens_(lens(finder.intrinsics)) {
    const Eigen::Matrix3d back = cameraFromTarget.rotation.transpose();
    const Point3 centre = -(back * cameraFromTarget.translationMm);
    // Ray (u, v, f): place = centre + s * back * ray, s = -centre_z / (back * ray)_z.
    Eigen::Matrix3d rays = back;
    rays.col(2) *= lens_.focalMm;
    depth_ = rays.row(2) / (-centre.z());  // 1/s
    placeX_ = centre.x() * depth_ + rays.row(0);
    placeY_ = centre.y() * depth_ + rays.row(1);
    // Distance from the light plane, which the rig knows in the world.
    const Extrinsics& pose = finder.cameraFromWorld;
    const Point3 normal = pose.rotation * finder.lightPlane.normal;
    offset_ = finder.lightPlane.distanceMm + normal.dot(pose.translationMm);
    plane_ = Point3(normal.x(), normal.y(), normal.z() * lens_.focalMm);
  }
  struct Place {
    Point2 onTarget{0, 0};
    double perFocal = 0;  ///< focal length / distance along the optical axis
    double fromLightMm = 0;
  };
  [[nodiscard]] Place at(double column, double row) const {
    const Eigen::Vector2d u = undistortedFromPixel(lens_, Vector2T<double>(column, row));
    const Point3 ray(u.x(), u.y(), 1);
    const double inverse = depth_.dot(ray);
    return {Point2(placeX_.dot(ray), placeY_.dot(ray)) / inverse, inverse, plane_.dot(ray) / inverse - offset_};
  }
  [[nodiscard]] const Lens<double>& camera() const { return lens_; }

 private:
  Lens<double> lens_;
  Eigen::RowVector3d depth_, placeX_, placeY_;
  Point3 plane_;
  double offset_ = 0;
};

/// One row of pixels' corners, mapped.
using Corners = std::vector<TargetPlane::Place>;

void mapCorners(const TargetPlane& plane, int row, Corners& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = plane.at(static_cast<double>(i) - 0.5, row - 0.5);
}

}  // namespace

struct VirtualTarget::Impl {
  VirtualTargetSettings settings;
  PrintedTarget printed;
  Sensor plain, speckled;
  mutable ScratchPool<Canvas> canvases;

  explicit Impl(VirtualTargetSettings s);
  [[nodiscard]] double blurVariance(double distanceMm) const;
  void paint(const TargetPlane& plane, bool laser, Canvas& canvas, std::vector<float>& variance) const;
};

namespace {

Effects noiseOf(const VirtualTargetSettings& s, double speckle) {
  Effects effects;
  effects.readNoiseDn = s.readNoiseDn;
  effects.shotNoise = s.shotNoise;
  effects.speckle = speckle;
  effects.ambientDn = 0;
  return effects;
}

}  // namespace

VirtualTarget::Impl::Impl(VirtualTargetSettings s)
    : settings(std::move(s)),
      printed(settings.target, settings.targetErrorMm, settings.mirrored, settings.seed),
      plain(settings.seed, noiseOf(settings, 0), settings.camera.intrinsics.widthPx,
            settings.camera.intrinsics.heightPx),
      speckled(settings.seed, noiseOf(settings, settings.speckle), settings.camera.intrinsics.widthPx,
               settings.camera.intrinsics.heightPx) {}

/// Of lens and diffraction, px^2; the pixel's own is in the areas.
double VirtualTarget::Impl::blurVariance(double distanceMm) const {
  const Intrinsics& in = settings.camera.intrinsics;
  const double aperture = in.focalMm / kFNumber;
  const double disk = settings.defocus * aperture * in.focalMm / (kFocusMm - in.focalMm) *
                      std::abs(distanceMm - kFocusMm) / distanceMm / in.pixelWidthMm;
  const double diffraction = 0.45 * kLampWavelengthMm * kFNumber / in.pixelWidthMm;
  return disk * disk / 16 + diffraction * diffraction;
}

/// Light of every pixel before blur and noise, and the blur there.
void VirtualTarget::Impl::paint(const TargetPlane& plane, bool laser, Canvas& canvas,
                                std::vector<float>& variance) const {
  const Intrinsics& in = settings.camera.intrinsics;
  const double lamp = laser ? kLampWithLaser : 1;
  const double sheet =
      settings.camera.lightPlane.thicknessMm > 0 ? settings.camera.lightPlane.thicknessMm : kUsualSheetSigmaMm;
  const double blackShare = settings.darkDn / settings.brightDn;
  Corners above(static_cast<std::size_t>(in.widthPx) + 1), below = above;
  mapCorners(plane, 0, above);
  for (int y = 0; y < in.heightPx; ++y) {
    mapCorners(plane, y + 1, below);
    float* row = canvas.row(y);
    for (int x = 0; x < in.widthPx; ++x) {
      const auto i = static_cast<std::size_t>(x);
      const TargetPlane::Place &p00 = above[i], &p10 = above[i + 1], &p01 = below[i], &p11 = below[i + 1];
      const Point2 middle = (p00.onTarget + p10.onTarget + p01.onTarget + p11.onTarget) / 4;
      const Footprint pixel{(p10.onTarget + p11.onTarget - p00.onTarget - p01.onTarget) / 2,
                            (p01.onTarget + p11.onTarget - p00.onTarget - p10.onTarget) / 2};
      PrintedShares shares;
      const double reach = (pixel.a.norm() + pixel.b.norm()) / 2;
      const bool before = p00.perFocal > 0 && p11.perFocal > 0 && p01.perFocal > 0 && p10.perFocal > 0;
      if (!before) {
        // Beyond the plane's horizon: nothing of the board is there.
      } else if (printed.clearanceMm(middle) > reach) {
        shares = printed.shares(middle, pixel);
      } else {
        const Footprint part{pixel.a / kSubPixels, pixel.b / kSubPixels};
        for (int v = 0; v < kSubPixels; ++v)
          for (int u = 0; u < kSubPixels; ++u) {
            const double s = (u + 0.5) / kSubPixels, t = (v + 0.5) / kSubPixels;
            const Point2 at =
                (1 - t) * ((1 - s) * p00.onTarget + s * p10.onTarget) + t * ((1 - s) * p01.onTarget + s * p11.onTarget);
            const PrintedShares one = printed.shares(at, part);
            shares.white += one.white / (kSubPixels * kSubPixels);
            shares.black += one.black / (kSubPixels * kSubPixels);
          }
      }
      const double inverse = (p00.perFocal + p11.perFocal) / 2;
      const double side =
          kBrightest[0] * ((x + 0.5) / in.widthPx - 0.5) + kBrightest[1] * ((y + 0.5) / in.heightPx - 0.5);
      double light = lamp * settings.brightDn * (1 + settings.gradient * side);
      const double reflectance = shares.white + blackShare * shares.black;
      double dn = light * (reflectance + blackShare * kSurroundingsShare * (1 - shares.white - shares.black));
      if (laser && before) {
        // The sheet's own thickness and the pixel's extent across it.
        const double far = (p00.fromLightMm + p10.fromLightMm + p01.fromLightMm + p11.fromLightMm) / 4;
        const double dx = (p10.fromLightMm - p00.fromLightMm), dy = (p01.fromLightMm - p00.fromLightMm);
        const double spread = sheet * sheet + (dx * dx + dy * dy) / 12;
        dn += settings.laserDn * sheet / std::sqrt(spread) * std::exp(-far * far / (2 * spread)) * reflectance;
      }
      row[x] = static_cast<float>(dn);
      variance[static_cast<std::size_t>(y) * static_cast<std::size_t>(in.widthPx) + i] =
          static_cast<float>(before ? blurVariance(plane.camera().focalMm / inverse) : 0);
    }
    std::swap(above, below);
  }
}

Expected<std::shared_ptr<const VirtualTarget>> VirtualTarget::create(VirtualTargetSettings settings) {
  const auto between = [](double value, double min, double max) { return value >= min && value <= max; };
  const VirtualTargetSettings& s = settings;
  if (s.target.columns < 2 || s.target.rows < 2 || !(s.target.pitchMm > 0))
    return inputError("target", "has no points; give it columns, rows and a distance");
  if (!between(s.targetErrorMm, 0, s.target.pitchMm / 10))
    return inputError("target-error-um", "must lie between 0 and a tenth of the points' distance");
  if (!between(s.readNoiseDn, 0, 50)) return inputError("read-noise", "must lie between 0 and 50 DN");
  if (!between(s.shotNoise, 0, 100)) return inputError("shot-noise", "must lie between 0 and 100");
  if (!between(s.defocus, 0, 5)) return inputError("defocus", "must lie between 0 and 5");
  if (!between(s.speckle, 0, 1)) return inputError("speckle", "must lie between 0 and 1");
  if (!(s.darkDn >= 0 && s.brightDn > s.darkDn && s.brightDn <= 1e4))
    return inputError("light", "bright must be brighter than dark");
  return std::shared_ptr<const VirtualTarget>(new VirtualTarget(std::make_unique<Impl>(std::move(settings))));
}

VirtualTarget::VirtualTarget(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VirtualTarget::~VirtualTarget() = default;

const VirtualTargetSettings& VirtualTarget::settings() const { return impl_->settings; }

void VirtualTarget::render(const Extrinsics& cameraFromTarget, int view, bool laser,
                           const MutableImageView& image) const {
  const VirtualTargetSettings& s = impl_->settings;
  const Intrinsics& in = s.camera.intrinsics;
  ScratchPool<Canvas>::Lease lease(impl_->canvases, in.widthPx, in.heightPx);
  Canvas& canvas = *lease;
  std::vector<float> variance(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
  impl_->paint(TargetPlane(s.camera, cameraFromTarget), laser, canvas, variance);
  blur(canvas, variance);
  std::fill(canvas.touched.begin(), canvas.touched.end(), std::uint8_t{1});
  const Exposure exposure{hash(s.seed, Stream::View, {s.noiseKey, static_cast<std::uint64_t>(view), laser ? 1U : 0U}),
                          false, 1};
  (laser ? impl_->speckled : impl_->plain).expose(exposure, canvas, image);
}

std::vector<Point2> VirtualTarget::truePixels(const Extrinsics& cameraFromTarget) const {
  const Lens<double> camera = lens(impl_->settings.camera.intrinsics);
  std::vector<Point2> pixels;
  for (const Point2& point : impl_->printed.points())
    pixels.emplace_back(project<double>(camera, cameraFromTarget.rotation, cameraFromTarget.translationMm,
                                        Point3(point.x(), point.y(), 0)));
  return pixels;
}

namespace {

/// A pose by where the board's middle is seen, how far it is, how it is tilted (about an axis in the picture) and
/// turned.
struct Stance {
  Point2 px{0, 0};
  double distanceMm = 0, tiltRad = 0, tiltAxisRad = 0, rollRad = 0;
};

Extrinsics poseOf(const Stance& stance, const Intrinsics& in, const Point2& middle) {
  const Eigen::Vector2d u = undistortedFromPixel(lens(in), Vector2T<double>(stance.px));
  const Point3 axis(std::cos(stance.tiltAxisRad), std::sin(stance.tiltAxisRad), 0);
  Extrinsics pose;
  pose.rotation =
      (Eigen::AngleAxisd(stance.tiltRad, axis) * Eigen::AngleAxisd(stance.rollRad, Point3::UnitZ())).toRotationMatrix();
  pose.translationMm = stance.distanceMm / in.focalMm * Point3(u.x(), u.y(), in.focalMm) -
                       pose.rotation * Point3(middle.x(), middle.y(), 0);
  return pose;
}

/// Whether every point, and what belongs to it, is in the picture.
bool fits(const PlanarTarget& target, const Intrinsics& in, const Extrinsics& pose) {
  constexpr double kEdgePx = 6;
  const TargetRectangle printed = [&] {
    TargetRectangle r = board(target);
    const double margin = target.pattern == TargetPattern::Chessboard ? target.pitchMm : target.pitchMm / 8;
    r.min += Point2(margin, margin);
    r.max -= Point2(margin, margin);
    return r;
  }();
  const Lens<double> camera = lens(in);
  for (const double x : {printed.min.x(), printed.max.x()})
    for (const double y : {printed.min.y(), printed.max.y()}) {
      const Point3 point = pose.rotation * Point3(x, y, 0) + pose.translationMm;
      if (!(point.z() > 0)) return false;
      const Eigen::Vector2d px = projectFromCamera<double>(camera, point);
      if (!(px.x() >= kEdgePx && px.y() >= kEdgePx && px.x() <= in.widthPx - 1 - kEdgePx &&
            px.y() <= in.heightPx - 1 - kEdgePx))
        return false;
    }
  return true;
}

}  // namespace

std::vector<Extrinsics> usualViews(const PlanarTarget& target, const Intrinsics& in, int count, std::uint64_t seed) {
  constexpr double kDegree = std::numbers::pi / 180;
  constexpr double kNearestMm = 350, kFarthestMm = 450, kTooFarMm = 4000;
  // Where the board goes, from the middle of the picture (-1 .. 1): over its corners, edges and middle.
  constexpr std::array<std::array<double, 2>, 9> kPlaces = {
      {{0, 0}, {-1, -1}, {1, 1}, {1, -1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  constexpr int kBeyondEvery = 8;   // of so many views one shows the board partly outside
  constexpr double kBeyond = 1.15;  // so much farther out than it fits
  const TargetRectangle whole = board(target);
  const Point2 middle = (whole.min + whole.max) / 2;
  const Point2 centre((in.widthPx - 1) / 2.0, (in.heightPx - 1) / 2.0);
  std::vector<Extrinsics> views;
  for (int i = 0; i < count; ++i) {
    Draws draws(seed, Stream::View, {static_cast<std::uint64_t>(i)});
    const auto& place = kPlaces[static_cast<std::size_t>(i) % kPlaces.size()];
    Stance stance;
    stance.distanceMm = draws.uniform(kNearestMm, kFarthestMm);
    stance.tiltRad = (i == 0 ? draws.uniform(0, 5) : draws.uniform(15, 35)) * kDegree;
    stance.tiltAxisRad = 2.4 * i + draws.uniform(-0.3, 0.3);  // the golden angle: to all sides
    stance.rollRad = draws.uniform(-15, 15) * kDegree + (i % 4 == 3 ? std::numbers::pi / 2 : 0);
    const auto poseAt = [&](double share) {
      Stance there = stance;
      there.px = centre + share * Point2(place[0] * centre.x(), place[1] * centre.y());
      return poseOf(there, in, middle);
    };
    while (!fits(target, in, poseAt(0)) && stance.distanceMm < kTooFarMm) stance.distanceMm *= 1.02;
    double low = 0, high = 1;
    for (int step = 0; step < 20; ++step) {
      const double share = (low + high) / 2;
      (fits(target, in, poseAt(share)) ? low : high) = share;
    }
    const bool beyond = i % kBeyondEvery == kBeyondEvery - 1;
    views.push_back(poseAt(beyond ? kBeyond * low : draws.uniform(0.75, 1) * low));
  }
  return views;
}

}  // namespace vignole
