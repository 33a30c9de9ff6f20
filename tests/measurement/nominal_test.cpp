#include <gtest/gtest.h>

#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

Section section(const char* name) {
  auto s = findSection(name);
  EXPECT_TRUE(s) << s.error().message();
  return *s;
}

PerDimension<std::optional<double>> nominals(const char* name) {
  const Section s = section(name);
  auto n = nominalDimensions(s, defaultParameters(s));
  EXPECT_TRUE(n) << n.error().message();
  return *n;
}

double at(const PerDimension<std::optional<double>>& n, Dimension d) { return n[index(d)].value(); }

TEST(Nominals, HitTheDesignTableFor60E1) {
  const auto n = nominals("60E1");
  EXPECT_NEAR(at(n, Dimension::RH), 172.000, 5e-4);
  EXPECT_NEAR(at(n, Dimension::RFH), 107.682, 5e-4);
  EXPECT_NEAR(at(n, Dimension::FW), 150.000, 5e-4);
  EXPECT_NEAR(at(n, Dimension::HW), 71.963, 5e-4);
  EXPECT_NEAR(at(n, Dimension::HWA), 72.157, 5e-4);
  EXPECT_NEAR(at(n, Dimension::FTl), 12.214, 5e-4);
  EXPECT_NEAR(at(n, Dimension::FTr), 12.214, 5e-4);
  EXPECT_NEAR(at(n, Dimension::RASl), 39.018, 5e-4);
  EXPECT_NEAR(at(n, Dimension::RASr), 39.018, 5e-4);
  EXPECT_NEAR(at(n, Dimension::WT), 16.500, 5e-4);
  EXPECT_NEAR(at(n, Dimension::HR), 300, 1e-2);
  EXPECT_NEAR(at(n, Dimension::FC), 0, 1e-12);
  EXPECT_NEAR(at(n, Dimension::HF), 0, 1e-12);
}

TEST(Nominals, The54E1WebIsOneArcThinnestAt76) {
  const auto n = nominals("54E1");
  EXPECT_NEAR(at(n, Dimension::WT), 16.0, 2e-3);
  EXPECT_NEAR(at(n, Dimension::HW), 69.989, 5e-4);
  EXPECT_NEAR(at(n, Dimension::HWA), 70.177, 5e-4);
  EXPECT_NEAR(at(n, Dimension::RFH), 79.4 + 0.72727 * 25, 2e-3);
}

TEST(Nominals, EverySectionOfTheCatalogueHasAllThirteen) {
  for (const std::string& name : catalogueNames()) {
    const Section s = section(name.c_str());
    const auto n = nominalDimensions(s, defaultParameters(s));
    ASSERT_TRUE(n) << n.error().message();
    for (const Dimension d : kDimensions) EXPECT_TRUE((*n)[index(d)]) << name << " " << vignole::name(d);
    EXPECT_NEAR(at(*n, Dimension::RH), s.heightMm(), 2e-3) << name;
    if (s.symmetric()) {
      EXPECT_NEAR(at(*n, Dimension::RASl), at(*n, Dimension::RASr), 1e-6) << name;
      EXPECT_NEAR(at(*n, Dimension::FTl), at(*n, Dimension::FTr), 1e-6) << name;
    }
  }
}

TEST(Nominals, TheAsymmetricExampleHasItsAxisBesideTheFootsMiddle) {
  for (const std::string& name : catalogueNames()) {
    if (name.find("ASYM") == std::string::npos) continue;
    const auto n = nominals(name.c_str());
    EXPECT_NEAR(at(n, Dimension::FW), 147, 1e-6);
    EXPECT_NEAR(at(n, Dimension::RASl) - at(n, Dimension::RASr), 84 - 63, 1e-6);
    EXPECT_NEAR(at(n, Dimension::WT), 36, 2e-2);
    return;
  }
  FAIL() << "the catalogue has no asymmetric example";
}

TEST(Nominals, RefuseAParameterThatFallsOffItsPrimitive) {
  const Section s = section("60E1");
  const auto refused = [&](auto change, const char* dimension, const char* value) {
    DimensionParameters p;
    change(p);
    const auto n = nominalDimensions(s, p);
    ASSERT_FALSE(n) << dimension;
    EXPECT_NE(n.error().message().find(dimension), std::string::npos) << n.error().message();
    EXPECT_NE(n.error().message().find(value), std::string::npos) << n.error().message();
  };
  refused([](DimensionParameters& p) { p.rfhFromAxisMm.left = 50; }, "RFH", "-50 mm");
  refused([](DimensionParameters& p) { p.hwDepthMm = 40; }, "HW", "40 mm");
  refused([](DimensionParameters& p) { p.hwaDepthMm = 39; }, "HWA", "39 mm");
  refused([](DimensionParameters& p) { p.ftInsideMm.right = 90; }, "FT_r", "90 mm");
  refused([](DimensionParameters& p) { p.rasDepthMm.left = 45; }, "RAS_l", "45 mm");
  refused([](DimensionParameters& p) { p.hfHalfWidthMm.right = 60; }, "HF", "37 mm");
  refused([](DimensionParameters& p) { p.wtHeightMm = 150; }, "WT", "150 mm");
}

TEST(Nominals, FollowTheirParameters) {
  const Section s = section("60E1");
  DimensionParameters p;
  p.rfhFromAxisMm = {20, 30};
  p.ftInsideMm = {15, 8};
  const auto n = nominalDimensions(s, p);
  ASSERT_TRUE(n) << n.error().message();
  EXPECT_NEAR(at(*n, Dimension::RFH), 89.5 + 0.72727 * 25, 2e-3);
  EXPECT_GT(at(*n, Dimension::FTl), at(*n, Dimension::FTr));
}

}  // namespace
}  // namespace vignole
