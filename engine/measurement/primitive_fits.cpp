#include "engine/measurement/primitive_fits.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr float kFallbackSigmaMm = 0.03F;  // where a point comes without its uncertainty
// A neighbour whose curvature differs by less than this shifts a smoothed line by less than a micrometre at the joint.
constexpr double kSmoothJointPerMm = 0.01;
constexpr double kReachMm = 1.5;  // a fit may be read this far beyond the points that were left out of it
constexpr std::array<double, 4> kTrimDegrees = {1, 0.5, 0.25, 0};
constexpr int kLongFitPoints = 30;  // a fit with so many points says how the points of a camera scatter
constexpr double kPointsPerAbsorbed = 4;
constexpr double kMisfit = 4;  // a fit that scatters so much more than the others is judged by itself

/// By how much shared errors raise the variance of a mean over n points: c for long runs, less where the run is hardly
/// longer than what is shared (exact for errors that are a moving average over c points).
double sharedBy(double correlatedPoints, int n) {
  const double c = correlatedPoints;
  return std::max(1.0, c - (c * c - 1) / (3.0 * std::max(1, n)));
}

template <typename Local>
GlobalDual lifted(const Local& local, std::size_t base, std::size_t count) {
  GlobalDual global(local.value);
  for (std::size_t i = 0; i < count; ++i) global.gradient[base + i] = local.gradient[i];
  return global;
}

}  // namespace

PrimitiveFits::PrimitiveFits(const Section& section, const SectionPlan& plan, const MeasurementSettings& settings)
    : settings_(settings), footBottom_(plan.footBottom) {
  for (const auto& p : section.primitives) names_.push_back(p.name);
  for (ChainPlan& chain : planChains(section, plan)) chains_.emplace_back(section, std::move(chain));
  makeBorders(section);
  const std::size_t n = section.primitives.size();
  counts_.resize(n);
  coverage_.resize(n);
  shapes_.pieces.resize(n);
  shapes_.missing.resize(n);
}

void PrimitiveFits::makeBorders(const Section& section) {
  const std::size_t n = section.primitives.size();
  borders_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    Border& b = borders_[k];
    const Primitive& shape = section.primitives[k].shape;
    b.lengthMm = length(shape);
    b.start = startPoint(shape);
    b.end = endPoint(shape);
    b.startTangent = tangentAt(shape, 0);
    b.endTangent = tangentAt(shape, b.lengthMm);
    b.chordMm = (b.end - b.start).norm();
    b.chord = (b.end - b.start) / b.chordMm;
    b.curvature = curvature(shape);
    const auto smooth = [&](std::size_t neighbour) {
      return std::abs(curvature(section.primitives[neighbour].shape) - b.curvature) < kSmoothJointPerMm;
    };
    b.trimStart = !smooth((k + n - 1) % n);
    b.trimEnd = !smooth((k + 1) % n);
  }
  borders_[footBottom_].fit = kFootBottom;
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const auto& members = chains_[c].plan().primitives;
    for (std::size_t m = 0; m < members.size(); ++m) {
      Border& b = borders_[members[m]];
      b.fit = static_cast<int>(c);
      b.position = m;
      if (m > 0) b.trimStart = false;  // inside a chain both sides of the joint are modelled
      if (m + 1 < members.size()) b.trimEnd = false;
    }
  }
}

