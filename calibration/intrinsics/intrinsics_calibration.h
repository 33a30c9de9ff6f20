#pragma once
// Intrinsic parameters of one camera from views of a flat target (paper section III-B), the lens model chosen by
// pictures that it has not seen, judged and refused where it would mislead.

#include <optional>
#include <string>
#include <vector>

#include "calibration/detection/target_finder.h"
#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/intrinsics/coverage.h"
#include "calibration/intrinsics/lens_variant.h"
#include "calibration/intrinsics/opencv_reference.h"
#include "calibration/intrinsics/outliers.h"
#include "calibration/job.h"

namespace vignole {

struct IntrinsicsSettings {
  double pixelMm = 0.0074;               ///< width of a pixel, s^x; as high as wide unless the data say otherwise
  std::optional<DistortionModel> model;  ///< nothing: chosen by the data
  double nominalFocalMm = 0;             ///< of the lens, one more place to start from; 0: unknown
  int folds = 6;                         ///< of the cross-validation over views
  double confidence = 0.995;             ///< with which a simpler model must be the worse one in it, to be left
  OutlierSettings outliers;
  std::size_t minViews = 3;
  std::size_t minViewPoints = 12;
  double samePosePx = 4;            ///< two views whose points lie closer than this (RMS) are the same pose
  double minTiltDifferenceDeg = 8;  ///< largest angle between two views' planes that is needed
  double maxRelativeUFocal = 0.01;
  double maxUPrincipalPoint = 0.02;  ///< of the picture's width
  bool openCvReference = true;
  std::string serial;  ///< of the camera, for the result
};

/// One point of one view after the adjustment.
struct PointResult {
  int index = 0;  ///< in PlanarTarget::points()
  Point2 px{0, 0};
  Point2 errorPx{0, 0};  ///< predicted less found
  bool used = false;
};

struct ViewResult {
  std::string file;
  bool used = false;
  std::string reason;  ///< why not used, and what to do
  int points = 0;      ///< used
  int rejected = 0;    ///< points that do not fit
  double rmsPx = 0, meanPx = 0;
  Extrinsics cameraFromTarget;
  std::vector<PointResult> pointResults;
};

/// One lens model adjusted to all views: a line of the paper's Table III and more.
struct VariantResult {
  LensVariant variant;
  Intrinsics intrinsics;
  double rmsPx = 0, meanPx = 0;
  double heldOutRmsPx = 0;  ///< cross-validation
};

struct IntrinsicsCalibration {
  CalibratedIntrinsics camera;
  LensVariant variant;  ///< of the camera
  Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> correlation;
  std::vector<VariantResult> variants;                ///< all that were tried
  std::optional<VariantResult> division, polynomial;  ///< the best of each family: Table III
  std::vector<ViewResult> views;                      ///< in the order given
  Coverage coverage;
  double unexplainedPx = 0;  ///< noise beyond what the finder says of its points, px
  double chi2PerDof = 0;     ///< of the finder's uncertainties alone
  /// Standard deviation of the target's points from where they are stated (each coordinate), mm, where the views show
  /// it or it was given; then the points were estimated as well. 0: taken as stated.
  double targetErrorMm = 0;
  double targetBendMm = 0;                              ///< the same out of the target's plane; 0: taken as flat
  std::vector<Point2> targetCorrectionsMm;              ///< of each point, where they were estimated
  std::vector<double> targetHeightsMm;                  ///< of each point, z of the target's frame, where estimated
  std::optional<OpenCvReference> openCv;                ///< with the target as estimated
  std::optional<OpenCvReference> openCvTargetAsStated;  ///< where that differs
  std::vector<std::string> refusals;                    ///< "refused, because ..., do ..."; empty: may be used
  std::vector<std::string> warnings;
  double seconds = 0;
  [[nodiscard]] bool accepted() const { return refusals.empty(); }
};

/// Views that are of no use are told in the result, too few or too similar ones as refusals. Error: cancelled.
[[nodiscard]] Expected<IntrinsicsCalibration> calibrateIntrinsics(const std::vector<TargetView>& views,
                                                                  const PlanarTarget& target,
                                                                  const IntrinsicsSettings& settings = {},
                                                                  const Job& job = {});

}  // namespace vignole
