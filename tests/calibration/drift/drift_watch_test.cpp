#include "calibration/drift/drift_watch.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "tests/calibration/drift/rendered_rails.h"

namespace vignole {
namespace {

using testing::RenderedRails;
using testing::SeamsBy;

struct Moved {
  int camera = -1;
  double xMm = 0, yMm = 0, turnRad = 0;
};

/// Seams of zones that pairs of cameras really see: the crown by 1 and 2, the right side of head and web by 2 and 3,
/// the foot bottom by 3 and 4, the left side by 4 and 1.
class SeamModel {
 public:
  /// `plain`: crown and foot bottom exactly level, the sides exactly upright.
  explicit SeamModel(std::uint64_t seed, bool plain = false) : random_(seed) {
    if (plain)
      for (SeamZone& zone : zones)
        if (seen(zone))
          zone.normal = std::abs(zone.normal.x()) > std::abs(zone.normal.y())
                            ? Point2(std::copysign(1, zone.normal.x()), 0)
                            : Point2(0, std::copysign(1, zone.normal.y()));
    for (std::size_t z = 0; z < zones.size(); ++z) offsets_.push_back(0.02 * normal_(random_));
  }
  std::vector<Seam> rail(const std::vector<Moved>& moved = {}) {
    std::vector<Seam> seams(zones.size());
    for (std::size_t z = 0; z < zones.size(); ++z) {
      const SeamZone& zone = zones[z];
      if (!seen(zone)) continue;
      constexpr double kWeight = 60;  // two profiles
      seams[z] = {kWeight, offsets_[z] + kNoiseMm / std::sqrt(kWeight) * normal_(random_)};
      for (const Moved& m : moved) {
        const Point2 shift(m.xMm - m.turnRad * zone.at.y(), m.yMm + m.turnRad * zone.at.x());
        if (zone.first == m.camera) seams[z].mm += shift.dot(zone.normal);
        if (zone.second == m.camera) seams[z].mm -= shift.dot(zone.normal);
      }
    }
    return seams;
  }
  static bool seen(const SeamZone& zone) {
    const bool up = zone.normal.y() > 0.8 && zone.at.y() > 60, down = zone.normal.y() < -0.9 && zone.at.y() < -80;
    const bool upright = std::abs(zone.normal.x()) > 0.9;
    switch (zone.first) {
      case 0:
        return up;
      case 1:
        return upright && zone.normal.x() > 0;
      case 2:
        return down;
      default:
        return upright && zone.normal.x() < 0;
    }
  }
  static constexpr double kNoiseMm = 0.06;  // of a seam of weight 1
  std::vector<SeamZone> zones = seamZones(*findSection("60E1"));

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::vector<double> offsets_;
};

TEST(DriftJudge, FindsTheMotionOfTheCameraThatMoved) {
  for (int camera = 0; camera < kCameraCount; ++camera) {
    SeamModel model(static_cast<std::uint64_t>(camera + 1));
    DriftJudge judge(model.zones, {});
    for (int r = 0; r < 20; ++r) judge.add(model.rail());
    EXPECT_FALSE(judge.indicators().learning);
    EXPECT_FALSE(judge.indicators().alarm());
    const Moved moved{camera, 0.03, -0.025, 2e-4};
    for (int r = 0; r < 50; ++r) judge.add(model.rail({moved}));
    const DriftIndicators& found = judge.indicators();
    for (const CameraDrift& c : found.cameras) EXPECT_EQ(c.alarm, c.camera == camera) << camera << ": " << c.words;
    const CameraDrift& named = found.cameras[static_cast<std::size_t>(camera)];
    EXPECT_NEAR(named.xMm, 0.03, 5 * named.uMm);
    EXPECT_NEAR(named.yMm, -0.025, 5 * named.uMm);
    EXPECT_NEAR(named.turnDeg, 2e-4 * 180 / std::numbers::pi, 0.004);
    EXPECT_LT(named.uMm, 0.004);
    EXPECT_NE(named.words.find("camera " + std::to_string(camera + 1)), std::string::npos) << named.words;
    EXPECT_NEAR(found.unexplained, 1, 0.5);
  }
}

TEST(DriftJudge, TellsWhenTwoCamerasCannotBeToldApart) {
  // Sideways alone shows at the right side of the rail only: either of its two cameras may have moved.
  SeamModel model(9, true);
  DriftJudge judge(model.zones, {});
  for (int r = 0; r < 20; ++r) judge.add(model.rail());
  for (int r = 0; r < 30; ++r) judge.add(model.rail({{2, 0.05, 0, 0}}));
  const CameraDrift& third = judge.indicators().cameras[2];
  EXPECT_TRUE(third.alarm);
  EXPECT_NE(third.words.find("camera 2"), std::string::npos) << third.words;
  EXPECT_NE(third.words.find("camera 3"), std::string::npos) << third.words;
  EXPECT_FALSE(judge.indicators().cameras[0].alarm);
}

TEST(DriftJudge, SaysWhenOneCamerasMotionIsNotAll) {
  SeamModel model(4);
  DriftJudge judge(model.zones, {});
  for (int r = 0; r < 20; ++r) judge.add(model.rail());
  for (int r = 0; r < 50; ++r) judge.add(model.rail({{0, 0.06, 0.07, 0}, {2, -0.03, 0.05, 0}}));
  EXPECT_TRUE(judge.indicators().alarm());
  EXPECT_GT(judge.indicators().unexplained, 4);
  for (const CameraDrift& c : judge.indicators().cameras)
    if (c.alarm) {
      EXPECT_NE(c.words.find("not explain all"), std::string::npos) << c.words;
    }
}

TEST(DriftJudge, NoiseAloneIsNoAlarmAndTheUncertaintyIsThatOfTheNoise) {
  SeamModel model(21);
  DriftJudge judge(model.zones, {});
  double x = 0, u = 0;
  int rails = 0, alarms = 0;
  for (int r = 0; r < 4000; ++r) {
    const DriftIndicators& now = judge.add(model.rail());
    if (now.learning) continue;
    alarms += now.alarm() ? 1 : 0;
    for (const CameraDrift& c : now.cameras) {
      x += c.valueMm * c.valueMm;
      u += c.uMm * c.uMm;
    }
    ++rails;
  }
  EXPECT_EQ(alarms, 0);
  // The largest of shifts in two directions at many places, so a little more than one of them; the baseline's own
  // error, the same for all these rails, is part of it.
  EXPECT_GT(x / u, 0.3);
  EXPECT_LT(x / u, 4);
}

TEST(DriftJudge, RailsWithoutSeamsChangeNothing) {
  SeamModel model(2);
  DriftJudge judge(model.zones, {});
  const std::vector<Seam> none(model.zones.size());
  for (int r = 0; r < 30; ++r) judge.add(none);
  EXPECT_EQ(judge.indicators().rails, 0U);
  EXPECT_TRUE(judge.indicators().learning);
  for (int r = 0; r < 10; ++r) judge.add(model.rail());
  const double before = judge.indicators().cameras[1].valueMm;
  judge.add(none);
  EXPECT_EQ(judge.indicators().cameras[1].valueMm, before);
}

TEST(RailSeams, SeeADisplacedCameraOnEveryZoneItShares) {
  const Section section = *findSection("60E1");
  RenderedRails rails("60E1", 3, 50);
  const auto stripes = rails.extract(0, 2);
  RigCalibration moved = rails.calibration();
  // Camera 2 is 0.1 mm further right and 0.05 mm lower than it is said to be: its points lie as far the other way.
  moved.rangeFinders[1].cameraFromWorld.translationMm -=
      moved.rangeFinders[1].cameraFromWorld.rotation * Eigen::Vector3d(-0.1, 0.05, 0);
  SeamsBy before(section, rails.calibration()), after(section, moved);
  const std::vector<Seam> a = before(stripes), b = after(stripes);
  const std::vector<SeamZone> zones = seamZones(section);
  int seen = 0;
  for (std::size_t z = 0; z < zones.size(); ++z) {
    if (a[z].weight < 5 || b[z].weight < 5) continue;
    const Point2 shift(-0.1, 0.05);
    const double expected = zones[z].first == 1    ? shift.dot(zones[z].normal)
                            : zones[z].second == 1 ? -shift.dot(zones[z].normal)
                                                   : 0;
    EXPECT_NEAR(b[z].mm - a[z].mm, expected, 0.02) << section.primitives[zones[z].primitive].name;
    ++seen;
  }
  EXPECT_GT(seen, 25);
}

/// Baseline, then some undisturbed rails, then a fault: a camera is named, the right one, and none before.
TEST(DriftOfRenderedRails, ACameraThatMovesOrTurnsIsNamed) {
  RenderedRails rails("60E1", 7, 400);
  SeamsBy seams(rails.section(), rails.calibration());
  DriftJudge quiet(seamZones(rails.section()), {});
  int rail = 0;
  for (; rail < 11; ++rail) EXPECT_FALSE(quiet.add(seams(rails.extract(rail, 1))).alarm()) << rail;
  ASSERT_FALSE(quiet.indicators().learning);
  for (const auto& [fault, camera] : {std::pair("move=0.05@3", 2U), std::pair("turn=0.02@2", 1U)}) {
    DriftJudge judge = quiet;
    for (int r = rail; r < rail + 9; ++r) judge.add(seams(rails.extract(r, 1, fault)));
    for (std::size_t c = 0; c < kCameraCount; ++c)
      EXPECT_EQ(judge.indicators().cameras[c].alarm, c == camera)
          << fault << " " << judge.indicators().cameras[c].words;
  }
}

}  // namespace
}  // namespace vignole
