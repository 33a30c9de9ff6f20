#pragma once
// Four range finders brought into one world by a plate with pins (paper section III-B and past it).

#include <array>
#include <string>
#include <vector>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/job.h"
#include "engine/stripe/stripe.h"
#include "engine/target/pin_plate.h"

namespace vignole {

enum class RigMethod {
  Joint,      ///< arcs fitted in the light plane, all cameras and placements at once, pins as unknowns with priors
  PerCamera,  ///< the same, each camera by itself, the plate taken as stated
  Paper       ///< direct least-squares ellipses, two filters, four-step association, pose from centres
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
  double cdMm = 0, rdMm = 0, pdMm = 0, pdNominalMm = 0;  ///< optics design, section 1.6; radius free
  std::vector<Point2> pointsInWorld;                     ///< for Fig. 8d
};

struct RangeFinderFit {
  SpreadMm cd, rd, pd, pdNominal;  ///< Table IV, over the pins used
  double reprojectionPx = 0;       ///< mean distance of points and arcs in the image
  double rmsPx = 0;
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

}  // namespace vignole
