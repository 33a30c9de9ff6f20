#include <Eigen/LU>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "engine/rail/catalogue.h"
#include "engine/registration/candidate_grid.h"
#include "engine/registration/registration.h"
#include "tests/registration/synthetic_profile.h"

namespace vignole {
namespace {

using synthetic::pose;
using synthetic::ProfileRequest;

Section section(const char* name = "60E1") {
  auto s = findSection(name);
  EXPECT_TRUE(s) << s.error().message();
  return *s;
}

/// Where the section's middle lands, against where it should: mm.
double poseError(const Transform2& found, const Transform2& truth) {
  const Point2 middle(0, 86);
  return (found * middle - truth * middle).norm();
}
double angleError(const Transform2& found, const Transform2& truth) {
  return std::abs(std::remainder(found.angleRad - truth.angleRad, 2 * std::numbers::pi));
}

Transform2 randomPose(std::mt19937_64& random, double mm, double degrees) {
  std::uniform_real_distribution<double> u(-1, 1);
  const double x = u(random), y = u(random), a = u(random);
  return pose(mm * x, mm * y, degrees * a);
}

TEST(CandidateGrid, AgreesWithEveryPrimitiveTried) {
  const Section s = section();
  std::vector<Carrier> carriers;
  for (const auto& p : s.primitives) carriers.push_back(Carrier::of(p.shape));
  const CandidateGrid grid(carriers, 1, 40, 3);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(-150, 150), y(-80, 260);
  for (int i = 0; i < 50000; ++i) {
    const Point2 p(x(random), y(random));
    double least = 1e300;
    for (const auto& primitive : s.primitives)
      least = std::min(least, std::abs(nearest(primitive.shape, p).distanceMm));
    EXPECT_NEAR(std::sqrt(carriers[grid.nearest(p.x(), p.y())].squaredDistance(p.x(), p.y())), least, 1e-9)
        << p.transpose();
  }
}

struct Case {
  const char* what;
  double outliers;
  int missing;
};

class RandomStarts : public testing::TestWithParam<Case> {};

TEST_P(RandomStarts, AlwaysConverge) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  std::mt19937_64 random(11);
  std::vector<double> errors;
  for (int trial = 0; trial < 250; ++trial) {
    ProfileRequest request;
    request.outlierShare = GetParam().outliers;
    request.missingCamera = GetParam().missing;
    request.worldFromSection = randomPose(random, 15, 8);
    request.seed = static_cast<std::uint64_t>(trial) + 100;
    const Profile profile = synthetic::sample(s, request);
    registrar.registerProfile(profile.points, r);
    ASSERT_TRUE(r.valid) << r.reason << " in trial " << trial;
    errors.push_back(poseError(r.worldFromSection, request.worldFromSection));
    EXPECT_LT(errors.back(), 0.02) << "trial " << trial;
    EXPECT_LT(angleError(r.worldFromSection, request.worldFromSection), 3e-4) << "trial " << trial;
  }
  std::nth_element(errors.begin(), errors.begin() + 125, errors.end());
  EXPECT_LT(errors[125], 0.0035);
}

INSTANTIATE_TEST_SUITE_P(Faults, RandomStarts,
                         testing::Values(Case{"clean", 0, -1}, Case{"outliers", 0.1, -1}, Case{"no1", 0.1, 0},
                                         Case{"no2", 0.1, 1}, Case{"no3", 0.1, 2}, Case{"no4", 0.1, 3}),
                         [](const auto& instance) { return instance.param.what; });

TEST(Registrar, ReachesTheStatisticalLimitAndSaysHowSureItIs) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  std::mt19937_64 random(3);
  double squared = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    ProfileRequest request;
    request.worldFromSection = randomPose(random, 5, 2);
    request.seed = static_cast<std::uint64_t>(trial) + 1;
    registrar.registerProfile(synthetic::sample(s, request).points, r);
    const Point2 middle(0, s.heightMm() / 2);
    const Point2 shift = r.worldFromSection * middle - request.worldFromSection * middle;
    const Eigen::Vector3d e(shift.x(), shift.y(), r.worldFromSection.angleRad - request.worldFromSection.angleRad);
    squared += e.dot(r.covariance.inverse() * e) / 3;
    EXPECT_NEAR(r.chi2, 1, 0.25);
  }
  EXPECT_NEAR(squared / kTrials, 1, 0.15);
}

