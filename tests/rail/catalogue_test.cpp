#include "engine/rail/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "engine/rail/check.h"

namespace vignole {
namespace {

Section catalogueSection(const std::string& name) {
  auto section = findSection(name);
  EXPECT_TRUE(section) << (section ? "" : section.error().message());
  return section ? std::move(*section) : Section{};
}

/// The first figures of the table in rails.md: exact integrals that somebody else computed.
struct Expectation {
  const char* name;
  double areaCm2, massKgPerM, ixCm4, iyCm4, centroidYMm;
};
constexpr Expectation kExpected[] = {
    {"60E1", 76.700, 60.210, 3038.35, 512.31, 80.92}, {"60E2", 76.484, 60.040, 3022.12, 510.54, 80.67},
    {"54E1", 69.772, 54.771, 2337.87, 419.07, 75.13}, {"54E3", 69.514, 54.568, 2074.1, 354.79, 0},
    {"54E4", 69.181, 54.307, 2055.9, 352.6, 0},       {"49E1", 62.918, 49.390, 1816.5, 319.08, 73.41},
    {"49E5", 62.587, 49.131, 1799.9, 316.9, 73.04}};

TEST(Catalogue, IntegralsAgreeWithTheTable) {
  for (const Expectation& e : kExpected) {
    const SectionProperties p = properties(catalogueSection(e.name));
    EXPECT_NEAR(p.areaMm2 / 100, e.areaCm2, 0.0006) << e.name;
    EXPECT_NEAR(p.massKgPerM, e.massKgPerM, 0.0006) << e.name;
    EXPECT_NEAR(p.ixCm4, e.ixCm4, 0.06) << e.name;
    EXPECT_NEAR(p.iyCm4, e.iyCm4, 0.06) << e.name;
    if (e.centroidYMm > 0) {
      EXPECT_NEAR(p.centroidYMm, e.centroidYMm, 0.006) << e.name;
    }
    EXPECT_NEAR(p.centroidXMm, 0, 1e-6) << e.name;
  }
}

/// The same integrals by brute force: a fine polygon instead of arcs.
TEST(Catalogue, ClosedFormsAgreeWithAFinePolygon) {
  for (const char* name : {"60E1", "54E1", "ASYM54"}) {
    const Section section = catalogueSection(name);
    double area = 0, ofX = 0, ofY = 0, ofXX = 0, ofYY = 0, perimeter = 0;
    for (const NamedPrimitive& p : section.primitives) {
      constexpr int kSteps = 4000;
      for (int i = 0; i < kSteps; ++i) {
        const Point2 a = pointAt(p.shape, length(p.shape) * i / kSteps);
        const Point2 b = pointAt(p.shape, length(p.shape) * (i + 1) / kSteps);
        const double cross = a.x() * b.y() - b.x() * a.y();
        area += cross / 2;
        ofX += cross * (a.x() + b.x()) / 6;
        ofY += cross * (a.y() + b.y()) / 6;
        ofXX += cross * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 12;
        ofYY += cross * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 12;
        perimeter += (b - a).norm();
      }
    }
    const SectionProperties p = properties(section);
    EXPECT_NEAR(p.areaMm2, area, 1e-3) << name;
    EXPECT_NEAR(p.centroidXMm, ofX / area, 1e-5) << name;
    EXPECT_NEAR(p.centroidYMm, ofY / area, 1e-5) << name;
    EXPECT_NEAR(p.ixCm4, (ofYY - ofY * ofY / area) / 1e4, 1e-3) << name;
    EXPECT_NEAR(p.iyCm4, (ofXX - ofX * ofX / area) / 1e4, 1e-3) << name;
    EXPECT_NEAR(p.perimeterMm, perimeter, 1e-3) << name;
  }
}

TEST(Catalogue, EverySectionClosesIsTangentAndMeetsWhatIsPublished) {
  const auto names = catalogueNames();
  EXPECT_EQ(names.size(), 9U);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const std::string& name : names) {
    const Section section = catalogueSection(name);
    EXPECT_EQ(section.name, name) << "the file is named after its section";
    EXPECT_FALSE(section.note.empty()) << name;
    for (const SectionCheck& check : checkSection(section))
      EXPECT_TRUE(check.pass) << name << " " << check.what << " " << check.value;
  }
}

TEST(Catalogue, HeightsAxesAndSymmetry) {
  const std::map<std::string, double> heights = {{"60E1", 172}, {"60E2", 172}, {"54E1", 159}, {"54E3", 154},
                                                 {"54E4", 154}, {"49E1", 149}, {"49E5", 149}, {"ASYM54", 129}};
  for (const auto& [name, height] : heights) {
    const Section section = catalogueSection(name);
    EXPECT_NEAR(section.heightMm(), height, 1e-3) << name;
    EXPECT_EQ(section.symmetric(), name != "ASYM54") << name;
    EXPECT_NEAR(section.axisXMm(), 0, 1e-9) << name;
  }
  EXPECT_EQ(catalogueSection("ASYM54").standing, SectionStanding::Invented);
  EXPECT_EQ(catalogueSection("115RE").standing, SectionStanding::Approximate);
  EXPECT_EQ(catalogueSection("60E1").standing, SectionStanding::Standard);
  EXPECT_NEAR(catalogueSection("115RE").heightMm(), 168.28, 0.01);
}

TEST(Catalogue, FindsByNameInAnyCaseOrByFile) {
  EXPECT_EQ(findSection("60e1")->name, "60E1");
  EXPECT_EQ(findSection((resourceDirectory() / "rails" / "54E3.json").string())->name, "54E3");
  const auto missing = findSection("61E1");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find("60E1, 60E2"), std::string::npos) << missing.error().message();
  EXPECT_FALSE(findSection("none.json"));
  EXPECT_FALSE(findSection(""));
}

