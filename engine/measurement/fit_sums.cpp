#include "engine/measurement/fit_sums.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vignole {
namespace {

// Vectors that every machine has, and no fused operations: the same sums, to the last bit, on all of them.
using Floats = float __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(16)));

template <typename V>
using NumberOf = std::decay_t<decltype(V{}[0])>;
template <typename V>
constexpr std::size_t kLanes = sizeof(V) / sizeof(NumberOf<V>);

Floats all(Floats, double v) {
  const auto f = static_cast<float>(v);
  return Floats{f, f, f, f};
}
Doubles all(Doubles, double v) { return Doubles{v, v}; }
template <typename V>
V all(double v) {
  return all(V{}, v);
}

void load(const float* p, Floats& v) { std::memcpy(&v, p, sizeof v); }
void load(const float* p, Doubles& v) { v = Doubles{static_cast<double>(p[0]), static_cast<double>(p[1])}; }
template <typename V>
V load(const float* p) {
  V v;
  load(p, v);
  return v;
}

double total(Floats v) { return static_cast<double>((v[0] + v[2]) + (v[1] + v[3])); }
double total(Doubles v) { return v[0] + v[1]; }
Doubles root(Doubles v) { return Doubles{std::sqrt(v[0]), std::sqrt(v[1])}; }

/// Which of the next lanes are points of the run.
auto amongFirst(Floats, std::size_t left) { return Floats{0, 1, 2, 3} < all<Floats>(static_cast<double>(left)); }
auto amongFirst(Doubles, std::size_t left) { return Doubles{0, 1} < all<Doubles>(static_cast<double>(left)); }
template <typename V>
using Mask = decltype(V{} < V{});
bool none(Mask<Floats> m) { return (m[0] | m[1] | m[2] | m[3]) == 0; }
bool none(Mask<Doubles> m) { return (m[0] | m[1]) == 0; }

/// Weights of residuals, and their sums.
template <typename V>
class Judge {
 public:
  explicit Judge(const Weighting& weighting)
      : cut2_(all<V>(weighting.cut2)), perCut2_(all<V>(1 / weighting.cut2)), hard_(weighting.hard) {}
  /// The weight that a residual counts with; `among`: the points that belong here.
  V operator()(V r, V weight, Mask<V> among) {
    const V square = r * r, z2 = square * weight;
    const auto counts = among & (z2 < cut2_);
    chi2_ += counts ? z2 : V{};
    squares_ += counts ? square : V{};
    count_ += counts ? all<V>(1) : V{};
    const V w = counts ? weight : V{};
    if (hard_) return w;
    const V u = 1 - z2 * perCut2_;
    return w * u * u;
  }
  void addTo(ResidualSums& sums) const {
    sums.chi2 += total(chi2_);
    sums.squares += total(squares_);
    sums.count += total(count_);
  }

 private:
  V cut2_, perCut2_;
  bool hard_;
  V chi2_{}, squares_{}, count_{};
};

/// Which points of a vector lie on the stretch.
template <typename V>
class Within {
 public:
  explicit Within(const Stretch& s)
      : fromX_(all<V>(s.from.x)),
        fromY_(all<V>(s.from.y)),
        from_(all<V>(s.from.at)),
        toX_(all<V>(s.to.x)),
        toY_(all<V>(s.to.y)),
        to_(all<V>(s.to.at)) {}
  Mask<V> operator()(V x, V y) const { return (x * fromX_ + y * fromY_ > from_) & (x * toX_ + y * toY_ <= to_); }

 private:
  V fromX_, fromY_, from_, toX_, toY_, to_;
};

template <bool kBounded>
void addStraight(const FitPoints& points, const FitPoints::Run& run, const CurvePiece& piece, const Stretch& stretch,
                 const Weighting& weighting, FrameSums& sums) {
  using V = Floats;
  const Vec& t = piece.tangent;
  const Vec& o = piece.origin;
  const V tx = all<V>(t.x), ty = all<V>(t.y), t0 = all<V>(-t.x * o.x - t.y * o.y), r0 = all<V>(t.y * o.x - t.x * o.y);
  Judge<V> judge(weighting);
  const Within<V> within(stretch);
  V sumW{}, sumT{}, sumTT{}, sumR{}, sumTR{};
  for (std::size_t i = run.from; i < run.to; i += kLanes<V>) {
    const V x = load<V>(&points.x[i]), y = load<V>(&points.y[i]);
    auto among = amongFirst(V{}, run.to - i);
    if constexpr (kBounded) {
      among &= within(x, y);
      if (none(among)) continue;
    }
    const V along = tx * x + (ty * y + t0), r = tx * y + (r0 - ty * x);
    const V w = judge(r, load<V>(&points.weight[i]), among), wt = w * along, wr = w * r;
    sumW += w;
    sumT += wt;
    sumTT += wt * along;
    sumR += wr;
    sumTR += wr * along;
  }
  judge.addTo(sums.residuals);
  // J = (t.y, -t.x, -along): how the residual changes when the line moves and turns.
  const double w = total(sumW), wt = total(sumT), wr = total(sumR);
  sums.matrix[0][0] += t.y * t.y * w;
  sums.matrix[0][1] -= t.x * t.y * w;
  sums.matrix[0][2] -= t.y * wt;
  sums.matrix[1][1] += t.x * t.x * w;
  sums.matrix[1][2] += t.x * wt;
  sums.matrix[2][2] += total(sumTT);
  sums.vector[0] += t.y * wr;
  sums.vector[1] -= t.x * wr;
  sums.vector[2] -= total(sumTR);
}

