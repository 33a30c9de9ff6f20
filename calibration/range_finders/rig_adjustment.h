#pragma once
// Four range finders brought into one world by a plate with pins (paper section III-B and past it). The world is the
// frame of the plate in the first placement of which a picture is used, and with it the rail section's.

#include <array>
#include <string>
#include <vector>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/job.h"
#include "calibration/range_finders/paper_method.h"
#include "calibration/range_finders/pin_lines.h"
#include "engine/target/pin_plate.h"

namespace vignole {

enum class RigMethod {
  Joint,      ///< arcs fitted in the light plane, all cameras and placements at once, pins as unknowns with priors
  PerCamera,  ///< the same, each camera by itself, the plate taken as stated
  Paper       ///< direct least-squares ellipses, two filters, four-step association, pose from centres
};
/// "joint", "per-camera", "paper".
[[nodiscard]] std::string_view name(RigMethod method);

/// Whether the plate may improve the intrinsic parameters, within their covariance.
enum class IntrinsicsUse {
  Decide,  ///< what leaves the image <-> plane maps less uncertain, by the errors that are stated and measured
  Held,
  Freed
};

/// What the adjustment works on. Parts of it may be left out (placements, the pin of an arc set to 0) to judge the rest.
struct RigInputs {
  PinPlate plate;
  std::array<CalibratedIntrinsics, kCameraCount> cameras;
  std::vector<PlacementLines> placements;  ///< associated: see association.h (the paper's method does that itself)
};

struct RigAdjustmentSettings {
  RigMethod method = RigMethod::Joint;
  IntrinsicsUse intrinsics = IntrinsicsUse::Decide;
  double endMarginSigmas = 2;    ///< points closer to an end of the light are left out, in sigmas of the smoothed light
  double leastLight = 0.3;       ///< of an arc's brightest: darker points, at grazing angles, are left out
  double outlierSigmas = 3;      ///< residuals count less from here on, and not at all from twice that
  int maxRounds = 6;             ///< of the pull of bends predicted, and solved with
  int fewestPins = 6;            ///< in a picture
  PaperSettings paper;
};

struct SpreadMm {
  double mean = 0, std = 0, max = 0;
};

/// One pin as one camera saw it in one placement.
struct PinView {
  int pin = 0;  ///< number
  int camera = 0, placement = 0;
  bool used = false;
  std::string reason;  ///< why not used
  double arcDeg = 0;
  int points = 0;
  double cdMm = 0, rdMm = 0, pdMm = 0, pdNominalMm = 0;  ///< optics design, section 1.6; radius free, plate as stated
  double leaveOneOutMm = 0;  ///< distance of the centre from where all the other pins put it
  std::vector<Point2> pointsInWorld;  ///< for Fig. 8d; what the filter pulls them inwards by is taken off
  std::vector<double> residualPx;     ///< of each of them, outwards: how far the line lies off the pin in the picture
};

struct RangeFinderFit {
  SpreadMm cd, rd, pd, pdNominal;  ///< Table IV, over the pins used
  double reprojectionPx = 0;       ///< mean distance of points and arcs in the image
  double rmsPx = 0;
  double noisePx = 0;         ///< standard deviation of a point of the ridge by its residuals
  double expectedNoisePx = 0;  ///< and by the noise of the pictures
  double correlatedPoints = 1;  ///< neighbours that share their error
};

struct PlacedPlate {
  std::string folder;
  Transform2 worldFromPlate;  ///< as found
};

struct RigAdjustment {
  RigMethod method = RigMethod::Joint;
  RigCalibration calibration;        ///< with covariance and the pins as found
  std::vector<ErrorSource> sources;  ///< their covariances sum up to the calibration's
  std::array<RangeFinderFit, kCameraCount> finders;
  std::vector<PinView> pins;
  std::vector<PlacedPlate> placements;
  bool intrinsicsFreed = false;  ///< whether the plate was good enough to improve them
  double chi2PerDof = 0;
  std::vector<std::string> refusals;  ///< "refused, because ..., do ..."; empty: may be used
  std::vector<std::string> warnings;
  double solveS = 0;
};

/// An error is one of input (fewer placements than one, a job cancelled); what the pictures do not bear is refused in
/// the result. Deterministic.
[[nodiscard]] Expected<RigAdjustment> adjustRig(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                                const Job& job);

}  // namespace vignole
