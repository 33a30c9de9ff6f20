// A writer that is killed at any moment loses at most the last second of the running rail, and never the archive.

#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "engine/archive/rail_archive.h"
#include "engine/archive/rail_writer.h"
#include "engine/archive/verify_archive.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::duration;

struct Handed {
  std::uint64_t rail = 0, profile = 0;  ///< the last that was handed to the writer
  double atS = 0;
};

double nowS() { return duration<double>(Clock::now().time_since_epoch()).count(); }

/// The child: rails of 200 profiles at about 200 Hz for ever, telling what it has handed over and when.
[[noreturn]] void measureForEver(const std::string& file, int told) {
  RailWriterSettings settings;
  settings.place.line = "line 1";
  settings.points.everyNthProfile = 10;
  settings.commitEveryS = 0.1;  // several blocks a rail
  auto writer = RailWriter::open(file, settings);
  if (!writer) _exit(1);
  GeneratedRails rails;
  rails.lengthM = 3;
  rails.failingShare = 0.3;
  RailGenerator generator(testing::recipe(), rails);
  const auto setup = testing::setup();
  for (std::uint64_t rail = 0;; ++rail) {
    (*writer)->begin(generator.begin(rail), {}, setup);
    for (std::uint64_t p = 0; p < generator.profiles(); ++p) {
      ProfileResult result;
      generator.measure(p, result);
      testing::addPoints(result.profile);
      (*writer)->add(result);
      const Handed handed{rail, p, nowS()};
      if (::write(told, &handed, sizeof handed) != sizeof handed) _exit(2);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    (*writer)->end(generator.ledger(), {});
  }
}

TEST(KilledWriter, LosesAtMostTheLastSecondAndNeverTheArchive) {
  const testing::ArchiveFolder folder;
  const char* wished = std::getenv("VIGNOLE_KILLS");
  const int kills = wished != nullptr ? std::atoi(wished) : 4;
  std::mt19937 random(std::random_device{}());
  std::uint64_t expectedRails = 0;
  for (int i = 0; i < kills; ++i) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(ends[0]);
      measureForEver(folder.file(), ends[1]);
    }
    ::close(ends[1]);
    std::vector<Handed> handed;
    // The last long enough for a second to be lost before it.
    const double killAfterS = i + 1 == kills ? 2 : std::uniform_real_distribution<double>(0.1, 1.2)(random);
    std::thread killer([&] {
      std::this_thread::sleep_for(duration<double>(killAfterS));
      ::kill(child, SIGKILL);
    });
    for (Handed h; ::read(ends[0], &h, sizeof h) == sizeof h;) handed.push_back(h);
    killer.join();
    const double killedS = nowS();
    ::close(ends[0]);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "exit " << status;

    if (handed.empty() && i == 0) continue;  // killed before there was an archive
    const Archive archive = testing::openArchive(folder.file());
    const auto check = verifyArchive(archive);
    ASSERT_TRUE(check) << check.error().message();
    for (const ArchiveFinding& f : check->findings) ADD_FAILURE() << f.where << ": " << f.what;
    RailQuery all;
    all.limit = 1000000;
    const auto rails = RailArchive(archive).search(all);
    ASSERT_TRUE(rails) << rails.error().message();
    // What was handed over more than a second before is there; of earlier runs, all that was there then.
    ASSERT_GE(rails->size(), expectedRails);
    std::uint64_t profilesNow = 0, due = 0;
    for (std::size_t r = 0; r + expectedRails < rails->size(); ++r) profilesNow += (*rails)[r].profiles;
    for (const Handed& h : handed) due += h.atS < killedS - 1 ? 1 : 0;
    EXPECT_GE(profilesNow, due);
    for (const RailLine& line : *rails) EXPECT_EQ(RailArchive(archive).profiles(line.key)->size(), line.profiles);
    expectedRails = rails->size();
  }
  // Who opens it next to write puts the last one in order.
  RailWriterSettings settings;
  settings.place.line = "line 1";
  ASSERT_TRUE(RailWriter::open(folder.file(), settings));
  const Archive archive = testing::openArchive(folder.file());
  RailQuery running;
  running.state = RailState::Running;
  EXPECT_TRUE(RailArchive(archive).search(running)->empty());
  const auto check = verifyArchive(archive);
  ASSERT_TRUE(check);
  for (const ArchiveFinding& f : check->findings) ADD_FAILURE() << f.where << ": " << f.what;
}

}  // namespace
}  // namespace vignole
