#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "engine/registration/candidate_grid.h"
#include "engine/registration/normal_equations.h"
#include "engine/registration/pose_kernels.h"
#include "engine/registration/registration.h"
#include "engine/stripe/stripe.h"

namespace vignole {
namespace {

constexpr double kCellMm = 1;
constexpr double kMarginMm = 40;
constexpr std::size_t kCoarsePoints = 128;
constexpr int kCoarseRounds = 25;
constexpr std::size_t kMinPoints = 20;
constexpr float kFallbackSigmaMm = 0.03F;  // where a point comes without its uncertainty
constexpr double kNearMm = 1.0;            // points further than this from the outline do not enter chi2
constexpr double kGoodShare = 0.6;         // so many points near the outline: other starts need not be tried
constexpr double kFarMm = 1e7;             // where a point without finite coordinates is put: never an inlier

double microsecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

std::string percent(double share) { return std::to_string(static_cast<int>(std::lround(100 * share))) + " %"; }

struct Extent {
  double low = 0, high = 0;
  [[nodiscard]] double middle() const { return (low + high) / 2; }
};

}  // namespace

struct Registrar::Impl {
  Impl(const Section& section, const RegistrationSettings& given)
      : settings(given),
        name(section.name),
        carriers(carriersOf(section)),
        grid(carriers, kCellMm, kMarginMm, std::max(settings.assignMm, kNearMm)) {
    centreY = section.heightMm() / 2;
    for (const Carrier& c : carriers) flat.push_back(c.flat());
    measureSection(section);
  }

  static std::vector<Carrier> carriersOf(const Section& section) {
    std::vector<Carrier> result;
    for (const auto& p : section.primitives) result.push_back(Carrier::of(p.shape));
    return result;
  }

  void measureSection(const Section& section) {
    outlineX = outlineY = {1e300, -1e300};
    for (const Carrier& c : carriers) {
      outlineX = {std::min(outlineX.low, c.startX), std::max(outlineX.high, c.startX)};
      outlineY = {std::min(outlineY.low, c.startY), std::max(outlineY.high, c.startY)};
    }
    outlineY.high = section.heightMm();
    headX = outlineX;
    if (const auto left = section.find("SHL"), right = section.find("SHR"); left && right)
      headX = {carriers[*left].startX, carriers[*right].startX};
  }

  /// Poses here are section from anchor: the world, shifted to near the data.
  static Motion motionOf(const Transform2& pose) {
    const auto narrow = [](double value) { return static_cast<float>(value); };
    return {narrow(std::cos(pose.angleRad)), narrow(std::sin(pose.angleRad)), narrow(pose.xMm), narrow(pose.yMm)};
  }
  [[nodiscard]] Tukey tukey(double scaleMm) const { return {static_cast<float>(centreY), static_cast<float>(scaleMm)}; }
  static Points pointsOf(const std::vector<float>& px, const std::vector<float>& py, std::size_t n) {
    return {px.data(), py.data(), n};
  }

  struct Pass {
    double step = -1;  ///< mm, how far the pose moved; < 0: nothing determined
    double rms = 0;
  };
  [[nodiscard]] Pass stepPose(const NormalEquations& equations, Transform2& pose) const {
    Eigen::Vector3d step;
    if (!equations.solve(step)) return {};
    const Transform2 turn{0, 0, step.z()};
    const Point2 centre(0, centreY);
    const Point2 moved = turn * Point2(pose.xMm, pose.yMm - centreY) + centre + Point2(step.x(), step.y());
    pose = {moved.x(), moved.y(), pose.angleRad + step.z()};
    return {std::abs(step.x()) + std::abs(step.y()) + std::abs(step.z()) * centreY,
            std::sqrt(equations.weightedSquares / equations.weight)};
  }

  void take(std::span<const ProfilePoint> points) {
    const std::size_t n = points.size(), room = std::max(n, 2 * kCoarsePoints) + kSlack;
    if (rawX.size() < room) {
      for (auto* v : {&rawX, &rawY, &rawSigma, &x, &y, &sigma, &residual, &coarseX, &coarseY}) v->resize(room);
      // What lies beyond the points is read, but nothing comes of it.
      cells.resize(room);
      home.resize(room);
      order.resize(room);
    }
    anchor = anchorOf(points);
    bodyVariance = 0;
    body = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double px = points[i].x - anchor.x(), py = points[i].y - anchor.y();
      const bool near = std::abs(px) < kFarMm && std::abs(py) < kFarMm;  // not if it is no number either
      rawX[i] = static_cast<float>(near ? px : kFarMm);
      rawY[i] = static_cast<float>(near ? py : kFarMm);
      rawSigma[i] = points[i].sigmaMm > 0 ? points[i].sigmaMm : kFallbackSigmaMm;
      if ((points[i].flags & (kLineEnd | kGapEdge)) != 0) continue;
      const float ridge = points[i].ridgeSigmaMm > 0 ? points[i].ridgeSigmaMm : rawSigma[i];
      bodyVariance += static_cast<double>(ridge * ridge);
      ++body;
    }
    const std::size_t stride = std::max<std::size_t>(1, n / kCoarsePoints);
    coarse = 0;
    for (std::size_t i = stride / 2; i < n; i += stride, ++coarse) {
      coarseX[coarse] = rawX[i];
      coarseY[coarse] = rawY[i];
    }
  }

