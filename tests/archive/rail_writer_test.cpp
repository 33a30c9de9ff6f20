#include "engine/archive/rail_writer.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "engine/archive/rail_archive.h"
#include "engine/database/database.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

using testing::ArchiveFolder;

RailWriterSettings settings() {
  RailWriterSettings s;
  s.live = false;
  s.place = {"line 1", "test", "0.0", "none"};
  return s;
}

std::unique_ptr<RailWriter> openWriter(const std::string& url, const RailWriterSettings& s = settings()) {
  auto writer = RailWriter::open(url, s);
  if (!writer) throw std::runtime_error(writer.error().message());
  return std::move(*writer);
}

/// Polls until it holds; false after ten seconds.
template <typename Condition>
bool becomesTrue(Condition condition) {
  for (int i = 0; i < 2000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

class RailWriterTest : public ::testing::Test {
 protected:
  /// Rails of 3 m at 15 mm: 200 profiles.
  GeneratedRails rails(double failingShare = 0) const {
    GeneratedRails g;
    g.lengthM = 3;
    g.failingShare = failingShare;
    return g;
  }
  void write(RailWriter& writer, RailGenerator& generator, std::size_t rail, RailSummariser* beside = nullptr) {
    const RailBegin begin = generator.begin(rail);
    writer.begin(begin, {"2", "order 7", "night", "Ann"}, testing::setup());
    for (std::size_t p = 0; p < generator.profiles(); ++p) {
      ProfileResult result;
      generator.measure(p, result);
      testing::addPoints(result.profile);
      writer.add(result);
      if (beside != nullptr) beside->add(result);
    }
    TriggerLedger ledger = generator.ledger();
    ledger.seen += 3;
    ledger.lost = 3;
    ledger.reasons["camera 3: frame lost"] = 3;
    writer.end(ledger, {{"extract.1", 200, 1.5, 0.1, 1.6, 2, 16, 3, 0, 300, 0}});
  }

  ArchiveFolder folder;
};

TEST_F(RailWriterTest, ARailComesBackAsItWasToldWhenItPassed) {
  RailGenerator generator(testing::recipe(), rails(1));
  RailSummariser beside(generator.begin(4), testing::recipe(), "test rig");
  {
    const auto writer = openWriter(folder.url());
    write(*writer, generator, 4, &beside);
    ASSERT_TRUE(writer->close());
    EXPECT_EQ(writer->status().railsStored, 1U);
    EXPECT_EQ(writer->status().profilesStored, 200U);
  }
  TriggerLedger ledger = generator.ledger();
  ledger.seen += 3;
  const RailSummary told = beside.summary(ledger);
  const Archive archive = testing::openArchive(folder.url(), Archive::Missing::Refuse);
  const RailArchive stored(archive);
  const auto found = stored.search({});
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_EQ(found->size(), 1U);
  EXPECT_EQ(found->front().id, "G100004");
  const auto rail = stored.open(found->front().key);
  ASSERT_TRUE(rail) << rail.error().message();
  EXPECT_EQ(rail->state, RailState::Finished);
  EXPECT_EQ(rail->papers.shift, "night");
  EXPECT_EQ(rail->papers.orderNumber, "order 7");
  const RailSummary& s = rail->summary;
  EXPECT_EQ(s.recipe, told.recipe);
  EXPECT_EQ(s.calibrationId, "test rig");
  EXPECT_EQ(s.verdict, told.verdict);
  EXPECT_EQ(s.lengthM, told.lengthM);
  EXPECT_EQ(s.profiles, 200U);
  EXPECT_EQ(s.triggers.reasons.at("camera 3: frame lost"), 3U);
  ASSERT_EQ(rail->stages.size(), 1U);
  EXPECT_EQ(rail->stages[0].name, "extract.1");
  EXPECT_EQ(s.verdict, Verdict::Fail);
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const DimensionSummary &a = told.dimensions[d], &b = s.dimensions[d];
    EXPECT_EQ(a.dimension, b.dimension);
    EXPECT_EQ(a.nominalMm, b.nominalMm);
    EXPECT_EQ(a.lowerMm, b.lowerMm);
    EXPECT_EQ(a.upperMm, b.upperMm);
    EXPECT_EQ(a.values.count(), b.values.count());
    EXPECT_EQ(a.values.mean(), b.values.mean());
    EXPECT_DOUBLE_EQ(a.values.sd(), b.values.sd());
    EXPECT_EQ(a.values.min(), b.values.min());
    EXPECT_EQ(a.values.max(), b.values.max());
    EXPECT_NEAR(a.meanMm(), b.meanMm(), 1e-9);
    EXPECT_NEAR(a.uOfMeanMm(), b.uOfMeanMm(), 1e-12);
    EXPECT_EQ(a.verdict, b.verdict);
    ASSERT_EQ(a.exceptions.size(), b.exceptions.size());
    for (std::size_t e = 0; e < a.exceptions.size(); ++e) {
      EXPECT_EQ(a.exceptions[e].fromM, b.exceptions[e].fromM);
      EXPECT_EQ(a.exceptions[e].toM, b.exceptions[e].toM);
      EXPECT_EQ(a.exceptions[e].worstMm, b.exceptions[e].worstMm);
    }
    ASSERT_EQ(a.track.size(), b.track.size());
    for (std::size_t t = 0; t < a.track.size(); ++t) {
      EXPECT_EQ(a.track[t].count, b.track[t].count);
      EXPECT_NEAR(a.track[t].meanMm, b.track[t].meanMm, 1e-6);
      EXPECT_NEAR(a.track[t].positionM, b.track[t].positionM, 1e-9);
    }
  }
  const auto text = stored.recipeText(*rail);
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, toToml(testing::recipe()));
  EXPECT_NE(stored.calibrationText(*rail)->find("test rig"), std::string::npos);
}

