#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/registration/candidate_grid.h"
#include "engine/registration/normal_equations.h"
#include "engine/registration/registration.h"

namespace vignole {
namespace {

constexpr double kCellMm = 1;
constexpr double kMarginMm = 40;
constexpr std::size_t kCoarsePoints = 128;
constexpr std::size_t kMiddlePoints = 640;  // brings the pose within a few micrometres before all points are looked at
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
      : settings(given), name(section.name), carriers(carriersOf(section)), grid(carriers, kCellMm, kMarginMm) {
    centreY = section.heightMm() / 2;
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

  /// Moves points into the section frame and sums a step; `search` looks the nearest primitives up again.
  struct Pass {
    double step = -1;  ///< mm, how far the pose moved; < 0: nothing determined
    double rms = 0;
  };
  Pass pass(const double* px, const double* py, std::size_t n, Transform2& sectionFromWorld, double scale, bool search,
            NormalEquations* kept = nullptr) {
    moveIntoSection(px, py, n, sectionFromWorld);
    if (search)
      for (std::size_t i = 0; i < n; ++i) nearest[i] = grid.nearest(x[i], y[i]);
    NormalEquations equations;
    for (std::size_t i = 0;
         i < n;) {  // runs of one primitive: the paper's primitive caching, and loops without branches
      std::size_t j = i + 1;
      while (j < n && nearest[j] == nearest[i]) ++j;
      equations.add(carriers[nearest[i]], &x[i], &y[i], j - i, 0, centreY, scale);
      i = j;
    }
    if (kept != nullptr) *kept = equations;
    Eigen::Vector3d step;
    if (!equations.solve(step)) return {};
    const Transform2 turn{0, 0, step.z()};
    const Point2 centre(0, centreY);
    const Point2 moved =
        turn * Point2(sectionFromWorld.xMm, sectionFromWorld.yMm - centreY) + centre + Point2(step.x(), step.y());
    sectionFromWorld = {moved.x(), moved.y(), sectionFromWorld.angleRad + step.z()};
    return {std::abs(step.x()) + std::abs(step.y()) + std::abs(step.z()) * centreY,
            std::sqrt(equations.weightedSquares / equations.weight)};
  }

  void moveIntoSection(const double* px, const double* py, std::size_t n, const Transform2& t) {
    const double c = std::cos(t.angleRad), s = std::sin(t.angleRad);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = c * px[i] - s * py[i] + t.xMm;
      y[i] = s * px[i] + c * py[i] + t.yMm;
    }
  }

  /// Looks the nearest primitive of every point up and lays the points out primitive by primitive, whatever their order
  /// and however many strays break it: one run, and one loop without branches, for each primitive.
  void sortByPrimitive(std::size_t n, const Transform2& sectionFromWorld) {
    moveIntoSection(rawX.data(), rawY.data(), n, sectionFromWorld);
    bucketEnd.assign(carriers.size() + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
      found[i] = grid.nearest(x[i], y[i]);
      ++bucketEnd[found[i] + 1U];
    }
    for (std::size_t k = 1; k < bucketEnd.size(); ++k) bucketEnd[k] += bucketEnd[k - 1];
    for (std::size_t i = 0; i < n; ++i) {  // afterwards bucketEnd[k] is one past the last point of primitive k
      const std::uint32_t at = bucketEnd[found[i]]++;
      order[at] = static_cast<std::uint32_t>(i);
      nearest[at] = found[i];
      sortedX[at] = rawX[i];
      sortedY[at] = rawY[i];
    }
  }

  void take(std::span<const ProfilePoint> points) {
    const std::size_t n = points.size();
    if (n > rawX.size())
      for (auto* v : {&rawX, &rawY, &x, &y, &sortedX, &sortedY}) v->resize(n);
    const std::size_t room = std::max({n, nearest.size(), 2 * kMiddlePoints});
    nearest.resize(room);
    found.resize(room);
    order.resize(room);
    for (auto* v : {&x, &y}) v->resize(room);
    for (std::size_t i = 0; i < n; ++i) {
      const bool finite = std::isfinite(points[i].x) && std::isfinite(points[i].y);
      rawX[i] = finite ? points[i].x : kFarMm;
      rawY[i] = finite ? points[i].y : kFarMm;
    }
    thin(n, kCoarsePoints, coarseX, coarseY);
    thin(n, kMiddlePoints, middleX, middleY);
  }

  void thin(std::size_t n, std::size_t wanted, std::vector<double>& tx, std::vector<double>& ty) const {
    tx.clear();
    ty.clear();
    const std::size_t stride = std::max<std::size_t>(1, n / wanted);
    for (std::size_t i = stride / 2; i < n; i += stride) {
      tx.push_back(rawX[i]);
      ty.push_back(rawY[i]);
    }
  }

  /// Tukey's scale shrinks as the subset settles; returns the rounds it took, 0 if nothing was determined.
  int settleCoarsely(Transform2& pose, double scale, double& rms) {
    int round = 0;
    while (round < kCoarseRounds) {
      const Pass p = pass(coarseX.data(), coarseY.data(), coarseX.size(), pose, scale, true);
      ++round;
      if (p.step < 0) return 0;
      rms = p.rms;
      if (p.step < 0.03 && scale <= 2) break;
      const double shrunk = p.step < 0.03 ? 0.3 * scale : std::min(0.7 * scale, std::max(7 * p.rms, 0.4 * scale));
      scale = std::max(1.0, shrunk);
    }
    return round;
  }

