#include "engine/stripe/ridge_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>

#ifndef VIGNOLE_RIDGE_KERNEL_TABLE
#define VIGNOLE_RIDGE_KERNEL_TABLE
namespace vignole {

/// For each set of eight lanes: which lanes come first when those of the set are moved together.
struct PackingOrder {
  alignas(32) std::array<std::array<std::uint32_t, 8>, 256> lanes{};
};
constexpr PackingOrder packingOrder() {
  PackingOrder order;
  for (std::size_t set = 0; set < 256; ++set) {
    std::size_t n = 0;
    for (std::uint32_t lane = 0; lane < 8; ++lane)
      if ((set >> lane & 1U) != 0) order.lanes[set][n++] = lane;
  }
  return order;
}
inline constexpr PackingOrder kPackingOrder = packingOrder();

}  // namespace vignole
#endif

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
const hn::Rebind<std::uint32_t, decltype(kFloats)> kPixels;
using Floats = hn::Vec<decltype(kFloats)>;
constexpr int kRows = kBandHeight + 2;

HWY_INLINE Floats load(const std::uint8_t* p) {
  return hn::ConvertTo(kFloats, hn::PromoteTo(kInts, hn::LoadU(kBytes, p)));
}

/// Moves the lanes of a mask together.
class Packing {
 public:
#if HWY_TARGET == HWY_AVX2  // hn::Compress copies a table of 2 KB at every call there
  HWY_INLINE explicit Packing(hn::Mask<decltype(kFloats)> mask) {
    std::uint8_t set[8];
    hn::StoreMaskBits(kFloats, mask, set);
    count_ = static_cast<std::size_t>(std::popcount(set[0]));
    order_ = hn::IndicesFromVec(kFloats, hn::Load(kPixels, kPackingOrder.lanes[set[0]].data()));
  }
  HWY_INLINE void store(Floats v, float* to) const { hn::StoreU(hn::TableLookupLanes(v, order_), kFloats, to); }
#else
  HWY_INLINE explicit Packing(hn::Mask<decltype(kFloats)> mask) : count_(hn::CountTrue(kFloats, mask)), mask_(mask) {}
  /// Writes a whole vector, of which count() lanes are meant.
  HWY_INLINE void store(Floats v, float* to) const { hn::StoreU(hn::Compress(v, mask_), kFloats, to); }
#endif
  HWY_INLINE void store(hn::Vec<decltype(kPixels)> v, std::uint32_t* to) const {
    store(hn::BitCast(kFloats, v), reinterpret_cast<float*>(to));
  }
  [[nodiscard]] HWY_INLINE std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
#if HWY_TARGET == HWY_AVX2
  hn::Indices256<float> order_;
#else
  hn::Mask<decltype(kFloats)> mask_;
#endif
};

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

// A pixel may hold a point if the line's distance along its normal, by an approximate direction, is at most half a
// diagonal (with a margin that covers the approximation). `s` points at the pixel one row and one column before in the
// smoothed band.
HWY_INLINE void gatherCandidates(const float* s, std::size_t width, hn::Vec<decltype(kPixels)> pixels, float leastRidge,
                                 RidgeCandidates& out) {
  constexpr std::size_t kPitch = RidgeBand::kPitch;
  const auto at = [s](std::size_t y, std::size_t x) HWY_ATTR { return hn::LoadU(kFloats, s + y * kPitch + x); };
  const Floats half = hn::Set(kFloats, 0.5F), quarter = hn::Set(kFloats, 0.25F);
  const Floats centre = at(1, 1), left = at(1, 0), right = at(1, 2), above = at(0, 1), below = at(2, 1);
  const Floats twice = hn::Add(centre, centre);
  const Floats dxx = hn::Sub(hn::Add(left, right), twice), dyy = hn::Sub(hn::Add(above, below), twice);
  const Floats mean = hn::Mul(hn::Add(dxx, dyy), half);
  // A ridge (the other eigenvalue smaller in size) of at least `least` has a mean of its eigenvalues below -least / 2.
  const auto steep = hn::Lt(mean, hn::Set(kFloats, -0.499F * leastRidge));
  if (hn::AllFalse(kFloats, steep)) return;

  const Floats dx = hn::Mul(hn::Sub(right, left), half), dy = hn::Mul(hn::Sub(below, above), half);
  const Floats dxy = hn::Mul(hn::Add(hn::Sub(at(2, 2), at(2, 0)), hn::Sub(at(0, 0), at(0, 2))), quarter);
  const Floats difference = hn::Mul(hn::Sub(dxx, dyy), half);
  const Floats square = hn::MulAdd(difference, difference, hn::MulAdd(dxy, dxy, hn::Set(kFloats, 1e-20F)));
  const Floats perRoot = hn::ApproximateReciprocalSqrt(square);
  const Floats ridge = hn::Sub(hn::Mul(square, perRoot), mean);
  const Floats dx2 = hn::Mul(dx, dx), dy2 = hn::Mul(dy, dy), dxdy = hn::Mul(dx, dy);
  // Twice the squared gradient along the normal, whose double angle is that of (-difference, -dxy).
  const Floats turned = hn::MulAdd(hn::Sub(dx2, dy2), difference, hn::Mul(hn::Add(dxdy, dxdy), dxy));
  const Floats across2 = hn::NegMulAdd(turned, perRoot, hn::Add(dx2, dy2));
  const auto near = hn::Lt(across2, hn::Mul(hn::Mul(ridge, ridge), hn::Set(kFloats, 1.02F)));
  const auto found = hn::And(hn::And(steep, near), hn::FirstN(kFloats, width));
  if (hn::AllFalse(kFloats, found)) return;
  const Packing packing(found);
  const std::size_t n = out.size;
  packing.store(dx, out.dx.data() + n);
  packing.store(dy, out.dy.data() + n);
  packing.store(dxx, out.dxx.data() + n);
  packing.store(dxy, out.dxy.data() + n);
  packing.store(dyy, out.dyy.data() + n);
  packing.store(centre, out.smoothed.data() + n);
  packing.store(pixels, out.pixel.data() + n);
  out.size = n + packing.count();
}

