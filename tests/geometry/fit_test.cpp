#include "engine/geometry/fit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace vignole {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Point2> arcPoints(const Point2& centre, double radius, double from, double to, int count) {
  std::vector<Point2> points;
  for (int i = 0; i < count; ++i) {
    const double a = from + (to - from) * i / (count - 1);
    points.emplace_back(centre + radius * Point2(std::cos(a), std::sin(a)));
  }
  return points;
}

TEST(LineFit, RecoversAnExactLineOfAnySlope) {
  for (const double angle : {-1.5, -0.3, 0.0, 0.8, kPi / 2}) {
    std::vector<Point2> points;
    for (int i = 0; i < 5; ++i) points.emplace_back(Point2(100, -50) + i * Point2(std::cos(angle), std::sin(angle)));
    const auto fit = fitLine(points);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(std::sin(fit->angleRad - angle), 0, 1e-12);
    EXPECT_LT(fit->rmsMm, 1e-12);
    EXPECT_EQ(fit->points, 5);
  }
}

TEST(LineFit, CovarianceAgreesWithMonteCarlo) {
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  constexpr int kRuns = 4000, kPoints = 30;
  const Point2 along(std::cos(0.4), std::sin(0.4)), across(-along.y(), along.x());
  std::vector<double> sigma;
  for (int i = 0; i < kPoints; ++i) sigma.push_back(i % 2 == 0 ? 0.01 : 0.03);
  double offset2 = 0, angle2 = 0;
  Eigen::Matrix2d reported;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<Point2> points;
    for (int i = 0; i < kPoints; ++i)
      points.emplace_back(0.5 * i * along + sigma[static_cast<std::size_t>(i)] * gauss(random) * across);
    const auto fit = fitLine(points, sigma);
    ASSERT_TRUE(fit);
    offset2 += std::pow(across.dot(fit->centroid), 2) / kRuns;
    angle2 += std::pow(fit->angleRad - 0.4, 2) / kRuns;
    reported = fit->covariance;
  }
  // A variance from 4000 runs is good to 2.2 % (1 sigma); 10 % is beyond 4 sigma.
  EXPECT_NEAR(offset2 / reported(0, 0), 1, 0.1);
  EXPECT_NEAR(angle2 / reported(1, 1), 1, 0.1);
}

TEST(LineFit, RefusesWhatDeterminesNoLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fitLine(std::vector<Point2>{{1, 1}}));
  EXPECT_FALSE(fitLine(std::vector<Point2>{{1, 1}, {1, 1}}));
  EXPECT_FALSE(fitLine(std::vector<Point2>{{1, 1}, {nan, 1}}));
  EXPECT_FALSE(fitLine(std::vector<Point2>{{1, 1}, {2, 1}}, std::vector<double>{1}));
  EXPECT_FALSE(fitLine(std::vector<Point2>{{1, 1}, {2, 1}}, std::vector<double>{1, 0}));
}

TEST(CircleFit, RecoversExactArcsFromFullToFlat) {
  struct Case {
    Point2 centre;
    double radius, from, to;
  };
  for (const Case& c : {Case{{0, 0}, 10, 0, 6.2}, Case{{30, -7}, 3, 1, 2}, Case{{0, -128}, 300, 1.537, 1.605},
                        Case{{516, 76}, 508, 3.1, 3.2}, Case{{-5, 2}, 0.5, -2, 1}}) {
    const auto fit = fitCircle(arcPoints(c.centre, c.radius, c.from, c.to, 40));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->radiusMm, c.radius, 1e-6 * c.radius);
    EXPECT_NEAR((fit->centre - c.centre).norm(), 0, 1e-6 * c.radius);
    EXPECT_LT(fit->rmsMm, 1e-9);
  }
}

TEST(CircleFit, CovarianceAgreesWithMonteCarlo) {
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  constexpr int kRuns = 3000;
  constexpr double kSigma = 0.01;
  const auto exact = arcPoints({2, 3}, 13, 0.05, 1.34, 60);  // the gauge corner of 60E1
  const std::vector<double> sigma(exact.size(), kSigma);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero(), reported;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<Point2> points = exact;
    for (Point2& p : points) p += kSigma * gauss(random) * (p - Point2(2, 3)).normalized();
    const auto fit = fitCircle(points, sigma);
    ASSERT_TRUE(fit);
    const Eigen::Vector3d d(fit->centre.x() - 2, fit->centre.y() - 3, fit->radiusMm - 13);
    scatter += d * d.transpose() / kRuns;
    reported = fit->covariance;
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(scatter(i, i) / reported(i, i), 1, 0.12) << "parameter " << i;
  EXPECT_NEAR(scatter(0, 2) / reported(0, 2), 1, 0.15);
}

TEST(CircleFit, IsTheLeastSquaresOptimum) {
  std::mt19937 random(11);
  std::normal_distribution<double> gauss;
  auto points = arcPoints({0, -128}, 300, 1.537, 1.605, 50);
  for (Point2& p : points) p.y() += 0.005 * gauss(random);
  const auto fit = fitCircle(points);
  ASSERT_TRUE(fit);
  const auto cost = [&](const Point2& centre, double radius) {
    double sum = 0;
    for (const Point2& p : points) sum += std::pow((p - centre).norm() - radius, 2);
    return sum;
  };
  const double best = cost(fit->centre, fit->radiusMm);
  EXPECT_NEAR(fit->rmsMm, std::sqrt(best / 50), 1e-9);
  for (const double h : {-0.01, 0.01}) {
    EXPECT_GT(cost(fit->centre + Point2(h, 0), fit->radiusMm), best);
    EXPECT_GT(cost(fit->centre + Point2(0, h), fit->radiusMm), best);
    EXPECT_GT(cost(fit->centre + Point2(0, -h), fit->radiusMm + h), best) << "along the weakest direction";
  }
}

TEST(CircleFit, RefusesWhatDeterminesNoCircle) {
  EXPECT_FALSE(fitCircle(std::vector<Point2>{{0, 0}, {1, 0}}));
  EXPECT_FALSE(fitCircle(std::vector<Point2>{{0, 0}, {1, 1}, {2, 2}, {5, 5}}));
  EXPECT_FALSE(fitCircle(std::vector<Point2>{{3, 3}, {3, 3}, {3, 3}}));
  EXPECT_FALSE(fitCircle(std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}}, std::vector<double>{1, 1, -1}));
  EXPECT_TRUE(fitCircle(std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}}));
}

}  // namespace
}  // namespace vignole
