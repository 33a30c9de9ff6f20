#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <sodium.h>

#include "engine/packing/point_pack.h"
#include "engine/packing/profile_record.h"

namespace vignole {
namespace {

std::vector<ProfileRecord> records(std::size_t count) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0, 1);
  std::vector<ProfileRecord> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    ProfileRecord& r = all[i];
    r.trigger = 100 + i;
    r.positionMm = 15.0 * static_cast<double>(i);
    r.registered = i % 7 != 3;
    r.worldFromSection = {normal(random), normal(random), 0.01 * normal(random)};
    r.rmsMm = 0.02 + 0.001 * normal(random);
    r.inliers = 2000 + static_cast<int>(i % 50);
    r.points = 2100;
    if (!r.registered) {
      r.missing[2] = "frame lost";
      r.whyNotRegistered = "too few points";
      r.overloaded[1] = true;
    }
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      DimensionResult& m = r.dimensions[d];
      if (!r.registered) {
        m.reason = "camera 3 gave nothing";
        continue;
      }
      m.valueMm = 70 + 10.0 * static_cast<double>(d) + 0.005 * normal(random);
      m.uMm = 0.005 + 0.0001 * normal(random);
      m.uCalibrationMm = 0.003;
      m.points = 300;
      m.verdict = Verdict::Pass;
      if (kDimensions[d] == Dimension::HF) {
        m.secondMm = -0.01 + 0.005 * normal(random);
        m.secondUMm = 0.004;
      }
      if (kDimensions[d] == Dimension::RFH) {
        m.leftMm = 31 + normal(random);
        m.rightMm = 31 + normal(random);
      }
    }
  }
  return all;
}

void expectSame(const std::optional<double>& a, const std::optional<double>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a) {
    EXPECT_NEAR(*a, *b, 0.51 * kRecordStepMm);
  }
}

TEST(ProfileRecords, ComeBackToTheNanometreWithTheirReasons) {
  const auto before = records(300);
  const auto after = unpackProfiles(packProfiles(before));
  ASSERT_TRUE(after) << after.error().message();
  ASSERT_EQ(after->size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const ProfileRecord &a = before[i], &b = (*after)[i];
    EXPECT_EQ(a.trigger, b.trigger);
    EXPECT_NEAR(a.positionMm, b.positionMm, kRecordStepMm);
    EXPECT_EQ(a.missing, b.missing);
    EXPECT_EQ(a.overloaded, b.overloaded);
    EXPECT_EQ(a.registered, b.registered);
    EXPECT_EQ(a.whyNotRegistered, b.whyNotRegistered);
    EXPECT_NEAR(a.worldFromSection.angleRad, b.worldFromSection.angleRad, 1e-9);
    EXPECT_EQ(a.inliers, b.inliers);
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      const DimensionResult &x = a.dimensions[d], &y = b.dimensions[d];
      expectSame(x.valueMm, y.valueMm);
      expectSame(x.secondMm, y.secondMm);
      expectSame(x.leftMm, y.leftMm);
      expectSame(x.rightMm, y.rightMm);
      EXPECT_NEAR(x.uMm, y.uMm, kRecordStepMm);
      EXPECT_NEAR(x.uCalibrationMm, y.uCalibrationMm, kRecordStepMm);
      EXPECT_EQ(x.points, y.points);
      EXPECT_EQ(x.verdict, y.verdict);
      EXPECT_EQ(x.reason, y.reason);
    }
  }
}

TEST(ProfileRecords, FourThousandStayBelowAQuarterOfAMegabyte) {
  EXPECT_LT(packProfiles(records(4000)).size(), 250'000U);
}

TEST(ProfileRecords, NumbersThatAreNoneAreMissing) {
  auto one = records(1);
  one[0].dimensions[0].valueMm = std::nan("");
  const auto after = unpackProfiles(packProfiles(one));
  ASSERT_TRUE(after);
  EXPECT_FALSE(after->front().dimensions[0].valueMm);
}

TEST(ProfileRecords, DamageIsRefused) {
  Bytes bytes = packProfiles(records(50));
  bytes[bytes.size() / 2] ^= 1U;
  EXPECT_FALSE(unpackProfiles(bytes));
  EXPECT_FALSE(unpackProfiles({}));
}

/// A profile as a rig gives it: four arcs with noise of some micrometres.
Profile profile() {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0, 1);
  Profile p;
  p.trigger = 17;
  p.positionMm = 255.25;
  p.correlatedPoints = 2.5F;
  p.missing[3] = "no stripe";
  for (std::uint8_t camera = 0; camera < 3; ++camera) {
    for (int i = 0; i < 700; ++i) {
      const double angle = 0.002 * i + camera, radius = 80 + 0.004 * normal(random);
      ProfilePoint point;
      point.x = radius * std::cos(angle);
      point.y = radius * std::sin(angle);
      point.nx = static_cast<float>(std::cos(angle));
      point.ny = static_cast<float>(std::sin(angle));
      point.sigmaMm = static_cast<float>(0.004 + 0.0001 * normal(random));
      point.strength = static_cast<float>(120 + 5 * normal(random));
      point.camera = camera;
      point.flags = i == 0 ? 2 : 0;
      point.shiftMm = static_cast<float>(0.001 * normal(random));
      point.ridgeSigmaMm = camera == 1 ? 0.F : 0.006F;
      p.points.push_back(point);
    }
    p.lineEnds.push_back(static_cast<std::uint32_t>(p.points.size()));
    p.pointsOfCamera[camera] = 700;
  }
  return p;
}