void testCandidates(const RidgeCandidates& in, float leastRidge, RidgeArrays& out) {
  const Floats half = hn::Set(kFloats, 0.5F), least = hn::Set(kFloats, leastRidge);
  std::size_t n = 0;
  for (std::size_t i = 0; i < in.size; i += hn::Lanes(kFloats)) {
    const Floats dx = hn::LoadU(kFloats, in.dx.data() + i), dy = hn::LoadU(kFloats, in.dy.data() + i);
    const Floats dxx = hn::LoadU(kFloats, in.dxx.data() + i), dyy = hn::LoadU(kFloats, in.dyy.data() + i);
    const Floats dxy = hn::LoadU(kFloats, in.dxy.data() + i);
    const auto pixel = hn::LoadU(kPixels, in.pixel.data() + i);
    const Floats mean = hn::Mul(hn::Add(dxx, dyy), half), difference = hn::Mul(hn::Sub(dxx, dyy), half);
    const Floats root = hn::Sqrt(hn::MulAdd(difference, difference, hn::Mul(dxy, dxy)));
    const Floats ridge = hn::Sub(root, mean);
    // Eigenvector of the lower eigenvalue, in the form whose terms do not cancel.
    const auto mostlyAlongY = hn::Gt(difference, hn::Zero(kFloats));
    const Floats nx = hn::IfThenElse(mostlyAlongY, hn::Neg(dxy), hn::Sub(root, difference));
    const Floats ny = hn::IfThenElse(mostlyAlongY, hn::Add(difference, root), hn::Neg(dxy));
    const Floats length2 = hn::Add(hn::MulAdd(nx, nx, hn::Mul(ny, ny)), hn::Set(kFloats, 1e-20F));
    const Floats step = hn::Div(hn::MulAdd(dx, nx, hn::Mul(dy, ny)), hn::Mul(ridge, length2));
    const Floats x = hn::Mul(step, nx), y = hn::Mul(step, ny);
    const auto inPixel = hn::And(hn::Le(hn::Abs(x), half), hn::Le(hn::Abs(y), half));
    const auto strong = hn::And(hn::Ge(ridge, least), hn::Ge(ridge, hn::Abs(hn::Add(mean, root))));
    const auto found = hn::And(hn::And(strong, inPixel), hn::FirstN(kFloats, in.size - i));
    const Floats unit = hn::Div(hn::Set(kFloats, 1.0F), hn::Sqrt(length2));
    const auto column = hn::And(pixel, hn::Set(kPixels, 0xFFFFU)), row = hn::ShiftRight<16>(pixel);
    const auto asFloat = [](auto v) HWY_ATTR { return hn::ConvertTo(kFloats, hn::BitCast(kInts, v)); };
    const Packing packing(found);
    const auto store = [&](Floats v, std::vector<float>& to) HWY_ATTR { packing.store(v, to.data() + n); };
    store(hn::Add(asFloat(column), x), out.x);
    store(hn::Add(asFloat(row), y), out.y);
    const Floats unitX = hn::Mul(nx, unit), unitY = hn::Mul(ny, unit);
    store(unitX, out.nx);
    store(unitY, out.ny);
    store(hn::MulSub(dy, unitX, hn::Mul(dx, unitY)), out.along);
    store(ridge, out.ridge);
    store(hn::LoadU(kFloats, in.smoothed.data() + i), out.smoothed);
    packing.store(pixel, out.pixel.data() + n);
    n += packing.count();
  }
  out.size = n;
}

void smooth(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, const RidgeFilter& filter, RidgeBand& band) {
  const int length = 2 * filter.radius + 1;
  const std::size_t lanes = hn::Lanes(kFloats);
  const auto inner = static_cast<std::size_t>(width), outer = inner + static_cast<std::size_t>(length) + 1;
  for (std::size_t i = 0; i < outer; i += lanes) smoothColumns(pixels, stride, filter.taps.data(), length, i, band);
  for (std::size_t i = 0; i < inner + 2; i += lanes) smoothRows(filter.taps.data(), length, i, band);
}

