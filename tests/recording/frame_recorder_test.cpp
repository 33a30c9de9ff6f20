// Recording while measuring: who measures never waits, and every trigger that is not recorded is counted.

#include "engine/recording/frame_recorder.h"

#include <condition_variable>
#include <csignal>
#include <fstream>
#include <set>
#include <sys/wait.h>
#include <thread>

#include "engine/recording/recording_files.h"
#include "tests/recording/recorded_rail.h"

namespace vignole {
namespace {

using namespace vignole::testing;

RecordingOrder orderOf(const std::filesystem::path& path, const VirtualRig& rig) {
  RecordingOrder order;
  order.path = path;
  order.setup = setupOf(rig);
  return order;
}

/// Frames that are in memory already, again and again.
struct Pictures {
  std::shared_ptr<const VirtualRig> rig = makeRig();
  std::array<std::vector<std::uint8_t>, kCameraCount> pixels;
  Pictures() {
    for (int c = 0; c < kCameraCount; ++c) {
      auto& p = pixels[static_cast<std::size_t>(c)];
      p.resize(1400 * 1024);
      rig->render(c, 3, {p.data(), 1400, 1024, 1400});
    }
  }
  [[nodiscard]] Frame frame(int camera, std::uint64_t trigger, std::shared_ptr<const void> lease = nullptr) const {
    return {camera, trigger, {pixels[static_cast<std::size_t>(camera)].data(), 1400, 1024, 1400}, std::move(lease)};
  }
};
const Pictures& pictures() {
  static const Pictures one;
  return one;
}

TEST(FrameRecorder, ThroughTheQueueOfALiveLineWhatDoesNotFitIsDroppedAndCounted) {
  const RecordingFolder folder;
  FrameRecorder recorder({.live = true, .framesHeld = 2});
  ASSERT_TRUE(recorder.start(orderOf(folder.file("a.vgr"), *pictures().rig)));
  constexpr std::uint64_t kTriggers = 200;
  const StripeResult none;
  RailBegin rail;
  rail.id = "R";
  for (int c = 0; c < kCameraCount; ++c) recorder.sourceGave(c, rail);
  std::weak_ptr<const void> oneLease;
  for (std::uint64_t t = 0; t < kTriggers; ++t)
    for (int c = 0; c < kCameraCount; ++c) {
      const auto lease = std::make_shared<int>(0);
      if (t == kTriggers - 1 && c == 0) oneLease = lease;
      const Frame frame = pictures().frame(c, t, lease);
      recorder.sourceGave(c, frame);
      recorder.extracted(frame, none);  // never waits: faster than any packing
    }
  for (int c = 0; c < kCameraCount; ++c) recorder.sourceGave(c, RailEnd{kTriggers});
  ASSERT_TRUE(recorder.stop());
  EXPECT_TRUE(oneLease.expired());
  const RecorderState state = recorder.state();
  EXPECT_GT(state.dropped, 0U);
  EXPECT_LT(state.dropped, kTriggers);
  EXPECT_FALSE(state.recording);
  const auto recording = opened(folder.file("a.vgr"));
  EXPECT_EQ(recording->dropped().size(), state.dropped);
  ASSERT_EQ(recording->rails().size(), 1U);
  EXPECT_EQ(recording->rails()[0].dropped, state.dropped);
  // Of every trigger either four frames or nothing.
  EXPECT_EQ(recording->rails()[0].triggers + state.dropped, kTriggers);
  EXPECT_EQ(recording->rails()[0].frames, 4 * recording->rails()[0].triggers);
  const RunResult again = replay(folder.file("a.vgr"));
  EXPECT_EQ(again.triggers.seen, kTriggers);
  EXPECT_EQ(again.triggers.measured, kTriggers - state.dropped);
  EXPECT_EQ(again.triggers.lost, state.dropped);
  EXPECT_EQ(again.triggers.reasons.at("camera 1: not recorded"), state.dropped);
}

TEST(FrameRecorder, WhatThePipelineDroppedIsRecordedAsLostThere) {
  const RecordingFolder folder;
  FrameRecorder recorder({.live = false});
  ASSERT_TRUE(recorder.start(orderOf(folder.file("a.vgr"), *pictures().rig)));
  RailBegin rail;
  rail.id = "R";
  for (int c = 0; c < kCameraCount; ++c) {
    recorder.sourceGave(c, rail);
    for (std::uint64_t t = 0; t < 4; ++t) {
      recorder.sourceGave(c, pictures().frame(c, t));
      if (c != 1 || t != 2) recorder.extracted(pictures().frame(c, t), {});
    }
    recorder.sourceGave(c, RailEnd{4});
  }
  ASSERT_TRUE(recorder.stop());
  const RunResult again = replay(folder.file("a.vgr"));
  EXPECT_EQ(again.triggers.reasons, (std::map<std::string, std::uint64_t>{{"camera 2: queue overflow", 1}}));
}

TEST(FrameRecorder, StartsAndStopsInTheMiddleOfARail) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  const auto recorder = std::make_shared<FrameRecorder>(FrameRecorderSettings{.live = false});
  auto source = tapped(makeVirtualSource(rig, {1, 15.0 * 240, false}), recorder);
  std::uint64_t n = 0;
  const RunResult live = run(*source, recipe60(), rig->calibration(), recorder, [&](const ProfileResult&) {
    if (++n == 10) {
      EXPECT_TRUE(recorder->start(orderOf(folder.file("part.vgr"), *rig)));
      EXPECT_FALSE(recorder->start(orderOf(folder.file("other.vgr"), *rig))) << "one at a time";
    }
    if (n == 220) {
      EXPECT_TRUE(recorder->stop());
    }
  });
  EXPECT_EQ(live.profiles.size(), 240U);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"part.vgr"});
  const auto recording = opened(folder.file("part.vgr"));
  ASSERT_EQ(recording->rails().size(), 1U);
  const RecordedRail& rail = recording->rails()[0];
  EXPECT_GE(rail.begin.rail.firstTrigger, 10U);
  EXPECT_EQ(rail.begin.rail.beginsAtMm, 15.0 * static_cast<double>(rail.begin.rail.firstTrigger));
  EXPECT_GT(rail.triggers, 20U);
  // The same profiles at the same places of the rail as the run gave.
  const RunResult again = replay(folder.file("part.vgr"));
  // Cameras are at most 64 triggers and what the queues hold apart.
  ASSERT_GT(again.profiles.size(), 60U);
  const std::set<std::string> all(live.profiles.begin(), live.profiles.end());
  for (const std::string& profile : again.profiles) EXPECT_TRUE(all.contains(profile)) << profile;
}