TEST(Registrar, AHeadAloneAnywhereIsFound) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  for (const Transform2& where : {pose(0, -170, 1.4), pose(500, 3000, -1.4), pose(-9000, 20, 1)}) {
    ProfileRequest request;
    request.worldFromSection = where;
    Profile profile = synthetic::sample(s, request);
    std::erase_if(profile.points,
                  [&](const ProfilePoint& p) { return (where.inverse() * Point2(p.x, p.y)).y() < 140; });
    registrar.registerProfile(profile.points, r);
    ASSERT_TRUE(r.valid) << r.reason;
    EXPECT_LT(poseError(r.worldFromSection, where), 0.1);
  }
}

TEST(Registrar, AWholeRailFarFromTheOriginIsFound) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  ProfileRequest request;
  request.outlierShare = 0.05;
  request.worldFromSection = pose(-4000, 7000, 1.4);
  registrar.registerProfile(synthetic::sample(s, request).points, r);
  ASSERT_TRUE(r.valid) << r.reason;
  EXPECT_LT(poseError(r.worldFromSection, request.worldFromSection), 0.01);
}

TEST(Registrar, PointsInAnyOrderGiveTheSamePoseAndTheSameInputTheSameBits) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration a, b;
  ProfileRequest request;
  request.outlierShare = 0.1;
  Profile profile = synthetic::sample(s, request);
  registrar.registerProfile(profile.points, a);
  registrar.registerProfile(profile.points, b);
  EXPECT_EQ(a.worldFromSection.xMm, b.worldFromSection.xMm);
  EXPECT_EQ(a.worldFromSection.angleRad, b.worldFromSection.angleRad);
  EXPECT_EQ(a.residualMm, b.residualMm);
  std::shuffle(profile.points.begin(), profile.points.end(), std::mt19937_64(5));
  registrar.registerProfile(profile.points, b);
  EXPECT_LT(poseError(a.worldFromSection, b.worldFromSection), 1e-3);
}

TEST(Registrar, FailsHonestly) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  registrar.registerProfile({}, r);
  EXPECT_FALSE(r.valid);
  EXPECT_EQ(r.reason, "only 0 points, at least 20 are needed");

  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(-100, 100);
  std::vector<ProfilePoint> noise(2000);
  for (auto& p : noise) p.x = u(random), p.y = u(random) + 86;
  registrar.registerProfile(noise, r);
  EXPECT_FALSE(r.valid);
  EXPECT_NE(r.reason.find("do not agree with 60E1"), std::string::npos) << r.reason;

  for (auto& p : noise) p.x = std::nan("");
  registrar.registerProfile(noise, r);
  EXPECT_FALSE(r.valid);
}

TEST(Registrar, AWrongRailShowsInChi2EvenThe60E2) {
  const Section right = section("60E1"), like = section("60E2"), other = section("54E1");
  ProfileRequest request;
  request.worldFromSection = pose(3, -2, 1);
  const Profile profile = synthetic::sample(right, request);
  Registration r;
  Registrar(like, {}).registerProfile(profile.points, r);
  EXPECT_GT(r.chi2, 5);
  for (std::size_t k = 0; k < like.primitives.size(); ++k)  // the crown differs, nothing else does
    if (like.primitives[k].name.starts_with("SW")) {
      EXPECT_LT(r.primitives[k].chi2, 2) << like.primitives[k].name;
    }
  EXPECT_GT(r.primitives[*like.find("AHTR1")].chi2, 5);
  const auto matches = bestMatch(profile.points, std::vector<Section>{other, like, right});
  ASSERT_EQ(matches.size(), 3U);
  EXPECT_EQ(matches[0].rail, "60E1");
  EXPECT_EQ(matches[1].rail, "60E2");
  EXPECT_NEAR(matches[0].chi2, 1, 0.2);
  EXPECT_GT(matches[2].chi2, 100);
}

TEST(Registrar, EveryRailOfTheCatalogueIsItsOwnBestMatch) {
  std::vector<Section> all;
  for (const auto& name : catalogueNames()) all.push_back(section(name.c_str()));
  for (const Section& s : all) {
    ProfileRequest request;
    request.worldFromSection = pose(-7, 4, -3);
    const auto matches = bestMatch(synthetic::sample(s, request).points, all);
    EXPECT_EQ(matches.front().rail, s.name);
  }
}

}  // namespace
}  // namespace vignole