void findCandidates(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int height, int column, int row,
                    const RidgeFilter& filter, RidgeBand& band, RidgeCandidates& candidates) {
  smooth(pixels, stride, width, filter, band);
  const auto inner = static_cast<std::size_t>(width);
  const auto ahead = hn::Iota(kPixels, 0U);
  for (int y = 0; y < height; ++y)
    for (std::size_t i = 0; i < inner; i += hn::Lanes(kFloats))
      gatherCandidates(band.smoothed[static_cast<std::size_t>(y)].data() + i, inner - i,
                       hn::Add(ahead, hn::Set(kPixels, packedPixel(column + static_cast<int>(i), row + y))),
                       filter.leastRidge, candidates);
}

void smoothNine(const std::uint8_t* pixels, std::ptrdiff_t stride, const RidgeFilter& filter, float* nine) {
  constexpr std::size_t kColumns = 2 * kMaxFilterRadius + 3 + 16;
  float vertical[3][kColumns];
  const int length = 2 * filter.radius + 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(length) + 2; i += hn::Lanes(kFloats)) {
    Floats first = hn::Zero(kFloats), second = first, third = first;
    for (int r = 0; r < length + 2; ++r) {  // each row of pixels serves up to three rows of sums
      const Floats row = load(pixels + r * stride + i);
      const auto tap = [&](int k) HWY_ATTR { return hn::Set(kFloats, filter.taps[static_cast<std::size_t>(k)]); };
      if (r < length) first = hn::MulAdd(row, tap(r), first);
      if (r >= 1 && r <= length) second = hn::MulAdd(row, tap(r - 1), second);
      if (r >= 2) third = hn::MulAdd(row, tap(r - 2), third);
    }
    hn::StoreU(first, kFloats, vertical[0] + i);
    hn::StoreU(second, kFloats, vertical[1] + i);
    hn::StoreU(third, kFloats, vertical[2] + i);
  }
  float sums[9] = {};
  for (int k = 0; k < length; ++k)  // nine sums side by side: none waits for another
    for (int row = 0; row < 3; ++row)
      for (int shift = 0; shift < 3; ++shift)
        sums[3 * row + shift] += vertical[row][k + shift] * filter.taps[static_cast<std::size_t>(k)];
  for (int i = 0; i < 9; ++i) nine[i] = sums[i];
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace
}  // namespace vignole::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole {

HWY_EXPORT(findCandidates);
HWY_EXPORT(testCandidates);
HWY_EXPORT(smoothNine);
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

namespace {

constexpr std::size_t kBehind = 64;  // more than any vector

template <class Vector>
void grow(Vector& values, std::size_t count) {
  if (values.size() < count + kBehind) values.resize(count + kBehind);
}

}  // namespace

void RidgeArrays::reserve(std::size_t count) {
  for (auto* v : {&x, &y, &nx, &ny, &ridge, &smoothed, &along}) grow(*v, count);
  grow(pixel, count);
}

void RidgeArrays::push(const RidgePoint& p) {
  x[size] = p.x;
  y[size] = p.y;
  nx[size] = p.nx;
  ny[size] = p.ny;
  ridge[size] = p.ridge;
  smoothed[size] = p.smoothed;
  along[size] = p.along;
  pixel[size++] = p.pixel;
}

void RidgeArrays::append(const RidgeArrays& from, std::span<const std::uint32_t> order) {
  const auto take = [&](auto RidgeArrays::*field) {
    auto* to = (this->*field).data() + size;
    const auto* source = (from.*field).data();
    for (std::size_t k = 0; k < order.size(); ++k) to[k] = source[order[k]];
  };
  for (auto field : {&RidgeArrays::x, &RidgeArrays::y, &RidgeArrays::nx, &RidgeArrays::ny, &RidgeArrays::ridge,
                     &RidgeArrays::smoothed, &RidgeArrays::along})
    take(field);
  take(&RidgeArrays::pixel);
  size += order.size();
}

void RidgeCandidates::reserve(std::size_t count) {
  for (auto* v : {&dx, &dy, &dxx, &dxy, &dyy, &smoothed}) grow(*v, count);
  grow(pixel, count);
}

void findRidgeCandidates(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int height, int column, int row,
                         const RidgeFilter& filter, RidgeBand& band, RidgeCandidates& candidates) {
  HWY_DYNAMIC_DISPATCH(findCandidates)(pixels, stride, width, height, column, row, filter, band, candidates);
}

void testRidgeCandidates(const RidgeCandidates& candidates, float leastRidge, RidgeArrays& points) {
  points.reserve(candidates.size);
  HWY_DYNAMIC_DISPATCH(testCandidates)(candidates, leastRidge, points);
}

std::array<float, 9> smoothedAround(const std::uint8_t* pixels, std::ptrdiff_t stride, const RidgeFilter& filter) {
  std::array<float, 9> nine{};
  HWY_DYNAMIC_DISPATCH(smoothNine)(pixels, stride, filter, nine.data());
  return nine;
}

const char* simdTargetName() { return HWY_DYNAMIC_DISPATCH(targetName)(); }

}  // namespace vignole
#endif