/// In double: unknowns of a chain of arcs can hardly be told from each other by the points.
template <bool kBounded>
void addArc(const FitPoints& points, const FitPoints::Run& run, const CurvePiece& piece, const Stretch& stretch,
            const Weighting& weighting, FrameSums& sums) {
  using V = Doubles;
  const V tx = all<V>(piece.tangent.x), ty = all<V>(piece.tangent.y), ox = all<V>(piece.origin.x);
  const V oy = all<V>(piece.origin.y), k = all<V>(piece.curvature), least = all<V>(1e-12);
  Judge<V> judge(weighting);
  const Within<V> within(stretch);
  std::array<V, 10> matrix{};
  std::array<V, 4> vector{};
  for (std::size_t i = run.from; i < run.to; i += kLanes<V>) {
    const V x = load<V>(&points.x[i]), y = load<V>(&points.y[i]), pull = load<V>(&points.pull[i]);
    auto among = amongFirst(V{}, run.to - i);
    if constexpr (kBounded) {  // neighbours lie together: this is foreseen well
      among &= within(x, y);
      if (none(among)) continue;
    }
    const V dx = x - ox, dy = y - oy, squared = dx * dx + dy * dy;
    const V f = tx * dy - ty * dx - 0.5 * k * squared;
    const V square = 1 - 2 * k * f, s = root(square > least ? square : least);
    const V perRoot = 1 / s, left = 2 * f / (1 + s), r = left - pull * k;
    const V nx = (-ty - k * dx) * perRoot, ny = (tx - k * dy) * perRoot;
    const std::array<V, 4> j = {-nx, -ny, nx * dy - ny * dx, 0.5 * (left * left - squared) * perRoot - pull};
    const V w = judge(r, load<V>(&points.weight[i]), among);
    for (std::size_t a = 0, at = 0; a < 4; ++a) {
      const V wj = w * j[a];
      vector[a] += wj * r;
      for (std::size_t b = a; b < 4; ++b, ++at) matrix[at] += wj * j[b];
    }
  }
  judge.addTo(sums.residuals);
  for (std::size_t a = 0, at = 0; a < 4; ++a) {
    sums.vector[a] += total(vector[a]);
    for (std::size_t b = a; b < 4; ++b, ++at) sums.matrix[a][b] += total(matrix[at]);
  }
}

}  // namespace

void addPiece(const FitPoints& points, const FitPoints::Run& run, const CurvePiece& piece, const Stretch& stretch,
              const Weighting& weighting, FrameSums& sums) {
  if (piece.curvature == 0)
    (stretch.bounded ? addStraight<true> : addStraight<false>)(points, run, piece, stretch, weighting, sums);
  else
    (stretch.bounded ? addArc<true> : addArc<false>)(points, run, piece, stretch, weighting, sums);
}

void addParabola(const FitPoints& points, const FitPoints::Run& run, const std::array<double, 3>& c, double scaleMm,
                 const Weighting& weighting, ParabolaSums& sums) {
  using V = Floats;
  const V perScale = all<V>(1 / scaleMm), c0 = all<V>(c[0]), c1 = all<V>(c[1]), c2 = all<V>(c[2]);
  Judge<V> judge(weighting);
  std::array<V, 5> powers{};
  std::array<V, 3> vector{};
  for (std::size_t i = run.from; i < run.to; i += kLanes<V>) {
    const V u = load<V>(&points.x[i]) * perScale, r = load<V>(&points.y[i]) - (c0 + u * (c1 + u * c2));
    const V w = judge(r, load<V>(&points.weight[i]), amongFirst(V{}, run.to - i));
    const V wr = w * r, wu = w * u, uu = u * u, wuu = w * uu;
    powers[0] += w;
    powers[1] += wu;
    powers[2] += wuu;
    powers[3] += wu * uu;
    powers[4] += wuu * uu;
    vector[0] += wr;
    vector[1] += wr * u;
    vector[2] += wr * uu;
  }
  judge.addTo(sums.residuals);
  for (std::size_t k = 0; k < powers.size(); ++k) sums.powers[k] += total(powers[k]);
  for (std::size_t k = 0; k < vector.size(); ++k) sums.vector[k] += total(vector[k]);
}

Interval intervalOf(const float* values, std::size_t count) {
  using V = Floats;
  Interval interval{values[0], values[0]};
  std::size_t i = 0;
  if (count >= kLanes<V>) {
    V low = load<V>(values), high = low;
    for (; i + kLanes<V> <= count; i += kLanes<V>) {
      const V v = load<V>(values + i);
      low = v < low ? v : low;
      high = v > high ? v : high;
    }
    for (std::size_t k = 0; k < kLanes<V>; ++k)
      interval = {std::min(interval.low, low[k]), std::max(interval.high, high[k])};
  }
  for (; i < count; ++i) interval = {std::min(interval.low, values[i]), std::max(interval.high, values[i])};
  return interval;
}

}  // namespace vignole
