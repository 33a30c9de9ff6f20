// The shape law and the truth gauge: nominals known from elsewhere, and every deviation where it belongs.

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "engine/rail/catalogue.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole {
namespace {

Section section(const std::string& name) {
  auto found = findSection(name);
  EXPECT_TRUE(found.has_value()) << (found ? "" : found.error().message());
  return found ? *found : Section{};
}

VirtualRigSettings still(const std::string& rail) {
  VirtualRigSettings s;
  s.section = section(rail);
  s.parameters = s.section.parameters;
  s.varyDimensions = false;
  return s;
}

Truth truthOf(const VirtualRigSettings& settings, std::uint64_t trigger = 7) {
  const auto rig = VirtualRig::create(settings);
  EXPECT_TRUE(rig.has_value()) << (rig ? "" : rig.error().message());
  return rig ? (*rig)->truth(trigger) : Truth{};
}

TEST(RailTruth, NominalsOf60E1AreThoseOfTheDrawing) {
  // rails.md; RAS = (150 - 71.963) / 2 with HW at 14 mm on the R13 arc, FT by hand from the 1:14 slope.
  const Truth t = truthOf(still("60E1"));
  const auto v = [&](Dimension d) { return t.valueMm[index(d)]; };
  EXPECT_NEAR(v(Dimension::RH), 172, 1e-3);
  EXPECT_NEAR(v(Dimension::RFH), 89.5 + 25 / 1.375, 1e-3);
  EXPECT_NEAR(v(Dimension::FW), 150, 1e-3);
  EXPECT_NEAR(v(Dimension::HW), 71.963, 1e-3);
  EXPECT_NEAR(v(Dimension::HWA), 72.1575, 1e-3);
  EXPECT_NEAR(v(Dimension::FTl), 12.879852 - (65 - 55.682066) / 14, 1e-3);
  EXPECT_NEAR(v(Dimension::FTr), 12.2143, 1e-3);
  EXPECT_NEAR(v(Dimension::RASl), 39.0185, 1e-3);
  EXPECT_NEAR(v(Dimension::RASr), 39.0185, 1e-3);
  EXPECT_NEAR(v(Dimension::WT), 16.5, 1e-3);
  EXPECT_NEAR(v(Dimension::HR), 300, 0.02);
  EXPECT_NEAR(v(Dimension::FC), 0, 1e-3);
  EXPECT_NEAR(v(Dimension::HF), 0, 1e-3);
  EXPECT_NEAR(t.hfMinMm, 0, 1e-3);
}

TEST(RailTruth, NominalsOfOtherSectionsAreThoseOfTheirDrawings) {
  const auto value = [](const char* rail, Dimension d) { return truthOf(still(rail)).valueMm[index(d)]; };
  EXPECT_NEAR(value("54E1", Dimension::HW), 69.989, 1e-3);
  EXPECT_NEAR(value("54E1", Dimension::HWA), 70.177, 1e-3);
  EXPECT_NEAR(value("54E1", Dimension::RFH), 79.4 + 25 / 1.375, 1e-3);
  EXPECT_NEAR(value("54E1", Dimension::WT), 16, 1e-3);
  EXPECT_NEAR(value("49E1", Dimension::RH), 149, 1e-3);
  EXPECT_NEAR(value("49E5", Dimension::HR), 115, 0.02);
}

class EveryRail : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryRail, testing::ValuesIn(catalogueNames()),
                         [](const auto& p) { return p.param; });

TEST_P(EveryRail, EachDeviationSteersItsOwnDimension) {
  const VirtualRigSettings nominal = still(GetParam());
  const Truth zero = truthOf(nominal);
  // A dimension that must move with another: the width at another depth, and RAS with widths (FW = RAS_l + HW + RAS_r).
  using D = Dimension;
  PerDimension<std::set<D>> follow = {{{},
                                       {},
                                       {D::RASl, D::RASr},
                                       {},
                                       {D::HWA, D::RASl, D::RASr},
                                       {D::HW, D::RASl, D::RASr},
                                       {},
                                       {},
                                       {D::RASr},
                                       {D::RASl},
                                       {},
                                       {D::HF},
                                       {}}};
  // HF ends on the corner arc of the others' heads, which goes with the head side.
  if (!std::set<std::string>{"60E1", "54E1"}.contains(GetParam()))
    for (const D d : {D::HW, D::HWA, D::RASl, D::RASr}) follow[index(d)].insert(D::HF);
  const bool oneShoulder = !std::set<std::string>{"60E2", "49E5", "54E4"}.contains(GetParam());
  for (const D steered : kDimensions) {
    // Small shoulders (49E5, 54E4) leave little room for the crown.
    const double amount = steered == D::HF ? 0.02 : steered == D::HR ? 0.2 : 0.15;
    VirtualRigSettings settings = nominal;
    settings.deviationMm[index(steered)] = amount;
    if (steered == D::HF && !oneShoulder) {
      EXPECT_FALSE(VirtualRig::create(settings).has_value());
      continue;
    }
    const Truth t = truthOf(settings);
    EXPECT_NEAR(t.valueMm[index(steered)] - zero.valueMm[index(steered)], amount, 2e-3) << name(steered);
    for (const D other : kDimensions) {
      if (other == steered || follow[index(steered)].contains(other)) continue;
      // HR comes out of 0.2 mm of sagitta: a nanometre there is a micrometre of radius.
      const double limit = other == D::HR ? 0.02 : 6e-3;
      EXPECT_NEAR(t.valueMm[index(other)], zero.valueMm[index(other)], limit)
          << name(other) << " moved when " << name(steered) << " was steered";
    }
  }
}

