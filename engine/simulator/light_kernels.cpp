#include "engine/simulator/light_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/simulator/hashing.h"
#include "engine/simulator/surface.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/simulator/light_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vignole::simulator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;

/// One column strip (as wide as a vector) of one Gaussian. Rows follow by recurrence: the ratio of neighbouring rows is
/// itself a geometric series, so a row costs two products instead of an exponential.
void splatStrip(const Splat& splat, const SplatKernel& k, float* HWY_RESTRICT middle, std::ptrdiff_t stride, int first,
                float dy) {
  const Floats d;
  const auto dx = hn::Add(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(first) - splat.x));
  const float half = 0.5F;
  // Exponent at the middle row; written so that the two halves cannot overflow one another.
  const auto exponent = hn::MulAdd(hn::Mul(hn::Set(d, -half * k.a), dx), dx,
                                   hn::MulAdd(hn::Set(d, -k.b * dy), dx, hn::Set(d, -half * k.c * dy * dy)));
  const auto start = hn::Mul(hn::Exp(d, exponent), hn::Set(d, splat.energy * k.scale));
  const auto tilt = hn::Exp(d, hn::Mul(hn::Set(d, -k.b), dx));
  const auto bend = hn::Set(d, std::exp(-k.c));
  const auto write = [&](float* at, hn::Vec<Floats> v) { hn::StoreU(hn::Add(hn::LoadU(d, at), v), d, at); };

  write(middle + first, start);
  auto value = start;
  auto ratio = hn::Mul(tilt, hn::Set(d, std::exp(-k.c * (dy + half))));
  float* at = middle + first;
  for (int i = 0; i < k.halfHeight; ++i) {
    value = hn::Mul(value, ratio);
    ratio = hn::Mul(ratio, bend);
    at += stride;
    write(at, value);
  }
  value = start;
  ratio = hn::Div(hn::Set(d, std::exp(k.c * (dy - half))), tilt);
  at = middle + first;
  for (int i = 0; i < k.halfHeight; ++i) {
    value = hn::Mul(value, ratio);
    ratio = hn::Mul(ratio, bend);
    at -= stride;
    write(at, value);
  }
}

void addSplat(const Splat& splat, const SplatKernel& kernel, float* row, std::ptrdiff_t stride, int column, int y) {
  const int lanes = static_cast<int>(hn::Lanes(Floats()));
  const float dy = static_cast<float>(y) - splat.y;
  for (int x = column - kernel.halfWidth; x < column + kernel.halfWidth; x += lanes)
    splatStrip(splat, kernel, row, stride, x, dy);
}