TEST_F(RailWriterTest, EveryProfileIsKeptToTheNanometre) {
  RailGenerator generator(testing::recipe(), rails());
  {
    const auto writer = openWriter(folder.url());
    write(*writer, generator, 1);
    ASSERT_TRUE(writer->close());
  }
  const Archive archive = testing::openArchive(folder.url());
  const auto profiles = RailArchive(archive).profiles(1);
  ASSERT_TRUE(profiles) << profiles.error().message();
  ASSERT_EQ(profiles->size(), 200U);
  (void)generator.begin(1);
  for (std::size_t p = 0; p < 200; ++p) {
    ProfileResult expected;
    generator.measure(p, expected);
    const ProfileRecord& is = (*profiles)[p];
    EXPECT_EQ(is.trigger, p);
    EXPECT_EQ(is.points, 40);
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      const DimensionResult &a = expected.measurement.dimensions[d], &b = is.dimensions[d];
      ASSERT_EQ(a.valueMm.has_value(), b.valueMm.has_value());
      if (!a.valueMm) continue;
      EXPECT_NEAR(*a.valueMm, *b.valueMm, 0.51e-6);
      EXPECT_NEAR(a.uMm, b.uMm, 0.51e-6);
      EXPECT_EQ(a.verdict, b.verdict);
      EXPECT_EQ(a.nominalMm, b.nominalMm);
      EXPECT_EQ(a.upperMm, b.upperMm);
    }
  }
  const auto some = RailArchive(archive).profiles(1, 190, 5);
  ASSERT_TRUE(some);
  ASSERT_EQ(some->size(), 5U);
  EXPECT_EQ(some->front().trigger, 190U);
}

TEST_F(RailWriterTest, PointsOfRejectedRailsAreAllKeptAndOfOthersOneInN) {
  for (const std::size_t memoryMb : {std::size_t{64}, std::size_t{0}}) {  // 0: what is undecided waits on disk
    const std::string file = folder.file("points" + std::to_string(memoryMb));
    RailWriterSettings s = settings();
    s.points.everyNthProfile = 50;
    s.pointsMemoryMb = memoryMb;
    s.commitEveryS = 0;
    {
      const auto writer = openWriter(file, s);
      RailGenerator good(testing::recipe(), rails(0)), bad(testing::recipe(), rails(1));
      write(*writer, good, 1);
      write(*writer, bad, 2);
      ASSERT_TRUE(writer->close());
    }
    const Archive archive = testing::openArchive(file);
    const RailArchive stored(archive);
    ASSERT_EQ(stored.open(2)->summary.verdict, Verdict::Fail);
    EXPECT_EQ(*stored.profilesWithPoints(1), (std::vector<std::uint64_t>{0, 50, 100, 150}));
    EXPECT_EQ(stored.profilesWithPoints(2)->size(), 200U);
    const auto points = stored.points(2, 17);
    ASSERT_TRUE(points);
    ASSERT_TRUE(*points);
    EXPECT_EQ((*points)->trigger, 17U);
    ASSERT_EQ((*points)->points.size(), 40U);
    EXPECT_NEAR((*points)->points[0].x, 50.017, 1e-5);
    EXPECT_FALSE(*stored.points(1, 17));
  }
}

TEST_F(RailWriterTest, WhatHasPassedIsSeenByOthersWhileTheRailRuns) {
  RailWriterSettings s = settings();
  s.commitEveryS = 0.05;
  const auto writer = openWriter(folder.file(), s);
  const Archive archive = testing::openArchive(folder.file());
  const RailArchive stored(archive);
  RailGenerator generator(testing::recipe(), rails());
  writer->begin(generator.begin(0), {}, testing::setup());
  ProfileResult result;
  for (std::size_t p = 0; p < 100; ++p) {
    generator.measure(p, result);
    writer->add(result);
  }
  EXPECT_TRUE(becomesTrue([&] {
    const auto found = stored.search({});
    return found && found->size() == 1 && found->front().profiles == 100;
  }));
  EXPECT_EQ(stored.search({})->front().state, RailState::Running);
  EXPECT_EQ(stored.profiles(1)->size(), 100U);
}

