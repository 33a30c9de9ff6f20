#include "engine/registration/pose_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/registration/pose_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vignole::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

const hn::ScalableTag<float> kFloats;
const hn::RebindToSigned<decltype(kFloats)> kInts;
using Floats = hn::Vec<decltype(kFloats)>;
using Ints = hn::Vec<decltype(kInts)>;
using Mask = hn::Mask<decltype(kFloats)>;

HWY_INLINE Floats all(float value) { return hn::Set(kFloats, value); }

struct Place {
  Floats x, y;
};
HWY_INLINE Place moved(const Points& points, const Motion& m, std::size_t i) {
  const Floats px = hn::LoadU(kFloats, points.x + i), py = hn::LoadU(kFloats, points.y + i);
  return {hn::NegMulAdd(all(m.sine), py, hn::MulAdd(all(m.cosine), px, all(m.x))),
          hn::MulAdd(all(m.cosine), py, hn::MulAdd(all(m.sine), px, all(m.y)))};
}

/// Signed distance and outward normal.
struct Foot {
  Floats residual, nx, ny;
};
HWY_INLINE Foot footOnLine(Place p, Floats nx, Floats ny, Floats offset) {
  return {hn::MulAdd(nx, p.x, hn::MulSub(ny, p.y, offset)), nx, ny};
}
HWY_INLINE Foot footOnCircle(Place p, Floats centreX, Floats centreY, Floats radius, Floats side) {
  const Floats dx = hn::Sub(p.x, centreX), dy = hn::Sub(p.y, centreY);
  // The centre itself has no normal; a micrometre beside it has one.
  const Floats distance = hn::Sqrt(hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, all(1e-12F))));
  const Floats unit = hn::Div(side, distance);
  return {hn::Mul(side, hn::Sub(distance, radius)), hn::Mul(dx, unit), hn::Mul(dy, unit)};
}

struct Sums {
  Floats xx, xy, xa, yy, ya, aa, bx, by, ba, w, rr;
};
HWY_INLINE Sums noSums() {
  const Floats none = hn::Zero(kFloats);
  return {none, none, none, none, none, none, none, none, none, none, none};
}

HWY_INLINE void add(Place p, const Foot& foot, Mask wanted, float centreY, Floats perScale2, Sums& s) {
  const Floats r = foot.residual, nx = foot.nx, ny = foot.ny;
  const Floats u = hn::Max(hn::Zero(kFloats), hn::NegMulAdd(hn::Mul(r, r), perScale2, all(1)));
  const Floats w = hn::IfThenElseZero(wanted, hn::Mul(u, u));
  const Floats turn = hn::NegMulAdd(hn::Sub(p.y, all(centreY)), nx, hn::Mul(p.x, ny));
  const Floats wx = hn::Mul(w, nx), wy = hn::Mul(w, ny), wa = hn::Mul(w, turn), wr = hn::Mul(w, r);
  s.xx = hn::MulAdd(wx, nx, s.xx);
  s.xy = hn::MulAdd(wx, ny, s.xy);
  s.xa = hn::MulAdd(wx, turn, s.xa);
  s.yy = hn::MulAdd(wy, ny, s.yy);
  s.ya = hn::MulAdd(wy, turn, s.ya);
  s.aa = hn::MulAdd(wa, turn, s.aa);
  s.bx = hn::MulAdd(wx, r, s.bx);
  s.by = hn::MulAdd(wy, r, s.by);
  s.ba = hn::MulAdd(wa, r, s.ba);
  s.w = hn::Add(s.w, w);
  s.rr = hn::MulAdd(wr, r, s.rr);
}

HWY_INLINE double total(Floats v) { return static_cast<double>(hn::GetLane(hn::SumOfLanes(kFloats, v))); }

HWY_INLINE void addTo(NormalEquations& e, const Sums& s) {
  e.xx += total(s.xx);
  e.xy += total(s.xy);
  e.xa += total(s.xa);
  e.yy += total(s.yy);
  e.ya += total(s.ya);
  e.aa += total(s.aa);
  e.bx += total(s.bx);
  e.by += total(s.by);
  e.ba += total(s.ba);
  e.weight += total(s.w);
  e.weightedSquares += total(s.rr);
}

