#include "engine/registration/rail_matcher.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "engine/rail/catalogue.h"
#include "engine/registration/shape_misfit.h"
#include "tests/registration/synthetic_profile.h"

namespace vignole {
namespace {

using synthetic::pose;
using synthetic::ProfileRequest;

/// Profiles of one section, or of an outline made from it, held against an expected one.
struct Expecting {
  explicit Expecting(const char* name)
      : section(findSection(name).value()), registrar(section, {}), matcher(section, catalogueSections(), {}) {}

  const Registration& of(const Profile& profile) {
    const auto correlated = static_cast<double>(profile.correlatedPoints);
    registrar.registerProfile(profile.points, registration, {}, correlated);
    matcher.check(profile.points, correlated, registration);
    return registration;
  }

  Section section;
  Registrar registrar;
  RailMatcher matcher;
  Registration registration;
};

ProfileRequest somewhere() {
  ProfileRequest request;
  request.worldFromSection = pose(3, -2, 1);
  return request;
}

/// The outline of a section with some of its primitives moved: it need not close.
struct Outline {
  explicit Outline(const Section& s) : section(s), primitives(synthetic::outlineOf(s)) {}
  /// All primitives whose names begin so.
  void move(const char* beginning, double x, double y) {
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      if (!section.primitives[k].name.starts_with(beginning)) continue;
      if (auto* arc = std::get_if<Arc>(&primitives[k])) arc->centre += Point2(x, y);
      if (auto* segment = std::get_if<Segment>(&primitives[k])) {
        segment->start += Point2(x, y);
        segment->end += Point2(x, y);
      }
    }
  }
  const Section& section;
  std::vector<Primitive> primitives;
};

TEST(RailMatcher, EveryOtherRailOfTheCatalogueIsNamedInOneProfile) {
  const std::vector<Section> all = catalogueSections();
  ASSERT_GE(all.size(), 9U);
  for (const Section& expected : all) {
    Expecting expecting(expected.name.c_str());
    for (const Section& s : all) {
      const Registration& r = expecting.of(synthetic::sample(s, somewhere()));
      if (s.name == expected.name) {
        EXPECT_TRUE(r.valid) << r.reason;
        EXPECT_FALSE(r.looksLike);
        continue;
      }
      EXPECT_FALSE(r.valid);
      ASSERT_TRUE(r.looksLike) << s.name << " where " << expected.name << " was expected";
      EXPECT_EQ(r.looksLike->name, s.name);
      EXPECT_TRUE(r.reason.starts_with("wrong section: looks like " + s.name + " rather than " + expected.name));
    }
  }
}

TEST(RailMatcher, SaysThatThe60E2DiffersAtTheCrownAndNowhereElse) {
  Expecting expecting("60E1");
  const Registration& r = expecting.of(synthetic::sample(findSection("60E2").value(), somewhere()));
  ASSERT_TRUE(r.looksLike);
  EXPECT_GT(r.looksLike->chi2OfExpected, 2 * r.looksLike->chi2);
  std::vector<std::string> names;
  for (const std::int16_t k : r.looksLike->primitives)
    names.push_back(expecting.section.primitives[static_cast<std::size_t>(k)].name);
  for (const std::string& name : names) EXPECT_TRUE(name.starts_with("AHT")) << name;
  EXPECT_NE(std::find(names.begin(), names.end(), "AHTR1"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "AHTL1"), names.end());
}

TEST(RailMatcher, ManyPosesSeedsAndLostCamerasAndStraysChangeNothing) {
  const Section like = findSection("60E2").value();
  Expecting expecting("60E1");
  for (int trial = 0; trial < 60; ++trial) {
    ProfileRequest request;
    request.worldFromSection = pose(trial % 11 - 5, trial % 7 - 3, 0.2 * (trial % 13 - 6));
    request.seed = static_cast<std::uint64_t>(trial) + 5;
    request.correlated = 1 + trial % 9;
    request.outlierShare = trial % 3 == 0 ? 0.1 : 0;
    request.missingCamera = trial % 5 == 0 ? 2 + trial % 2 : -1;  // below: the crown is still seen
    EXPECT_FALSE(expecting.of(synthetic::sample(expecting.section, request)).looksLike) << trial;
    const Registration& r = expecting.of(synthetic::sample(like, request));
    ASSERT_TRUE(r.looksLike) << trial;
    EXPECT_EQ(r.looksLike->name, "60E2");
  }
}

TEST(RailMatcher, ARailWithDefectsIsNoOtherRail) {
  for (const char* rail : {"60E1", "60E2", "54E3", "54E4", "49E1", "49E5", "54E1"}) {
    Expecting expecting(rail);
    const auto isItself = [&](const Outline& outline, const char* what) {
      const Registration& r = expecting.of(synthetic::sample(outline.primitives, somewhere()));
      EXPECT_FALSE(r.looksLike) << rail << ", " << what << ": " << r.reason;
      EXPECT_TRUE(r.valid) << rail << ", " << what << ": " << r.reason;
    };
    const auto head = [](Outline& outline, double x, double y) {
      for (const char* part : {"AH", "SH"}) outline.move(part, x, y);
    };
    for (const double mm : {1.0, -1.0, 0.6}) {
      Outline high(expecting.section);
      head(high, 0, mm);
      isItself(high, "height");
      Outline askew(expecting.section);
      head(askew, mm, 0);
      isItself(askew, "head beside the axis");
    }
    Outline worn(expecting.section);
    worn.move("AHT", 0, -2);
    isItself(worn, "2 mm of head wear");
    Outline wide(expecting.section);
    for (const char* part : {"SBR", "ABBR", "ABTR1"}) wide.move(part, 1, 0);
    isItself(wide, "foot too wide");
  }
}

TEST(RailMatcher, NamesNothingWhereThereIsNoRail) {
  Expecting expecting("60E1");
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(-100, 100);
  Profile noise;
  noise.points.resize(2000);
  for (auto& p : noise.points) p.x = u(random), p.y = u(random) + 86;
  const Registration& r = expecting.of(noise);
  EXPECT_FALSE(r.valid);
  EXPECT_FALSE(r.looksLike);
  EXPECT_FALSE(expecting.of({}).looksLike);
}

TEST(RailMatcher, EveryRailOfTheCatalogueIsItsOwnBestMatch) {
  const std::vector<Section> all = catalogueSections();
  RailMatcher matcher(all.front(), all, {});
  for (const Section& s : all) {
    ProfileRequest request;
    request.worldFromSection = pose(-7, 4, -3);
    const auto matches = matcher.bestMatch(synthetic::sample(s, request).points);
    ASSERT_EQ(matches.size(), all.size());
    EXPECT_EQ(matches.front().rail, s.name);
    EXPECT_NEAR(matches.front().chi2, 1, 0.2);
    EXPECT_GT(matches[1].chi2, 5);
    EXPECT_GT(matches.back().chi2, 100);
  }
}

TEST(ShapeMisfit, SmoothDisplacementCostsLittleAndAnotherBendALot) {
  const Section s = findSection("60E1").value(), like = findSection("60E2").value();
  Registrar registrar(s, {});
  ShapeMisfit misfit(s);
  Registration r;
  const auto of = [&](const std::vector<Primitive>& outline) {
    const Profile profile = synthetic::sample(outline, somewhere());
    registrar.registerProfile(profile.points, r);
    return misfit.measure(profile.points, r, 1).chi2;
  };
  EXPECT_LT(of(synthetic::outlineOf(s)), 1);
  EXPECT_GT(of(synthetic::outlineOf(like)), 2);
}

}  // namespace
}  // namespace vignole
