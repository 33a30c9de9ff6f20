#include "engine/archive/audit_trail.h"

#include <gtest/gtest.h>

#include "engine/archive/verify_archive.h"
#include "engine/database/database.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

class AuditTrailTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int i = 1; i <= 6; ++i)
      ASSERT_TRUE(trail.add("Ann", "limit changed", "60E1 X/A", "reason " + std::to_string(i), "HW 0.5 -> 0.4"));
  }
  /// Somebody who may write into the file does this.
  void tamper(const std::string& sql) { archive.database()->run(sql); }
  std::vector<std::string> found() const { return *trail.verify(); }

  testing::ArchiveFolder folder;
  Archive archive = testing::openArchive(folder.url());
  AuditTrail trail{archive};
};

TEST_F(AuditTrailTest, IsReadNewestFirst) {
  EXPECT_TRUE(found().empty());
  AuditQuery query;
  query.limit = 2;
  auto entries = trail.entries(query);
  ASSERT_TRUE(entries);
  ASSERT_EQ(entries->size(), 2U);
  EXPECT_EQ(entries->front().number, 6);
  EXPECT_EQ(entries->front().reason, "reason 6");
  query.beforeNumber = 3;
  EXPECT_EQ(trail.entries(query)->front().number, 2);
  query = {};
  query.user = "Bob";
  EXPECT_TRUE(trail.entries(query)->empty());
}

TEST_F(AuditTrailTest, AnEntryNeedsWhoWhatAndWhy) {
  EXPECT_FALSE(trail.add("", "a", "b", "c"));
  EXPECT_FALSE(trail.add("Ann", "", "b", "c"));
  EXPECT_FALSE(trail.add("Ann", "a", "b", ""));
}

TEST_F(AuditTrailTest, ARemovedLineShows) {
  tamper("delete from audit where number = 3");
  EXPECT_FALSE(found().empty());
}

TEST_F(AuditTrailTest, TheFirstAndTheLastLineRemovedShow) {
  tamper("delete from audit where number = 1");
  EXPECT_FALSE(found().empty());
  tamper("delete from audit where number = 6");
  EXPECT_GE(found().size(), 2U);
}

TEST_F(AuditTrailTest, AllLinesRemovedShow) {
  tamper("delete from audit");
  EXPECT_FALSE(found().empty());
}

TEST_F(AuditTrailTest, EveryChangedFieldShows) {
  for (const char* change : {"time_us = time_us + 1", "by_user = 'Bob'", "action = 'x'", "subject = 'x'",
                             "reason = 'x'", "details = ''", "before = 'x'", "digest = 'x'", "number = 40"}) {
    const testing::ArchiveFolder other;
    const Archive copy = testing::openArchive(other.url());
    AuditTrail of(copy);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(of.add("Ann", "a", "b", "c", "d"));
    ASSERT_TRUE(of.verify()->empty());
    copy.database()->run("update audit set " + std::string(change) + " where number = 2");
    EXPECT_FALSE(of.verify()->empty()) << change;
  }
}

TEST_F(AuditTrailTest, AMovedFieldBorderShows) {
  tamper("update audit set by_user = 'An', action = 'nlimit changed' where number = 2");
  EXPECT_FALSE(found().empty());
}

TEST_F(AuditTrailTest, ATrailWrittenAnewContradictsTheRailsMeasuredSince) {
  GeneratedRails g;
  g.rails = 1;
  g.lengthM = 0.3;
  ASSERT_TRUE(generateRails(folder.url(), testing::recipe(), g));
  EXPECT_TRUE(found().empty());
  // The last entry taken out, and the head put back so that the chain itself is whole.
  tamper("delete from audit where number = 6");
  tamper("update audit_head set number = 5, digest = (select digest from audit where number = 5)");
  const auto wrong = found();
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_NE(wrong.front().find("G100000"), std::string::npos);
  EXPECT_FALSE(verifyArchive(archive)->findings.empty());
}

}  // namespace
}  // namespace vignole