void PrimitiveFits::gather(const Profile& profile, const Registration& registration) {
  assigned_.clear();
  for (auto& c : counts_) c.fill(0);
  const Transform2 t = registration.worldFromSection.inverse();
  const double c = std::cos(t.angleRad), s = std::sin(t.angleRad);
  for (std::size_t i = 0; i < profile.points.size(); ++i) {
    const std::int16_t k = registration.primitiveOfPoint[i];
    if (k < 0) continue;
    const Border& b = borders_[static_cast<std::size_t>(k)];
    if (b.fit < 0) continue;
    const ProfilePoint& p = profile.points[i];
    // The ridge itself: the fit knows the bend better than the extraction, and neighbours that were smoothed together
    // tell nothing twice.
    const float given = p.ridgeSigmaMm > 0 ? p.ridgeSigmaMm : p.sigmaMm;
    const double sigma = given > 0 ? given : kFallbackSigmaMm;
    const double px = p.x - p.shiftMm * p.nx, py = p.y - p.shiftMm * p.ny;
    Assigned a;
    a.point = {c * px - s * py + t.xMm, s * px + c * py + t.yMm, 1 / (sigma * sigma),
               0.5 * p.smoothingMm * p.smoothingMm, static_cast<std::uint8_t>(p.camera % kCameraCount)};
    a.primitive = static_cast<std::uint16_t>(k);
    const double dx = a.point.x - b.start.x(), dy = a.point.y - b.start.y();
    a.alongMm = static_cast<float>(dx * b.chord.x() + dy * b.chord.y());
    double margin = 1e6;
    if (b.trimStart) margin = dx * b.startTangent.x() + dy * b.startTangent.y();
    if (b.trimEnd)
      margin =
          std::min(margin, (b.end.x() - a.point.x) * b.endTangent.x() + (b.end.y() - a.point.y) * b.endTangent.y());
    a.marginMm = static_cast<float>(margin);
    auto& counts = counts_[a.primitive];
    for (std::size_t d = 0; d < kTrimDegrees.size(); ++d) counts[d] += margin >= kTrimDegrees[d] * settings_.trimMm;
    assigned_.push_back(a);
  }
}

/// Coarse profiles (a point every 0.7 mm) leave too few points inside short primitives: they are trimmed less.
double PrimitiveFits::trimOf(std::size_t primitive) const {
  for (std::size_t d = 0; d < kTrimDegrees.size(); ++d)
    if (counts_[primitive][d] >= settings_.minPoints) return kTrimDegrees[d] * settings_.trimMm;
  return 0;
}

void PrimitiveFits::distribute() {
  for (ChainFit& chain : chains_) chain.points().clear();
  footFit_.points().clear();
  for (Coverage& c : coverage_) c = {};
  for (const Assigned& a : assigned_) {
    if (a.marginMm < trimOf(a.primitive)) continue;
    Coverage& c = coverage_[a.primitive];
    ++c.points;
    c.lowMm = std::min(c.lowMm, static_cast<double>(a.alongMm));
    c.highMm = std::max(c.highMm, static_cast<double>(a.alongMm));
    const int fit = borders_[a.primitive].fit;
    (fit == kFootBottom ? footFit_.points() : chains_[static_cast<std::size_t>(fit)].points()).push_back(a.point);
  }
}

std::string PrimitiveFits::tooFew(std::size_t primitive) const {
  const int n = coverage_[primitive].points;
  if (n == 0) return "no points on " + names_[primitive];
  return "only " + std::to_string(n) + (n == 1 ? " point on " : " points on ") + names_[primitive] + ", " +
         std::to_string(settings_.minPoints) + " are needed";
}

double PrimitiveFits::arcLengthAt(const Border& b, double along) const {
  if (b.curvature == 0) return along;
  const double half = b.chordMm / 2, k = std::abs(b.curvature);
  return b.lengthMm / 2 + std::asin(std::clamp((along - half) * k, -1.0, 1.0)) / k;
}

void PrimitiveFits::fitFootBottom() {
  if (coverage_[footBottom_].points < settings_.minPoints) return miss(footBottom_, tooFew(footBottom_));
  footFit_.solve();
  if (!footFit_.solution().valid) return miss(footBottom_, "the points on " + names_[footBottom_] + " make no curve");
  const Eigen::Vector3d& c = footFit_.coefficients();
  constexpr double kScale = FootBottomFit::kFootScaleMm;
  shapes_.footBottom = {GlobalDual::variable(c(0), 0), GlobalDual::variable(c(1), 1) / kScale,
                        GlobalDual::variable(c(2), 2) / (kScale * kScale)};
  blocks_.push_back({&footFit_.solution(), 0});
  miss(footBottom_, "");
}

