#include "engine/measurement/chain_fit.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr double kFreeBreakPerMm = 0.03;  // a jump of curvature that places its break by itself

/// Signed distance to the left of the piece's carrier, less what the line filter did (curve_piece.h).
double distanceTo(const CurvePiece& p, double x, double y, double pull) {
  const double dx = x - p.origin.x, dy = y - p.origin.y, k = p.curvature;
  const double f = p.tangent.x * dy - p.tangent.y * dx - 0.5 * k * (dx * dx + dy * dy);
  if (k == 0) return f;
  return 2 * f / (1 + std::sqrt(std::max(1e-12, 1 - 2 * k * f))) - pull * k;
}

/// Takes an unknown out of normal equations.
void hold(std::size_t unknown, UnknownMatrix& a, UnknownVector& b) {
  for (std::size_t i = 0; i < kMaxUnknowns; ++i) a[i][unknown] = a[unknown][i] = 0;
  a[unknown][unknown] = 1;
  b[unknown] = 0;
}

/// The line across the chain at the origin of a piece.
Stretch::Line across(const CurvePiece& piece) {
  const Vec& o = piece.origin;
  const Vec& t = piece.tangent;
  return {t.x, t.y, t.x * o.x + t.y * o.y};
}

}  // namespace

ChainFit::ChainFit(const Section& section, ChainPlan plan) : plan_(std::move(plan)) {
  const auto shapeOf = [&](std::size_t k) -> const Primitive& { return section.primitives[plan_.primitives[k]].shape; };
  const std::size_t n = plan_.primitives.size();
  double s = 0;
  for (std::size_t k = 0; k < n; ++k) {
    nominal_.push_back(pieceOf(shapeOf(k)));
    startMm_.push_back(s);
    s += nominal_.back().toMm;
  }
  const double half = nominal_[plan_.anchor].toMm / 2, middle = startMm_[plan_.anchor] + half;
  for (double& start : startMm_) start -= middle;
  anchorNominal_ = pieceOf(shapeOf(plan_.anchor), half);
  origin_ = anchorNominal_.origin;
  anchorNominal_.origin = {};
  for (CurvePiece& piece : nominal_) piece.origin = {piece.origin.x - origin_.x, piece.origin.y - origin_.y};
  pieces_.resize(n);
  stretches_.resize(n);
  curvatureUnknown_.resize(n);
  breakUnknown_.resize(n);
}

void ChainFit::layOut(std::size_t first, std::size_t last) {
  first_ = first;
  last_ = last;
  std::size_t count = 2;
  std::fill(curvatureUnknown_.begin(), curvatureUnknown_.end(), -1);
  std::fill(breakUnknown_.begin(), breakUnknown_.end(), -1);
  for (std::size_t k = first; k <= last; ++k)
    if (nominal_[k].curvature != 0 && nominal_[k].toMm >= kShortArcMm && count < kMaxUnknowns)
      curvatureUnknown_[k] = static_cast<int>(count++);
  for (std::size_t k = first; k < last; ++k) {
    const bool shortBefore = k > first && k != plan_.anchor && nominal_[k].toMm < kShortArcMm;
    if (shortBefore && breakUnknown_[k - 1] >= 0)
      breakUnknown_[k] = breakUnknown_[k - 1];  // both ends of a short arc move together
    else if (std::abs(nominal_[k + 1].curvature - nominal_[k].curvature) >= kFreeBreakPerMm && count < kMaxUnknowns)
      breakUnknown_[k] = static_cast<int>(count++);
  }
  solution_.unknowns = count;
  state_ = {};
}

