#include <fstream>
#include <gtest/gtest.h>

#include "engine/archive/alarm_history.h"
#include "engine/archive/audit_trail.h"
#include "engine/archive/calibration_history.h"
#include "engine/archive/recipe_history.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

class HistoriesTest : public ::testing::Test {
 protected:
  testing::ArchiveFolder folder;
  Archive archive = testing::openArchive(folder.url());
};

TEST_F(HistoriesTest, ARecipeIsDraftedApprovedAndReplaced) {
  RecipeHistory recipes(archive);
  Recipe recipe = testing::recipe();
  EXPECT_EQ(*recipes.nextVersion(recipe.name), 1);
  const auto first = recipes.addDraft(recipe, "Quinn", "as the standard has it");
  ASSERT_TRUE(first) << first.error().message();
  EXPECT_EQ(first->state, RecipeState::Draft);
  EXPECT_FALSE(*recipes.approved(recipe.name));
  EXPECT_FALSE(recipes.approve(first->key, "Rosa", ""));
  EXPECT_FALSE(recipes.approve(first->key, "Quinn", "my own"));
  ASSERT_TRUE(recipes.approve(first->key, "Rosa", "checked against the standard"));
  EXPECT_FALSE(recipes.approve(first->key, "Rosa", "again"));
  EXPECT_EQ((*recipes.approved(recipe.name))->version, 1);

  EXPECT_FALSE(recipes.addDraft(recipe, "Quinn", "the same"));
  recipe.version = *recipes.nextVersion(recipe.name);
  recipe.limits[index(Dimension::HW)].upperMm = 0.4;
  const auto second = recipes.addDraft(recipe, "Quinn", "narrower head");
  ASSERT_TRUE(second) << second.error().message();
  EXPECT_EQ((*recipes.approved(recipe.name))->version, 1);
  ASSERT_TRUE(recipes.approve(second->key, "Rosa", "customer asks"));
  const auto versions = recipes.versions(recipe.name);
  ASSERT_EQ(versions->size(), 2U);
  EXPECT_EQ(versions->at(0).state, RecipeState::Approved);
  EXPECT_EQ(versions->at(1).state, RecipeState::Retired);
  EXPECT_EQ(versions->at(0).reason, "customer asks");
  EXPECT_EQ(*recipes.text(second->key), toToml(recipe));
  EXPECT_EQ(*recipes.names(), (std::vector<std::string>{recipe.name}));
  EXPECT_EQ(AuditTrail(archive).entries()->size(), 5U);
  EXPECT_TRUE(AuditTrail(archive).verify()->empty());
}

TEST_F(HistoriesTest, ARecipeThatRailsWereMeasuredWithCanBeEnteredLater) {
  GeneratedRails g;
  g.rails = 2;
  g.lengthM = 0.3;
  ASSERT_TRUE(generateRails(folder.url(), testing::recipe(), g));
  RecipeHistory recipes(archive);
  EXPECT_TRUE(recipes.names()->empty());
  const auto draft = recipes.addDraft(testing::recipe(), "Quinn", "from the line");
  ASSERT_TRUE(draft) << draft.error().message();
  EXPECT_EQ(draft->state, RecipeState::Draft);
  EXPECT_EQ(draft->version, 1);
}

TEST_F(HistoriesTest, CalibrationsAreKeptAndOneIsInForce) {
  CalibrationHistory calibrations(archive);
  RigCalibration a, b;
  a.id = "A";
  a.method = "joint";
  b.id = "B";
  const auto first = calibrations.add(a, "Tom", "new optics");
  ASSERT_TRUE(first) << first.error().message();
  const auto second = calibrations.add(b, "Tom", "yearly");
  EXPECT_EQ(*calibrations.add(a, "Tom", "again"), *first);
  EXPECT_TRUE(calibrations.uses()->empty());
  ASSERT_TRUE(calibrations.putInForce(*first, "Tom", "better"));
  ASSERT_TRUE(calibrations.putInForce(*second, "Tom", "due"));
  ASSERT_TRUE(calibrations.putInForce(*first, "Tom", "back: B drifts"));
  const auto uses = calibrations.uses();
  ASSERT_EQ(uses->size(), 3U);
  EXPECT_EQ(uses->front().id, "A");
  EXPECT_EQ(uses->front().reason, "back: B drifts");
  EXPECT_EQ(calibrations.all()->size(), 2U);
  const std::string file = folder.file("a.toml");
  std::ofstream(file) << *calibrations.text(*first);
  EXPECT_EQ(*calibrations.text(*first), toToml(a));
  EXPECT_FALSE(calibrations.putInForce(99, "Tom", "none"));
  EXPECT_EQ(AuditTrail(archive).entries()->size(), 5U);
}

TEST_F(HistoriesTest, AlarmsChangeTheirStateAndStayOne) {
  AlarmHistory alarms(archive);
  AlarmRecord a;
  a.rule = "rail out of tolerance";
  a.priority = 2;
  a.cause = "HW of rail 7 is 0.3 mm too wide";
  a.consequence = "rail is rejected";
  a.action = "look at the finishing stand";
  a.rail = "7";
  a.raisedUs = 1000;
  const auto uid = alarms.save(a);
  ASSERT_TRUE(uid) << uid.error().message();
  a.uid = *uid;
  a.acknowledgedUs = 2000;
  a.acknowledgedBy = "Olga";
  ASSERT_TRUE(alarms.save(a));
  AlarmRecord other;
  other.raisedUs = 3000;
  ASSERT_TRUE(alarms.save(other));
  auto all = alarms.alarms();
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ(all->at(1).acknowledgedBy, "Olga");
  EXPECT_EQ(all->at(1).cause, a.cause);
  ASSERT_TRUE(alarms.addStep({a.uid, 1000, "raised", "", "HW 72.9 mm at 12.3 m"}));
  ASSERT_TRUE(alarms.addStep({a.uid, 2000, "acknowledged", "Olga", ""}));
  ASSERT_EQ(alarms.steps(a.uid)->size(), 2U);
  EXPECT_EQ(alarms.steps(a.uid)->at(1).who, "Olga");
  a.clearedUs = 4000;
  ASSERT_TRUE(alarms.save(a));
  AlarmQuery active;
  active.activeOnly = true;
  EXPECT_EQ(alarms.alarms(active)->size(), 1U);
  AlarmQuery early;
  early.toUs = 3000;
  EXPECT_EQ(alarms.alarms(early)->front().uid, a.uid);
}

TEST_F(HistoriesTest, EventsAreListedNewestFirst) {
  AlarmHistory log(archive);
  ASSERT_TRUE(log.addEvent({10, "line", "armed", "Olga"}));
  ASSERT_TRUE(log.addEvent({20, "line", "stopped", ""}));
  const auto events = log.events();
  ASSERT_EQ(events->size(), 2U);
  EXPECT_EQ(events->front().text, "stopped");
  EXPECT_EQ(log.events(15)->size(), 1U);
}

}  // namespace
}  // namespace vignole
