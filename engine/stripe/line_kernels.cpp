#include "engine/stripe/line_kernels.h"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/stripe/line_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vignole::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

const hn::ScalableTag<float> kFloats;
const hn::Rebind<std::uint32_t, decltype(kFloats)> kWords;
const hn::Rebind<std::int32_t, decltype(kFloats)> kInts;
using Floats = hn::Vec<decltype(kFloats)>;

HWY_INLINE Floats load(const PaddedFloats& from, std::size_t i) { return hn::LoadU(kFloats, from.data() + i); }
HWY_INLINE void store(Floats v, PaddedFloats& to, std::size_t i) { hn::StoreU(v, kFloats, to.data() + i); }
HWY_INLINE Floats set(float v) { return hn::Set(kFloats, v); }

void light(LinePoints& p, float variance) {
  const Floats filter = set(variance), quarter = set(0.25F);
  const Floats one = set(1);
  for (std::size_t i = 0; i < p.size; i += hn::Lanes(kFloats)) {
    const Floats x = load(p.x, i), y = load(p.y, i), nx = load(p.nx, i), ny = load(p.ny, i);
    const Floats bright = hn::Max(load(p.light, i), one);
    const auto pixel = hn::LoadU(kWords, p.pixel.data() + i);
    const Floats column = hn::ConvertTo(kFloats, hn::BitCast(kInts, hn::And(pixel, hn::Set(kWords, 0xFFFFU))));
    const Floats row = hn::ConvertTo(kFloats, hn::BitCast(kInts, hn::ShiftRight<16>(pixel)));
    const Floats t = hn::MulAdd(hn::Sub(x, column), nx, hn::Mul(hn::Sub(y, row), ny));
    const Floats slanted = hn::Mul(hn::Mul(nx, nx), hn::Mul(ny, ny));
    // The smoothed line is L exp(a u - w^2 / 2 v), u along it, w across. Its logarithm is a parabola whose offset and
    // direction have no error of third order and none where the brightness changes along the line, which turns the
    // normal of the picture itself away by t a.
    const Floats perLight = hn::Div(one, bright), curved = hn::Mul(load(p.ridge, i), perLight);
    const Floats across = hn::Mul(t, curved), along = hn::Mul(load(p.along, i), perLight);
    const Floats logCurved = hn::MulAdd(across, across, curved), perCurved = hn::Div(one, logCurved);
    const Floats most = set(0.3F);
    const Floats turn = hn::Max(hn::Neg(most), hn::Min(most, hn::Mul(hn::Mul(across, along), perCurved)));
    const Floats turnedX = hn::NegMulAdd(turn, ny, nx), turnedY = hn::MulAdd(turn, nx, ny);
    const Floats unit = hn::Div(one, hn::Sqrt(hn::MulAdd(turn, turn, one)));
    // By differences instead of derivatives v is too large by (1 + p) / 4 and the offset short by (1 - 5 p) / (4 v).
    const Floats apparent = hn::NegMulAdd(quarter, hn::Add(one, slanted), perCurved);
    const Floats v = hn::Max(apparent, hn::Add(filter, quarter)), s2 = hn::Sub(v, filter);
    const Floats stretch = hn::Div(hn::Mul(quarter, hn::NegMulAdd(set(5), slanted, one)), v);
    const Floats offset = hn::Mul(hn::MulAdd(turn, along, across), hn::Mul(perCurved, hn::Add(one, stretch)));
    const Floats unitX = hn::Mul(turnedX, unit), unitY = hn::Mul(turnedY, unit), way = hn::Mul(offset, unit);
    store(hn::MulAdd(way, unitX, column), p.x, i);
    store(hn::MulAdd(way, unitY, row), p.y, i);
    store(unitX, p.nx, i);
    store(unitY, p.ny, i);
    store(bright, p.light, i);
    store(s2, p.s2, i);
    store(hn::Mul(bright, hn::Sqrt(hn::Div(v, s2))), p.strength, i);
  }
}

void orient(LinePoints& p) {
  for (std::size_t i = 0; i < p.size; i += hn::Lanes(kFloats)) {
    const float *xs = p.x.data() + i, *ys = p.y.data() + i;
    const Floats x = hn::LoadU(kFloats, xs), y = hn::LoadU(kFloats, ys);
    const Floats nextX = hn::LoadU(kFloats, xs + 1), nextY = hn::LoadU(kFloats, ys + 1);
    const Floats alongX = hn::Sub(nextX, hn::LoadU(kFloats, xs - 1)),
                 alongY = hn::Sub(nextY, hn::LoadU(kFloats, ys - 1));
    const Floats nx = load(p.nx, i), ny = load(p.ny, i);
    const auto wrong = hn::Lt(hn::Mul(alongX, ny), hn::Mul(alongY, nx));
    store(hn::IfThenElse(wrong, hn::Neg(nx), nx), p.nx, i);
    store(hn::IfThenElse(wrong, hn::Neg(ny), ny), p.ny, i);
    const Floats dx = hn::Sub(nextX, x), dy = hn::Sub(nextY, y);
    store(hn::Sqrt(hn::MulAdd(dx, dx, hn::Mul(dy, dy))), p.step, i);
  }
}

