#include "engine/stripe/ridge_kernel.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/stripe/ridge_kernel.cpp"
// The kernel keeps arrays of vectors, which need a size known at compile time: SVE machines run the NEON code.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vignole::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

const hn::ScalableTag<float> kFloats;
const hn::Rebind<std::uint8_t, decltype(kFloats)> kBytes;
const hn::Rebind<std::int32_t, decltype(kFloats)> kInts;
using Floats = hn::Vec<decltype(kFloats)>;
constexpr int kRows = kBandHeight + 2;

HWY_INLINE Floats load(const std::uint8_t* p) {
  return hn::ConvertTo(kFloats, hn::PromoteTo(kInts, hn::LoadU(kBytes, p)));
}

// Ten output rows stay in registers while the input rows pass once; a row serves the outputs it lies in reach of.
HWY_INLINE void smoothColumns(const std::uint8_t* p, std::ptrdiff_t stride, const float* taps, int length,
                              std::size_t i, RidgeBand& band) {
  Floats sums[kRows];
  for (auto& sum : sums) sum = hn::Zero(kFloats);
  const auto pass = [&](int row, int firstOutput, int lastOutput) HWY_ATTR {
    const Floats pixels = load(p + row * stride + i);
    HWY_UNROLL(10)
    for (int j = 0; j < kRows; ++j)
      if (j >= firstOutput && j <= lastOutput) sums[j] = hn::MulAdd(pixels, hn::Set(kFloats, taps[row - j]), sums[j]);
  };
  HWY_UNROLL(9)
  for (int row = 0; row < kRows - 1; ++row) pass(row, 0, row);
  for (int row = kRows - 1; row < length; ++row) pass(row, 0, kRows - 1);
  HWY_UNROLL(9)
  for (int beyond = 0; beyond < kRows - 1; ++beyond) pass(length + beyond, beyond + 1, kRows - 1);
  for (int j = 0; j < kRows; ++j) hn::StoreU(sums[j], kFloats, band.vertical[static_cast<std::size_t>(j)].data() + i);
}

HWY_INLINE void smoothRows(const float* taps, int length, std::size_t i, RidgeBand& band) {
  constexpr int kTogether = 5;
  for (std::size_t first = 0; first < kRows; first += kTogether) {
    Floats sums[kTogether];
    for (auto& sum : sums) sum = hn::Zero(kFloats);
    for (int k = 0; k < length; ++k) {
      const Floats tap = hn::Set(kFloats, taps[k]);
      for (std::size_t j = 0; j < kTogether; ++j)
        sums[j] = hn::MulAdd(hn::LoadU(kFloats, band.vertical[first + j].data() + i + k), tap, sums[j]);
    }
    for (std::size_t j = 0; j < kTogether; ++j) hn::StoreU(sums[j], kFloats, band.smoothed[first + j].data() + i);
  }
}

// Steger's test on one vector of pixels; `s` points at the pixel one row and one column before in the smoothed band.
HWY_INLINE std::size_t testPixels(const float* s, std::size_t width, int column, int row, float leastRidge,
                                  RidgePoint* out) {
  constexpr std::size_t kPitch = RidgeBand::kPitch;
  const auto at = [s](std::size_t y, std::size_t x) HWY_ATTR { return hn::LoadU(kFloats, s + y * kPitch + x); };
  const Floats half = hn::Set(kFloats, 0.5F), quarter = hn::Set(kFloats, 0.25F), least = hn::Set(kFloats, leastRidge);
  const Floats centre = at(1, 1), left = at(1, 0), right = at(1, 2), above = at(0, 1), below = at(2, 1);
  const Floats twice = hn::Add(centre, centre);
  const Floats dxx = hn::Sub(hn::Add(left, right), twice), dyy = hn::Sub(hn::Add(above, below), twice);
  const Floats mean = hn::Mul(hn::Add(dxx, dyy), half);
  // A ridge (the other eigenvalue smaller in size) of at least `least` has a mean of its eigenvalues below -least / 2.
  if (hn::AllFalse(kFloats, hn::Lt(mean, hn::Mul(least, hn::Set(kFloats, -0.5F))))) return 0;

  const Floats dx = hn::Mul(hn::Sub(right, left), half), dy = hn::Mul(hn::Sub(below, above), half);
  const Floats dxy = hn::Mul(hn::Add(hn::Sub(at(2, 2), at(2, 0)), hn::Sub(at(0, 0), at(0, 2))), quarter);
  const Floats difference = hn::Mul(hn::Sub(dxx, dyy), half);
  const Floats root = hn::Sqrt(hn::MulAdd(difference, difference, hn::Mul(dxy, dxy)));
  const Floats eigenvalue = hn::Sub(mean, root), ridge = hn::Neg(eigenvalue);
  // Eigenvector of the lower eigenvalue, in the form whose terms do not cancel.
  const auto mostlyAlongY = hn::Gt(difference, hn::Zero(kFloats));
  const Floats nx = hn::IfThenElse(mostlyAlongY, hn::Neg(dxy), hn::Sub(root, difference));
  const Floats ny = hn::IfThenElse(mostlyAlongY, hn::Add(difference, root), hn::Neg(dxy));
  const Floats length2 = hn::Add(hn::MulAdd(nx, nx, hn::Mul(ny, ny)), hn::Set(kFloats, 1e-20F));
  const Floats step = hn::Div(hn::MulAdd(dx, nx, hn::Mul(dy, ny)), hn::Mul(ridge, length2));
  const Floats x = hn::Mul(step, nx), y = hn::Mul(step, ny);
  const auto inPixel = hn::And(hn::Le(hn::Abs(x), half), hn::Le(hn::Abs(y), half));
  const auto found = hn::And(hn::And(hn::Ge(ridge, least), hn::Ge(ridge, hn::Abs(hn::Add(mean, root)))), inPixel);
  if (hn::AllFalse(kFloats, found)) return 0;

  constexpr std::size_t kLanes = HWY_MAX_BYTES / sizeof(float);
  alignas(HWY_MAX_BYTES) float xs[kLanes], ys[kLanes], nxs[kLanes], nys[kLanes], ridges[kLanes], centres[kLanes];
  const Floats unit = hn::Div(hn::Set(kFloats, 1.0F), hn::Sqrt(length2));
  hn::Store(x, kFloats, xs);
  hn::Store(y, kFloats, ys);
  hn::Store(hn::Mul(nx, unit), kFloats, nxs);
  hn::Store(hn::Mul(ny, unit), kFloats, nys);
  hn::Store(ridge, kFloats, ridges);
  hn::Store(centre, kFloats, centres);
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(kFloats, found, bytes);
  std::uint32_t bits = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U;
  if (width < 16) bits &= (1U << width) - 1;
  std::size_t count = 0;
  for (; bits != 0; bits &= bits - 1) {
    const auto k = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
    const int pixelColumn = column + static_cast<int>(k);
    out[count++] = {
        static_cast<float>(pixelColumn) + xs[k], static_cast<float>(row) + ys[k], nxs[k], nys[k], ridges[k], centres[k],
        static_cast<std::uint16_t>(pixelColumn), static_cast<std::uint16_t>(row)};
  }
  return count;
}

