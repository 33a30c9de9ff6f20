#include "calibration/intrinsics/target_adjustment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <gtest/gtest.h>

#include "calibration/intrinsics/information.h"
#include "calibration/intrinsics/robust_fit.h"
#include "calibration/intrinsics/zhang_start.h"
#include "tests/calibration/synthetic_target/synthetic_observations.h"

namespace vignole {
namespace {

constexpr auto kPolynomial = DistortionModel::Polynomial;

/// A camera whose lens has exactly what the variant estimates.
Intrinsics cameraOf(const LensVariant& variant) {
  Intrinsics in = usualCamera();
  in.model = variant.model;
  if (variant.aspect) in.pixelHeightMm = 0.00744;
  if (variant.model == DistortionModel::Division) in.kappa = -4e-4;
  if (variant.radial > 0) in.k1 = 4e-4;
  if (variant.radial > 1) in.k2 = -4e-6;
  if (variant.radial > 2) in.k3 = 1e-7;
  if (variant.tangential) {
    in.p1 = 5e-4;  // 0.008 / f: a tilted lens
    in.p2 = -1e-4;
  }
  return in;
}

std::vector<LensVariant> allVariants() {
  std::vector<LensVariant> all = lensVariants(false);
  for (const LensVariant& v : lensVariants(true)) all.push_back(v);
  return all;
}

class EveryVariant : public testing::TestWithParam<LensVariant> {};
INSTANTIATE_TEST_SUITE_P(Variants, EveryVariant, testing::ValuesIn(allVariants()), [](const auto& tested) {
  std::string text = name(tested.param);
  std::replace(text.begin(), text.end(), ' ', '_');
  return text;
});

TEST_P(EveryVariant, IsFoundExactlyWithoutNoiseFromNothing) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = cameraOf(GetParam())};
  settings.views = 8;
  settings.noisePx = 0;
  std::mt19937_64 random(11);
  const TargetObservations observations = observationsOf(syntheticViews(settings, random), settings.target);
  Intrinsics like;
  like.pixelHeightMm = 0.0074;
  const auto found = robustFit(observations, GetParam(), like, 0, {}, {});
  ASSERT_TRUE(found.has_value()) << found.error().message();
  const IntrinsicVector off = toVector(found->fit.intrinsics) - toVector(settings.camera);
  IntrinsicVector limit;
  limit << 1e-6, 1e-9, 1e-4, 1e-4, 1e-9, 1e-9, 1e-10, 1e-12, 1e-9, 1e-9;
  for (int i = 0; i < kIntrinsicParameters; ++i)
    EXPECT_LT(std::abs(off[i]), limit[i]) << name(static_cast<CameraParameter>(i));
}

/// Sum over draws and parameters of (error / u)^2, decorrelated: errors^T covariance^-1 errors.
TEST_P(EveryVariant, ErrsAsItsCovarianceSays) {
  const LensVariant variant = GetParam();
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = cameraOf(variant)};
  settings.views = 8;
  constexpr int kDraws = 25;
  double sum = 0, freedom = 0;
  std::vector<int> free;
  for (const CameraParameter p : freeParameters(variant)) free.push_back(static_cast<int>(p));
  for (int draw = 0; draw < kDraws; ++draw) {
    std::mt19937_64 random(static_cast<unsigned>(400 + draw));
    const SyntheticViews views = syntheticViews(settings, random);
    const TargetObservations observations = observationsOf(views, settings.target);
    const TargetFit fit = adjust(observations, variant, truthAsStart(views, settings.target, settings.camera, variant));
    ASSERT_TRUE(fit.converged);
    const IntrinsicVector off = toVector(fit.intrinsics) - toVector(settings.camera);
    const auto covariance = informationOf(observations, variant, fit, {}).covariance();
    const auto n = static_cast<Eigen::Index>(free.size());
    Eigen::VectorXd scaled(n);
    Eigen::MatrixXd correlation(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const int row = free[static_cast<std::size_t>(i)];
      scaled[i] = off[row] / std::sqrt(covariance(row, row));
      for (Eigen::Index j = 0; j < n; ++j) {
        const int column = free[static_cast<std::size_t>(j)];
        correlation(i, j) = covariance(row, column) / std::sqrt(covariance(row, row) * covariance(column, column));
      }
    }
    sum += scaled.dot(correlation.ldlt().solve(scaled));
    freedom += static_cast<double>(n);
  }
  // 99.9 % interval of chi^2, normal approximation: the degrees of freedom are 100 and more.
  EXPECT_NEAR(sum, freedom, 3.3 * std::sqrt(2 * freedom));
}

