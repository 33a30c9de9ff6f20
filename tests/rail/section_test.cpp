#include "engine/rail/section.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <unistd.h>

#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

namespace fs = std::filesystem;

Section good() { return *findSection("60E1"); }

std::string refusal(const std::function<void(Section&)>& spoil) {
  Section section = good();
  spoil(section);
  const auto created = createSection(section);
  return created ? "" : created.error().message();
}

Segment& segment(Section& s, const char* name) { return std::get<Segment>(s.primitives[*s.find(name)].shape); }
Arc& arc(Section& s, const char* name) { return std::get<Arc>(s.primitives[*s.find(name)].shape); }

::testing::AssertionResult says(const std::string& message, const std::vector<std::string>& wanted) {
  for (const std::string& w : wanted)
    if (message.find(w) == std::string::npos)
      return ::testing::AssertionFailure() << "\"" << message << "\" does not say \"" << w << "\"";
  return ::testing::AssertionSuccess();
}

TEST(Section, AcceptsWhatIsGood) {
  EXPECT_EQ(refusal([](Section&) {}), "");
}

TEST(Section, RefusesAGap) {
  EXPECT_TRUE(says(refusal([](Section& s) { segment(s, "SHR").end.y() -= 0.002; }), {"SHR to AHTR1", "gap", "0.002"}));
  EXPECT_TRUE(says(refusal([](Section& s) { s.primitives.pop_back(); }), {"SBL to SBB", "gap"}));
  EXPECT_EQ(refusal([](Section& s) { segment(s, "SHR").end.y() -= 0.0005; }), "") << "half a micrometre is rounding";
}

TEST(Section, RefusesAKink) {
  EXPECT_TRUE(says(refusal([](Section& s) {
                     // 0.02 degrees at both ends of the foot edge, without a gap
                     segment(s, "SBR").start.x() -= 0.0009;
                     segment(s, "SBR").end.x() += 0.0009;
                   }),
                   {"SBR", "kink"}));
}

TEST(Section, RefusesClockwise) {
  EXPECT_TRUE(says(refusal([](Section& s) {
                     std::reverse(s.primitives.begin(), s.primitives.end());
                     for (NamedPrimitive& p : s.primitives)
                       if (auto* g = std::get_if<Segment>(&p.shape)) {
                         std::swap(g->start, g->end);
                       } else {
                         auto& a = std::get<Arc>(p.shape);
                         a.startAngleRad += a.sweepRad;
                         a.sweepRad = -a.sweepRad;
                       }
                   }),
                   {"clockwise"}));
}

TEST(Section, RefusesAnOutlineThatCrossesItself) {
  // A stadium with a loop: every joint is closed and tangent, but the loop passes through the lower side.
  Section s;
  s.name = "loop";
  const double pi = std::acos(-1.0);
  s.primitives = {{"A", Segment{{0, 0}, {10, 0}}}, {"B", Arc{{10, -1}, 1, pi / 2, -1.5 * pi}},
                  {"C", Segment{{9, -1}, {9, 4}}}, {"D", Arc{{8, 4}, 1, 0, pi / 2}},
                  {"E", Segment{{8, 5}, {0, 5}}},  {"F", Arc{{0, 2.5}, 2.5, pi / 2, pi}}};
  const auto created = createSection(s);
  ASSERT_FALSE(created);
  EXPECT_TRUE(says(created.error().message(), {"A and C", "cross"}));
}

TEST(Section, RefusesMissingPrimitives) {
  for (const char* needed : {"SBB", "SBL", "SBR", "SWBL", "SWBR", "SHBL", "SHBR", "SHL", "SHR", "AHT"})
    EXPECT_TRUE(says(refusal([&](Section& s) { s.primitives[*s.find(needed)].name = "X"; }), {needed, "missing"}));
  EXPECT_TRUE(
      says(refusal([](Section& s) { std::swap(s.primitives[*s.find("AHT")].name, s.primitives[*s.find("SHR")].name); }),
           {"must be"}));
  EXPECT_TRUE(
      says(refusal([](Section& s) { std::swap(s.primitives[*s.find("SBL")].name, s.primitives[*s.find("SBR")].name); }),
           {"left and right"}));
}

TEST(Section, RefusesValuesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(refusal([&](Section& s) { segment(s, "SHR").end.y() = nan; }), {"SHR", "not a number"}));
  EXPECT_TRUE(says(refusal([&](Section& s) { arc(s, "AHT").sweepRad = nan; }), {"AHT", "not a number"}));
  EXPECT_TRUE(says(refusal([](Section& s) { arc(s, "AHT").radiusMm = 0; }), {"AHT", "radius"}));
  EXPECT_TRUE(says(refusal([](Section& s) { arc(s, "AHT").sweepRad = 7; }), {"AHT", "circle"}));
  EXPECT_TRUE(says(refusal([](Section& s) { s.primitives[1].name = "SBB"; }), {"SBB", "twice"}));
  EXPECT_TRUE(says(refusal([](Section& s) { s.primitives[1].name = ""; }), {"no name"}));
  EXPECT_TRUE(says(refusal([](Section& s) { s.primitives.clear(); }), {"fewer than 3"}));
  EXPECT_TRUE(says(refusal([](Section& s) { s.name = ""; }), {"no name"}));
  EXPECT_TRUE(says(refusal([&](Section& s) { s.axisFromFootMiddleMm = nan; }), {"axis_from_foot_middle_mm"}));
}

