// Rails for a server that is away for a while: measured as ever, they wait on disk and arrive in order, none twice.

#include "engine/archive/rail_delivery.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "engine/archive/rail_archive.h"
#include "engine/archive/rail_writer.h"
#include "engine/archive/verify_archive.h"
#include "engine/database/database.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

template <typename Condition>
bool becomesTrue(Condition condition) {
  for (int i = 0; i < 4000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

class RailDeliveryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::PostgresqlServer::wished()) GTEST_SKIP() << "needs PostgreSQL";
    server.emplace();
    url = server->url("mill");
  }
  RailWriterSettings settings(bool live = true) const {
    RailWriterSettings s;
    s.live = live;
    s.place = {"line 1", "test", "0.0", "none"};
    s.points.everyNthProfile = 20;
    s.queueProfiles = 16384;  // quicker than any line
    s.waitingFolder = folder.file("waiting");
    s.deliveryRetryS = 0.05;
    s.commitEveryS = 0.05;
    return s;
  }
  std::unique_ptr<RailWriter> writer(bool live = true) const {
    auto opened = RailWriter::open(url, settings(live));
    if (!opened) throw std::runtime_error(opened.error().message());
    return std::move(*opened);
  }
  void write(RailWriter& into, std::size_t rails) {
    for (std::size_t i = 0; i < rails; ++i) {
      into.begin(generator.begin(written++), {"2", "order 7", "night", "Ann"}, testing::setup());
      ProfileResult result;
      for (std::size_t p = 0; p < generator.profiles(); ++p) {
        generator.measure(p, result);
        testing::addPoints(result.profile);
        into.add(result);
      }
      into.end(generator.ledger(), {});
    }
  }
  static GeneratedRails small() {
    GeneratedRails g;
    g.lengthM = 1.5;
    g.failingShare = 0.5;
    return g;
  }
  /// All that were written, each once, in order, whole.
  void expectAll() const {
    const Archive archive = testing::openArchive(url, Archive::Missing::Refuse);
    RailQuery all;
    all.limit = 100000;
    const auto rails = RailArchive(archive).search(all);
    ASSERT_TRUE(rails) << rails.error().message();
    ASSERT_EQ(rails->size(), written);
    for (std::size_t i = 0; i < written; ++i) {
      const RailLine& line = (*rails)[written - 1 - i];
      EXPECT_EQ(line.id, "G" + std::to_string(100000 + i));
      EXPECT_EQ(RailArchive(archive).profiles(line.key)->size(), 100U);
      EXPECT_GE(RailArchive(archive).profilesWithPoints(line.key)->size(), 5U);
    }
    EXPECT_EQ(archive.database()->first("select count(*) from recipe", {}, "i")->integer(0), 1);
    EXPECT_EQ(archive.database()->first("select count(*) from calibration", {}, "i")->integer(0), 1);
    const auto check = verifyArchive(archive);
    ASSERT_TRUE(check);
    for (const ArchiveFinding& f : check->findings) ADD_FAILURE() << f.where << ": " << f.what;
  }

  testing::ArchiveFolder folder;
  std::optional<testing::PostgresqlServer> server;
  std::string url;
  RailGenerator generator{testing::recipe(), small()};
  std::size_t written = 0;
};

TEST_F(RailDeliveryTest, ARailThatHasPassedIsOnTheServerAtOnceAndLeavesTheFile) {
  const auto w = writer();
  write(*w, 3);
  EXPECT_TRUE(becomesTrue([&] { return w->status().railsStored == 3; })) << w->status().failure;
  EXPECT_TRUE(becomesTrue([&] { return w->status().railsWaiting == 0; }));
  expectAll();
  ASSERT_TRUE(w->close());
}

TEST_F(RailDeliveryTest, AServerThatIsAwayHoldsNobodyUpAndGetsEveryRailInOrderWhenItIsBack) {
  const auto w = writer();
  write(*w, 3);
  for (int outage = 0; outage < 3; ++outage) {
    write(*w, 2);  // some of these may be on their way when it stops
    server->stop();
    write(*w, 12);
    ASSERT_TRUE(becomesTrue([&] { return w->status().railsWaiting >= 12; }));
    ASSERT_TRUE(becomesTrue([&] { return !w->status().failure.empty(); }));
    EXPECT_EQ(w->status().profilesLost, 0U);
    server->start();
    ASSERT_TRUE(becomesTrue([&] { return w->status().railsWaiting == 0; })) << w->status().failure;
    EXPECT_TRUE(becomesTrue([&] { return w->status().failure.empty(); }));
  }
  ASSERT_TRUE(w->close());
  expectAll();
}

TEST_F(RailDeliveryTest, WhatStillWaitsWhenTheProgramEndsGoesWithTheNext) {
  {
    const auto w = writer();
    write(*w, 1);
    ASSERT_TRUE(becomesTrue([&] { return w->status().railsStored == 1; }));
    server->stop();
    write(*w, 4);
    const auto closed = w->close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().message().find("4 rails wait"), std::string::npos) << closed.error().message();
    EXPECT_EQ(closed.error().kind, ErrorKind::World);
  }
  {
    const auto w = writer();  // still away: a live line measures
    write(*w, 2);
    EXPECT_FALSE(w->close());
  }
  EXPECT_FALSE(RailWriter::open(url, settings(false)));  // off line there is no hurry
  server->start();
  ASSERT_TRUE(writer(false)->close());
  expectAll();
}

TEST_F(RailDeliveryTest, ARailThatTheServerHasAlreadyIsNotStoredTwice) {
  // The connection is lost after the server has it and before the file knows: it is in both.
  const std::string file = folder.file("waiting.db");
  {
    auto s = settings();
    const auto w = RailWriter::open(file, s);
    ASSERT_TRUE(w);
    write(**w, 2);
    ASSERT_TRUE((*w)->close());
  }
  std::filesystem::copy_file(file, folder.file("before.db"));
  const Archive there = testing::openArchive(url);
  for (const std::string& from : {file, folder.file("before.db")}) {
    const Archive waiting = testing::openArchive(from, Archive::Missing::Refuse);
    const bool isNew = from == file;
    for (const std::int64_t key : {1, 2}) EXPECT_EQ(deliverRail(*waiting.database(), *there.database(), key), isNew);
    EXPECT_EQ(*RailArchive(waiting).count(), 0U);
  }
  expectAll();
}

TEST_F(RailDeliveryTest, ADamagedRailArrivesAndIsTold) {
  const std::string file = folder.file("waiting.db");
  {
    const auto w = RailWriter::open(file, settings());
    ASSERT_TRUE(w);
    write(**w, 1);
    ASSERT_TRUE((*w)->close());
  }
  const Archive waiting = testing::openArchive(file), there = testing::openArchive(url);
  waiting.database()->run("update rail_dimension set mean_mm = mean_mm + 1 where dimension = 2");
  EXPECT_TRUE(deliverRail(*waiting.database(), *there.database(), 1));
  const auto check = verifyArchive(there);
  ASSERT_TRUE(check);
  EXPECT_EQ(check->findings.size(), 1U);
}

}  // namespace
}  // namespace vignole