void PrimitiveFits::fitChain(std::size_t index) {
  ChainFit& chain = chains_[index];
  const auto& members = chain.plan().primitives;
  const auto enough = [&](std::size_t m) { return coverage_[members[m]].points >= settings_.minPoints; };
  const std::size_t anchor = chain.plan().anchor;
  if (!enough(anchor)) {
    for (const std::size_t p : members) miss(p, tooFew(enough(borders_[p].position) ? members[anchor] : p));
    return;
  }
  // Neighbours without points leave the chain from its ends inwards; a short arc is worth keeping only inside.
  std::size_t first = 0, last = members.size() - 1;
  const auto bears = [&](std::size_t m) { return enough(m) && borders_[members[m]].lengthMm >= kShortArcMm; };
  while (first < anchor && !bears(first)) ++first;
  while (last > anchor && !bears(last)) --last;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (m < first || m > last) miss(members[m], tooFew(members[m]));
  if (first > 0 || last + 1 < members.size()) {
    const auto outside = [&](const Assigned& a) {
      const std::size_t m = borders_[a.primitive].position;
      return m < first || m > last;
    };
    chain.points().clear();
    for (const Assigned& a : assigned_)
      if (borders_[a.primitive].fit == static_cast<int>(index) && a.marginMm >= trimOf(a.primitive) && !outside(a))
        chain.points().push_back(a.point);
  }
  chain.solve(first, last);
  std::size_t base = 3;
  for (const Block& b : blocks_) base = std::max(base, b.base + b.solution->unknowns);
  const bool fits = base + chain.solution().unknowns <= kMaxGlobalUnknowns;
  if (!chain.solution().valid || !fits) {
    for (std::size_t m = first; m <= last; ++m)
      miss(members[m], "the points on " + names_[members[m]] + " make no curve");
    return;
  }
  publishChain(index, first, last, base);
}

void PrimitiveFits::publishChain(std::size_t index, std::size_t first, std::size_t last, std::size_t base) {
  const ChainFit& chain = chains_[index];
  const auto& members = chain.plan().primitives;
  const std::size_t count = chain.solution().unknowns;
  for (std::size_t m = first; m <= last; ++m) {
    const CurvePiece<LocalDual>& local = chain.piece(m);
    const std::size_t p = members[m];
    CurvePiece<GlobalDual>& global = shapes_.pieces[p];
    global.origin = {lifted(local.origin.x, base, count), lifted(local.origin.y, base, count)};
    global.tangent = {lifted(local.tangent.x, base, count), lifted(local.tangent.y, base, count)};
    global.curvature = lifted(local.curvature, base, count);
    global.fromMm = local.fromMm;
    global.toMm = local.toMm;
    // At its ends a chain may be read as far as its points went, and over what was trimmed.
    const double reach = settings_.trimMm + kReachMm;
    const Coverage& c = coverage_[p];
    if (m == first) global.fromMm += arcLengthAt(borders_[p], c.lowMm) - reach;
    if (m == last) global.toMm += arcLengthAt(borders_[p], c.highMm) - borders_[p].lengthMm + reach;
    miss(p, "");
  }
  blocks_.push_back({&chain.solution(), base});
}