TEST(Catalogue, ResourcesMayBeMoved) {
  ::setenv("VIGNOLE_RESOURCES", "/no/such/place", 1);
  EXPECT_EQ(resourceDirectory(), "/no/such/place");
  EXPECT_TRUE(catalogueNames().empty());
  const auto missing = findSection("60E1");
  ::unsetenv("VIGNOLE_RESOURCES");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::World);
  EXPECT_FALSE(catalogueNames().empty());
}

TEST(Catalogue, ReadsTheOutlinesThatItWasMadeFrom) {
  const std::filesystem::path shared = std::filesystem::path(VIGNOLE_SHARED_DATA) / "rails";
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not here";
  const std::map<std::string, std::string> files = {
      {"60E1", "60E1"}, {"60E2", "60E2"},          {"54E1", "54E1"},
      {"54E3", "54E3"}, {"54E4", "54E4"},          {"49E1", "49E1"},
      {"49E5", "49E5"}, {"115RE", "115RE_APPROX"}, {"ASYM54", "ASYM_54E1A1_like_SYNTHETIC"}};
  for (const auto& [name, file] : files) {
    const Section ours = catalogueSection(name);
    const auto theirs = loadSection(shared / (file + ".json"));
    ASSERT_TRUE(theirs) << theirs.error().message();
    ASSERT_EQ(ours.primitives.size(), theirs->primitives.size());
    EXPECT_NEAR(ours.axisFromFootMiddleMm, theirs->axisFromFootMiddleMm, 1e-9);
    for (std::size_t i = 0; i < ours.primitives.size(); ++i) {
      EXPECT_EQ(ours.primitives[i].name, theirs->primitives[i].name);
      EXPECT_EQ(startPoint(ours.primitives[i].shape), startPoint(theirs->primitives[i].shape));
      EXPECT_EQ(curvature(ours.primitives[i].shape), curvature(theirs->primitives[i].shape));
    }
  }
}

}  // namespace
}  // namespace vignole
