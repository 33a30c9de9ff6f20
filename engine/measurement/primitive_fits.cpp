#include "engine/measurement/primitive_fits.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr double kReachMm = 1.5;       // a fit may be read this far beyond the points that were left out of it
constexpr double kLongFitPoints = 30;  // a fit with so many points says how the points of a camera scatter
constexpr double kPointsPerAbsorbed = 4;
constexpr double kMisfit = 4;  // a fit that scatters so much more than the others is judged by itself

std::vector<ChainFit> chainsOf(const Section& section, const SectionPlan& plan) {
  std::vector<ChainFit> chains;
  for (ChainPlan& chain : planChains(section, plan)) chains.emplace_back(section, std::move(chain));
  return chains;
}

}  // namespace

PrimitiveFits::PrimitiveFits(const Section& section, const SectionPlan& plan, const MeasurementSettings& settings)
    : settings_(settings),
      footBottom_(plan.footBottom),
      chains_(chainsOf(section, plan)),
      groups_(section, plan.footBottom, chains_, settings) {
  const Primitive& bottom = section.primitives[footBottom_].shape;
  footSpanMm_ = {static_cast<float>(startPoint(bottom).x()), static_cast<float>(endPoint(bottom).x())};
  const std::size_t n = section.primitives.size();
  shapes_.pieces.resize(n);
  shapes_.missing.resize(n);
  blockOfFit_.resize(chains_.size() + 1);
  for (std::size_t p = 0; p < n; ++p) {
    names_.push_back(section.primitives[p].name);
    lengthMm_.push_back(length(section.primitives[p].shape));
    if (groups_.fitOf(p) == PointGroups::kNoFit) miss(p, names_[p] + " is not fitted");
  }
}

std::string PrimitiveFits::tooFew(std::size_t primitive) const {
  const int n = groups_.pointsOf(primitive);
  if (n == 0) return "no points on " + names_[primitive];
  return "only " + std::to_string(n) + (n == 1 ? " point on " : " points on ") + names_[primitive] + ", " +
         std::to_string(settings_.minPoints) + " are needed";
}

std::size_t PrimitiveFits::nextBase() const {
  return blocks_.empty() ? 0 : blocks_.back().base + blocks_.back().solution->unknowns;
}

void PrimitiveFits::fitFootBottom(double correlatedPoints) {
  if (groups_.pointsOf(footBottom_) < settings_.minPoints) return miss(footBottom_, tooFew(footBottom_));
  footFit_.solve(groups_.select(chains_.size(), 0, 0), correlatedPoints);
  if (!footFit_.solution().valid) return miss(footBottom_, "the points on " + names_[footBottom_] + " make no curve");
  shapes_.footBottom = footFit_.parabola();
  miss(footBottom_, "");
  blockOfFit_[chains_.size()] = blocks_.size();
  blocks_.push_back({&footFit_.solution(), nextBase()});
}

void PrimitiveFits::fitChain(std::size_t index, double correlatedPoints) {
  ChainFit& chain = chains_[index];
  const auto& members = chain.plan().primitives;
  const auto enough = [&](std::size_t m) { return groups_.pointsOf(members[m]) >= settings_.minPoints; };
  const std::size_t anchor = chain.plan().anchor;
  if (!enough(anchor)) {
    for (std::size_t m = 0; m < members.size(); ++m) miss(members[m], tooFew(members[enough(m) ? anchor : m]));
    return;
  }
  // Neighbours without points leave the chain from its ends inwards; a short arc is worth keeping only inside.
  std::size_t first = 0, last = members.size() - 1;
  const auto bears = [&](std::size_t m) { return enough(m) && lengthMm_[members[m]] >= kShortArcMm; };
  while (first < anchor && !bears(first)) ++first;
  while (last > anchor && !bears(last)) --last;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (m < first || m > last) miss(members[m], tooFew(members[m]));
  chain.solve(groups_.select(index, first, last), first, last, correlatedPoints);
  if (!chain.solution().valid || nextBase() + chain.solution().unknowns > kMaxGlobalUnknowns) {
    for (std::size_t m = first; m <= last; ++m)
      miss(members[m], "the points on " + names_[members[m]] + " make no curve");
    return;
  }
  publishChain(index, first, last);
}

void PrimitiveFits::publishChain(std::size_t index, std::size_t first, std::size_t last) {
  const ChainFit& chain = chains_[index];
  for (std::size_t m = first; m <= last; ++m) {
    const std::size_t p = chain.plan().primitives[m];
    CurvePiece& piece = shapes_.pieces[p];
    piece = chain.piece(m).piece;
    piece.origin = {piece.origin.x + chain.origin().x, piece.origin.y + chain.origin().y};
    // At its ends a chain may be read as far as its points went, and over what was trimmed.
    const double slack = settings_.trimMm + kReachMm;
    const auto reach = groups_.reachOf(p);
    if (m == first) piece.fromMm -= reach[0] + slack;
    if (m == last) piece.toMm += reach[1] + slack;
    miss(p, "");
  }
  blockOfFit_[index] = blocks_.size();
  blocks_.push_back({&chain.solution(), nextBase()});
}

