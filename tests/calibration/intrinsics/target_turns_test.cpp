#include "calibration/intrinsics/target_turns.h"

#include <gtest/gtest.h>

#include "calibration/intrinsics/circle_shift.h"
#include "calibration/intrinsics/target_errors.h"
#include "tests/calibration/synthetic_target/synthetic_observations.h"

namespace vignole {
namespace {

std::vector<Eigen::Vector3d> pointsOf(const PlanarTarget& target) {
  std::vector<Eigen::Vector3d> points;
  for (const Point2& p : target.points()) points.emplace_back(p.x(), p.y(), 0);
  return points;
}

PlanarTarget asymmetric(int columns, int rows) {
  PlanarTarget target = circles(columns, rows, 10, 5);
  target.pattern = TargetPattern::AsymmetricCircles;
  return target;
}

TEST(TargetTurns, AreThoseThatBringTheGridOntoItself) {
  EXPECT_EQ(turnsOf(pointsOf(chessboard(9, 6, 20))).size(), 1U) << "half a turn";
  EXPECT_EQ(turnsOf(pointsOf(chessboard(7, 7, 20))).size(), 3U);
  EXPECT_EQ(turnsOf(pointsOf(asymmetric(4, 10))).size(), 1U);
  EXPECT_EQ(turnsOf(pointsOf(asymmetric(4, 11))).size(), 0U);
}

TEST(TargetTurns, LeaveTheProjectionAsItIs) {
  const PlanarTarget target = chessboard(7, 7, 20);
  const auto points = pointsOf(target);
  std::mt19937_64 random(2);
  const SyntheticViews views =
      syntheticViews({.target = target, .camera = usualCamera(), .views = 1, .noisePx = 0}, random);
  for (const TargetTurn& by : turnsOf(points)) {
    ObservedView view = observationsOf(views, target).views.front();
    Extrinsics pose = views.cameraFromTarget.front();
    turn(by, view);
    turn(by, pose);
    for (const Observation& o : view)
      EXPECT_LT((reprojected(usualCamera(), pose, points[static_cast<std::size_t>(o.point)], 0) - o.px).norm(), 1e-6);
  }
}

TEST(TargetTurns, AreFoundByTheTargetsErrorsAlone) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
  settings.views = 8;
  const LensVariant division{DistortionModel::Division};
  const auto turns = turnsOf(pointsOf(settings.target));
  for (const double errorMm : {0.0, 0.05}) {
    settings.targetErrorMm = errorMm;
    std::mt19937_64 random(31);
    const SyntheticViews views = syntheticViews(settings, random);
    TargetObservations observations = observationsOf(views, settings.target);
    TargetFit fit = adjust(observations, division, truthAsStart(views, settings.target, settings.camera, division));
    for (const std::size_t v : {2U, 3U, 7U}) {
      turn(turns[0], observations.views[v]);
      turn(turns[0], fit.cameraFromTarget[v]);
    }
    const std::vector<int> expected =
        errorMm > 0 ? std::vector<int>{-1, -1, 0, 0, -1, -1, -1, 0} : std::vector<int>(8, -1);
    EXPECT_EQ(turnedViews(observations, fit, turns), expected) << errorMm;
  }
}

TEST(SuspectedErrors, AreThoseOfTheTarget) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
  settings.views = 12;
  const LensVariant division{DistortionModel::Division};
  const auto suspected = [&](double errorMm, double bendMm) {
    settings.targetErrorMm = errorMm;
    settings.bendMm = bendMm;
    std::mt19937_64 random(41);
    const SyntheticViews views = syntheticViews(settings, random);
    const TargetObservations observations = observationsOf(views, settings.target);
    return suspectedErrors(
        observations, adjust(observations, division, truthAsStart(views, settings.target, settings.camera, division)));
  };
  EXPECT_EQ(suspected(0, 0).inPlaneMm, 0);
  EXPECT_EQ(suspected(0, 0).outOfPlaneMm, 0);
  EXPECT_NEAR(suspected(0.05, 0).inPlaneMm, 0.05 / std::sqrt(3.0), 0.006);
  EXPECT_GT(suspected(0, 0.5).outOfPlaneMm, 0.05);
}

TEST(CircleShift, IsTakenOffButForAFewPercent) {
  SyntheticSettings settings{.target = circles(9, 6, 20, 10), .camera = usualCamera()};
  settings.camera.kappa = -3e-3;
  settings.views = 4;
  settings.noisePx = 0;
  std::mt19937_64 random(51);
  const SyntheticViews views = syntheticViews(settings, random);
  const TargetObservations observations = observationsOf(views, settings.target);
  const TargetFit truth = truthAsStart(views, settings.target, settings.camera, {DistortionModel::Division});
  const auto largest = [&](const TargetObservations& o) {
    double most = 0;
    for (const auto& view : residuals(o, truth))
      for (const Point2& r : view) most = std::max(most, r.norm());
    return most;
  };
  EXPECT_GT(largest(observations), 0.1) << "or the test proves nothing";
  EXPECT_LT(largest(withoutCircleShift(observations, truth)), 0.04 * largest(observations));
}

}  // namespace
}  // namespace vignole
