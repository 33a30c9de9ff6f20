#include "engine/simulator/virtual_target.h"

#include <algorithm>
#include <cmath>

#include "engine/optics/camera_model.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/lens_blur.h"
#include "engine/simulator/printed_target.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/sensor.h"
#include "engine/simulator/target_plane.h"

namespace vignole {

using namespace simulator;  // the room's own parts

namespace {

constexpr double kFocusMm = 400;
constexpr double kLampWavelengthMm = 550e-6;
constexpr double kRoomShare = 0.4;           // of what black print reflects: the room behind the board
constexpr double kLampWithLaser = 0.12;      // the lamp is dimmed so that the line stands out
constexpr int kSubPixels = 4;                // a side, where a border crosses the pixel
constexpr double kMostBlurPx2 = 25;          // what is nearer than that is a blot anyway
constexpr double kUsualSheetSigmaMm = 0.35;  // where the calibration does not know it
const Point2 kLampSide(0.8, -0.6);           // of the picture: right, above

/// One row of pixels' corners, mapped.
using Corners = std::vector<TargetPlane::Place>;

void mapCorners(const TargetPlane& plane, int row, Corners& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = plane.at(static_cast<double>(i) - 0.5, row - 0.5);
}

/// A pixel on the target, by its corners.
struct PixelOnTarget {
  const TargetPlane::Place &p00, &p10, &p01, &p11;

  PixelOnTarget(const Corners& above, const Corners& below, std::size_t x)
      : p00(above[x]), p10(above[x + 1]), p01(below[x]), p11(below[x + 1]) {}
  [[nodiscard]] bool isBefore() const {
    return p00.perFocal > 0 && p10.perFocal > 0 && p01.perFocal > 0 && p11.perFocal > 0;
  }
  [[nodiscard]] Point2 middle() const { return (p00.onTarget + p10.onTarget + p01.onTarget + p11.onTarget) / 4; }
  [[nodiscard]] Footprint footprint() const {
    return {(p10.onTarget + p11.onTarget - p00.onTarget - p01.onTarget) / 2,
            (p01.onTarget + p11.onTarget - p00.onTarget - p10.onTarget) / 2};
  }
  /// Place within the pixel, both from 0 to 1.
  [[nodiscard]] Point2 at(double s, double t) const {
    return (1 - t) * ((1 - s) * p00.onTarget + s * p10.onTarget) + t * ((1 - s) * p01.onTarget + s * p11.onTarget);
  }
};

PrintedShares sharesAcrossBorder(const PrintedTarget& printed, const PixelOnTarget& pixel, const Footprint& footprint) {
  const Footprint part{footprint.a / kSubPixels, footprint.b / kSubPixels};
  PrintedShares shares;
  for (int v = 0; v < kSubPixels; ++v)
    for (int u = 0; u < kSubPixels; ++u) {
      const PrintedShares one = printed.shares(pixel.at((u + 0.5) / kSubPixels, (v + 0.5) / kSubPixels), part);
      shares.white += one.white / (kSubPixels * kSubPixels);
      shares.black += one.black / (kSubPixels * kSubPixels);
    }
  return shares;
}

/// What the pixels of one row show of the target.
void rowOfShares(const PrintedTarget& printed, const Corners& above, const Corners& below,
                 std::vector<PrintedShares>& row) {
  constexpr double kLongestRunPx = 32;  // the scale changes by little over it
  constexpr double kSafe = 0.9;
  for (std::size_t x = 0; x < row.size();) {
    const PixelOnTarget pixel(above, below, x);
    if (!pixel.isBefore()) {  // beyond the plane's horizon
      row[x++] = {};
      continue;
    }
    const Footprint footprint = pixel.footprint();
    const double step = footprint.a.norm(), reach = (step + footprint.b.norm()) / 2;
    const double clear = printed.clearanceMm(pixel.middle()) - reach;
    if (clear <= 0) {
      row[x++] = sharesAcrossBorder(printed, pixel, footprint);
      continue;
    }
    // The same as far as no border can be.
    const PrintedShares shares = printed.shares(pixel.middle(), footprint);
    const auto run = static_cast<std::size_t>(std::min(kLongestRunPx, kSafe * clear / step));
    for (const std::size_t end = std::min(row.size(), x + run + 1); x < end; ++x) row[x] = shares;
  }
}

}  // namespace

struct VirtualTarget::Impl {
  VirtualTargetSettings settings;
  PrintedTarget printed;
  Sensor plain, speckled;
  mutable ScratchPool<Canvas> canvases;

