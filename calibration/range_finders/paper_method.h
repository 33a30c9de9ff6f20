#pragma once
// The paper's chain (section III-B): direct least-squares ellipses, filters on the ratio of their axes and on the
// length of their arc, four-step association (optics design, section 1.9), pose from centres.

#include <array>
#include <string>
#include <vector>

#include "calibration/range_finders/ellipse_fit.h"
#include "calibration/range_finders/pin_lines.h"
#include "engine/optics/calibration.h"
#include "engine/target/pin_plate.h"

namespace vignole {

/// Which ellipse is the "centermost": the paper does not say.
enum class Centermost { Mean, ImageCentre };

struct PaperSettings {
  EllipseFitVariant fit = EllipseFitVariant::HalirFlusser;
  bool undistort = true;      ///< the points, before ellipses are fitted to them
  double minAxisRatio = 0.3;  ///< of an ellipse
  double maxAxisRatio = 1;
  double minArcShare = 0.3;     ///< length of the line over the perimeter of its ellipse
  double matchDistance = 0.35;  ///< t_ec, in the coordinates of the association (-1 .. 1)
  int maxEllipses = 13;         ///< used for the pose: those of the longest arcs
  Centermost centermost = Centermost::Mean;
  bool fourSteps = true;    ///< false: the pins that the arcs have been given already (association.h)
  double maxRmsPx = 4;      ///< of the centres about their pose: more, and wrong pins were paired
  double rollErrorDeg = 0;  ///< added to the roll of the drawing: what a technician may have got wrong
};

/// One ellipse and the pin it was associated with.
struct PaperEllipse {
  int arc = 0;      ///< index in PinPicture::arcs
  Ellipse ellipse;  ///< px; undistorted ones if the settings say so
  double arcShare = 0;
  int pin = 0;  ///< number; 0: none
  std::string reason;
};

/// One picture.
struct PaperPose {
  std::vector<PaperEllipse> ellipses;
  Extrinsics cameraFromPlate;
  double rmsPx = 0;                                                              ///< of the centres
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< TurnX .. T3, by that rms
  std::string refusal;                                                           ///< empty: there is a pose
};

/// `drawing`: of this camera, for its roll and as the start of the pose.
[[nodiscard]] PaperPose paperPose(const PinPicture& picture, const PinPlate& plate, const Intrinsics& intrinsics,
                                  const Extrinsics& drawing, const PaperSettings& settings);

}  // namespace vignole
