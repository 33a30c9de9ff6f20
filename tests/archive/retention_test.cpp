#include "engine/archive/retention.h"

#include <gtest/gtest.h>

#include "engine/archive/audit_trail.h"
#include "engine/archive/rail_archive.h"
#include "engine/archive/rail_rows.h"
#include "engine/archive/verify_archive.h"
#include "engine/database/database.h"
#include "engine/packing/point_pack.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

constexpr TimeUs kDayUs = 86'400'000'000;

/// A rail a day for twelve days, the seventh rejected, each with points of two of its profiles.
class RetentionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    GeneratedRails g;
    g.rails = 12;
    g.lengthM = 0.3;
    g.failingShare = 0;
    g.everyS = 86400;
    g.firstUs = first;
    const auto made = generateRails(url, testing::recipe(), g);
    ASSERT_TRUE(made) << made.error().message();
    archive.emplace(testing::openArchive(url));
    rails.emplace(*archive);
    archive->database()->run("update rail set verdict = :a where id = 7", {static_cast<std::int64_t>(Verdict::Fail)});
    for (std::int64_t key = 1; key <= 12; ++key)
      for (const std::int64_t profile : {0, 5})
        archive->database()->run("insert into profile_points (rail, profile, content) values (:a, :b, :c)",
                                 {key, profile, packed()});
    EXPECT_FALSE(verifyArchive(*archive)->findings.empty());  // the rows above came without a digest
    digestAll();
    ASSERT_TRUE(verifyArchive(*archive)->findings.empty());
  }
  static Bytes packed() {
    Profile profile;
    testing::addPoints(profile);
    return packPoints(profile, PointCoding::Compact);
  }
  void digestAll() {
    for (std::int64_t key = 1; key <= 12; ++key)
      archive->database()->run("update rail set digest = :a where id = :b",
                               {railDigest(*archive->database(), key), key});
  }
  std::vector<std::int64_t> keys() const {
    std::vector<std::int64_t> found;
    archive->database()->query("select id from rail order by id", {}, "i",
                               [&](const Row& row) { found.push_back(row.integer(0)); });
    return found;
  }
  const TimeUs first = 1'735'689'600'000'000, now = first + 30 * kDayUs;
  testing::ArchiveFolder folder;
  std::string url = folder.url();
  std::optional<Archive> archive;
  std::optional<RailArchive> rails;
};

TEST_F(RetentionTest, ShowsWhatWouldGoAndThatGoes) {
  RetentionPolicy policy;
  policy.keepDays = 22;  // rails 1 to 8
  const auto plan = planRetention(*archive, policy, now);
  ASSERT_TRUE(plan) << plan.error().message();
  EXPECT_EQ(plan->rails, 7U);
  EXPECT_EQ(plan->profiles, 140U);
  EXPECT_GT(plan->bytes, 7000U);
  EXPECT_EQ(plan->keptRejected, 1U);
  EXPECT_EQ(*plan->firstUs, first);
  EXPECT_EQ(*plan->lastUs, first + 7 * kDayUs);
  EXPECT_EQ(keys().size(), 12U);
  EXPECT_TRUE(AuditTrail(*archive).entries()->empty());

  EXPECT_FALSE(applyRetention(*archive, policy, now, "", "old"));
  EXPECT_FALSE(applyRetention(*archive, policy, now, "Ann", ""));
  EXPECT_EQ(keys().size(), 12U);
  const auto went = applyRetention(*archive, policy, now, "Ann", "old");
  ASSERT_TRUE(went) << went.error().message();
  EXPECT_EQ(went->rails, plan->rails);
  EXPECT_EQ(went->bytes, plan->bytes);
  EXPECT_EQ(keys(), (std::vector<std::int64_t>{7, 9, 10, 11, 12}));
  const auto entries = AuditTrail(*archive).entries();
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->front().user, "Ann");
  EXPECT_NE(entries->front().details.find("G100000 G100001"), std::string::npos) << entries->front().details;
  EXPECT_TRUE(verifyArchive(*archive)->findings.empty());
  EXPECT_EQ(archive->database()->first("select count(*) from profile_block where rail = 1", {}, "i")->integer(0), 0);
  EXPECT_EQ(planRetention(*archive, policy, now)->rails, 0U);
}

TEST_F(RetentionTest, RejectedRailsStayTheirOwnTimeAndHeldOnesForEver) {
  ASSERT_TRUE(rails->setHold(2, "complaint 4711", "Ann", "asked for"));
  ASSERT_TRUE(rails->addRecording(3, {"/srv/recordings/3", "digest", now}));
  archive->database()->run("update rail set state = 0 where id = 4");
  RetentionPolicy policy;
  policy.keepDays = 1;
  policy.keepRejectedDays = 1;
  const auto went = applyRetention(*archive, policy, now, "Ann", "old");
  ASSERT_TRUE(went) << went.error().message();
  EXPECT_EQ(keys(), (std::vector<std::int64_t>{2, 3, 4}));
  EXPECT_EQ(went->keptHeld, 1U);
  EXPECT_EQ(went->keptWithRecording, 1U);
  EXPECT_FALSE(rails->remove(2, "Ann", "old"));
  EXPECT_EQ(rails->hold(2)->value().why, "complaint 4711");
  ASSERT_TRUE(rails->setHold(2, "", "Ann", "settled"));
  EXPECT_FALSE(*rails->hold(2));
  EXPECT_TRUE(rails->remove(2, "Ann", "old"));
  EXPECT_EQ(rails->recordings(3)->front().place, "/srv/recordings/3");
}

TEST_F(RetentionTest, PointsOfRailsThatStayMayGoEarlierAndDamageStaysVisible) {
  ASSERT_TRUE(rails->setHold(2, "complaint 4711", "Ann", "asked for"));
  archive->database()->run("update rail_dimension set mean_mm = mean_mm + 1 where rail = 3 and dimension = 1");
  RetentionPolicy policy;
  policy.keepDays = 1000;
  policy.keepPointsDays = 22;
  const auto plan = planRetention(*archive, policy, now);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->rails, 0U);
  EXPECT_EQ(plan->profilesLosingPoints, 14U);
  const auto went = applyRetention(*archive, policy, now, "Ann", "old");
  ASSERT_TRUE(went) << went.error().message();
  EXPECT_EQ(went->profilesLosingPoints, 14U);
  EXPECT_EQ(rails->profilesWithPoints(2)->size(), 2U);
  EXPECT_TRUE(rails->profilesWithPoints(1)->empty());
  EXPECT_EQ(rails->profilesWithPoints(9)->size(), 2U);
  const auto check = verifyArchive(*archive);
  ASSERT_EQ(check->findings.size(), 1U);
  EXPECT_EQ(check->findings.front().where, "rail G100002 (3)");
}

}  // namespace
}  // namespace vignole
