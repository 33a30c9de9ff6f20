#include "engine/measurement/chain_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr double kFreeBreakPerMm = 0.03;  // a jump of curvature that places its break by itself
constexpr double kTukey = 4.685;          // 95 % efficiency on normal errors
constexpr double kHardCut = 4;            // standard deviations, in the last rounds
constexpr int kSoftRounds = 6;
constexpr int kHardRounds = 3;
constexpr std::size_t kSoftPoints = 120;
constexpr double kSettledMm = 2e-3;  // a step this small: on to the last rounds
constexpr std::size_t kScaleSamples = 63;

/// Weight of a residual whose square, in variances, is z2.
double robustWeight(double z2, double cut2, bool hard) {
  if (hard) return z2 < cut2 ? 1.0 : 0.0;
  const double u = 1 - z2 / cut2;
  return u > 0 ? u * u : 0.0;
}

double medianScale(std::vector<double>& z) {
  if (z.empty()) return 1;
  const auto middle = z.begin() + static_cast<std::ptrdiff_t>(z.size() / 2);
  std::nth_element(z.begin(), middle, z.end());
  return std::max(1.0, 1.4826 * *middle);
}

struct Distance {
  double r = 0, nx = 0, ny = 0, perCurvature = 0, dx = 0, dy = 0;
};

/// Signed distance to the left of the piece's carrier, less what the line filter did; its normal and its slope with the
/// curvature (curve_piece.h).
inline Distance distanceTo(const CurvePiece<double>& p, const FitPoint& point) {
  Distance d;
  d.dx = point.x - p.origin.x;
  d.dy = point.y - p.origin.y;
  const double k = p.curvature, across = p.tangent.x * d.dy - p.tangent.y * d.dx, squared = d.dx * d.dx + d.dy * d.dy;
  if (k == 0) {  // most primitives: no root, no quotient
    d.r = across;
    d.nx = -p.tangent.y;
    d.ny = p.tangent.x;
    d.perCurvature = (across * across - squared) / 2 - point.pullMm2;
    return d;
  }
  const double f = across - 0.5 * k * squared;
  const double root = std::sqrt(std::max(1e-12, 1 - 2 * k * f));
  const double left = 2 * f / (1 + root);
  d.r = left - point.pullMm2 * k;
  const double perRoot = 1 / root;
  d.nx = (-p.tangent.y - k * d.dx) * perRoot;
  d.ny = (p.tangent.x - k * d.dy) * perRoot;
  d.perCurvature = 0.5 * (left * left - squared) * perRoot - point.pullMm2;
  return d;
}

CurvePiece<double> plain(const CurvePiece<LocalDual>& p) {
  return {{p.origin.x.value, p.origin.y.value},
          {p.tangent.x.value, p.tangent.y.value},
          p.curvature.value,
          p.fromMm,
          p.toMm};
}

/// Rounds of weighting and solving shared by both fits: soft weights on some of the points until the steps are small,
/// then a hard cut on all of them. round(cut, hard, stride) returns its step in mm, negative if it failed.
template <typename Scale, typename Round>
bool iterate(std::size_t points, Scale scale, Round round) {
  const std::size_t stride = std::max<std::size_t>(1, points / kSoftPoints);
  for (int i = 0; i < kSoftRounds; ++i) {
    const double step = round(kTukey * scale(), false, stride);
    if (!(step >= 0)) return false;
    if (step < kSettledMm) break;
  }
  const double cut = kHardCut * scale();
  for (int i = 0; i < kHardRounds; ++i) {
    const double step = round(cut, true, 1);
    if (!(step >= 0)) return false;
    if (step < kSettledMm) break;
  }
  return true;
}

}  // namespace

ChainFit::ChainFit(const Section& section, ChainPlan plan) : plan_(std::move(plan)) {
  double s = 0;
  for (const std::size_t p : plan_.primitives) {
    nominal_.push_back(pieceOf(section.primitives[p].shape));
    startMm_.push_back(s);
    s += nominal_.back().toMm;
  }
  const double middle = startMm_[plan_.anchor] + nominal_[plan_.anchor].toMm / 2;
  for (double& start : startMm_) start -= middle;
  anchorNominal_ = pieceOf(section.primitives[plan_.primitives[plan_.anchor]].shape, nominal_[plan_.anchor].toMm / 2);
  pieces_.resize(nominal_.size());
  plain_.resize(nominal_.size());
  breaks_.resize(nominal_.size());
  sums_.resize(nominal_.size());
  unknowns_.curvature.resize(nominal_.size());
  unknowns_.breakAfter.resize(nominal_.size());
}