  /// A place among the points, whatever a few of them say. Any will do: it only keeps numbers small.
  static Point2 anchorOf(std::span<const ProfilePoint> points) {
    std::array<double, 15> px{}, py{};
    for (std::size_t k = 0; k < px.size(); ++k) {
      const ProfilePoint& p = points[k * (points.size() - 1) / (px.size() - 1)];
      px[k] = std::isfinite(p.x) ? p.x : kFarMm;
      py[k] = std::isfinite(p.y) ? p.y : kFarMm;
    }
    for (auto* v : {&px, &py}) std::nth_element(v->begin(), v->begin() + v->size() / 2, v->end());
    const Point2 middle(px[px.size() / 2], py[py.size() / 2]);
    return middle.cwiseAbs().maxCoeff() < kFarMm ? middle : Point2(0, 0);
  }

  /// Lays the points out primitive by primitive, whatever their order and however many strays break it: one run, and
  /// one loop without branches, for each primitive. Points far from the outline come last and belong to no run.
  void sortByPrimitive(std::size_t n, const Transform2& pose) {
    const Motion m = motionOf(pose);
    locate(pointsOf(rawX, rawY, n), m, grid.frame(), cells.data());
    bucketEnd.assign(carriers.size() + 2, 0);
    for (std::size_t i = 0; i < n; ++i) {
      home[i] = grid.within(cells[i], m.cosine * rawX[i] - m.sine * rawY[i] + m.x,
                            m.sine * rawX[i] + m.cosine * rawY[i] + m.y);
      ++bucketEnd[home[i] + 1U];
    }
    for (std::size_t k = 1; k < bucketEnd.size(); ++k) bucketEnd[k] += bucketEnd[k - 1];
    runs.clear();
    for (std::uint32_t k = 0; k < carriers.size(); ++k)
      if (bucketEnd[k] < bucketEnd[k + 1]) runs.push_back({k, bucketEnd[k], bucketEnd[k + 1]});
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t at = bucketEnd[home[i]]++;
      order[at] = static_cast<std::uint32_t>(i);
      x[at] = rawX[i];
      y[at] = rawY[i];
      sigma[at] = rawSigma[i];
    }
  }

  Pass passOverAll(std::size_t n, Transform2& pose, double scale, NormalEquations& equations) const {
    equations = {};
    sumRuns(pointsOf(x, y, n), motionOf(pose), flat.data(), runs, tukey(scale), equations);
    return stepPose(equations, pose);
  }

  struct Start {
    Transform2 pose;
    double cost = 2;  ///< how badly the subset fits: 0 all on the outline, 1 all further than 1 mm
    double rms = 0;
    int rounds = 0;
  };

  /// Tukey's scale shrinks as the subset settles.
  void tryStart(const Transform2& from, double scale, Start& best) {
    Start candidate{from};
    const Points points = pointsOf(coarseX, coarseY, coarse);
    for (bool settled = false; !settled && candidate.rounds < kCoarseRounds; ++candidate.rounds) {
      const Motion motion = motionOf(candidate.pose);
      locate(points, motion, grid.frame(), cells.data());
      for (std::size_t i = 0; i < coarse; ++i) cells[i] = grid.roughly(cells[i]);
      NormalEquations equations;
      candidate.cost = sumScattered(points, motion, flat.data(), cells.data(), tukey(scale), equations) /
                       static_cast<double>(coarse);
      const Pass p = stepPose(equations, candidate.pose);
      if (p.step < 0) return;
      candidate.rms = p.rms;
      settled = p.step < 0.03 && scale <= 2;
      const double shrunk = p.step < 0.03 ? 0.3 * scale : std::min(0.7 * scale, std::max(7 * p.rms, 0.4 * scale));
      scale = std::max(1.0, shrunk);
    }
    if (candidate.cost < best.cost) best = candidate;
  }

  Extent extentOf(const std::vector<float>& values) {
    sorted.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(coarse));
    std::sort(sorted.begin(), sorted.end());
    const std::size_t cut = sorted.size() / 32;  // a few strays must not say how large the rail is
    return {static_cast<double>(sorted[cut]), static_cast<double>(sorted[sorted.size() - 1 - cut])};
  }

  /// The data laid onto the section by their extents: as a whole, as a head, as a foot, by one side only.
  void tryExtents(Start& best) {
    const Extent dataX = extentOf(coarseX), dataY = extentOf(coarseY);
    const std::array<double, 5> shiftX = {-dataX.middle(), outlineX.low - dataX.low, outlineX.high - dataX.high,
                                          headX.low - dataX.low, headX.high - dataX.high};
    const std::array<double, 3> shiftY = {outlineY.high - dataY.high, outlineY.middle() - dataY.middle(),
                                          outlineY.low - dataY.low};
    for (const double dy : shiftY)
      for (const double dx : shiftX) tryStart({dx, dy, 0}, settings.startScaleMm / 2, best);
  }

  Start findStart(const std::optional<Transform2>& given) {
    const Transform2 worldFromAnchor{anchor.x(), anchor.y(), 0};
    Start best;
    tryStart((given ? given->inverse() : Transform2{}) * worldFromAnchor,
             given ? settings.trackScaleMm : settings.startScaleMm, best);
    if (1 - best.cost < kGoodShare) {
      if (given) tryStart(worldFromAnchor, settings.startScaleMm, best);
      tryExtents(best);
    }
    return best;
  }

  void evaluate(std::size_t n, const Transform2& pose, Registration& r) {
    const Motion motion = motionOf(pose);
    const auto narrow = [](double value) { return static_cast<float>(value); };
    const ResidualLimits limits{narrow(settings.assignMm), narrow(settings.inlierMm), narrow(kNearMm)};
    RunResiduals all;
    for (const Run& run : runs) {
      const RunResiduals of =
          residualsOf(pointsOf(x, y, n), sigma.data(), motion, flat[run.primitive], run, limits, residual.data());
      for (std::uint32_t i = run.from; i < run.to; ++i) {
        if (std::abs(residual[i]) > limits.assignMm) continue;  // stays -1
        r.residualMm[order[i]] = residual[i];
        r.primitiveOfPoint[order[i]] = static_cast<std::int16_t>(run.primitive);
      }
      if (of.assigned > 0)
        r.primitives[run.primitive] = {static_cast<int>(of.assigned), std::sqrt(of.squares / of.assigned),
                                       of.sum / of.assigned, of.chi2 / of.assigned};
      all.assigned += of.assigned;
      all.squares += of.squares;
      all.near += of.near;
      all.nearChi2 += of.nearChi2;
      all.inliers += of.inliers;
      all.inlierSquares += of.inlierSquares;
      all.inlierVariance += of.inlierVariance;
    }
    r.inliers = static_cast<int>(all.inliers);
    r.rmsMm = all.inliers > 0 ? std::sqrt(all.inlierSquares / all.inliers) : 0;
    r.chi2 = all.near > 0 ? all.nearChi2 / all.near : 0;
    assignedRms = all.assigned > 0 ? std::sqrt(all.squares / all.assigned) : settings.assignMm;
    meanVariance = all.inliers > 0 ? all.inlierVariance / all.inliers : 0;
  }

  void judge(Registration& r) const {
    const double share = static_cast<double>(r.inliers) / r.points;
    r.valid = share >= settings.minInlierShare && assignedRms <= settings.maxRmsMm;
    if (r.valid) return;
    char rms[32];
    std::snprintf(rms, sizeof rms, "%.2f", assignedRms);
    r.reason = "the points do not agree with " + name + ": " + percent(share) + " lie on it, rms " + rms +
               " mm; another rail, badly worn, or not a rail?";
  }

  static void clear(Registration& r, std::size_t points, std::size_t primitives) {
    r.valid = false;
    r.reason.clear();
    r.looksLike.reset();
    r.worldFromSection = {};
    r.covariance.setZero();
    r.rmsMm = r.chi2 = r.timeUs = 0;
    r.inliers = r.iterations = 0;
    r.points = static_cast<int>(points);
    r.primitiveOfPoint.assign(points, -1);
    r.residualMm.assign(points, 0);
    r.primitives.assign(primitives, {});
  }

  void run(std::span<const ProfilePoint> points, Registration& r, const std::optional<Transform2>& start,
           double correlatedPoints) {
    const auto began = std::chrono::steady_clock::now();
    if (!begin(points, r)) return;
    settle(findStart(start), correlatedPoints, r);
    r.timeUs = microsecondsSince(began);
  }

  void runFrom(const Transform2& start, double scaleMm, std::span<const ProfilePoint> points, Registration& r) {
    const auto began = std::chrono::steady_clock::now();
    if (!begin(points, r)) return;
    Start best;
    tryStart(start.inverse() * Transform2{anchor.x(), anchor.y(), 0}, scaleMm, best);
    if (1 - best.cost < kGoodShare) best.rounds = 0;
    settle(best, 1, r);
    r.timeUs = microsecondsSince(began);
  }

  bool begin(std::span<const ProfilePoint> points, Registration& r) {
    clear(r, points.size(), carriers.size());
    if (points.size() < kMinPoints) {
      r.reason =
          "only " + std::to_string(points.size()) + " points, at least " + std::to_string(kMinPoints) + " are needed";
      return false;
    }
    take(points);
    return true;
  }

  void settle(const Start& best, double correlatedPoints, Registration& r) {
    if (best.rounds == 0) {
      r.reason = "no point is near the outline of " + name;
      return;
    }
    const auto n = static_cast<std::size_t>(r.points);
    Transform2 pose = best.pose;
    sortByPrimitive(n, pose);
    NormalEquations equations;
    double scale = std::clamp(6 * best.rms, 0.15, 1.0);
    if (const Pass p = passOverAll(n, pose, scale, equations); p.step >= 0) scale = std::clamp(6 * p.rms, 0.15, scale);
    passOverAll(n, pose, scale, equations);
    r.iterations = best.rounds + 2;
    evaluate(n, pose, r);
    r.worldFromSection = Transform2{anchor.x(), anchor.y(), 0} * pose.inverse();
    r.worldFromSection.angleRad = std::remainder(r.worldFromSection.angleRad, 2 * 3.14159265358979323846);
    judge(r);
    propagate(equations, correlatedPoints, r);
  }

  void propagate(const NormalEquations& equations, double correlatedPoints, Registration& r) const {
    Eigen::Matrix3d inverse;
    bool invertible = false;
    equations.matrix().computeInverseWithCheck(inverse, invertible, 1e-12);
    if (!invertible) {
      r.valid = false;
      if (r.reason.empty()) r.reason = "the points do not determine a pose";
      return;
    }
    const Transform2 turn{0, 0, r.worldFromSection.angleRad};
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    rotation.block<2, 1>(0, 0) = turn.rotate({1, 0});
    rotation.block<2, 1>(0, 1) = turn.rotate({0, 1});
    // Points that were smoothed along their line are surer and share their error further: what they tell together is
    // what the ridge told. The ends of the lines are few and far less sure; they would speak for all.
    const double variance = body > kMinPoints ? bodyVariance / static_cast<double>(body) : meanVariance;
    r.covariance = rotation * inverse * rotation.transpose() * (variance * std::max(1.0, correlatedPoints));
  }

  RegistrationSettings settings;
  std::string name;
  std::vector<Carrier> carriers;
  std::vector<FlatCarrier> flat;
  CandidateGrid grid;
  double centreY = 0;
  Extent outlineX, outlineY, headX;
  // Of the profile in hand. Points as they came, relative to the anchor; a few of them; and primitive by primitive.
  Point2 anchor{0, 0};
  std::vector<float> rawX, rawY, rawSigma, coarseX, coarseY, x, y, sigma, residual, sorted;
  std::size_t coarse = 0;
  std::vector<std::int32_t> cells;
  std::vector<std::uint16_t> home;
  std::vector<std::uint32_t> order, bucketEnd;
  std::vector<Run> runs;
  double assignedRms = 0, meanVariance = 0;
  double bodyVariance = 0;  ///< of the ridge, summed over the points that no end of a line touches
  std::size_t body = 0;
};

Registrar::Registrar(const Section& section, const RegistrationSettings& settings)
    : impl_(std::make_unique<Impl>(section, settings)) {}
Registrar::~Registrar() = default;
Registrar::Registrar(Registrar&&) noexcept = default;
Registrar& Registrar::operator=(Registrar&&) noexcept = default;

void Registrar::registerProfile(std::span<const ProfilePoint> points, Registration& result,
                                const std::optional<Transform2>& start, double correlatedPoints) {
  impl_->run(points, result, start, correlatedPoints);
}
void Registrar::registerFrom(const Transform2& start, double scaleMm, std::span<const ProfilePoint> points,
                             Registration& result) {
  impl_->runFrom(start, scaleMm, points, result);
}

}  // namespace vignole