void ridgeSigma(LinePoints& p, float gradient, float speckle, float variance) {
  // speckleGain() of uncertainty.cpp, position part: common m2 / sigma^4.
  constexpr auto kRootPi = static_cast<float>(1 / std::numbers::inv_sqrtpi);
  const float alongLine = 1 / (2 * kRootPi * std::sqrt(variance));
  const float factor =
      speckle * alongLine / (2 * std::numbers::pi_v<float> * variance) * (kRootPi / 2) / (variance * variance);
  for (std::size_t i = 0; i < p.size; i += hn::Lanes(kFloats)) {
    const Floats noise = hn::Div(set(gradient), load(p.ridge, i));
    const Floats s2 = load(p.s2, i), v = hn::Add(s2, set(variance));
    const Floats q2 = hn::Div(hn::Mul(set(variance), s2), v), q3 = hn::Mul(q2, hn::Sqrt(q2));
    const Floats gain = hn::Div(hn::Mul(hn::Mul(v, v), hn::Mul(v, q3)), s2);
    store(hn::Sqrt(hn::MulAdd(noise, noise, hn::Mul(set(factor), gain))), p.sigma, i);
  }
}

void brightening(LinePoints& p) {
  constexpr std::ptrdiff_t kReach = 5;
  const Floats reach = set(kReach);
  for (std::size_t i = 0; i < p.size; i += hn::Lanes(kFloats)) {
    // Slope of a straight line through the strengths, over their mean.
    Floats slope = hn::Zero(kFloats), sum = load(p.strength, i);
    for (std::ptrdiff_t k = 1; k <= kReach; ++k) {
      const Floats before = hn::LoadU(kFloats, p.strength.data() + i - k);
      const Floats behind = hn::LoadU(kFloats, p.strength.data() + i + k);
      slope = hn::MulAdd(set(static_cast<float>(k)), hn::Sub(behind, before), slope);
      sum = hn::Add(sum, hn::Add(before, behind));
    }
    const Floats way =
        hn::Sub(hn::LoadU(kFloats, p.arc.data() + i + kReach), hn::LoadU(kFloats, p.arc.data() + i - kReach));
    // sum k^2 = 55 to either side, 2 kReach + 1 strengths, way / (2 kReach) px from one to the next
    constexpr float kFactor = 11.0F * 10 / 110;
    const Floats relative = hn::Div(hn::Mul(set(kFactor), slope), hn::Mul(sum, way));
    store(hn::IfThenElseZero(hn::Ge(load(p.room, i), reach), relative), p.brightening, i);
  }
}

/// Sums for the parabola w = c0 + c1 u + c2 u^2 in the frame of a point, u along the line, w along its normal.
struct Moments {
  Floats s0, s1, s2, s3, s4, w0, w1, w2, ww;
};