TEST_P(EveryRail, TheLawGivesAnOutlineEverywhere) {
  VirtualRigSettings settings = still(GetParam());
  settings.varyDimensions = true;
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL}) {
    settings.seed = seed;
    const auto rig = VirtualRig::create(settings);
    ASSERT_TRUE(rig.has_value()) << rig.error().message();
    for (std::uint64_t trigger = 0; trigger < 4000; trigger += 397) {
      const auto outline = (*rig)->outline(trigger);
      for (std::size_t i = 0; i < outline.size(); ++i)
        EXPECT_LT((outline[(i + 1) % outline.size()] - outline[i]).norm(), 0.25) << "a crack at " << i;
    }
  }
}

TEST(RailTruth, NegativeCrownDeviationIsTheMinimum) {
  VirtualRigSettings settings = still("60E1");
  settings.deviationMm[index(Dimension::HF)] = -0.2;
  const Truth t = truthOf(settings);
  EXPECT_NEAR(t.hfMinMm, -0.2, 2e-3);
  EXPECT_NEAR(t.valueMm[index(Dimension::HF)], 0, 2e-3);
}

TEST(RailTruth, BothSidesOfTheHeadSetItsWidth) {
  VirtualRigSettings settings = still("60E1");
  settings.deviationMm[index(Dimension::RASl)] = 0.3;
  settings.deviationMm[index(Dimension::RASr)] = -0.1;
  const Truth t = truthOf(settings);
  EXPECT_NEAR(t.valueMm[index(Dimension::RASl)], 39.3185, 2e-3);
  EXPECT_NEAR(t.valueMm[index(Dimension::RASr)], 38.9185, 2e-3);
  EXPECT_NEAR(t.valueMm[index(Dimension::FW)], 150, 2e-3);
  EXPECT_NEAR(t.valueMm[index(Dimension::HW)], 71.963 - 0.2, 2e-3);
}

TEST(RailTruth, ContradictingDeviationsAreRefused) {
  VirtualRigSettings settings = still("60E1");
  settings.deviationMm[index(Dimension::HW)] = 0.1;
  settings.deviationMm[index(Dimension::HWA)] = 0.2;
  EXPECT_FALSE(VirtualRig::create(settings).has_value());
  settings = still("60E1");
  for (const Dimension d : {Dimension::HW, Dimension::FW, Dimension::RASl, Dimension::RASr})
    settings.deviationMm[index(d)] = 0.1;
  EXPECT_FALSE(VirtualRig::create(settings).has_value());
}

TEST(RailTruth, AParameterOffItsPrimitiveIsRefused) {
  VirtualRigSettings settings = still("60E1");
  settings.parameters.rfhFromAxisMm = {5, 5};  // inside the web
  const auto rig = VirtualRig::create(settings);
  ASSERT_FALSE(rig.has_value());
  EXPECT_NE(rig.error().message().find("RFH"), std::string::npos) << rig.error().message();
}

TEST(RailTruth, TheLawVariesWithinAQuarterOfTheClassAndSmoothly) {
  VirtualRigSettings settings = still("60E1");
  settings.varyDimensions = true;
  const auto rig = VirtualRig::create(settings);
  ASSERT_TRUE(rig.has_value());
  const Truth nominal = truthOf(still("60E1"));
  double low = 1e9, high = -1e9, before = std::nan("");
  for (std::uint64_t trigger = 0; trigger < 4000; ++trigger) {
    if (trigger % 10 > 1) continue;
    const double rh = (*rig)->truth(trigger).valueMm[index(Dimension::RH)];
    low = std::min(low, rh);
    high = std::max(high, rh);
    if (trigger % 10 == 1) {
      EXPECT_LT(std::abs(rh - before), 0.01) << "jump in 15 mm";
    }
    before = rh;
  }
  const double rh = nominal.valueMm[index(Dimension::RH)];
  EXPECT_GT(high - low, 0.08);
  EXPECT_LT(high, rh + 0.17);
  EXPECT_GT(low, rh - 0.13);
}

TEST(RailTruth, TheRenderedRailGrowsWithTemperatureAndTheTruthDoesNot) {
  VirtualRigSettings cold = still("60E1");
  cold.effects.wander = cold.effects.vibration = 0;
  cold.temperatureC = 15;
  VirtualRigSettings hot = cold;
  hot.temperatureC = 115;
  const auto a = VirtualRig::create(cold), b = VirtualRig::create(hot);
  ASSERT_TRUE(a && b);
  double top = 0, hotTop = 0;
  for (const Point2& p : (*a)->outline(0)) top = std::max(top, p.y());
  for (const Point2& p : (*b)->outline(0)) hotTop = std::max(hotTop, p.y());
  EXPECT_NEAR(hotTop - top, 172 * 11.5e-6 * 100, 1e-6);
  EXPECT_EQ((*a)->truth(0).valueMm, (*b)->truth(0).valueMm);
}

}  // namespace
}  // namespace vignole
