#include "calibration/drift/drift_watch.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace vignole {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kFreeMm = 10, kFreeRad = 0.1;  // standard deviation of what no seam determines
/// Two cameras cannot be told apart unless one explains the seams that much better, chi^2 (5 standard deviations).
constexpr double kTellsApart = 25;
constexpr double kNotAll = 4;  // chi^2 a degree of freedom

std::string wordsFor(const CameraDrift& drift, const std::string& who, bool notAll) {
  std::array<char, 320> text{};
  std::snprintf(text.data(), text.size(),
                "%s: its points have moved by %.3f mm since the first rails after the calibration (x %+.3f, y %+.3f, "
                "turn %+.4f deg)%s; look at its mount and its lens, then calibrate again",
                who.c_str(), drift.valueMm, drift.xMm, drift.yMm, drift.turnDeg,
                notAll ? ", which does not explain all: a lens has changed, or others have moved, too" : "");
  return text.data();
}

}  // namespace

/// The best motion of some cameras that explains the seams' changes.
struct DriftJudge::Motion {
  std::vector<int> cameras;
  Eigen::VectorXd value;  ///< x, y (mm), turn (rad) of each
  Eigen::MatrixXd covariance;
  double explained = 0;  ///< by how much it lowers chi^2
};

DriftJudge::DriftJudge(std::vector<SeamZone> zones, const DriftSettings& settings)
    : zones_(std::move(zones)), settings_(settings), states_(zones_.size()) {
  settings_.baselineRails = std::max(2, settings_.baselineRails);
  settings_.lambda = std::clamp(settings_.lambda, 0.01, 1.0);
  for (int c = 0; c < kCameraCount; ++c) indicators_.cameras[static_cast<std::size_t>(c)].camera = c;
}

const DriftIndicators& DriftJudge::add(const std::vector<Seam>& rail) {
  const bool any = std::any_of(rail.begin(), rail.end(), [](const Seam& s) { return s.weight > 0; });
  if (!any || rail.size() != zones_.size()) return indicators_;
  ++indicators_.rails;
  if (indicators_.learning) {
    learn(rail);
    if (indicators_.rails == static_cast<std::uint64_t>(settings_.baselineRails)) finishBaseline();
  } else {
    follow(rail);
    judge();
  }
  return indicators_;
}

void DriftJudge::learn(const std::vector<Seam>& rail) {
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    if (!(rail[z].weight > 0)) continue;
    State& s = states_[z];
    ++s.rails;
    s.baseWeight += rail[z].weight;
    const double before = rail[z].mm - s.baseMm;
    s.baseMm += before * rail[z].weight / s.baseWeight;
    s.baseSquares += rail[z].weight * before * (rail[z].mm - s.baseMm);
  }
}

/// How much seams differ from rail to rail is the same for all but for their weight, so few rails tell it.
void DriftJudge::finishBaseline() {
  double squares = 0, freedom = 0;
  for (State& s : states_) {
    if (2 * s.rails < settings_.baselineRails) s = {};  // seen too seldom to be watched
    if (s.rails == 0) continue;
    squares += s.baseSquares;
    freedom += s.rails - 1;
  }
  if (!(freedom > 0)) return;  // no seam on any two rails: goes on learning
  variance_ = squares / freedom;
  indicators_.learning = false;
}

void DriftJudge::follow(const std::vector<Seam>& rail) {
  const double l = settings_.lambda;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    State& s = states_[z];
    if (s.rails == 0 || !(rail[z].weight > 0)) continue;
    s.changeMm += l * (rail[z].mm - s.baseMm - s.changeMm);
    s.changeVariance = (1 - l) * (1 - l) * s.changeVariance + l * l / rail[z].weight;
  }
}