/// One row of a block: 16 pixels.
void developRow(float* HWY_RESTRICT light, const float* HWY_RESTRICT speckle, const float* HWY_RESTRICT normals,
                const DevelopSettings& s, std::uint8_t* HWY_RESTRICT pixels) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const hn::Rebind<std::uint8_t, Floats> du;
  const auto zero = hn::Zero(d);
  for (int x = 0; x < kBlock; x += lanes) {
    const auto lit = hn::Mul(hn::Mul(hn::LoadU(d, light + x), hn::LoadU(d, speckle + x)), hn::Set(d, s.gain));
    hn::StoreU(zero, d, light + x);
    const auto signal = hn::Add(lit, hn::Set(d, s.ambientDn));
    const auto variance = hn::MulAdd(signal, hn::Set(d, s.shotPerDn), hn::Set(d, s.readVariance));
    const auto noisy = hn::MulAdd(hn::Sqrt(variance), hn::LoadU(d, normals + x), signal);
    const auto clipped = hn::Min(hn::Max(noisy, zero), hn::Set(d, 255.0F));
    hn::StoreU(hn::DemoteTo(du, hn::NearestInt(clipped)), du, pixels + x);
  }
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace vignole::simulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole::simulator {

HWY_EXPORT(addSplat);
HWY_EXPORT(developRow);
HWY_EXPORT(targetName);

const char* lightKernelTarget() { return HWY_DYNAMIC_DISPATCH(targetName)(); }

Canvas::Canvas(int width, int height)
    : blocksX((width + kBlock - 1) / kBlock),
      blocksY((height + kBlock - 1) / kBlock),
      width_(width),
      height_(height),
      stride_(blocksX * kBlock + 2 * kMargin),
      data_(static_cast<std::size_t>(stride_ * (blocksY * kBlock + 2 * kMargin)), 0.0F) {
  touched.assign(static_cast<std::size_t>(blocksX * blocksY), 0);
}

void Canvas::add(const std::vector<Splat>& splats, const std::vector<SplatKernel>& kernels) {
  const auto splatInto = HWY_DYNAMIC_DISPATCH(addSplat);
  for (const Splat& splat : splats) {
    const SplatKernel& kernel = kernels[splat.kernel];
    // Written so that NaN falls through.
    if (!(splat.x > -kMargin && splat.x < static_cast<float>(width_ + kMargin) && splat.y > -kMargin &&
          splat.y < static_cast<float>(height_ + kMargin)))
      continue;
    const int column = static_cast<int>(std::lround(splat.x)), y = static_cast<int>(std::lround(splat.y));
    const int left = column - kernel.halfWidth, right = column + kernel.halfWidth - 1;
    const int top = y - kernel.halfHeight, bottom = y + kernel.halfHeight;
    if (left < -kMargin || top < -kMargin || right >= blocksX * kBlock + kMargin ||
        bottom >= blocksY * kBlock + kMargin)
      continue;
    splatInto(splat, kernel, row(y), stride_, column, y);
    if (left < 0 || top < 0 || right >= blocksX * kBlock || bottom >= blocksY * kBlock) marginTouched_ = true;
    const int b0 = std::max(0, left) / kBlock, b1 = std::min(right / kBlock, blocksX - 1);
    const int r0 = std::max(0, top) / kBlock, r1 = std::min(bottom / kBlock, blocksY - 1);
    if (right < 0 || bottom < 0) continue;
    for (int r = r0; r <= r1; ++r)
      for (int b = b0; b <= b1; ++b) touched[static_cast<std::size_t>(r * blocksX + b)] = 1;
  }
}

void Canvas::clearMargin() {
  if (!marginTouched_) return;
  marginTouched_ = false;
  const int w = blocksX * kBlock, h = blocksY * kBlock;
  for (int y = -kMargin; y < h + kMargin; ++y) {
    float* r = row(y);
    if (y < 0 || y >= h) {
      std::fill(r - kMargin, r + w + kMargin, 0.0F);
    } else {
      std::fill(r - kMargin, r, 0.0F);
      std::fill(r + w, r + w + kMargin, 0.0F);
    }
  }
}

void develop(Canvas& canvas, const DevelopSettings& settings, const MutableImageView& image) {
  const auto developInto = HWY_DYNAMIC_DISPATCH(developRow);
  const std::uint64_t shift = hash(settings.key, Stream::SpeckleOffset, {});
  const auto shiftX = static_cast<int>(shift % kSpeckleSize), shiftY = static_cast<int>((shift >> 20) % kSpeckleSize);
  for (int by = 0; by < canvas.blocksY; ++by)
    for (int bx = 0; bx < canvas.blocksX; ++bx) {
      std::uint8_t& touched = canvas.touched[static_cast<std::size_t>(by * canvas.blocksX + bx)];
      if (touched == 0) continue;
      touched = 0;
      const std::uint64_t h =
          hash(settings.key, Stream::PixelNoise, {static_cast<std::uint64_t>(by * canvas.blocksX + bx)});
      const float* normals = settings.normals + h % (settings.normalCount - kBlock * kBlock);
      const int x0 = bx * kBlock;
      const int columns = std::min(kBlock, image.width - x0);
      for (int i = 0; i < kBlock; ++i) {
        const int y = by * kBlock + i;
        std::uint8_t pixels[kBlock];
        const float* speckle = settings.speckle +
                               static_cast<std::ptrdiff_t>((y + shiftY) % kSpeckleSize) * kSpeckleStride +
                               (x0 + shiftX) % kSpeckleSize;
        developInto(canvas.row(y) + x0, speckle, normals + i * kBlock, settings, pixels);
        if (y < image.height) std::memcpy(image.row(y) + x0, pixels, static_cast<std::size_t>(columns));
      }
    }
  canvas.clearMargin();
}

}  // namespace vignole::simulator
#endif  // HWY_ONCE
