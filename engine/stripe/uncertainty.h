#pragma once
// How sure a point of a line is: what pixel noise and speckle do to the filter's answers. All for a stripe of Gaussian
// profile (contrast A, standard deviation s) under a Gaussian filter of standard deviation sigma; v = s^2 + sigma^2.

#include <cstddef>
#include <vector>

#include "engine/stripe/line_points.h"
#include "engine/stripe/ridge_kernel.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// Second derivative at the centre of a line of contrast 1 DN: s / v^1.5, 1/px^2. With s = sigma, which is how the
/// thresholds t_l and t_h are meant: 1 / (2 sqrt(2) sigma^2).
[[nodiscard]] double ridgePerContrast(double s, double sigma);
/// Standard deviation of the second derivative for pixels of 1 DN: sqrt(3 / (16 pi)) / sigma^3 (Steger 1998). What the
/// filter's differences really do stands in RidgeFilter: 10 % less at sigma = 1.5, 3 % less at 3.
[[nodiscard]] double ridgeNoise(double sigma);
/// Standard deviation of the first derivative across the line for pixels of 1 DN: 1 / (sqrt(8 pi) sigma^2). Divided by
/// the second derivative it is Steger's position noise, sn/A (s^2 + sigma^2)^1.5 / (sqrt(8 pi) sigma^2 s).
[[nodiscard]] double gradientNoise(double sigma);

/// Variances caused by noise that grows with the light, for C^2 a = 1 px^2 (C: its contrast, a: area of a grain).
struct SpeckleGain {
  float positionPx2 = 0;  ///< of the point along its normal, px^2
  float ridge = 0;        ///< of the second derivative, relative
};
[[nodiscard]] SpeckleGain speckleGain(float s2, float sigma2);

/// C^2 a of a frame, px^2: how much more than pixel noise explains do position and strength fluctuate along the lines.
/// Both are asked and the lesser answer is taken: a real contour moves the line but does not make it flicker, a change
/// of reflectance makes it flicker but does not move it. Buffers live from frame to frame.
class SpeckleMeter {
 public:
  void begin(const RidgeFilter& filter, double noiseDn);
  void add(const LinePoints& points, const LineRange& line);
  /// 0 if there is too little to tell.
  [[nodiscard]] float speckle();

 private:
  float sigma_ = 1, positionNoise2_ = 0, ridgeNoise2_ = 0;
  std::vector<float> fromPosition_, fromRidge_;
};

/// What the end of the light adds to the error of a point `edgePx` away from it, px (standard deviation, found on
/// rendered ends).
[[nodiscard]] float endSigma(float edgePx, double sigma);

}  // namespace vignole