void ChainFit::layOut(std::size_t first, std::size_t last) {
  first_ = first;
  last_ = last;
  std::size_t count = 2;
  std::fill(unknowns_.curvature.begin(), unknowns_.curvature.end(), -1);
  std::fill(unknowns_.breakAfter.begin(), unknowns_.breakAfter.end(), -1);
  for (std::size_t k = first; k <= last; ++k)
    if (nominal_[k].curvature != 0 && nominal_[k].toMm >= kShortArcMm && count < kMaxUnknowns)
      unknowns_.curvature[k] = static_cast<int>(count++);
  for (std::size_t k = first; k < last; ++k) {
    const bool shortBefore = k > first && k != plan_.anchor && nominal_[k].toMm < kShortArcMm;
    if (shortBefore && unknowns_.breakAfter[k - 1] >= 0)
      unknowns_.breakAfter[k] = unknowns_.breakAfter[k - 1];  // both ends of a short arc move together
    else if (std::abs(nominal_[k + 1].curvature - nominal_[k].curvature) >= kFreeBreakPerMm && count < kMaxUnknowns)
      unknowns_.breakAfter[k] = static_cast<int>(count++);
  }
  unknowns_.count = count;
  state_.setZero();
}

void ChainFit::walk() {
  const auto unknown = [&](int i) { return LocalDual::variable(state_(i), static_cast<std::size_t>(i)); };
  const auto curvatureOf = [&](std::size_t k) {
    const int i = unknowns_.curvature[k];
    return i < 0 ? LocalDual(nominal_[k].curvature) : nominal_[k].curvature + unknown(i);
  };
  const auto breakAfter = [&](std::size_t k) {
    const int i = unknowns_.breakAfter[k];
    return i < 0 ? LocalDual(startMm_[k + 1]) : startMm_[k + 1] + unknown(i);
  };
  const std::size_t anchor = plan_.anchor;
  CurvePiece<LocalDual>& middle = pieces_[anchor];
  const LocalDual offset = unknown(0), turn = unknown(1);
  middle.origin = {anchorNominal_.origin.x - anchorNominal_.tangent.y * offset,
                   anchorNominal_.origin.y + anchorNominal_.tangent.x * offset};
  const LocalDual c = cos(turn), s = sin(turn);
  middle.tangent = {anchorNominal_.tangent.x * c - anchorNominal_.tangent.y * s,
                    anchorNominal_.tangent.y * c + anchorNominal_.tangent.x * s};
  middle.curvature = curvatureOf(anchor);
  middle.fromMm = startMm_[anchor];
  middle.toMm = startMm_[anchor] + nominal_[anchor].toMm;

  LocalDual at = 0;
  for (std::size_t k = anchor; k < last_; ++k) {  // onwards: each piece starts at the break before it
    const LocalDual next = breakAfter(k);
    pieces_[k].toMm = (next - at).value;
    pieces_[k + 1] = advanced(pieces_[k], next - at);
    pieces_[k + 1].curvature = curvatureOf(k + 1);
    pieces_[k + 1].fromMm = 0;
    pieces_[k + 1].toMm = startMm_[k + 1] + nominal_[k + 1].toMm - next.value;
    at = next;
  }
  at = 0;
  for (std::size_t k = anchor; k > first_; --k) {  // backwards: each piece has its origin at the break after it
    const LocalDual previous = breakAfter(k - 1);
    pieces_[k].fromMm = (previous - at).value;
    pieces_[k - 1] = advanced(pieces_[k], previous - at);
    pieces_[k - 1].curvature = curvatureOf(k - 1);
    pieces_[k - 1].toMm = 0;
    pieces_[k - 1].fromMm = startMm_[k - 1] - previous.value;
    at = previous;
  }
  for (std::size_t k = first_; k <= last_; ++k) plain_[k] = plain(pieces_[k]);
  for (std::size_t k = first_; k < last_; ++k) {
    const CurvePiece<double>& joint = k < anchor ? plain_[k] : plain_[k + 1];
    breaks_[k] = {joint.origin.x, joint.origin.y, joint.tangent.x, joint.tangent.y};
  }
}

std::size_t ChainFit::pieceAt(double x, double y) const {
  std::size_t k = first_;
  while (k < last_ && (x - breaks_[k].x) * breaks_[k].tx + (y - breaks_[k].y) * breaks_[k].ty > 0) ++k;
  return k;
}

double ChainFit::robustScale() {
  sorted_.clear();
  const std::size_t stride = points_.size() / kScaleSamples + 1;
  for (std::size_t i = stride / 2; i < points_.size(); i += stride) {
    const FitPoint& p = points_[i];
    sorted_.push_back(std::abs(distanceTo(plain_[pieceAt(p.x, p.y)], p).r) * std::sqrt(p.weight));
  }
  return medianScale(sorted_);
}