TEST_F(RailWriterTest, ARailWithoutEndIsInterruptedByTheNextAndByTheEnd) {
  {
    const auto writer = openWriter(folder.url());
    RailGenerator generator(testing::recipe(), rails());
    ProfileResult result;
    for (std::size_t rail = 0; rail < 2; ++rail) {
      writer->begin(generator.begin(rail), {}, testing::setup());
      for (std::size_t p = 0; p < 10; ++p) {
        generator.measure(p, result);
        writer->add(result);
      }
    }
    ASSERT_TRUE(writer->close());
  }
  const Archive archive = testing::openArchive(folder.url());
  const auto found = RailArchive(archive).search({});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2U);
  for (const RailLine& line : *found) {
    EXPECT_EQ(line.state, RailState::Interrupted);
    EXPECT_EQ(line.profiles, 10U);
  }
}

TEST_F(RailWriterTest, ASecondWriterIsRefused) {
  const auto writer = openWriter(folder.url());
  const auto second = RailWriter::open(folder.url(), settings());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, ErrorKind::World);
}

TEST_F(RailWriterTest, OnALiveLineNobodyWaitsAndWhatIsLostIsCounted) {
  RailWriterSettings s = settings();
  s.live = true;
  s.queueProfiles = 10;
  s.queueWithoutPoints = 50;
  s.points.everyNthProfile = 1;
  const auto writer = openWriter(folder.file(), s);
  const Archive archive = testing::openArchive(folder.file());
  RailGenerator generator(testing::recipe(), rails());
  const RailBegin begin = generator.begin(0);
  {
    const Transaction hold(*archive.database());  // the writer cannot store
    writer->begin(begin, {}, testing::setup());
    ASSERT_TRUE(becomesTrue([&] { return writer->status().queued == 0; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it is in its first store, or soon will be
    ProfileResult result;
    for (std::size_t p = 0; p < 200; ++p) {
      generator.measure(p, result);
      testing::addPoints(result.profile);
      writer->add(result);
    }
  }
  writer->end(generator.ledger(), {});
  ASSERT_TRUE(writer->close());
  const RailWriterStatus status = writer->status();
  EXPECT_GT(status.profilesLost, 0U);
  EXPECT_GE(status.pointsDropped, status.profilesLost);
  EXPECT_EQ(status.profilesStored + status.profilesLost, 200U);
  const auto rail = RailArchive(archive).open(1);
  ASSERT_TRUE(rail);
  EXPECT_EQ(rail->notStored, status.profilesLost);
  EXPECT_EQ(rail->summary.profiles, status.profilesStored);
}

TEST_F(RailWriterTest, AfterAFailureOfTheDiskALiveLineGoesOnWhereItWas) {
  RailWriterSettings s = settings();
  s.live = true;
  s.commitEveryS = 0.02;
  const auto writer = openWriter(folder.file(), s);
  const Archive archive = testing::openArchive(folder.file());
  RailGenerator generator(testing::recipe(), rails());
  writer->begin(generator.begin(0), {}, testing::setup());
  archive.database()->run("alter table profile_block rename to gone");
  ProfileResult result;
  for (std::size_t p = 0; p < 100; ++p) {
    generator.measure(p, result);
    writer->add(result);
  }
  ASSERT_TRUE(becomesTrue([&] { return !writer->status().failure.empty(); }));
  archive.database()->run("alter table gone rename to profile_block");
  for (std::size_t p = 100; p < 200; ++p) {
    generator.measure(p, result);
    writer->add(result);
  }
  writer->end(generator.ledger(), {});
  EXPECT_TRUE(becomesTrue([&] { return writer->status().railsStored == 1; }));
  EXPECT_TRUE(writer->status().failure.empty());
  ASSERT_TRUE(writer->close());
  EXPECT_EQ(RailArchive(archive).profiles(1)->size(), 200U);
}

TEST_F(RailWriterTest, OffLineAFailureIsToldAndNobodyWaitsForEver) {
  RailWriterSettings s = settings();
  s.queueProfiles = 10;
  const auto writer = openWriter(folder.file(), s);
  testing::openArchive(folder.file()).database()->run("drop table profile_block");
  RailGenerator generator(testing::recipe(), rails());
  write(*writer, generator, 0);
  write(*writer, generator, 1);
  EXPECT_FALSE(writer->close());
}

}  // namespace
}  // namespace vignole
