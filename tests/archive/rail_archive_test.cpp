#include "engine/archive/rail_archive.h"

#include <gtest/gtest.h>

#include "engine/archive/audit_trail.h"
#include "engine/archive/verify_archive.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

/// Sixty rails of 1.5 m, some failing, made once for all tests that only read.
class RailArchiveTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new testing::ArchiveFolder;
    GeneratedRails g;
    g.rails = 60;
    g.lengthM = 1.5;
    g.failingShare = 0.3;
    g.railsPerHeat = 20;
    const auto made = generateRails(folder->url(), testing::recipe(), g);
    ASSERT_TRUE(made) << made.error().message();
    archive = new Archive(testing::openArchive(folder->url()));
  }
  static void TearDownTestSuite() {
    delete archive;
    delete folder;
    archive = nullptr;
    folder = nullptr;
  }
  static std::vector<RailLine> search(const RailQuery& query) {
    auto found = RailArchive(*archive).search(query);
    if (!found) throw std::runtime_error(found.error().message());
    return *found;
  }
  static testing::ArchiveFolder* folder;
  static Archive* archive;
};
testing::ArchiveFolder* RailArchiveTest::folder = nullptr;
Archive* RailArchiveTest::archive = nullptr;

TEST_F(RailArchiveTest, ListsTheNewestFirstPageByPage) {
  RailQuery query;
  query.limit = 25;
  std::vector<std::string> ids;
  for (auto page = search(query); !page.empty(); page = search(query)) {
    for (const RailLine& line : page) ids.push_back(line.id);
    query.beforeKey = page.back().key;
  }
  ASSERT_EQ(ids.size(), 60U);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(ids[i], "G" + std::to_string(100059 - i));
  EXPECT_EQ(*RailArchive(*archive).count(), 60U);
}

TEST_F(RailArchiveTest, FindsByIdHeatSectionRecipeAndTime) {
  RailQuery query;
  query.railId = "G10001";
  EXPECT_EQ(search(query).size(), 10U);
  query = {};
  query.heat = "H5001";
  EXPECT_EQ(search(query).size(), 20U);
  query.section = "60E1";
  query.recipe = "60E1 X/A v1";
  EXPECT_EQ(search(query).size(), 20U);
  query.section = "54E1";
  EXPECT_TRUE(search(query).empty());
  query = {};
  const GeneratedRails g;
  query.fromUs = g.firstUs + 10 * 90'000'000LL;
  query.toUs = g.firstUs + 15 * 90'000'000LL;
  const auto found = search(query);
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found.back().id, "G100010");
}

TEST_F(RailArchiveTest, FindsByVerdictAndByWhatOneDimensionDid) {
  RailQuery failed;
  failed.verdicts = {Verdict::Fail};
  const auto bad = search(failed);
  ASSERT_GT(bad.size(), 5U);
  ASSERT_LT(bad.size(), 40U);
  std::size_t byDimension = 0;
  for (const Dimension d : kDimensions) {
    RailQuery query;
    query.dimensions = {{d, 0.05, {}}};
    for (const RailLine& line : search(query)) {
      const auto rail = RailArchive(*archive).open(line.key);
      ASSERT_TRUE(rail);
      const DimensionSummary& s = rail->summary.dimensions[index(d)];
      ASSERT_TRUE(rail->excessMm[index(d)]);
      EXPECT_GT(*rail->excessMm[index(d)], 0.05);
      const bool beyond = (s.upperMm && s.values.max() > *s.upperMm + 0.05) ||
                          (s.lowerMm && s.values.min() - (d == Dimension::HF ? 0.011 : 0) < *s.lowerMm - 0.05);
      EXPECT_TRUE(beyond) << name(d) << " of " << line.id;
      EXPECT_EQ(line.worst, d);
      ++byDimension;
    }
    query.dimensions = {{d, {}, Verdict::Fail}};
    for (const RailLine& line : search(query)) EXPECT_EQ(line.verdict, Verdict::Fail);
  }
  EXPECT_GT(byDimension, 5U);
}

TEST_F(RailArchiveTest, WhatIsAskedForIsNeverReadAsSql) {
  RailQuery query;
  query.heat = "' or 1 = 1 --";
  EXPECT_TRUE(search(query).empty());
  query = {};
  query.section = "60E1'; drop table rail; --";
  EXPECT_TRUE(search(query).empty());
  EXPECT_EQ(*RailArchive(*archive).count(), 60U);
}

TEST_F(RailArchiveTest, WhatIsNotThereIsAnError) {
  EXPECT_FALSE(RailArchive(*archive).open(999));
  EXPECT_TRUE(RailArchive(*archive).profiles(999)->empty());
  EXPECT_FALSE(*RailArchive(*archive).points(999, 0));
}

TEST_F(RailArchiveTest, IsWholeAndSaysSo) {
  const auto check = verifyArchive(*archive);
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->findings.empty()) << check->findings.front().where << ": " << check->findings.front().what;
  EXPECT_EQ(check->rails, 60U);
  EXPECT_EQ(check->profiles, 6000U);
}

TEST(RailArchiveRemoval, NeedsAReasonAndIsAudited) {
  const testing::ArchiveFolder folder;
  GeneratedRails g;
  g.rails = 3;
  g.lengthM = 0.3;
  ASSERT_TRUE(generateRails(folder.url(), testing::recipe(), g));
  const Archive archive = testing::openArchive(folder.url());
  RailArchive rails(archive);
  EXPECT_FALSE(rails.remove(2, "Eve", ""));
  EXPECT_EQ(*rails.count(), 3U);
  ASSERT_TRUE(rails.remove(2, "Eve", "a test piece"));
  EXPECT_EQ(*rails.count(), 2U);
  EXPECT_TRUE(rails.profiles(2)->empty());
  const auto entries = AuditTrail(archive).entries();
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->front().subject, "G100001");
  EXPECT_TRUE(verifyArchive(archive)->findings.empty());
}

}  // namespace
}  // namespace vignole