/// From a piece to its neighbour, whose origin is put at the break between them.
void ChainFit::step(std::size_t from, std::size_t to) {
  FittedPiece& here = pieces_[from];
  FittedPiece& there = pieces_[to];
  const bool onwards = to > from;
  const auto breakOf = [&](std::size_t k) { return breakUnknown_[onwards ? k : k - 1]; };
  const auto breakAt = [&](std::size_t k) {
    const int i = breakOf(k);
    return startMm_[onwards ? k + 1 : k] + (i < 0 ? 0 : state_[static_cast<std::size_t>(i)]);
  };
  // The anchor has its origin in its middle, every other piece at the break towards the anchor.
  const bool fromAnchor = from == plan_.anchor;
  const std::size_t before = onwards ? from - 1 : from + 1;
  const double ds = breakAt(from) - (fromAnchor ? 0 : breakAt(before));
  (onwards ? here.piece.toMm : here.piece.fromMm) = ds;

  const Advance next = advanced(here.piece, ds);
  there.piece = next.piece;
  const Vec& t = next.piece.tangent;
  const double k = here.piece.curvature;
  const double dx = next.piece.origin.x - here.piece.origin.x, dy = next.piece.origin.y - here.piece.origin.y;
  for (std::size_t i = 0; i < solution_.unknowns; ++i) {
    const double turn = here.perUnknown[2][i], bend = here.perUnknown[3][i];
    double along = breakOf(from) == static_cast<int>(i) ? 1 : 0;
    if (!fromAnchor && breakOf(before) == static_cast<int>(i)) along -= 1;
    there.perUnknown[0][i] = here.perUnknown[0][i] - turn * dy + bend * next.perCurvature.x + along * t.x;
    there.perUnknown[1][i] = here.perUnknown[1][i] + turn * dx + bend * next.perCurvature.y + along * t.y;
    there.perUnknown[2][i] = turn + bend * ds + along * k;
  }
  const double startMm = startMm_[to] - breakAt(from);
  there.piece.fromMm = onwards ? 0 : startMm;
  there.piece.toMm = onwards ? startMm + nominal_[to].toMm : 0;
}

void ChainFit::walk() {
  const auto bend = [&](std::size_t k) {
    const int i = curvatureUnknown_[k];
    FittedPiece& f = pieces_[k];
    f.piece.curvature = nominal_[k].curvature + (i < 0 ? 0 : state_[static_cast<std::size_t>(i)]);
    f.perUnknown[3] = {};
    if (i >= 0) f.perUnknown[3][static_cast<std::size_t>(i)] = 1;
  };
  const std::size_t anchor = plan_.anchor;
  FittedPiece& middle = pieces_[anchor];
  const Vec& t = anchorNominal_.tangent;
  const double c = std::cos(state_[1]), s = std::sin(state_[1]);
  middle.piece.origin = {-t.y * state_[0], t.x * state_[0]};
  middle.piece.tangent = {t.x * c - t.y * s, t.y * c + t.x * s};
  middle.piece.fromMm = startMm_[anchor];
  middle.piece.toMm = startMm_[anchor] + nominal_[anchor].toMm;
  middle.perUnknown = {UnknownVector{-t.y}, UnknownVector{t.x}, UnknownVector{0, 1}, UnknownVector{}};
  bend(anchor);
  for (std::size_t k = anchor; k < last_; ++k) {
    step(k, k + 1);
    bend(k + 1);
  }
  for (std::size_t k = anchor; k > first_; --k) {
    step(k, k - 1);
    bend(k - 1);
  }
  Stretch everywhere;
  everywhere.bounded = first_ != last_;
  std::fill(stretches_.begin(), stretches_.end(), everywhere);
  for (std::size_t k = first_; k < last_; ++k)
    stretches_[k].to = stretches_[k + 1].from = across(pieces_[k < anchor ? k : k + 1].piece);
}

std::size_t ChainFit::pieceAt(double x, double y) const {
  std::size_t k = first_;
  while (k < last_ && x * stretches_[k].to.x + y * stretches_[k].to.y > stretches_[k].to.at) ++k;
  return k;
}

