#pragma once
// Views of a flat target by a known camera, as points: truth for the adjustment.

#include <random>
#include <vector>

#include "calibration/detection/target_finder.h"
#include "engine/optics/calibration.h"

namespace vignole {

struct SyntheticViews {
  std::vector<TargetView> views;
  std::vector<Extrinsics> cameraFromTarget;
  std::vector<Eigen::Vector3d> points;  ///< true ones
};

struct SyntheticSettings {
  PlanarTarget target;
  Intrinsics camera;
  int views = 16;
  double noisePx = 0.05;
  double uPx = -1;         ///< what the finder says; negative: noisePx
  double maxTiltDeg = 35;  ///< each view is tilted up to this
  double minTiltDeg = 5;
  double bendMm = 0;         ///< the target is a saddle, so high in its corners
  double targetErrorMm = 0;  ///< each coordinate uniform within
};

/// Targets that fill 40 to 70 % of the picture's width, moved over the picture; only points inside it.
[[nodiscard]] SyntheticViews syntheticViews(const SyntheticSettings& settings, std::mt19937_64& random);

[[nodiscard]] PlanarTarget chessboard(int columns, int rows, double pitchMm);
[[nodiscard]] PlanarTarget circles(int columns, int rows, double pitchMm, double diameterMm);

/// 1400 x 1024 of 7.4 um behind 16 mm, principal point a little off.
[[nodiscard]] Intrinsics usualCamera();

/// Centre of the ellipse-like outline of a circle as the camera sees it: centroid of its area, by a fine polygon.
[[nodiscard]] Point2 imagedCircleCentre(const Intrinsics& in, const Extrinsics& pose, const Eigen::Vector3d& centre,
                                        double radiusMm);

}  // namespace vignole
