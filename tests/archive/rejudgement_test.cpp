#include "engine/archive/rejudgement.h"

#include <gtest/gtest.h>

#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

/// Forty rails of 1.5 m, some of them failing.
class RejudgementTest : public ::testing::Test {
 protected:
  testing::ArchiveFolder folder;
  std::optional<Archive> archive;
  std::vector<RailLine> rails;

  void SetUp() override {
    GeneratedRails g;
    g.rails = 40;
    g.lengthM = 1.5;
    g.failingShare = 0.4;
    ASSERT_TRUE(generateRails(folder.url(), testing::recipe(), g));
    archive.emplace(testing::openArchive(folder.url()));
    auto found = RailArchive(*archive).search({});
    ASSERT_TRUE(found);
    rails = std::move(*found);
  }
};

TEST_F(RejudgementTest, TheSameLimitsGiveTheSameVerdicts) {
  std::size_t failing = 0;
  for (const RailLine& rail : rails) {
    const auto again = rejudge(RailArchive(*archive), rail.key, testing::recipe().limits);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->before, rail.verdict);
    EXPECT_EQ(again->after, rail.verdict) << rail.id;
    EXPECT_EQ(again->dimensionsAfter, again->dimensionsBefore) << rail.id;
    failing += again->after == Verdict::Fail ? 1 : 0;
  }
  EXPECT_GT(failing, 5U);
  EXPECT_LT(failing, 35U);
}

TEST_F(RejudgementTest, WithoutLimitsNothingFailsAndWithNarrowOnesEverythingDoes) {
  PerDimension<ToleranceLimits> none{}, narrow{};
  // A web 15 mm thinner than nominal is no web.
  narrow[index(Dimension::WT)].upperMm = -15;
  for (const RailLine& rail : rails) {
    EXPECT_EQ(rejudge(RailArchive(*archive), rail.key, none)->after, Verdict::NoLimit);
    const auto failed = rejudge(RailArchive(*archive), rail.key, narrow);
    EXPECT_EQ(failed->after, Verdict::Fail);
    EXPECT_EQ(failed->dimensionsAfter[index(Dimension::WT)], Verdict::Fail);
    EXPECT_EQ(failed->dimensionsAfter[index(Dimension::RH)], Verdict::NoLimit);
  }
}

TEST_F(RejudgementTest, ARailThatIsNotThereIsAnError) {
  EXPECT_FALSE(rejudge(RailArchive(*archive), 987654, testing::recipe().limits));
}

}  // namespace
}  // namespace vignole