double ChainFit::residual(const FitPoints& points, std::size_t i) const {
  const double x = static_cast<double>(points.x[i]), y = static_cast<double>(points.y[i]);
  return distanceTo(pieces_[pieceAt(x, y)].piece, x, y, static_cast<double>(points.pull[i]));
}

/// Of the residual over its sigma with the unknowns, as for a point on the curve.
UnknownVector ChainFit::slopes(const FitPoints& points, std::size_t i) const {
  const double x = static_cast<double>(points.x[i]), y = static_cast<double>(points.y[i]);
  const FittedPiece& f = pieces_[pieceAt(x, y)];
  const double dx = x - f.piece.origin.x, dy = y - f.piece.origin.y, k = f.piece.curvature;
  const double nx = -f.piece.tangent.y - k * dx, ny = f.piece.tangent.x - k * dy;
  const double perSigma = std::sqrt(static_cast<double>(points.weight[i]));
  const std::array<double, 4> frame = {-nx, -ny, nx * dy - ny * dx, -0.5 * (dx * dx + dy * dy)};
  UnknownVector s{};
  for (std::size_t p = 0; p < 4; ++p)
    for (std::size_t u = 0; u < solution_.unknowns; ++u) s[u] += perSigma * frame[p] * f.perUnknown[p][u];
  return s;
}

double ChainFit::round(const FitPoints& points, const Weighting& weighting, bool free) {
  const std::size_t n = solution_.unknowns;
  solution_.scatter = {};
  ResidualSums all;
  UnknownMatrix a{};
  UnknownVector b{};
  for (std::size_t k = first_; k <= last_; ++k) {
    FrameSums sums;
    for (const FitPoints::Run& run : points.runs) {
      const ResidualSums before = sums.residuals;
      addPiece(points, run, pieces_[k].piece, stretches_[k], weighting, sums);
      addTo(solution_.scatter, run.camera, sums.residuals.since(before));
    }
    all.squares += sums.residuals.squares;
    all.count += sums.residuals.count;
    const auto& frame = pieces_[k].perUnknown;
    for (std::size_t i = 0; i < n; ++i) {
      std::array<double, 4> moved{};
      for (std::size_t p = 0; p < 4; ++p)
        for (std::size_t q = 0; q < 4; ++q) moved[p] += sums.matrix[std::min(p, q)][std::max(p, q)] * frame[q][i];
      for (std::size_t p = 0; p < 4; ++p) {
        b[i] += frame[p][i] * sums.vector[p];
        for (std::size_t j = 0; j <= i; ++j) a[i][j] += moved[p] * frame[p][j];
      }
    }
  }
  if (all.count < static_cast<double>(n + 1)) return -1;
  solution_.meanSquareMm2 = all.squares / all.count;
  if (!free)
    for (const int held : curvatureUnknown_)
      if (held >= 0) hold(static_cast<std::size_t>(held), a, b);
  if (!solution_.normal.decompose(a, n)) return -1;
  const UnknownVector change = solution_.normal.solve(b);
  double size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    state_[i] -= change[i];
    size += std::abs(change[i]);
  }
  if (!std::isfinite(size)) return -1;
  walk();
  return std::abs(change[0]) + 10 * std::abs(change[1]);
}

void ChainFit::solve(const FitPoints& points, std::size_t first, std::size_t last, double correlatedPoints) {
  solution_ = {};
  layOut(first, last);
  walk();
  solution_.valid = rounds_.run(
      points, [&](const FitPoints& p, std::size_t i) { return residual(p, i); },
      [&](const FitPoints& p, const Weighting& weighting, bool free) { return round(p, weighting, free); });
  if (!solution_.valid) return;
  SharedErrors errors(solution_.unknowns, correlatedPoints);
  for (const FitPoints::Run& run : points.runs)
    errors.addRun(run.from, run.to, [&](std::size_t i) { return slopes(points, i); });
  solution_.setShared(errors);
}

}  // namespace vignole
