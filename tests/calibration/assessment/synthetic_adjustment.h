#pragma once
// Adjustments made by hand: arcs of pins as an exact rig sees them, with noise that the line filter would leave.

#include <cmath>
#include <random>
#include <vector>

#include "calibration/assessment/pin_centres.h"
#include "calibration/range_finders/rig_adjustment.h"
#include "engine/optics/nominal_rig.h"
#include "engine/target/pin_plate.h"

namespace vignole::testing {

/// White noise of standard deviation 1 through a Gaussian filter of standard deviation s: neighbours d apart are
/// correlated by exp(-d^2 / 4 s^2), 2 sqrt(pi) s of them share their error.
inline std::vector<double> filteredNoise(std::size_t count, double s, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const int reach = static_cast<int>(std::ceil(4 * s));
  std::vector<double> white(count + 2 * static_cast<std::size_t>(reach));
  for (double& w : white) w = normal(random);
  std::vector<double> kernel;
  double squares = 0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(s > 0 ? std::exp(-k * k / (2 * s * s)) : (k == 0 ? 1.0 : 0.0));
    squares += kernel.back() * kernel.back();
  }
  std::vector<double> filtered(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < kernel.size(); ++k) filtered[i] += kernel[k] * white[i + k] / std::sqrt(squares);
  return filtered;
}
inline double sharedPoints(double s) { return std::max(1.0, 3.5449 * s); }

/// Every pin of the plate in every camera and placement, arcs of 120 degrees a pixel apart, noise `sigmaPx` along the
/// normal that neighbours share as filter `s` has it. The calibration is the rig itself.
inline RigAdjustment adjustmentOf(const RigCalibration& rig, const PinPlate& plate,
                                  const std::vector<Transform2>& placements, double sigmaPx, double s,
                                  std::uint64_t seed) {
  std::mt19937_64 random(seed);
  RigAdjustment adjustment;
  adjustment.calibration = rig;
  for (const Pin& pin : plate.pins)
    adjustment.calibration.pins.push_back(
        {pin.number, pin.centreMm.x(), pin.centreMm.y(), pin.radiusMm, pin.uCentreMm, pin.uRadiusMm});
  for (const Transform2& t : placements) adjustment.placements.push_back({"", t});
  for (int c = 0; c < kCameraCount; ++c) {
    RangeFinderFit& fit = adjustment.finders[static_cast<std::size_t>(c)];
    fit.noisePx = fit.expectedNoisePx = sigmaPx;
    fit.correlatedPoints = sharedPoints(s);
    const RangeFinderCalibration& finder = rig.rangeFinders[static_cast<std::size_t>(c)];
    const PlaneMap map(finder);
    const Eigen::Vector3d camera = cameraCentre(finder.cameraFromWorld);
    for (std::size_t m = 0; m < placements.size(); ++m)
      for (const Pin& pin : plate.pins) {
        const Point2 centre = placements[m] * pin.centreMm;
        const double towards = std::atan2(camera.y() - centre.y(), camera.x() - centre.x());
        PinView view;
        view.pin = pin.number;
        view.camera = c;
        view.placement = static_cast<int>(m);
        view.used = true;
        view.arcDeg = 120;
        const auto count = static_cast<std::size_t>(pin.radiusMm * 2.09 / 0.2);
        const std::vector<double> noise = filteredNoise(count, s, random);
        for (std::size_t i = 0; i < count; ++i) {
          const double angle = towards + 2.09 * (static_cast<double>(i) / static_cast<double>(count - 1) - 0.5);
          const Point2 n(std::cos(angle), std::sin(angle)), at = centre + pin.radiusMm * n;
          const Point2 px = pixelOf(finder, at);
          const PlanePoint p = map(px.x(), px.y());
          const double mmPerPx = std::hypot(p.dxdc * n.x() + p.dydc * n.y(), p.dxdr * n.x() + p.dydr * n.y());
          view.pointsInWorld.push_back(at + sigmaPx * mmPerPx * noise[i] * n);
          view.residualPx.push_back(sigmaPx * noise[i]);
        }
        view.points = static_cast<int>(count);
        adjustment.pins.push_back(std::move(view));
      }
  }
  return adjustment;
}

}  // namespace vignole::testing