DriftJudge::Motion DriftJudge::motionOf(std::vector<int> cameras) const {
  const auto n = static_cast<Eigen::Index>(3 * cameras.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) a(i, i) = i % 3 == 2 ? 1 / (kFreeRad * kFreeRad) : 1 / (kFreeMm * kFreeMm);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const State& s = states_[z];
    if (s.rails == 0) continue;
    const SeamZone& zone = zones_[z];
    const Eigen::Vector3d slope(zone.normal.x(), zone.normal.y(),
                                zone.at.x() * zone.normal.y() - zone.at.y() * zone.normal.x());
    Eigen::VectorXd g = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      if (zone.first == cameras[k]) g.segment<3>(static_cast<Eigen::Index>(3 * k)) += slope;
      if (zone.second == cameras[k]) g.segment<3>(static_cast<Eigen::Index>(3 * k)) -= slope;
    }
    const double weight = 1 / (variance_ * (s.changeVariance + 1 / s.baseWeight));
    a += weight * g * g.transpose();
    b += weight * s.changeMm * g;
  }
  Motion motion;
  motion.cameras = std::move(cameras);
  motion.covariance = a.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  motion.value = motion.covariance * b;
  motion.explained = b.dot(motion.value);
  return motion;
}

/// Of the motion's camera number `which`.
void DriftJudge::describe(const Motion& motion, std::size_t which, CameraDrift& drift) const {
  const auto at = static_cast<Eigen::Index>(3 * which);
  const Eigen::Vector3d v = motion.value.segment<3>(at);
  const Eigen::Matrix3d covariance = motion.covariance.block<3, 3>(at, at);
  drift.xMm = v.x();
  drift.yMm = v.y();
  drift.turnDeg = v.z() * kDegrees;
  drift.valueMm = 0;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const SeamZone& zone = zones_[z];
    if (states_[z].rails == 0 || (zone.first != drift.camera && zone.second != drift.camera)) continue;
    const Point2 shift(v.x() - v.z() * zone.at.y(), v.y() + v.z() * zone.at.x());
    const double mm = shift.norm();
    if (!(mm > drift.valueMm)) continue;
    const Point2 d = shift / mm;
    const Eigen::Vector3d slope(d.x(), d.y(), zone.at.x() * d.y() - zone.at.y() * d.x());
    drift.valueMm = mm;
    drift.uMm = std::sqrt(slope.dot(covariance * slope));
  }
  drift.limitMm = std::max(settings_.limitMm, settings_.limitInU * drift.uMm);
}

void DriftJudge::judge() {
  std::vector<Motion> alone;
  std::size_t best = 0;
  for (int c = 0; c < kCameraCount; ++c) {
    const auto k = static_cast<std::size_t>(c);
    alone.push_back(motionOf({c}));
    CameraDrift& drift = indicators_.cameras[k];
    drift.alarm = false;
    drift.words.clear();
    describe(alone[k], 0, drift);
    if (alone[k].explained > alone[best].explained) best = k;
  }
  double total = 0, freedom = -3;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const State& s = states_[z];
    if (s.rails == 0) continue;
    total += s.changeMm * s.changeMm / (variance_ * (s.changeVariance + 1 / s.baseWeight));
    freedom += 1;
  }
  indicators_.unexplained = freedom > 0 ? (total - alone[best].explained) / freedom : 0;
  CameraDrift& named = indicators_.cameras[best];
  named.alarm = named.valueMm > named.limitMm;
  if (!named.alarm) return;
  std::string who = "camera " + std::to_string(best + 1);
  for (std::size_t k = 0; k < kCameraCount; ++k) {
    if (k == best) continue;
    CameraDrift& other = indicators_.cameras[k];
    if (alone[k].explained > alone[best].explained - kTellsApart) {
      who += " or camera " + std::to_string(k + 1);
      other.alarm = other.valueMm > other.limitMm;
    } else {
      describe(motionOf({named.camera, other.camera}), 1, other);  // beside the motion of the named one
    }
  }
  for (CameraDrift& drift : indicators_.cameras)
    if (drift.alarm) drift.words = wordsFor(drift, who, indicators_.unexplained > kNotAll);
}

DriftWatch::DriftWatch(const Section& section, const DriftSettings& settings)
    : settings_(settings), seams_(section), judge_(seamZones(section), settings) {
  settings_.everyNthProfile = std::max(1, settings_.everyNthProfile);
}

void DriftWatch::add(const Profile& profile, const Registration& registration) {
  if (profile_++ % static_cast<std::uint64_t>(settings_.everyNthProfile) == 0) seams_.add(profile, registration);
}

const DriftIndicators& DriftWatch::endRail() {
  profile_ = 0;
  return judge_.add(seams_.take());
}

}  // namespace vignole