/// The scatter of the points about the fits tells how right their sigmas are: speckle and roughness show there.
void PrimitiveFits::pool(double correlatedPoints) {
  sorted_.clear();
  // Each unknown takes the freedom of as many points as share an error; on short primitives that count is too rough.
  const auto absorbed = [&](const FitSolution& s) { return static_cast<double>(s.unknowns) * correlatedPoints; };
  const auto isLong = [&](const FitSolution& s) {
    return s.scatter.total() >= std::max<double>(kLongFitPoints, kPointsPerAbsorbed * absorbed(s));
  };
  const auto reduced = [&](const FitSolution& s) { return s.scatter.sum() / (s.scatter.total() - absorbed(s)); };
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
    const int total = s.total();
    if (!isLong(*b.solution) || reduced(*b.solution) > kMisfit * usual) continue;
    const double share = 1 - absorbed(*b.solution) / total;
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
    factor /= std::max(1, s.total());
    if (isLong(*b.solution) && reduced(*b.solution) > kMisfit * std::max(1.0, usual))
      factor = std::max(factor, reduced(*b.solution));
    b.factor = factor * sharedBy(correlatedPoints, s.total());
  }
}

void PrimitiveFits::fit(const Profile& profile, const Registration& registration) {
  gather(profile, registration);
  distribute();
  blocks_.clear();
  fitFootBottom();
  for (std::size_t c = 0; c < chains_.size(); ++c) fitChain(c);
  for (std::size_t p = 0; p < borders_.size(); ++p)
    if (borders_[p].fit < 0) miss(p, names_[p] + " is not fitted");
  pool(std::max(1.0, static_cast<double>(profile.correlatedPoints)));
}

double PrimitiveFits::covariance(const GlobalDual& a, const GlobalDual& b) const {
  double sum = 0;
  for (const Block& block : blocks_) {
    const std::size_t n = block.solution->unknowns;
    double part = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double g = a.gradient[block.base + i];
      if (g == 0) continue;
      double row = 0;
      for (std::size_t j = 0; j < n; ++j)
        row += block.solution->covariance(static_cast<int>(i), static_cast<int>(j)) * b.gradient[block.base + j];
      part += g * row;
    }
    sum += part * block.factor;
  }
  return sum;
}

int PrimitiveFits::pointsOn(const PrimitiveSet& primitives) const {
  int n = 0;
  for (std::size_t p = 0; p < coverage_.size(); ++p)
    if (primitives.test(p)) n += coverage_[p].points;
  return n;
}

void PrimitiveFits::describe(const Transform2& worldFromSection, std::vector<FittedPrimitive>& fitted) const {
  fitted.clear();
  for (std::size_t p = 0; p < borders_.size(); ++p) {
    if (!shapes_.missing[p].empty()) continue;
    const Border& b = borders_[p];
    const Coverage& c = coverage_[p];
    FittedPrimitive f;
    f.primitive = p;
    f.points = c.points;
    CurvePiece<double> piece;
    double from = 0, to = 0;
    if (b.fit == kFootBottom) {  // the parabola as its circle of curvature
      const Eigen::Vector3d& k = footFit_.coefficients();
      constexpr double kScale = FootBottomFit::kFootScaleMm;
      const double slope = k(1) / kScale, norm = std::hypot(1.0, slope);
      piece = {{0, k(0)}, {1 / norm, slope / norm}, 2 * k(2) / (kScale * kScale * norm * norm * norm), 0, 0};
      from = b.start.x();
      to = b.end.x();
      f.rmsMm = std::sqrt(footFit_.solution().meanSquareMm2);
    } else {
      const CurvePiece<GlobalDual>& g = shapes_.pieces[p];
      piece = {{g.origin.x.value, g.origin.y.value}, {g.tangent.x.value, g.tangent.y.value}, g.curvature.value, 0, 0};
      const double reach = settings_.trimMm + kReachMm;
      const auto& chain = chains_[static_cast<std::size_t>(b.fit)];
      from = chain.piece(b.position).fromMm == g.fromMm ? g.fromMm : g.fromMm + reach;
      to = chain.piece(b.position).toMm == g.toMm ? g.toMm : g.toMm - reach;
      f.rmsMm = std::sqrt(chain.solution().meanSquareMm2);
    }
    f.shape = transformed(worldFromSection, primitiveOf(piece, from, to));
    fitted.push_back(f);
  }
}

}  // namespace vignole
