#pragma once
// Our lens models and OpenCV's: opposite directions (OpenCV's polynomial runs undistorted -> distorted, in units of the
// focal length), so that neither is a closed form of the other but for division to first order (optics design, 1.1).

#include "engine/geometry/expected.h"
#include "engine/optics/calibration.h"

namespace vignole {

/// x_d = x (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), y alike.
struct OpenCvLens {
  double fxPx = 0, fyPx = 0, cxPx = 0, cyPx = 0;
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0, k4 = 0, k5 = 0, k6 = 0;
  int widthPx = 0, heightPx = 0;
};

struct ToOpenCv {
  OpenCvLens lens;
  double maxResidualPx = 0;  ///< largest difference over the picture
};
/// k1, k2, p1, p2, k3 by least squares over a grid of 50 x 40 points of the picture.
[[nodiscard]] ToOpenCv toOpenCv(const Intrinsics& in);

struct FromOpenCv {
  Intrinsics intrinsics;
  double maxResidualPx = 0;
};
/// The same the other way round, to the polynomial model (all five numbers) or division. `pixelMm`: the width of a
/// pixel, which OpenCV does not know. Error: the distortion folds the picture over.
[[nodiscard]] Expected<FromOpenCv> fromOpenCv(const OpenCvLens& lens, DistortionModel model, double pixelMm);

}  // namespace vignole