void locateCells(const Points& points, const Motion& motion, const CellFrame& f, std::int32_t* cells) {
  const Floats lastColumn = all(static_cast<float>(f.columns - 1)), lastRow = all(static_cast<float>(f.rows - 1));
  const Ints columns = hn::Set(kInts, f.columns);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(kFloats)) {
    const Place p = moved(points, motion, i);
    // Converting cuts towards zero, which below zero the rim hides.
    const auto inside = [&](Floats v, Floats last)
                            HWY_ATTR { return hn::ConvertTo(kInts, hn::Min(hn::Max(v, hn::Zero(kFloats)), last)); };
    const Ints column = inside(hn::Mul(hn::Sub(p.x, all(f.x0)), all(f.perCell)), lastColumn);
    const Ints row = inside(hn::Mul(hn::Sub(p.y, all(f.y0)), all(f.perCell)), lastRow);
    hn::StoreU(hn::Add(hn::Mul(row, columns), column), kInts, cells + i);
  }
}

double scattered(const Points& points, const Motion& motion, const FlatCarrier* carriers, const std::int32_t* carrierOf,
                 const Tukey& tukey, NormalEquations& equations) {
  const float* table = &carriers->ax;
  const Floats perScale2 = all(1 / (tukey.scaleMm * tukey.scaleMm));
  Sums sums = noSums();
  Floats cost = hn::Zero(kFloats);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(kFloats)) {
    const Place p = moved(points, motion, i);
    const Mask wanted = hn::FirstN(kFloats, points.count - i);
    const Ints code = hn::IfThenElseZero(hn::RebindMask(kInts, wanted), hn::LoadU(kInts, carrierOf + i));
    const Mask far = hn::RebindMask(kFloats, hn::Gt(code, hn::Set(kInts, kFarAway - 1)));
    const Ints at = hn::ShiftLeft<2>(hn::And(code, hn::Set(kInts, kFarAway - 1)));
    const Floats ax = hn::GatherIndex(kFloats, table, at), ay = hn::GatherIndex(kFloats, table + 1, at),
                 c = hn::GatherIndex(kFloats, table + 2, at), side = hn::GatherIndex(kFloats, table + 3, at);
    const Mask line = hn::Eq(side, hn::Zero(kFloats));
    const Foot a = footOnLine(p, ax, ay, c), b = footOnCircle(p, ax, ay, c, side);
    const Foot foot{hn::IfThenElse(line, a.residual, b.residual), hn::IfThenElse(line, a.nx, b.nx),
                    hn::IfThenElse(line, a.ny, b.ny)};
    add(p, foot, wanted, tukey.centreY, perScale2, sums);
    const Floats squared = hn::IfThenElse(far, all(1), hn::Min(all(1), hn::Mul(foot.residual, foot.residual)));
    cost = hn::Add(cost, hn::IfThenElseZero(wanted, squared));
  }
  addTo(equations, sums);
  return total(cost);
}

void ofRuns(const Points& points, const Motion& motion, const FlatCarrier* carriers, std::span<const Run> runs,
            const Tukey& tukey, NormalEquations& equations) {
  const Floats perScale2 = all(1 / (tukey.scaleMm * tukey.scaleMm));
  Sums sums = noSums();
  for (const Run& run : runs) {
    const FlatCarrier& carrier = carriers[run.primitive];
    const Floats ax = all(carrier.ax), ay = all(carrier.ay), c = all(carrier.c), side = all(carrier.side);
    for (std::size_t i = run.from; i < run.to; i += hn::Lanes(kFloats)) {
      const Place p = moved(points, motion, i);
      const Foot foot = carrier.side == 0 ? footOnLine(p, ax, ay, c) : footOnCircle(p, ax, ay, c, side);
      add(p, foot, hn::FirstN(kFloats, run.to - i), tukey.centreY, perScale2, sums);
    }
  }
  addTo(equations, sums);
}

