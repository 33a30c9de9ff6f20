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

TEST(CandidateGrid, NamesManyPointsAtOnceAndKnowsWhatIsFar) {
  for (const std::string& name : catalogueNames()) {
    const Section s = section(name.c_str());
    std::vector<Carrier> carriers;
    for (const auto& p : s.primitives) carriers.push_back(Carrier::of(p.shape));
    constexpr double kReach = 3;
    const CandidateGrid grid(carriers, 1, 40, kReach);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<float> px(-130, 130), py(-60, 230);
    constexpr std::size_t kCount = 20001;  // no multiple of any vector
    std::vector<float> x(kCount + kSlack), y(kCount + kSlack);
    std::vector<std::int32_t> cells(kCount + kSlack);
    for (std::size_t i = 0; i < kCount; ++i) x[i] = px(random), y[i] = py(random);
    locate({x.data(), y.data(), kCount}, {}, grid.frame(), cells.data());
    int far = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      const double at[2] = {static_cast<double>(x[i]), static_cast<double>(y[i])};
      const double least = std::sqrt(carriers[grid.nearest(at[0], at[1])].squaredDistance(at[0], at[1]));
      const std::uint16_t k = grid.within(cells[i], x[i], y[i]);
      if (k == carriers.size()) {
        EXPECT_GT(least, kReach);
        EXPECT_GE(grid.roughly(cells[i]), kFarAway);
        ++far;
      } else {
        EXPECT_NEAR(std::sqrt(carriers[k].squaredDistance(at[0], at[1])), least, 1e-4)
            << name << " " << at[0] << " " << at[1];
      }
    }
    EXPECT_GT(far, 10000);
    EXPECT_LT(far, 19000);
  }
}

enum class Strays {
  None,
  Everywhere,   // as ProfileRequest::outlierShare
  InABox,       // uniform, 200 mm
  InOneClump,   // a few millimetres wide
  OnALine,      // as of a clamp or a roller
  Neighbouring  // a stretch of the profile is elsewhere, as one
};

struct Case {
  const char* what;
  Strays strays;
  int missing;
};

/// Moves a tenth of the points.
void putAstray(Profile& profile, Strays strays, const Transform2& worldFromSection, std::mt19937_64& random) {
  if (strays == Strays::None || strays == Strays::Everywhere) return;
  std::uniform_real_distribution<double> unit(-1, 1), share(0, 1);
  const double cx = 100 * unit(random), cy = 86 + 100 * unit(random), dx = 40 * unit(random), dy = 40 * unit(random);
  const double width = 1 + 4 * share(random), first = 0.9 * share(random);
  const auto count = static_cast<double>(profile.points.size());
  for (std::size_t i = 0; i < profile.points.size(); ++i) {
    const double at = static_cast<double>(i) / count, u = unit(random), v = unit(random);
    const bool chosen = strays == Strays::Neighbouring ? at >= first && at < first + 0.1 : share(random) < 0.1;
    if (!chosen) continue;
    Point2 p(cx + width * u, cy + width * v);
    if (strays == Strays::InABox) p = {100 * u, 86 + 100 * v};
    if (strays == Strays::OnALine) p = {cx + u * dx, cy + u * dy + 0.05 * v};
    p = worldFromSection * p;
    profile.points[i].x = p.x();
    profile.points[i].y = p.y();
  }
}

class RandomStarts : public testing::TestWithParam<Case> {};

TEST_P(RandomStarts, AlwaysConverge) {
  constexpr int kTrials = 1000;
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  std::mt19937_64 random(11);
  std::vector<double> errors;
  for (int trial = 0; trial < kTrials; ++trial) {
    ProfileRequest request;
    request.outlierShare = GetParam().strays == Strays::Everywhere ? 0.1 : 0;
    request.missingCamera = GetParam().missing;
    request.worldFromSection = randomPose(random, 15, 8);
    request.seed = static_cast<std::uint64_t>(trial) + 100;
    Profile profile = synthetic::sample(s, request);
    putAstray(profile, GetParam().strays, request.worldFromSection, random);
    registrar.registerProfile(profile.points, r);
    ASSERT_TRUE(r.valid) << r.reason << " in trial " << trial;
    errors.push_back(poseError(r.worldFromSection, request.worldFromSection));
    EXPECT_LT(errors.back(), 0.02) << "trial " << trial;
    EXPECT_LT(angleError(r.worldFromSection, request.worldFromSection), 3e-4) << "trial " << trial;
  }
  std::nth_element(errors.begin(), errors.begin() + kTrials / 2, errors.end());
  EXPECT_LT(errors[kTrials / 2], 0.002);
}

INSTANTIATE_TEST_SUITE_P(Faults, RandomStarts,
                         testing::Values(Case{"clean", Strays::None, -1}, Case{"outliers", Strays::Everywhere, -1},
                                         Case{"no1", Strays::Everywhere, 0}, Case{"no2", Strays::Everywhere, 1},
                                         Case{"no3", Strays::Everywhere, 2}, Case{"no4", Strays::Everywhere, 3},
                                         Case{"box", Strays::InABox, -1}, Case{"boxNo1", Strays::InABox, 0},
                                         Case{"clump", Strays::InOneClump, -1}, Case{"clumpNo3", Strays::InOneClump, 2},
                                         Case{"line", Strays::OnALine, -1}, Case{"lineNo2", Strays::OnALine, 1},
                                         Case{"neighbouring", Strays::Neighbouring, -1},
                                         Case{"neighbouringNo4", Strays::Neighbouring, 3}),
                         [](const auto& instance) { return instance.param.what; });

/// Points whose errors are shared by so many neighbours.
class SharedErrors : public testing::TestWithParam<int> {};

TEST_P(SharedErrors, ThePoseIsAsSureAsItSays) {
  const Section s = section();
  Registrar registrar(s, {});
  Registration r;
  std::mt19937_64 random(3);
  Eigen::Vector3d squared = Eigen::Vector3d::Zero(), stated = squared;
  double together = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    ProfileRequest request;
    request.correlated = GetParam();
    request.worldFromSection = randomPose(random, 5, 2);
    request.seed = static_cast<std::uint64_t>(trial) + 1;
    const Profile profile = synthetic::sample(s, request);
    registrar.registerProfile(profile.points, r, {}, static_cast<double>(profile.correlatedPoints));
    const Point2 middle(0, s.heightMm() / 2);
    const Point2 shift = r.worldFromSection * middle - request.worldFromSection * middle;
    const Eigen::Vector3d e(shift.x(), shift.y(), r.worldFromSection.angleRad - request.worldFromSection.angleRad);
    squared += e.cwiseAbs2();
    stated += r.covariance.diagonal();
    together += e.dot(r.covariance.inverse() * e) / 3;
    EXPECT_NEAR(r.chi2, 1, 0.5);
  }
  // 15 % of a standard uncertainty
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::sqrt(squared[k] / stated[k]), 1, 0.15) << "xya"[k];
  EXPECT_NEAR(std::sqrt(together / kTrials), 1, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Neighbours, SharedErrors, testing::Values(1, 5, 9));

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

}  // namespace
}  // namespace vignole