class SectionFile : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::path(testing::TempDir()) / ("vignole_section_" + std::to_string(::getpid()) + ".json");
    text_ = toJson(good());
  }
  void TearDown() override { fs::remove(file_); }
  Expected<Section> load(const std::string& text) {
    EXPECT_TRUE(writeFile(file_, text));
    return loadSection(file_);
  }
  std::string refusalAfter(const std::string& from, const std::string& to) {
    std::string text = text_;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    const auto section = load(text);
    return section ? "" : section.error().message();
  }
  fs::path file_;
  std::string text_;
};

TEST_F(SectionFile, RoundTripKeepsEverything) {
  for (const std::string& name : catalogueNames()) {
    const Section before = *findSection(name);
    const auto after = load(toJson(before));
    ASSERT_TRUE(after) << after.error().message();
    EXPECT_EQ(after->name, before.name);
    EXPECT_EQ(after->standard, before.standard);
    EXPECT_EQ(after->note, before.note);
    EXPECT_EQ(after->standing, before.standing);
    EXPECT_EQ(after->axisFromFootMiddleMm, before.axisFromFootMiddleMm);
    EXPECT_EQ(after->parameters.rfhFromAxisMm.left, before.parameters.rfhFromAxisMm.left);
    EXPECT_EQ(after->published.areaCm2, before.published.areaCm2);
    EXPECT_EQ(after->published.areaTolerancePercent, before.published.areaTolerancePercent);
    ASSERT_EQ(after->primitives.size(), before.primitives.size());
    for (std::size_t i = 0; i < before.primitives.size(); ++i) {
      EXPECT_EQ(after->primitives[i].name, before.primitives[i].name);
      EXPECT_NEAR((startPoint(after->primitives[i].shape) - startPoint(before.primitives[i].shape)).norm(), 0, 2e-6);
      EXPECT_NEAR(length(after->primitives[i].shape), length(before.primitives[i].shape), 4e-6);
    }
  }
}

TEST_F(SectionFile, NamesFileAndFieldOfWhatIsWrong) {
  EXPECT_TRUE(
      says(refusalAfter("\"radius\":13.0", "\"radius\":\"13\""), {file_.string(), "AHTR1", "radius", "number"}));
  EXPECT_TRUE(says(refusalAfter("\"radius\":13.0", "\"radius\":14.0"), {"AHTR1", "radius", "off the circle"}));
  EXPECT_TRUE(says(refusalAfter("\"radius\":13.0", "\"radius\":null"), {"AHTR1", "radius"}));
  EXPECT_TRUE(says(refusalAfter("\"radius\":13.0", "\"radius\":NaN"), {file_.string() + ":", "not JSON"}));
  EXPECT_TRUE(says(refusalAfter("\"radius\":13.0", "\"radius\":1e999"), {"too large"}));
  EXPECT_TRUE(says(refusalAfter("\"radius\":13.0,", ""), {"AHTR1", "radius", "missing"}));
  EXPECT_TRUE(says(refusalAfter("\"type\":\"arc\"", "\"type\":\"ark\""), {"ABBR", "type", "ark"}));
  EXPECT_TRUE(says(refusalAfter("\"ccw\":true", "\"ccw\":1"), {"ABBR", "ccw"}));
  EXPECT_TRUE(says(refusalAfter("\"p0\":[-73.0,0.0]", "\"p0\":[-73.0]"), {"SBB", "p0", "two numbers"}));
  EXPECT_TRUE(says(refusalAfter("\"format\": 1", "\"format\": 2"), {"format"}));
  EXPECT_TRUE(says(refusalAfter("\"standing\": \"standard\"", "\"standing\": \"good\""), {"standing", "good"}));
  EXPECT_TRUE(says(refusalAfter("\"standard\":", "\"standart\":"), {"standart", "not known"}));
  EXPECT_TRUE(says(refusalAfter("\"area_cm2\"", "\"area_mm2\""), {"published", "area_mm2", "not known"}));
  EXPECT_TRUE(says(refusalAfter("\"name\":\"SHR\"", "\"name\":\"SHX\""), {"SHR", "missing"}));
  EXPECT_TRUE(says(refusalAfter("\"primitives\"", "\"primitifs\""), {"primiti"}));
}

TEST_F(SectionFile, TruncatedAtAnyPlaceIsRefused) {
  for (std::size_t size = 0; size + 3 < text_.size(); size += 97) {
    const auto section = load(text_.substr(0, size));
    ASSERT_FALSE(section) << size;
    EXPECT_TRUE(says(section.error().message(), {file_.string(), "incomplete"})) << size;
  }
}

TEST_F(SectionFile, RefusesOtherJson) {
  for (const char* text : {"[]", "3", "null", "{}", "{\"format\":1}", "\"text\""}) EXPECT_FALSE(load(text)) << text;
}

TEST(SectionName, OfEveryDimensionIsUniqueAndFound) {
  for (const Dimension d : kDimensions) {
    EXPECT_EQ(dimensionFromName(name(d)), d);
    EXPECT_FALSE(title(d).empty());
  }
  EXPECT_EQ(name(Dimension::FTl), "FT_l");
  EXPECT_EQ(dimensionFromName("rh"), std::nullopt);
}

}  // namespace
}  // namespace vignole