void smooth(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, const RidgeFilter& filter, RidgeBand& band) {
  const int length = 2 * filter.radius + 1;
  const std::size_t lanes = hn::Lanes(kFloats);
  const auto inner = static_cast<std::size_t>(width), outer = inner + static_cast<std::size_t>(length) + 1;
  for (std::size_t i = 0; i < outer; i += lanes) smoothColumns(pixels, stride, filter.taps.data(), length, i, band);
  for (std::size_t i = 0; i < inner + 2; i += lanes) smoothRows(filter.taps.data(), length, i, band);
}

std::size_t findPoints(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int column, int row,
                       const RidgeFilter& filter, RidgeBand& band) {
  smooth(pixels, stride, width, filter, band);
  const std::size_t lanes = hn::Lanes(kFloats);
  const auto inner = static_cast<std::size_t>(width);
  std::size_t count = 0;
  for (int y = 0; y < kBandHeight; ++y)
    for (std::size_t i = 0; i < inner; i += lanes)
      count += testPixels(band.smoothed[static_cast<std::size_t>(y)].data() + i, inner - i,
                          column + static_cast<int>(i), row + y, filter.leastRidge, band.points.data() + count);
  return count;
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace
}  // namespace vignole::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole {

HWY_EXPORT(findPoints);
HWY_EXPORT(smooth);
HWY_EXPORT(targetName);

RidgeFilter ridgeFilter(double sigma, double leastRidge) {
  RidgeFilter filter;
  // 3.34 sigma: what is cut off is below 0.1 % of the light
  filter.radius = std::min(kMaxFilterRadius, static_cast<int>(std::ceil(3.34 * sigma - 0.5)));
  const auto below = [sigma](double x) { return 0.5 * std::erfc(-x / (sigma * std::sqrt(2.0))); };
  double sum = 0, squares = 0;
  std::array<double, 2 * kMaxFilterRadius + 1> taps{};
  for (int k = -filter.radius; k <= filter.radius; ++k) {
    const double tap = below(k + 0.5) - below(k - 0.5);
    const int index = k + filter.radius;
    taps[static_cast<std::size_t>(index)] = tap;
    sum += tap;
    squares += tap * k * k;
  }
  for (std::size_t k = 0; k < taps.size(); ++k) filter.taps[k] = static_cast<float>(taps[k] / sum);
  filter.variancePx2 = squares / sum;
  const auto tapAt = [&](int k) {
    const int i = k + filter.radius;
    return i < 0 || i > 2 * filter.radius ? 0.0 : taps[static_cast<std::size_t>(i)] / sum;
  };
  double smooth2 = 0, first2 = 0, second2 = 0;
  for (int k = -filter.radius - 1; k <= filter.radius + 1; ++k) {
    smooth2 += std::pow(tapAt(k), 2);
    first2 += std::pow((tapAt(k + 1) - tapAt(k - 1)) / 2, 2);
    second2 += std::pow(tapAt(k + 1) + tapAt(k - 1) - 2 * tapAt(k), 2);
  }
  filter.gradientNoise = std::sqrt(first2 * smooth2);
  filter.ridgeNoise = std::sqrt(second2 * smooth2);
  filter.leastRidge = static_cast<float>(leastRidge);
  return filter;
}

std::span<const RidgePoint> findRidgePoints(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int column,
                                            int row, const RidgeFilter& filter, RidgeBand& band) {
  return {band.points.data(), HWY_DYNAMIC_DISPATCH(findPoints)(pixels, stride, width, column, row, filter, band)};
}

void smoothBand(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, const RidgeFilter& filter,
                RidgeBand& band) {
  HWY_DYNAMIC_DISPATCH(smooth)(pixels, stride, width, filter, band);
}

const char* simdTargetName() { return HWY_DYNAMIC_DISPATCH(targetName)(); }

}  // namespace vignole
#endif