RunResiduals ofRun(const Points& points, const float* sigmaMm, const Motion& motion, const FlatCarrier& carrier,
                   const Run& run, const ResidualLimits& limits, float* residuals) {
  const Floats ax = all(carrier.ax), ay = all(carrier.ay), c = all(carrier.c), side = all(carrier.side);
  const Floats one = all(1), none = hn::Zero(kFloats);
  Floats assigned = none, sum = none, squares = none, chi2 = none, near = none, nearChi2 = none, inliers = none,
         inlierSquares = none, inlierVariance = none;
  for (std::size_t i = run.from; i < run.to; i += hn::Lanes(kFloats)) {
    const Place p = moved(points, motion, i);
    const Floats r = (carrier.side == 0 ? footOnLine(p, ax, ay, c) : footOnCircle(p, ax, ay, c, side)).residual;
    hn::StoreU(r, kFloats, residuals + i);
    const Floats distance = hn::Abs(r), r2 = hn::Mul(r, r), sigma = hn::LoadU(kFloats, sigmaMm + i);
    const Floats variance = hn::Mul(sigma, sigma), inSigmas = hn::Div(r2, variance);
    const Mask taken = hn::And(hn::FirstN(kFloats, run.to - i), hn::Le(distance, all(limits.assignMm)));
    const Mask isNear = hn::And(taken, hn::Lt(distance, all(limits.nearMm)));
    const Mask inlier = hn::And(taken, hn::Lt(distance, hn::Max(hn::Mul(all(3), sigma), all(limits.inlierMm))));
    assigned = hn::Add(assigned, hn::IfThenElseZero(taken, one));
    sum = hn::Add(sum, hn::IfThenElseZero(taken, r));
    squares = hn::Add(squares, hn::IfThenElseZero(taken, r2));
    chi2 = hn::Add(chi2, hn::IfThenElseZero(taken, inSigmas));
    near = hn::Add(near, hn::IfThenElseZero(isNear, one));
    nearChi2 = hn::Add(nearChi2, hn::IfThenElseZero(isNear, inSigmas));
    inliers = hn::Add(inliers, hn::IfThenElseZero(inlier, one));
    inlierSquares = hn::Add(inlierSquares, hn::IfThenElseZero(inlier, r2));
    inlierVariance = hn::Add(inlierVariance, hn::IfThenElseZero(inlier, variance));
  }
  return {total(assigned), total(sum),     total(squares),       total(chi2),          total(near),
          total(nearChi2), total(inliers), total(inlierSquares), total(inlierVariance)};
}

}  // namespace
}  // namespace vignole::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole {

HWY_EXPORT(locateCells);
HWY_EXPORT(scattered);
HWY_EXPORT(ofRuns);
HWY_EXPORT(ofRun);

void locate(const Points& points, const Motion& motion, const CellFrame& frame, std::int32_t* cells) {
  HWY_DYNAMIC_DISPATCH(locateCells)(points, motion, frame, cells);
}

double sumScattered(const Points& points, const Motion& motion, const FlatCarrier* carriers,
                    const std::int32_t* carrierOf, const Tukey& tukey, NormalEquations& sums) {
  return HWY_DYNAMIC_DISPATCH(scattered)(points, motion, carriers, carrierOf, tukey, sums);
}

void sumRuns(const Points& points, const Motion& motion, const FlatCarrier* carriers, std::span<const Run> runs,
             const Tukey& tukey, NormalEquations& sums) {
  HWY_DYNAMIC_DISPATCH(ofRuns)(points, motion, carriers, runs, tukey, sums);
}

RunResiduals residualsOf(const Points& points, const float* sigmaMm, const Motion& motion, const FlatCarrier& carrier,
                         const Run& run, const ResidualLimits& limits, float* residuals) {
  return HWY_DYNAMIC_DISPATCH(ofRun)(points, sigmaMm, motion, carrier, run, limits, residuals);
}

}  // namespace vignole
#endif