void smooth(LinePoints& p, const LineSmoothing& smoothing) {
  constexpr float kScatter = 3;   // standard deviations of what noise alone leaves
  constexpr float kScalePx = 16;  // u and w in units in which their powers stay near 1
  const Floats perScale = set(1 / kScalePx);
  const Floats zero = hn::Zero(kFloats);
  for (std::size_t i = 0; i < p.size; i += hn::Lanes(kFloats)) {
    const Floats x = load(p.x, i), y = load(p.y, i), sigma = load(p.sigma, i), room = load(p.room, i);
    const Floats nx = hn::Mul(load(p.nx, i), perScale), ny = hn::Mul(load(p.ny, i), perScale);
    Moments m{set(1), zero, zero, zero, zero, zero, zero, zero, zero};
    Floats bend = zero, place = zero, variance = hn::Mul(sigma, sigma);
    auto active = hn::Ge(room, set(smoothing.windows[0].room));
    for (const SmoothingWindow& window : smoothing.windows) {
      active = hn::And(active, hn::Ge(room, set(window.room)));
      if (hn::AllFalse(kFloats, active)) break;
      const Floats weight = set(window.weight);
      for (int k = 0; k < window.count; ++k)
        for (const std::ptrdiff_t offset :
             {-window.offsets[static_cast<std::size_t>(k)], window.offsets[static_cast<std::size_t>(k)]}) {
          const Floats dx = hn::Sub(hn::LoadU(kFloats, p.x.data() + i + offset), x);
          const Floats dy = hn::Sub(hn::LoadU(kFloats, p.y.data() + i + offset), y);
          const Floats u = hn::NegMulAdd(dy, nx, hn::Mul(dx, ny)), w = hn::MulAdd(dx, nx, hn::Mul(dy, ny));
          const Floats mu = hn::Mul(weight, u), u2 = hn::Mul(u, u), mu2 = hn::Mul(mu, u);
          m.s0 = hn::Add(m.s0, weight);
          m.s1 = hn::Add(m.s1, mu);
          m.s2 = hn::Add(m.s2, mu2);
          m.s3 = hn::MulAdd(mu, u2, m.s3);
          m.s4 = hn::MulAdd(mu2, u2, m.s4);
          m.w0 = hn::MulAdd(weight, w, m.w0);
          m.w1 = hn::MulAdd(mu, w, m.w1);
          m.w2 = hn::MulAdd(mu2, w, m.w2);
          m.ww = hn::MulAdd(hn::Mul(weight, w), w, m.ww);
        }
      const Floats a00 = hn::MulSub(m.s2, m.s4, hn::Mul(m.s3, m.s3));
      const Floats a01 = hn::MulSub(m.s2, m.s3, hn::Mul(m.s1, m.s4));
      const Floats a02 = hn::MulSub(m.s1, m.s3, hn::Mul(m.s2, m.s2));
      const Floats a11 = hn::MulSub(m.s0, m.s4, hn::Mul(m.s2, m.s2));
      const Floats a12 = hn::MulSub(m.s1, m.s2, hn::Mul(m.s0, m.s3));
      const Floats a22 = hn::MulSub(m.s0, m.s2, hn::Mul(m.s1, m.s1));
      const Floats determinant = hn::MulAdd(m.s0, a00, hn::MulAdd(m.s1, a01, hn::Mul(m.s2, a02)));
      const Floats per = hn::Div(set(1), determinant);
      const Floats c0 = hn::Mul(per, hn::MulAdd(a00, m.w0, hn::MulAdd(a01, m.w1, hn::Mul(a02, m.w2))));
      const Floats c2 = hn::Mul(per, hn::MulAdd(a02, m.w0, hn::MulAdd(a12, m.w1, hn::Mul(a22, m.w2))));
      const Floats c1 = hn::Mul(per, hn::MulAdd(a01, m.w0, hn::MulAdd(a11, m.w1, hn::Mul(a12, m.w2))));
      const Floats scatter = hn::NegMulAdd(c0, m.w0, hn::NegMulAdd(c1, m.w1, hn::NegMulAdd(c2, m.w2, m.ww)));
      // In px: place = 16 c0, bend = c2 / 16. A bend that is not larger than its noise is taken off in part.
      const Floats sigma2 = hn::Mul(sigma, sigma), b = hn::Mul(c2, perScale), b2 = hn::Mul(b, b);
      const Floats share = hn::Div(b2, hn::MulAdd(set(window.ofBend), sigma2, b2));
      const Floats trusted = hn::Mul(share, set(smoothing.pullPx2));
      const Floats spread2 = hn::Div(m.s2, m.s0), circle = hn::Mul(hn::Mul(c2, c2), hn::Mul(c2, set(window.ofCircle)));
      const Floats centred = hn::NegMulAdd(circle, hn::Mul(spread2, spread2), c0);
      const Floats at = hn::NegMulAdd(trusted, b, hn::Mul(centred, set(kScalePx)));
      const Floats factor =
          hn::MulAdd(trusted, hn::MulSub(trusted, set(window.ofBend), set(2 * window.covariance)), set(window.ofPlace));
      // What noise alone leaves; more of it says that the line is no parabola here, and the answer as much less sure.
      const Floats expected = hn::Mul(sigma2, set(window.scatter / (kScalePx * kScalePx)));
      active =
          hn::And(active, hn::Le(scatter, hn::Mul(expected, set(1 + kScatter * window.scatterSd / window.scatter))));
      const Floats excess = hn::Max(set(1), hn::Div(scatter, expected));
      const Floats spread = hn::Mul(hn::Mul(sigma2, factor), excess);
      place = hn::IfThenElse(active, at, place);
      bend = hn::IfThenElse(active, hn::Mul(share, b), bend);
      variance = hn::IfThenElse(active, spread, variance);
    }
    store(bend, p.bend, i);
    store(smoothing.applied ? place : zero, p.shift, i);
    store(smoothing.applied ? hn::Sqrt(variance) : sigma, p.shiftedSigma, i);
  }
}

}  // namespace
}  // namespace vignole::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole {

HWY_EXPORT(light);
HWY_EXPORT(orient);
HWY_EXPORT(ridgeSigma);
HWY_EXPORT(smooth);
HWY_EXPORT(brightening);

void measureLight(LinePoints& points, float filterVariancePx2) {
  HWY_DYNAMIC_DISPATCH(light)(points, filterVariancePx2);
}

void orientNormals(LinePoints& points) { HWY_DYNAMIC_DISPATCH(orient)(points); }

void setRidgeSigma(LinePoints& points, float gradientNoiseDn, float speckle, float filterVariancePx2) {
  HWY_DYNAMIC_DISPATCH(ridgeSigma)(points, gradientNoiseDn, speckle, filterVariancePx2);
}

void smoothAlong(LinePoints& points, const LineSmoothing& smoothing) {
  HWY_DYNAMIC_DISPATCH(smooth)(points, smoothing);
}

void setBrightening(LinePoints& points) { HWY_DYNAMIC_DISPATCH(brightening)(points); }

}  // namespace vignole
#endif