TEST(FrameRecorder, RailsAreKeptOrDroppedByTheirVerdict) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  const auto recorder = std::make_shared<FrameRecorder>(FrameRecorderSettings{.live = false});
  RecordingOrder order = orderOf(folder.path(), *rig);
  order.keep = {.all = false, .rejected = true, .everyNth = 4};
  ASSERT_TRUE(recorder->start(std::move(order)));
  auto source = tapped(makeVirtualSource(rig, {6, 15.0 * 3, false}), recorder);
  int rail = 0;
  run(*source, recipe60(), rig->calibration(), recorder, {}, [&](const RailBegin& begin) {
    ++rail;  // the 1st and the 5th are one in four, the 3rd is rejected
    recorder->railPassed(begin, rail == 3 ? Verdict::Fail : Verdict::Pass);
  });
  ASSERT_TRUE(recorder->stop());
  EXPECT_EQ(recorder->state().filesKept, 3U);
  EXPECT_EQ(recorder->state().filesDiscarded, 3U);
  const auto names = folder.names();
  ASSERT_EQ(names.size(), 3U);
  EXPECT_TRUE(names[0].starts_with("V5-1-"));
  EXPECT_TRUE(names[1].starts_with("V5-3-"));
  EXPECT_TRUE(names[2].starts_with("V5-5-"));
  for (const std::string& name : names) {
    const auto recording = opened(folder.file(name));
    EXPECT_TRUE(recording->closed());
    EXPECT_EQ(recording->frames(), 12U);
    EXPECT_EQ(replay(folder.file(name)).triggers.measured, 3U);
  }
}

TEST(FrameRecorder, KeptOnDemandWhateverTheVerdict) {
  const RecordingFolder folder;
  FrameRecorder recorder({.live = false});
  RecordingOrder order = orderOf(folder.path(), *pictures().rig);
  order.keep = {.all = false};
  ASSERT_TRUE(recorder.start(std::move(order)));
  for (std::uint64_t r = 0; r < 2; ++r) {
    RailBegin rail;
    rail.id = "../R " + std::to_string(r);
    rail.firstTrigger = r;
    for (int c = 0; c < kCameraCount; ++c) {
      recorder.sourceGave(c, rail);
      recorder.sourceGave(c, pictures().frame(c, r));
      recorder.extracted(pictures().frame(c, r), {});
      recorder.sourceGave(c, RailEnd{r + 1});
    }
    if (r == 1) recorder.keepThisRail();
    recorder.railPassed(rail, Verdict::Pass);
  }
  ASSERT_TRUE(recorder.stop());
  const auto names = folder.names();
  ASSERT_EQ(names.size(), 1U);
  EXPECT_TRUE(names[0].starts_with("___R_1-")) << names[0];
}

