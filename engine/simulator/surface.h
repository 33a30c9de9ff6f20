#pragma once
// How the rail's skin reflects: mill scale in patches, bare glossy spots between them; and the speckle of laser light.
// Tables drawn once, looked up at hashed places.

#include <cstdint>
#include <vector>

namespace vignole::simulator {

/// Smooth noise over the rail's skin as ranks: the share of the skin below a value is that value. Periodic: 768 mm
/// around the outline, 8 m along the rail.
class SkinTexture {
 public:
  explicit SkinTexture(std::uint64_t seed);
  /// Rank 0..1 at a place of the skin (bilinear).
  [[nodiscard]] float rank(double aroundMm, double alongMm) const;

 private:
  std::vector<float> ranks_;
};

/// Reflectance of the skin.
class Surface {
 public:
  explicit Surface(std::uint64_t seed);
  /// `scaleShare` of the skin is mill scale with 0.3-0.7 of the bare reflectance and soft borders; where there is scale
  /// at all, 1 % of the skin is glossy.
  [[nodiscard]] float reflectance(double aroundMm, double alongMm, double scaleShare) const;

 private:
  SkinTexture skin_;  ///< patches, shades and gloss are read from it at places and scales that have nothing in common
};

inline constexpr double kSpeckleGrainSigma = 0.6;  ///< px: white noise smoothed by that much
inline constexpr int kSpeckleSize = 512;
inline constexpr int kSpeckleStride = kSpeckleSize + 16;

/// Multiplicative speckle: mean 1, standard deviation `contrast`, gamma-like (Wilson-Hilferty), grain 2 px (width of
/// the autocorrelation at half its height). kSpeckleSize rows of kSpeckleStride, periodic, the first 16 columns
/// repeated.
[[nodiscard]] std::vector<float> speckleField(std::uint64_t seed, double contrast);
/// Correlation of the field along a row or a column at 0, 1, 2 ... px, and 0 beyond; over both axes it is the product.
[[nodiscard]] std::vector<double> speckleCorrelation();

}  // namespace vignole::simulator