  /// How badly the subset fits: 0 all on the outline, 1 all further than kNearMm.
  double coarseCost(const Transform2& pose) {
    const std::size_t n = coarseX.size();
    moveIntoSection(coarseX.data(), coarseY.data(), n, pose);
    double cost = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double d2 = carriers[grid.nearest(x[i], y[i])].squaredDistance(x[i], y[i]);
      cost += std::min(1.0, d2 / (kNearMm * kNearMm));
    }
    return cost / static_cast<double>(n);
  }

  Extent extentOf(const std::vector<double>& values) {
    sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t cut = sorted.size() / 32;  // a few strays must not say how large the rail is
    return {sorted[cut], sorted[sorted.size() - 1 - cut]};
  }

  struct Start {
    Transform2 pose;
    double cost = 2, rms = 0;
    int rounds = 0;
  };
  void tryStart(const Transform2& from, double scale, Start& best) {
    Start candidate{from};
    candidate.rounds = settleCoarsely(candidate.pose, scale, candidate.rms);
    if (candidate.rounds == 0) return;
    candidate.cost = coarseCost(candidate.pose);
    if (candidate.cost < best.cost) best = candidate;
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
    Start best;
    tryStart(given ? given->inverse() : Transform2{}, given ? settings.trackScaleMm : settings.startScaleMm, best);
    if (1 - best.cost < kGoodShare) {
      if (given) tryStart({}, settings.startScaleMm, best);
      tryExtents(best);
    }
    return best;
  }

  void evaluate(std::span<const ProfilePoint> points, const Transform2& pose, Registration& r) {
    const std::size_t n = points.size();
    moveIntoSection(sortedX.data(), sortedY.data(), n, pose);
    double squares = 0, chi2 = 0, assignedSquares = 0, variance = 0;
    int near = 0, assigned = 0;
    for (std::size_t k = 0, i = 0; k < carriers.size(); ++k) {
      PrimitiveResidual& p = r.primitives[k];
      for (; i < bucketEnd[k]; ++i) {
        const double d = carriers[k].residual(x[i], y[i]), distance = std::abs(d), d2 = d * d;
        const std::uint32_t point = order[i];
        r.residualMm[point] = static_cast<float>(d);
        if (distance > settings.assignMm) continue;  // stays -1
        r.primitiveOfPoint[point] = static_cast<std::int16_t>(k);
        const float given = points[point].sigmaMm;
        const double sigma = given > 0 ? given : kFallbackSigmaMm, c = d2 / (sigma * sigma);
        ++assigned;
        assignedSquares += d2;
        ++p.points;
        p.meanMm += d;
        p.rmsMm += d2;
        p.chi2 += c;
        if (distance < kNearMm) {
          ++near;
          chi2 += c;
        }
        if (distance < std::max(3 * sigma, settings.inlierMm)) {
          ++r.inliers;
          squares += d2;
          variance += sigma * sigma;
        }
      }
    }
    for (PrimitiveResidual& p : r.primitives) {
      if (p.points == 0) continue;
      p.meanMm /= p.points;
      p.rmsMm = std::sqrt(p.rmsMm / p.points);
      p.chi2 /= p.points;
    }
    r.rmsMm = r.inliers > 0 ? std::sqrt(squares / r.inliers) : 0;
    r.chi2 = near > 0 ? chi2 / near : 0;
    assignedRms = assigned > 0 ? std::sqrt(assignedSquares / assigned) : settings.assignMm;
    meanVariance = r.inliers > 0 ? variance / r.inliers : 0;
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
    clear(r, points.size(), carriers.size());
    if (points.size() < kMinPoints) {
      r.reason =
          "only " + std::to_string(points.size()) + " points, at least " + std::to_string(kMinPoints) + " are needed";
      return;
    }
    take(points);
    const Start best = findStart(start);
    if (best.rounds == 0) {
      r.reason = "no point is near the outline of " + name;
      return;
    }
    Transform2 pose = best.pose;
    double scale = std::clamp(6 * best.rms, 0.15, 1.0);
    NormalEquations equations;
    if (const Pass p = pass(middleX.data(), middleY.data(), middleX.size(), pose, scale, true); p.step >= 0)
      scale = std::clamp(6 * p.rms, 0.15, scale);
    sortByPrimitive(points.size(), pose);
    pass(sortedX.data(), sortedY.data(), points.size(), pose, scale, false, &equations);
    r.iterations = best.rounds + 2;
    evaluate(points, pose, r);
    r.worldFromSection = pose.inverse();
    r.worldFromSection.angleRad = std::remainder(r.worldFromSection.angleRad, 2 * 3.14159265358979323846);
    judge(r);
    propagate(equations, correlatedPoints, r);
    r.timeUs = microsecondsSince(began);
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
    r.covariance = rotation * inverse * rotation.transpose() * (meanVariance * std::max(1.0, correlatedPoints));
  }

  RegistrationSettings settings;
  std::string name;
  std::vector<Carrier> carriers;
  CandidateGrid grid;
  double centreY = 0;
  Extent outlineX, outlineY, headX;
  std::vector<double> rawX, rawY, x, y, sortedX, sortedY, coarseX, coarseY, middleX, middleY, sorted;
  std::vector<std::uint16_t> nearest, found;
  std::vector<std::uint32_t> order, bucketEnd;
  double assignedRms = 0, meanVariance = 0;
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

}  // namespace vignole
