#pragma once
// What the points of every arc are expected to be, by where cameras, pins and plates are thought to stand: which of
// them count, how far the filter pulls them inwards, how much each is worth.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "calibration/range_finders/arc_cost.h"
#include "calibration/range_finders/pin_lines.h"
#include "calibration/range_finders/rig_adjustment.h"

namespace vignole {

/// Cameras, pins and plates as found so far. World: the plate's frame in its reference placement.
struct RigState {
  std::array<RangeFinderCalibration, kCameraCount> finders;
  std::vector<Pin> pins;                    ///< as the plate's, centres and radii as found
  std::vector<Transform2> worldFromPlate;  ///< per placement
};

/// How the light of one camera comes to be where it is.
struct CameraLight {
  /// Variance of the blur by lens and pixel, px^2: [0] + [1] z + [2] z^2, z = (distance along the axis - 400 mm) / 100.
  Eigen::Vector3d blurPx2{0.25, 0, 0};
  double thicknessMm2 = 0.1225;  ///< variance of the sheet
  Point2 laserMm{0, 0};
  std::array<Point2, kCameraCount - 1> othersMm{};  ///< the other lasers
  double otherShare = 0.03;  ///< of their light, that comes through the filter
  double noise = 1;        ///< of the ridge's points, in their own standard uncertainties
  double correlation = 1;  ///< how much further along the line it reaches than the filter's (variances): grain
  double uBlurPx2 = 0, uThicknessMm2 = 0;  ///< standard uncertainties, as far as the widths of the lines tell

  [[nodiscard]] double blurAt(double distanceMm) const;
};

/// One arc, with the pin that it was associated with.
struct ArcObservation {
  int camera = 0, placement = 0, pin = 0;  ///< indices
  std::size_t arc = 0;                     ///< in its picture
  const PinArc* line = nullptr;
  std::string rejected;  ///< why it is of no use
  // For each of the line's points:
  std::vector<char> inside;          ///< neither too close to an end of the light nor too dark
  std::vector<char> shown;           ///< a little more of the line, for what is shown and measured of each pin
  std::vector<double> pullMm;        ///< of the ridge, outwards (so mostly < 0)
  std::vector<double> mmPerPx;       ///< along the normal
  std::vector<double> sigmaPx;       ///< standard uncertainty by the picture's noise
  std::vector<double> residualPx;    ///< outwards
  std::vector<double> weight;        ///< 0 .. 1
  std::vector<double> widthMisfit;   ///< variance across the line, found - expected, px^2; NaN: of no use
  std::vector<double> lightMisfit;   ///< logarithm of the light, found - expected
  std::vector<double> arcPx;         ///< way along the line
  std::vector<double> angleRad;      ///< about the pin's centre, in the world
  Point2 offPlanePx{0, 0};           ///< ArcLight::pxPerMmOffPlane
  double distanceMm = 0;             ///< from the camera, along its axis
  double arcRad = 0;                 ///< of the whole line
  double filterPx2 = 1;              ///< variance of the line filter
  double spacingPx = 1;              ///< of the points

  [[nodiscard]] bool used() const { return rejected.empty(); }
  [[nodiscard]] int pointsUsed() const;
  /// Errors d px apart are correlated by exp(-d^2 / 4 this).
  [[nodiscard]] double correlationPx2(const CameraLight& light) const { return filterPx2 * light.correlation; }
  /// Neighbours that share their error: the sum of that over all points.
  [[nodiscard]] double correlatedPoints(const CameraLight& light) const;
};

/// Arcs of associated pins; those without a pin are left out.
[[nodiscard]] std::vector<ArcObservation> observations(const RigInputs& inputs, std::span<const int> cameras);

/// Predicts each arc anew and finds its residuals. `placeMm`: what arcs may lie off by, beside the noise of their
/// points, without being suspected.
void predict(const RigState& state, const std::array<CameraLight, kCameraCount>& lights,
             const RigAdjustmentSettings& settings, double placeMm, std::vector<ArcObservation>& arcs);

/// Blur, sheet and place of the laser from how broad and how bright the lines are beside what was expected.
void refineLights(const RigState& state, const std::vector<ArcObservation>& arcs,
                  std::array<CameraLight, kCameraCount>& lights);

}  // namespace vignole
