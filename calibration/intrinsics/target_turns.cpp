#include "calibration/intrinsics/target_turns.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numeric>

namespace vignole {

namespace {

/// Where a view sees the target's points off, in the target's plane, mm; by index, zero where it does not see them.
struct ErrorField {
  std::vector<Point2> off;
  std::vector<bool> seen;
  double sigmaMm = 0;  ///< of each coordinate
};

ErrorField errorField(const ObservedView& view, std::size_t v, const TargetObservations& observations,
                      const TargetFit& fit) {
  ErrorField field{std::vector<Point2>(observations.points.size(), Point2(0, 0)),
                   std::vector<bool>(observations.points.size(), false), 0};
  double squares = 0, count = 0;
  for (const Observation& o : view) {
    const auto index = static_cast<std::size_t>(o.point);
    Reprojection r;
    if (!reproject(fit.intrinsics, fit.cameraFromTarget[v], fit.points[index], observations.radiusMm, r)) continue;
    field.off[index] = r.byPoint.leftCols<2>().inverse() * (o.px - r.px);
    field.seen[index] = true;
    squares += field.off[index].squaredNorm();
    count += 2;
  }
  field.sigmaMm = count > 0 ? std::sqrt(squares / count) : 0;
  return field;
}

ErrorField turned(const ErrorField& field, const TargetTurn& turn) {
  ErrorField result = field;
  const Eigen::Matrix2d r = turn.turnedFromTarget.rotation.topLeftCorner<2, 2>();
  for (std::size_t i = 0; i < field.off.size(); ++i) {
    result.off[turn.places[i]] = r * field.off[i];
    result.seen[turn.places[i]] = field.seen[i];
  }
  return result;
}

/// Sum of fields, and in how many a point was seen.
struct FieldSum {
  std::vector<Point2> off;
  std::vector<double> count;
  explicit FieldSum(std::size_t points) : off(points, Point2(0, 0)), count(points, 0) {}
  void add(const ErrorField& field, double sign) {
    for (std::size_t i = 0; i < off.size(); ++i) {
      if (!field.seen[i]) continue;
      off[i] += sign * field.off[i];
      count[i] += sign;
    }
  }
  [[nodiscard]] Point2 mean(std::size_t i) const { return count[i] > 0 ? Point2(off[i] / count[i]) : Point2(0, 0); }
};

/// How alike a field is to the mean, and how uncertain that is if it were chance.
struct Likeness {
  double sum = 0, variance = 0;
};
Likeness likeness(const ErrorField& field, const FieldSum& mean) {
  Likeness l;
  for (std::size_t i = 0; i < field.off.size(); ++i) {
    if (!field.seen[i]) continue;
    const Point2 m = mean.mean(i);
    l.sum += field.off[i].dot(m);
    l.variance += m.squaredNorm() * field.sigmaMm * field.sigmaMm;
  }
  return l;
}

/// The turn that makes the field most alike to the mean, -1 for none.
int bestTurn(const ErrorField& field, const FieldSum& mean, const std::vector<TargetTurn>& turns) {
  constexpr double kBeyondChance = 4;  // standard deviations
  const Likeness asItIs = likeness(field, mean);
  int best = -1;
  double most = asItIs.sum;
  for (std::size_t t = 0; t < turns.size(); ++t) {
    const Likeness l = likeness(turned(field, turns[t]), mean);
    if (l.sum > most && l.sum - asItIs.sum > kBeyondChance * std::sqrt(l.variance + asItIs.variance)) {
      most = l.sum;
      best = static_cast<int>(t);
    }
  }
  return best;
}

}  // namespace

std::vector<TargetTurn> turnsOf(const std::vector<Eigen::Vector3d>& points) {
  constexpr double kSameMm = 1e-6;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) middle += p / static_cast<double>(points.size());
  const std::array<Eigen::Vector2d, 3> quarters = {Eigen::Vector2d(-1, 0), {0, 1}, {0, -1}};  // cosine, sine
  std::vector<TargetTurn> turns;
  for (const Eigen::Vector2d& q : quarters) {
    TargetTurn turn;
    turn.turnedFromTarget.rotation << q.x(), -q.y(), 0, q.y(), q.x(), 0, 0, 0, 1;
    turn.turnedFromTarget.translationMm = middle - turn.turnedFromTarget.rotation * middle;
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d to = turn.turnedFromTarget.rotation * p + turn.turnedFromTarget.translationMm;
      std::size_t place = 0;
      while (place < points.size() && (points[place] - to).norm() > kSameMm) ++place;
      if (place == points.size()) break;
      turn.places.push_back(place);
    }
    if (turn.places.size() == points.size()) turns.push_back(std::move(turn));
  }
  return turns;
}

std::vector<int> turnedViews(const TargetObservations& observations, const TargetFit& fit,
                             const std::vector<TargetTurn>& turns) {
  std::vector<int> result(observations.views.size(), -1);
  if (turns.empty()) return result;
  std::vector<ErrorField> fields, asCounted;
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    fields.push_back(errorField(observations.views[v], v, observations, fit));
  asCounted = fields;
  const auto redo = [&](std::size_t v, FieldSum& sum, bool inSum) {
    if (inSum) sum.add(fields[v], -1);
    result[v] = bestTurn(asCounted[v], sum, turns);
    fields[v] = result[v] < 0 ? asCounted[v] : turned(asCounted[v], turns[static_cast<std::size_t>(result[v])]);
    sum.add(fields[v], 1);
  };
  FieldSum sum(observations.points.size());
  for (std::size_t v = 0; v < fields.size(); ++v) redo(v, sum, false);
  constexpr int kRounds = 3;  // the first views were judged by few
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t v = 0; v < fields.size(); ++v) redo(v, sum, true);
  return result;
}

void turn(const TargetTurn& by, ObservedView& view) {
  for (Observation& o : view) o.point = static_cast<int>(by.places[static_cast<std::size_t>(o.point)]);
}

void turn(const TargetTurn& by, Extrinsics& cameraFromTarget) {
  const Eigen::Matrix3d targetFromTurned = by.turnedFromTarget.rotation.transpose();
  const Eigen::Matrix3d rotation = cameraFromTarget.rotation * targetFromTurned;
  cameraFromTarget.translationMm -= rotation * by.turnedFromTarget.translationMm;
  cameraFromTarget.rotation = rotation;
}

}  // namespace vignole