  explicit Impl(VirtualTargetSettings s);
  [[nodiscard]] double blurVariance(double perMm) const;
  [[nodiscard]] double laserDn(const PixelOnTarget& pixel) const;
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

/// Of lens and diffraction, px^2 (the pixel's own is in the areas), at 1 / distance along the optical axis.
double VirtualTarget::Impl::blurVariance(double perMm) const {
  const Intrinsics& in = settings.camera.intrinsics;
  const double aperture = in.focalMm / kFNumber;
  const double disk =
      settings.defocus * aperture * in.focalMm / ((kFocusMm - in.focalMm) * in.pixelWidthMm) * (1 - kFocusMm * perMm);
  const double diffraction = 0.45 * kLampWavelengthMm * kFNumber / in.pixelWidthMm;
  return disk * disk / 16 + diffraction * diffraction;
}

/// Of the laser on white: the sheet's thickness, and the pixel's extent across it.
double VirtualTarget::Impl::laserDn(const PixelOnTarget& pixel) const {
  const double known = settings.camera.lightPlane.thicknessMm, sheet = known > 0 ? known : kUsualSheetSigmaMm;
  const auto &p00 = pixel.p00, &p10 = pixel.p10, &p01 = pixel.p01, &p11 = pixel.p11;
  const double far = (p00.fromLightMm + p10.fromLightMm + p01.fromLightMm + p11.fromLightMm) / 4;
  const double dx = p10.fromLightMm - p00.fromLightMm, dy = p01.fromLightMm - p00.fromLightMm;
  const double spread = sheet * sheet + (dx * dx + dy * dy) / 12;
  return settings.laserDn * sheet / std::sqrt(spread) * std::exp(-far * far / (2 * spread));
}

/// Light of every pixel before blur and noise, and the variance of the blur there.
void VirtualTarget::Impl::paint(const TargetPlane& plane, bool laser, Canvas& canvas,
                                std::vector<float>& variance) const {
  const Intrinsics& in = settings.camera.intrinsics;
  const double black = settings.darkDn / settings.brightDn, room = kRoomShare * black;
  const auto columns = static_cast<std::size_t>(in.widthPx);
  Corners above(columns + 1), below(columns + 1);
  std::vector<PrintedShares> shares(columns);
  mapCorners(plane, 0, above);
  float* blur = variance.data();
  for (int y = 0; y < in.heightPx; ++y, blur += columns) {
    mapCorners(plane, y + 1, below);
    rowOfShares(printed, above, below, shares);
    float* row = canvas.row(y);
    for (std::size_t x = 0; x < columns; ++x) {
      const PixelOnTarget pixel(above, below, x);
      const double side = kLampSide.x() * ((static_cast<double>(x) + 0.5) / in.widthPx - 0.5) +
                          kLampSide.y() * ((y + 0.5) / in.heightPx - 0.5);
      const double lamp = settings.brightDn * (laser ? kLampWithLaser : 1) * (1 + settings.gradient * side);
      const double reflected = shares[x].white + black * shares[x].black;
      double dn = lamp * (reflected + room * (1 - shares[x].white - shares[x].black));
      if (laser && reflected > 0) dn += laserDn(pixel) * reflected;
      row[x] = static_cast<float>(dn);
      const double perFocal = (pixel.p00.perFocal + pixel.p11.perFocal) / 2;
      blur[x] = perFocal > 0 ? static_cast<float>(std::min(kMostBlurPx2, blurVariance(perFocal / in.focalMm))) : 0.0F;
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

}  // namespace vignole