TEST(FrameRecorder, AFileThatHasGrownLargeGoesOnInANextOne) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  const auto recorder = std::make_shared<FrameRecorder>(FrameRecorderSettings{.live = false});
  RecordingOrder order = orderOf(folder.file("rail.vgr"), *rig);
  order.mostMbOfFile = 2;
  ASSERT_TRUE(recorder->start(std::move(order)));
  auto source = tapped(makeVirtualSource(rig, {1, 15.0 * 60, false}), recorder);
  const RunResult live = run(*source, recipe60(), rig->calibration(), recorder);
  ASSERT_TRUE(recorder->stop());
  const auto names = folder.names();
  ASSERT_GE(names.size(), 3U);
  std::set<std::string> profiles;
  for (const std::string& name : names) {
    // And what the cameras behind the foremost still had to give.
    EXPECT_LT(std::filesystem::file_size(folder.file(name)), 5'500'000U);
    for (const std::string& profile : replay(folder.file(name)).profiles)
      EXPECT_TRUE(profiles.insert(profile).second) << name;
  }
  EXPECT_EQ(profiles, std::set<std::string>(live.profiles.begin(), live.profiles.end()));
}

TEST(FrameRecorder, TheOldestRecordingsOfAFolderMakeRoom) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  record(folder.file("a.vgr"), rig, 1, 5);
  std::ofstream(folder.file("notes.vgr")) << std::string(3'000'000, 'x');
  for (const char* name : {"b.vgr", "c.vgr"}) std::filesystem::copy_file(folder.file("a.vgr"), folder.file(name));
  const auto now = std::filesystem::file_time_type::clock::now();
  std::filesystem::last_write_time(folder.file("b.vgr"), now - std::chrono::hours(2));
  std::filesystem::last_write_time(folder.file("a.vgr"), now - std::chrono::hours(1));
  pruneRecordings(folder.path(), 3, folder.file("c.vgr"));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.vgr", "c.vgr", "notes.vgr"})) << "what is no recording stays";
  pruneRecordings(folder.path(), 0, folder.file("c.vgr"));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"c.vgr", "notes.vgr"}));
}

TEST(FrameRecorder, WhatCannotBeWrittenIsSaidAtOnce) {
  const RecordingFolder folder;
  FrameRecorder recorder;
  EXPECT_FALSE(recorder.start(orderOf(folder.file("none/a.vgr"), *pictures().rig)));
  EXPECT_FALSE(recorder.start(orderOf("/dev/null", *pictures().rig)));
  RecordingOrder order = orderOf(folder.file("a.vgr"), *pictures().rig);
  order.keep = {.all = false, .rejected = true};
  EXPECT_FALSE(recorder.start(std::move(order)));
  EXPECT_TRUE(folder.names().empty());
  EXPECT_TRUE(recorder.stop());
}

TEST(FrameRecorder, AnEarlierRecordingStaysUntilTheNewOneIsClosed) {
  const RecordingFolder folder;
  std::ofstream(folder.file("a.vgr")) << "earlier";
  std::ofstream(folder.file("a.vgr.part")) << "left by somebody";
  FrameRecorder recorder;
  ASSERT_TRUE(recorder.start(orderOf(folder.file("a.vgr"), *pictures().rig)));
  EXPECT_EQ(std::filesystem::file_size(folder.file("a.vgr")), 7U);
  ASSERT_TRUE(recorder.stop());
  EXPECT_GT(std::filesystem::file_size(folder.file("a.vgr")), 1000U);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.vgr", "a.vgr.part"}));
}

TEST(FrameRecorder, AKilledProcessLeavesAllThatItHadWritten) {
  const RecordingFolder folder;
  (void)pictures();
  for (int kill = 0; kill < 3; ++kill) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(ends[0]);
      FrameRecorder recorder({.live = false});
      if (!recorder.start(orderOf(folder.file("killed.vgr"), *pictures().rig))) _exit(1);
      RailBegin rail;
      rail.id = "R";
      for (int c = 0; c < kCameraCount; ++c) recorder.sourceGave(c, rail);
      for (std::uint64_t t = 0;; ++t) {
        for (int c = 0; c < kCameraCount; ++c) {
          recorder.sourceGave(c, pictures().frame(c, t));
          recorder.extracted(pictures().frame(c, t), {});
        }
        const std::uint64_t written = recorder.state().frames;
        if (::write(ends[1], &written, sizeof written) != sizeof written) _exit(2);
      }
    }
    ::close(ends[1]);
    std::uint64_t written = 0;
    for (std::uint64_t n = 0; n < 40 + 37U * static_cast<unsigned>(kill);)
      if (::read(ends[0], &n, sizeof n) == sizeof n)
        written = n;
      else
        break;
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "exit " << status;
    ::close(ends[0]);
    const auto part = folder.file(kill == 0 ? "killed.vgr.part" : "killed.vgr.part" + std::to_string(kill + 1));
    const auto recording = opened(part);
    ASSERT_TRUE(recording);
    EXPECT_FALSE(recording->closed());
    EXPECT_TRUE(recording->setup());
    EXPECT_GE(recording->frames(), written);
    const RunResult again = replay(part);
    EXPECT_GE(again.triggers.measured + 1, written / 4);
  }
}

}  // namespace
}  // namespace vignole