double ChainFit::accumulate(double cut, bool hard, std::size_t stride, UnknownMatrix& a, UnknownVector& b) {
  solution_.scatter = {};
  for (std::size_t k = first_; k <= last_; ++k) sums_[k] = {};
  double squares = 0;
  int kept = 0;
  for (std::size_t i = 0; i < points_.size(); i += stride) {
    const FitPoint& p = points_[i];
    const std::size_t k = pieceAt(p.x, p.y);
    const Distance d = distanceTo(plain_[k], p);
    const double z2 = d.r * d.r * p.weight, w = robustWeight(z2, cut * cut, hard);
    if (w == 0) continue;
    const Eigen::Vector4d j(-d.nx, -d.ny, d.nx * d.dy - d.ny * d.dx, d.perCurvature);
    const Eigen::Vector4d wj = w * p.weight * j;
    sums_[k].matrix.noalias() += wj * j.transpose();
    sums_[k].vector += wj * d.r;
    solution_.scatter.chi2[p.camera] += z2;
    ++solution_.scatter.points[p.camera];
    squares += d.r * d.r;
    ++kept;
  }
  a.setZero();
  b.setZero();
  for (std::size_t k = first_; k <= last_; ++k) {
    // How the frame of this piece moves with the unknowns of the chain.
    Eigen::Matrix<double, 4, static_cast<int>(kMaxUnknowns)> frame;
    const CurvePiece<LocalDual>& f = pieces_[k];
    for (std::size_t i = 0; i < kMaxUnknowns; ++i)
      frame.col(static_cast<int>(i)) << f.origin.x.gradient[i], f.origin.y.gradient[i],
          f.tangent.x.value * f.tangent.y.gradient[i] - f.tangent.y.value * f.tangent.x.gradient[i],
          f.curvature.gradient[i];
    const Eigen::Matrix<double, 4, static_cast<int>(kMaxUnknowns)> moved = sums_[k].matrix * frame;
    a.noalias() += frame.transpose() * moved;
    b.noalias() += frame.transpose() * sums_[k].vector;
  }
  solution_.meanSquareMm2 = kept > 0 ? squares / kept : 0;
  return kept;
}

void ChainFit::solve(std::size_t first, std::size_t last) {
  layOut(first, last);
  solution_ = {};
  solution_.unknowns = unknowns_.count;
  const auto n = static_cast<int>(unknowns_.count);
  walk();
  UnknownMatrix a;
  UnknownVector b;
  const auto round = [&](double cut, bool hard, std::size_t stride) -> double {
    if (accumulate(cut, hard, stride, a, b) < n + 1) return -1;
    for (int i = n; i < a.rows(); ++i) a(i, i) = 1;  // unknowns that this chain does not have
    // Unit diagonal: curvatures and angles differ from offsets by orders of magnitude.
    const UnknownVector scale = a.diagonal().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
    const UnknownMatrix scaled = scale.asDiagonal() * a * scale.asDiagonal();
    const Eigen::LLT<UnknownMatrix> llt(scaled);
    if (llt.info() != Eigen::Success) return -1;
    const UnknownVector scaledB = scale.asDiagonal() * b;
    const UnknownVector step = -(scale.asDiagonal() * llt.solve(scaledB));
    if (!step.allFinite()) return -1;
    state_ += step;
    if (hard) {
      const UnknownMatrix inverse = llt.solve(UnknownMatrix::Identity());
      solution_.covariance = scale.asDiagonal() * inverse * scale.asDiagonal();
    }
    walk();
    return std::abs(step(0)) + 10 * std::abs(step(1));
  };
  solution_.valid = iterate(
      points_.size(), [&] { return robustScale(); }, round);
}

double FootBottomFit::accumulate(double cut, bool hard, std::size_t stride, Eigen::Matrix3d& a, Eigen::Vector3d& b) {
  a.setZero();
  b.setZero();
  solution_.scatter = {};
  double squares = 0;
  for (std::size_t i = 0; i < points_.size(); i += stride) {
    const FitPoint& p = points_[i];
    const double u = p.x / kFootScaleMm, r = p.y - (c_(0) + u * (c_(1) + u * c_(2))), z2 = r * r * p.weight;
    const double w = robustWeight(z2, cut * cut, hard) * p.weight;
    if (w == 0) continue;
    const Eigen::Vector3d j(1, u, u * u);
    a += w * j * j.transpose();
    b += w * r * j;
    solution_.scatter.chi2[p.camera] += z2;
    ++solution_.scatter.points[p.camera];
    squares += r * r;
  }
  const int kept = solution_.scatter.total();
  solution_.meanSquareMm2 = kept > 0 ? squares / kept : 0;
  return kept;
}

void FootBottomFit::solve() {
  c_.setZero();
  solution_ = {};
  solution_.unknowns = 3;
  Eigen::Matrix3d a;
  Eigen::Vector3d b;
  const auto scale = [&] {
    sorted_.clear();
    const std::size_t stride = points_.size() / kScaleSamples + 1;
    for (std::size_t i = stride / 2; i < points_.size(); i += stride) {
      const FitPoint& p = points_[i];
      const double u = p.x / kFootScaleMm;
      sorted_.push_back(std::abs(p.y - (c_(0) + u * (c_(1) + u * c_(2)))) * std::sqrt(p.weight));
    }
    return medianScale(sorted_);
  };
  const auto round = [&](double cut, bool hard, std::size_t stride) -> double {
    if (accumulate(cut, hard, stride, a, b) < 4) return -1;
    const Eigen::LLT<Eigen::Matrix3d> llt(a);
    if (llt.info() != Eigen::Success) return -1;
    const Eigen::Vector3d step = llt.solve(b);
    if (!step.allFinite()) return -1;
    c_ += step;
    if (hard) solution_.covariance.topLeftCorner<3, 3>() = llt.solve(Eigen::Matrix3d::Identity());
    return step.lpNorm<1>();
  };
  solution_.valid = iterate(points_.size(), scale, round);
}

}  // namespace vignole