TEST(TargetAdjustment, EstimatesTheTargetsPointsWithTheirPrior) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = cameraOf({DistortionModel::Division})};
  settings.views = 10;
  settings.targetErrorMm = 0.1;
  std::mt19937_64 random(3);
  const SyntheticViews views = syntheticViews(settings, random);
  const TargetObservations observations = observationsOf(views, settings.target);
  const LensVariant division{DistortionModel::Division};
  const TargetFit start = truthAsStart(views, settings.target, settings.camera, division);
  AdjustmentSettings free;
  free.target.inPlaneMm = 0.1 / std::sqrt(3.0);
  const TargetFit asStated = adjust(observations, division, start),
                  estimated = adjust(observations, division, start, free);
  const auto rms = [&](const TargetFit& fit) {
    double squares = 0, count = 0;
    for (const auto& view : residuals(observations, fit))
      for (const Point2& r : view) {
        squares += r.squaredNorm();
        count += 1;
      }
    return std::sqrt(squares / count);
  };
  EXPECT_GT(rms(asStated), 0.2);
  EXPECT_LT(rms(estimated), 0.08) << "the noise is 0.071 px";
  double before = 0, after = 0;  // up to a similarity, which the prior leaves nearly as it is
  for (std::size_t i = 0; i < views.points.size(); ++i) {
    before += (asStated.points[i] - views.points[i]).squaredNorm();
    after += (estimated.points[i] - views.points[i]).squaredNorm();
  }
  EXPECT_LT(after, 0.15 * before);
}

TEST(TargetAdjustment, LeavesIntrinsicsAloneWhereOnlyPosesAreAskedFor) {
  SyntheticSettings settings{.target = circles(9, 6, 20, 10), .camera = cameraOf({DistortionModel::Division})};
  settings.views = 3;
  std::mt19937_64 random(4);
  const SyntheticViews views = syntheticViews(settings, random);
  const LensVariant division{DistortionModel::Division};
  TargetFit start = truthAsStart(views, settings.target, settings.camera, division);
  for (Extrinsics& pose : start.cameraFromTarget)
    pose = moved(pose, (Eigen::Matrix<double, 6, 1>() << 0.02, -0.03, 0.05, 3, -2, 8).finished());
  AdjustmentSettings poses;
  poses.posesOnly = true;
  const TargetFit fit = adjust(observationsOf(views, settings.target), division, start, poses);
  EXPECT_EQ(toVector(fit.intrinsics), toVector(start.intrinsics));
  for (std::size_t v = 0; v < views.cameraFromTarget.size(); ++v) {
    EXPECT_LT((fit.cameraFromTarget[v].rotation - views.cameraFromTarget[v].rotation).norm(), 1e-3);
    EXPECT_LT((fit.cameraFromTarget[v].translationMm - views.cameraFromTarget[v].translationMm).norm(), 0.2);
  }
}

TEST(ZhangStart, IsNearWithoutDistortion) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
  settings.views = 6;
  std::mt19937_64 random(5);
  const TargetObservations observations = observationsOf(syntheticViews(settings, random), settings.target);
  std::vector<Eigen::Matrix3d> homographies;
  for (const ObservedView& view : observations.views) homographies.push_back(*homography(observations.points, view));
  const std::vector<Intrinsics> starts = zhangStarts(homographies, Intrinsics{});
  EXPECT_NEAR(starts.front().focalMm, settings.camera.focalMm, 0.3);
  EXPECT_NEAR(starts.front().cxPx, settings.camera.cxPx, 30);
  for (const Eigen::Matrix3d& h : homographies) EXPECT_FALSE(mirrored(h, starts.front()));
}

TEST(ZhangStart, FindsTheLensOfALongAndAShortCamera) {
  for (const double focalMm : {5.0, 60.0}) {
    SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
    settings.camera.focalMm = focalMm;
    settings.views = 10;
    std::mt19937_64 random(6);
    const TargetObservations observations = observationsOf(syntheticViews(settings, random), settings.target);
    const auto found = robustFit(observations, {DistortionModel::Division}, Intrinsics{}, 0, {}, {});
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->fit.intrinsics.focalMm, focalMm, 0.01 * focalMm);
  }
}

}  // namespace
}  // namespace vignole