TEST(Points, ExactIsExact) {
  const Profile before = profile();
  const auto after = unpackPoints(packPoints(before, PointCoding::Exact));
  ASSERT_TRUE(after) << after.error().message();
  EXPECT_EQ(after->trigger, before.trigger);
  EXPECT_EQ(after->positionMm, before.positionMm);
  EXPECT_EQ(after->correlatedPoints, before.correlatedPoints);
  EXPECT_EQ(after->missing, before.missing);
  EXPECT_EQ(after->lineEnds, before.lineEnds);
  EXPECT_EQ(after->pointsOfCamera, before.pointsOfCamera);
  ASSERT_EQ(after->points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const ProfilePoint &a = before.points[i], &b = after->points[i];
    EXPECT_TRUE(a.x == b.x && a.y == b.y && a.nx == b.nx && a.ny == b.ny && a.sigmaMm == b.sigmaMm &&
                a.strength == b.strength && a.camera == b.camera && a.flags == b.flags && a.shiftMm == b.shiftMm &&
                a.ridgeSigmaMm == b.ridgeSigmaMm && a.smoothingMm == b.smoothingMm)
        << i;
  }
}

TEST(Points, CompactIsSmallAndFarBelowTheNoise) {
  const Profile before = profile();
  const Bytes bytes = packPoints(before, PointCoding::Compact);
  EXPECT_LT(bytes.size(), 11 * before.points.size());
  const auto after = unpackPoints(bytes);
  ASSERT_TRUE(after) << after.error().message();
  ASSERT_EQ(after->points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const ProfilePoint &a = before.points[i], &b = after->points[i];
    EXPECT_NEAR(a.x, b.x, 0.51e-5);
    EXPECT_NEAR(a.y, b.y, 0.51e-5);
    EXPECT_NEAR(a.nx, b.nx, 1e-4);
    EXPECT_NEAR(a.ny, b.ny, 1e-4);
    EXPECT_NEAR(a.sigmaMm, b.sigmaMm, 0.51e-5);
    EXPECT_NEAR(a.strength, b.strength, 0.26);
    EXPECT_EQ(a.ridgeSigmaMm == 0, b.ridgeSigmaMm == 0);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(a.flags, b.flags);
  }
}

TEST(Points, DamageAndWrongKindsAreRefused) {
  Bytes bytes = packPoints(profile(), PointCoding::Compact);
  EXPECT_FALSE(unpackPoints(packProfiles({})));
  bytes[100] ^= 1U;
  EXPECT_FALSE(unpackPoints(bytes));
  EXPECT_FALSE(unpackPoints({}));
}

/// A file made by somebody who knows the format: changed, but signed again.
Bytes signedAgain(Bytes bytes) {
  constexpr std::size_t kDigest = crypto_generichash_BYTES_MIN;
  const std::size_t content = bytes.size() - kDigest;
  crypto_generichash(bytes.data() + content, kDigest, bytes.data(), content, nullptr, 0);
  return bytes;
}

TEST(Damage, EvenSignedItIsReadOrRefusedAndNothingElse) {
  const Bytes blocks[] = {packProfiles(records(40)), packPoints(profile(), PointCoding::Compact),
                          packPoints(profile(), PointCoding::Exact)};
  std::mt19937 random(8);
  std::size_t refused = 0;
  for (const Bytes& good : blocks) {
    for (int i = 0; i < 400; ++i) {
      Bytes bad = good;
      const std::size_t changes = 1 + random() % 3;
      for (std::size_t c = 0; c < changes; ++c)  // the beginning says how long everything is
        bad[2 + random() % (random() % 2 == 0 ? 60 : bad.size() - 20)] = static_cast<std::uint8_t>(random());
      if (random() % 4 == 0) bad.resize(18 + random() % (bad.size() - 18));
      bad = signedAgain(std::move(bad));
      refused += unpackProfiles(bad) ? 0U : 1U;
      refused += unpackPoints(bad) ? 0U : 1U;
    }
  }
  EXPECT_GT(refused, 1200U);  // what is one kind is refused as the other
}

}  // namespace
}  // namespace vignole
