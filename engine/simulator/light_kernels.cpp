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

/// Numbers too small for a normal float count as 0 while this lives: the far ends of the kernels are full of them, and
/// each costs more than all else of its row.
class FlushToZero {
 public:
#if HWY_ARCH_X86
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040U); }
  ~FlushToZero() { _mm_setcsr(before_); }
#else
  FlushToZero() = default;
  ~FlushToZero() = default;
#endif
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  [[maybe_unused]] unsigned before_ = 0;
};

/// One Gaussian, in strips as wide as a vector. Rows follow by recurrence, up and down from the middle: the ratio of
/// neighbouring rows is itself a geometric series, so a row costs two products instead of an exponential.
void addSplat(const Splat& splat, const SplatKernel& k, const Canvas::Area& area, std::ptrdiff_t stride) {
  const Floats d;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  constexpr float kHalf = 0.5F;
  constexpr float kMostLean = 80;  // far beside the kernel, where all is 0, the ratio must stay finite
  const float dy = static_cast<float>(area.y) - splat.y;
  const auto down = hn::Set(d, std::exp(-k.c * (kHalf + dy))), up = hn::Set(d, std::exp(-k.c * (kHalf - dy)));
  const auto bend = hn::Set(d, k.bend);
  for (int x = 0; x < area.columns; x += lanes) {
    const auto dx = hn::Add(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(area.left + x) - splat.x));
    // Exponent at the middle row; written so that the two halves cannot overflow one another.
    const auto exponent = hn::MulAdd(hn::Mul(hn::Set(d, -kHalf * k.a), dx), dx,
                                     hn::MulAdd(hn::Set(d, -k.b * dy), dx, hn::Set(d, -kHalf * k.c * dy * dy)));
    const auto start = hn::Mul(hn::Exp(d, exponent), hn::Set(d, splat.energy * k.scale));
    const auto lean = hn::Mul(hn::Set(d, -k.b), dx);
    const auto tilt = hn::Exp(d, hn::Min(hn::Max(lean, hn::Set(d, -kMostLean)), hn::Set(d, kMostLean)));
    const auto write = [d](float* at, hn::Vec<Floats> v) { hn::Store(hn::Add(hn::Load(d, at), v), d, at); };

    float* below = area.row + area.left + x;
    float* above = below;
    write(below, start);
    auto valueBelow = start, valueAbove = start;
    auto ratioBelow = hn::Mul(tilt, down), ratioAbove = hn::Div(up, tilt);
    for (int i = 0; i < k.halfHeight; ++i) {
      valueBelow = hn::Mul(valueBelow, ratioBelow);
      valueAbove = hn::Mul(valueAbove, ratioAbove);
      ratioBelow = hn::Mul(ratioBelow, bend);
      ratioAbove = hn::Mul(ratioAbove, bend);
      below += stride;
      above -= stride;
      write(below, valueBelow);
      write(above, valueAbove);
    }
  }
}

void addSplats(const std::vector<Splat>& splats, const std::vector<SplatKernel>& kernels, Canvas& canvas) {
  const FlushToZero flush;
  for (const Splat& splat : splats) {
    const SplatKernel& kernel = kernels[splat.kernel];
    if (const auto area = canvas.reserve(splat, kernel)) addSplat(splat, kernel, *area, canvas.stride());
  }
}

/// One row of a block.
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

void developTouched(Canvas& canvas, const DevelopSettings& settings, const MutableImageView& image) {
  const std::uint64_t shift = hash(settings.key, Stream::SpeckleOffset, {});
  const auto shiftX = static_cast<int>(shift % kSpeckleSize), shiftY = static_cast<int>((shift >> 20) % kSpeckleSize);
  for (int by = 0; by < canvas.blocksY; ++by)
    for (int bx = 0; bx < canvas.blocksX; ++bx) {
      const int block = by * canvas.blocksX + bx;
      std::uint8_t& touched = canvas.touched[static_cast<std::size_t>(block)];
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
        developRow(canvas.row(y) + x0, speckle, normals + static_cast<std::ptrdiff_t>(i) * kBlock, settings, pixels);
        if (y < image.height) std::memcpy(image.row(y) + x0, pixels, static_cast<std::size_t>(columns));
      }
    }
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace vignole::simulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole::simulator {

HWY_EXPORT(addSplats);
HWY_EXPORT(developTouched);
HWY_EXPORT(targetName);

const char* lightKernelTarget() { return HWY_DYNAMIC_DISPATCH(targetName)(); }

Canvas::Canvas(int width, int height)
    : blocksX((width + kBlock - 1) / kBlock),
      blocksY((height + kBlock - 1) / kBlock),
      width_(width),
      height_(height),
      // An odd number of lines: the rows of a column spread over all sets of the cache.
      linesPerRow_((blocksX + 2 * kMargin / kBlock) | 1),
      data_(static_cast<std::size_t>(linesPerRow_ * (blocksY * kBlock + 2 * kMargin))) {
  const int blocks = blocksX * blocksY;
  touched.assign(static_cast<std::size_t>(blocks), 0);
}

std::optional<Canvas::Area> Canvas::reserve(const Splat& splat, const SplatKernel& kernel) {
  // Written so that NaN falls through.
  if (!(splat.x > -kMargin && splat.x < static_cast<float>(width_ + kMargin) && splat.y > -kMargin &&
        splat.y < static_cast<float>(height_ + kMargin)))
    return {};
  const auto block = [](float px) { return static_cast<int>(std::floor(px / kBlock)); };
  const int b0 = block(splat.x - kernel.halfWidth), b1 = block(splat.x + kernel.halfWidth);
  const int y = static_cast<int>(std::lround(splat.y));
  const int top = y - kernel.halfHeight, bottom = y + kernel.halfHeight;
  constexpr int kMarginBlocks = kMargin / kBlock;
  if (b0 < -kMarginBlocks || top < -kMargin || b1 >= blocksX + kMarginBlocks || bottom >= blocksY * kBlock + kMargin)
    return {};
  if (b0 < 0 || top < 0 || b1 >= blocksX || bottom >= blocksY * kBlock) marginTouched_ = true;
  if (bottom >= 0) {
    const int r0 = std::max(0, top) / kBlock, r1 = std::min(bottom / kBlock, blocksY - 1);
    for (int r = r0; r <= r1; ++r)
      for (int b = std::max(0, b0); b <= std::min(b1, blocksX - 1); ++b) {
        const int lit = r * blocksX + b;
        touched[static_cast<std::size_t>(lit)] = 1;
      }
  }
  return Area{row(y), b0 * kBlock, (b1 - b0 + 1) * kBlock, y};
}

void Canvas::add(const std::vector<Splat>& splats, const std::vector<SplatKernel>& kernels) {
  HWY_DYNAMIC_DISPATCH(addSplats)(splats, kernels, *this);
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
  HWY_DYNAMIC_DISPATCH(developTouched)(canvas, settings, image);
  canvas.clearMargin();
}

}  // namespace vignole::simulator
#endif  // HWY_ONCE