/// The scatter of the points about the fits tells how right their sigmas are: speckle and roughness show there. A fit
/// lowers it by what it absorbs.
void PrimitiveFits::pool() {
  sorted_.clear();
  const auto isLong = [&](const FitSolution& s) {
    return s.scatter.total() >= std::max(kLongFitPoints, kPointsPerAbsorbed * s.absorbed);
  };
  const auto reduced = [&](const FitSolution& s) { return s.scatter.sum() / (s.scatter.total() - s.absorbed); };
  for (const Block& b : blocks_)
    if (isLong(*b.solution)) sorted_.push_back(reduced(*b.solution));
  double usual = 1;
  if (!sorted_.empty()) {
    const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
    std::nth_element(sorted_.begin(), middle, sorted_.end());
    usual = std::max(1e-9, *middle);
  }
  std::array<double, kCameraCount> chi2{}, freedom{};
  for (const Block& b : blocks_) {
    const FitScatter& s = b.solution->scatter;
    const double total = s.total();
    if (!isLong(*b.solution) || reduced(*b.solution) > kMisfit * usual) continue;
    const double share = 1 - b.solution->absorbed / total;
    for (std::size_t c = 0; c < chi2.size(); ++c) {
      chi2[c] += s.chi2[c];
      freedom[c] += s.points[c] * share;
    }
  }
  for (Block& b : blocks_) {
    const FitScatter& s = b.solution->scatter;
    double factor = 0;
    for (std::size_t c = 0; c < chi2.size(); ++c)
      factor += s.points[c] * (freedom[c] > kLongFitPoints ? std::max(1.0, chi2[c] / freedom[c]) : 1.0);
    factor /= std::max(1.0, s.total());
    if (isLong(*b.solution) && reduced(*b.solution) > kMisfit * std::max(1.0, usual))
      factor = std::max(factor, reduced(*b.solution));
    b.factor = factor;
  }
}

void PrimitiveFits::fit(const Profile& profile, const Registration& registration, double cold) {
  groups_.gather(profile, registration, cold);
  blocks_.clear();
  std::fill(blockOfFit_.begin(), blockOfFit_.end(), kNoBlock);
  const auto correlatedPoints = static_cast<double>(profile.correlatedPoints);
  fitFootBottom(correlatedPoints);
  for (std::size_t c = 0; c < chains_.size(); ++c) fitChain(c, correlatedPoints);
  pool();
}

Deviations PrimitiveFits::deviations(const Reading& reading) const {
  Deviations all{};
  // A term after another: several primitives of one chain share their unknowns.
  std::array<std::size_t, Reading::kMaxTerms> blocks{};
  std::array<UnknownVector, Reading::kMaxTerms> gradients;
  std::size_t used = 0;
  for (const Reading::Term& term : reading) {
    const bool foot = term.mover == kFootBottomMover;
    const std::size_t p = foot ? footBottom_ : primitiveOf(term.mover);
    const auto fit = static_cast<std::size_t>(groups_.fitOf(p));
    std::size_t at = 0;
    while (at < used && blocks[at] != blockOfFit_[fit]) ++at;
    if (at == used) {
      blocks[used] = blockOfFit_[fit];
      gradients[used++] = {};
    }
    UnknownVector& g = gradients[at];
    if (foot) {
      g = FootBottomFit::gradient(term.slopes);
      continue;
    }
    const auto& frame = chains_[fit].piece(groups_.placeOf(p)).perUnknown;
    for (std::size_t k = 0; k < frame.size(); ++k)
      for (std::size_t i = 0; i < kMaxUnknowns; ++i) g[i] += term.slopes[k] * frame[k][i];
  }
  for (std::size_t at = 0; at < used; ++at) {
    const Block& block = blocks_[blocks[at]];
    const UnknownVector own = block.solution->deviations(gradients[at]);
    const double scale = std::sqrt(block.factor);
    for (std::size_t i = 0; i < block.solution->unknowns; ++i) all[block.base + i] = scale * own[i];
  }
  return all;
}

int PrimitiveFits::pointsOn(const PrimitiveSet& primitives) const {
  int n = 0;
  for (std::size_t p = 0; p < names_.size(); ++p)
    if (primitives.test(p)) n += groups_.pointsOf(p);
  return n;
}

void PrimitiveFits::describe(const Transform2& worldFromSection, double cold,
                             std::vector<FittedPrimitive>& fitted) const {
  fitted.clear();
  for (std::size_t p = 0; p < names_.size(); ++p) {
    if (!shapes_.missing[p].empty()) continue;
    FittedPrimitive f;
    f.primitive = p;
    f.points = groups_.pointsOf(p);
    CurvePiece piece;
    double from = 0, to = 0;
    if (p == footBottom_) {  // the parabola as its circle of curvature
      const Parabola& k = shapes_.footBottom;
      const double norm = std::hypot(1.0, k.c1);
      piece = {{0, k.c0}, {1 / norm, k.c1 / norm}, 2 * k.c2 / (norm * norm * norm), 0, 0};
      from = static_cast<double>(footSpanMm_.low);
      to = static_cast<double>(footSpanMm_.high);
      f.rmsMm = std::sqrt(footFit_.solution().meanSquareMm2);
    } else {
      piece = shapes_.pieces[p];
      const auto& chain = chains_[static_cast<std::size_t>(groups_.fitOf(p))];
      const CurvePiece& own = chain.piece(groups_.placeOf(p)).piece;
      const double slack = settings_.trimMm + kReachMm;
      from = own.fromMm == piece.fromMm ? piece.fromMm : piece.fromMm + slack;
      to = own.toMm == piece.toMm ? piece.toMm : piece.toMm - slack;
      f.rmsMm = std::sqrt(chain.solution().meanSquareMm2);
    }
    piece.origin = {piece.origin.x / cold, piece.origin.y / cold};  // as hot as it is in the world
    piece.curvature *= cold;
    f.shape = transformed(worldFromSection, primitiveOf(piece, from / cold, to / cold));
    fitted.push_back(f);
  }
}

}  // namespace vignole
