#include "engine/synchronisation/trigger_line.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace vignole {
namespace {

/// What a stream was told, in words: "begin 5", "frame 5", "lost 6 missed trigger", "end 9", "over".
std::vector<std::string> told(TriggerLine& line, int camera) {
  std::vector<std::string> words;
  while (auto message = line.take(camera)) {
    if (const auto* f = std::get_if<Frame>(&*message)) {
      EXPECT_EQ(f->camera, camera);
      words.push_back("frame " + std::to_string(f->trigger));
    } else if (const auto* l = std::get_if<FrameLost>(&*message)) {
      EXPECT_EQ(l->camera, camera);
      words.push_back("lost " + std::to_string(l->trigger) + " " + l->reason);
    } else if (const auto* b = std::get_if<RailBegin>(&*message)) {
      words.push_back("begin " + std::to_string(b->firstTrigger));
    } else if (const auto* e = std::get_if<RailEnd>(&*message)) {
      words.push_back("end " + std::to_string(e->endTrigger));
    } else {
      words.emplace_back("over");
    }
  }
  return words;
}

using Words = std::vector<std::string>;

class ALine {
 public:
  explicit ALine(TriggerLineSettings settings = {}) : line(settings) {}
  void frame(int camera, std::uint64_t trigger, bool rail = true) {
    Frame f;
    f.camera = camera;
    f.trigger = trigger;
    f.lease = std::make_shared<int>(0);
    line.add(std::move(f), rail, static_cast<double>(trigger) * 0.02);
  }
  void all(std::uint64_t from, std::uint64_t to, bool rail, const std::set<int>& without = {}) {
    for (std::uint64_t t = from; t < to; ++t)
      for (int c = 0; c < 4; ++c)
        if (!without.contains(c)) frame(c, t, rail);
  }
  TriggerLine line;
};

TriggerLineSettings quick() {
  TriggerLineSettings s;
  s.beginAfter = 2;
  s.endAfter = 2;
  s.giveUpAfter = 10;
  return s;
}

TEST(TriggerLine, ARailBeginsBeforeItsFirstFrameAndEndsAfterItsLastInEveryStream) {
  ALine a(quick());
  a.all(0, 3, false);
  a.all(3, 7, true);
  a.all(7, 10, false);
  for (int c = 0; c < 4; ++c)
    EXPECT_EQ(told(a.line, c), (Words{"begin 3", "frame 3", "frame 4", "frame 5", "frame 6", "end 7"}));
  EXPECT_EQ(a.line.counts().inRails, 4u);
  EXPECT_EQ(a.line.counts().outsideRails, 6u);
  EXPECT_EQ(a.line.counts().rails, 1u);
}

TEST(TriggerLine, OneCameraThatSeesItIsEnough) {
  ALine a(quick());
  for (std::uint64_t t = 0; t < 4; ++t)
    for (int c = 0; c < 4; ++c) a.frame(c, t, c == 2);
  EXPECT_EQ(told(a.line, 0).front(), "begin 0");
}

TEST(TriggerLine, LightInASingleTriggerIsNoRailAndAGapInARailDoesNotEndIt) {
  ALine a(quick());
  a.all(0, 2, false);
  a.all(2, 3, true);
  a.all(3, 5, false);
  EXPECT_TRUE(told(a.line, 0).empty());
  a.all(5, 8, true);
  a.all(8, 9, false);
  a.all(9, 10, true);
  EXPECT_EQ(told(a.line, 0), (Words{"begin 5", "frame 5", "frame 6", "frame 7", "frame 8", "frame 9"}));
}

TEST(TriggerLine, AFrameThatOneCameraLacksIsALossThereOnly) {
  ALine a(quick());
  a.all(0, 2, true);
  for (int c = 0; c < 4; ++c)
    if (c != 1) a.frame(c, 2);
  EXPECT_EQ(told(a.line, 0), (Words{"begin 0", "frame 0", "frame 1"})) << "camera 2 may still bring it";
  a.line.lose(1, 3, 1, "missed trigger");
  a.all(3, 4, true);
  EXPECT_EQ(told(a.line, 0), (Words{"frame 2", "frame 3"}));
  EXPECT_EQ(told(a.line, 1), (Words{"begin 0", "frame 0", "frame 1", "lost 2 missed trigger", "frame 3"}));
}

TEST(TriggerLine, ACameraThatIsDownIsNotWaitedForAndIsWaitedForWhenItIsBack) {
  ALine a(quick());
  a.all(0, 3, true);
  a.all(3, 6, true, {2});
  EXPECT_EQ(told(a.line, 0).back(), "frame 2");
  a.line.setDown(2, "camera lost");
  EXPECT_EQ(told(a.line, 0), (Words{"frame 3", "frame 4", "frame 5"}));
  told(a.line, 2);
  a.all(6, 8, true, {2});
  EXPECT_EQ(told(a.line, 2), (Words{"lost 6 camera lost", "lost 7 camera lost"}));
  a.line.setUp(2);
  a.all(8, 10, true, {2});
  told(a.line, 0);
  a.frame(2, 10);
  EXPECT_EQ(told(a.line, 2), (Words{"lost 8 camera lost", "lost 9 camera lost"}));
  for (int c = 0; c < 4; ++c)
    if (c != 2) a.frame(c, 10);
  for (int c = 0; c < 4; ++c)
    if (c != 2) a.frame(c, 11);
  EXPECT_EQ(told(a.line, 0), (Words{"frame 10"})) << "trigger 11 waits for camera 3 again";
  a.frame(2, 11);
  EXPECT_EQ(told(a.line, 2), (Words{"frame 10", "frame 11"}));
}

TEST(TriggerLine, ACameraTooFarBehindIsGivenUpForThoseTriggers) {
  ALine a(quick());
  a.all(0, 2, true);
  a.all(2, 14, true, {3});
  const Words words = told(a.line, 3);
  EXPECT_EQ(words, (Words{"begin 0", "frame 0", "frame 1", "lost 2 too late", "lost 3 too late"}));
  a.frame(3, 2);
  EXPECT_EQ(a.line.counts().lateFrames, 1u);
}

TEST(TriggerLine, TriggersThatAllCamerasLostAreStillTriggersOfTheRail) {
  ALine a(quick());
  a.all(0, 3, true);
  a.all(5, 8, true);
  EXPECT_EQ(told(a.line, 1), (Words{"begin 0", "frame 0", "frame 1", "frame 2", "lost 3 frame lost",
                                    "lost 4 frame lost", "frame 5", "frame 6", "frame 7"}));
  EXPECT_EQ(a.line.counts().seenByNone, 2u);
  EXPECT_EQ(a.line.counts().inRails, 8u);
}

TEST(TriggerLine, BeginsWithTheFirstTriggerThatAnyCameraAnsweredOnceAllTakePart) {
  ALine a(quick());
  a.frame(0, 5);
  a.frame(0, 6);
  a.frame(1, 6);
  a.frame(2, 6);
  EXPECT_TRUE(told(a.line, 0).empty()) << "camera 4 may still show trigger 5";
  a.frame(3, 7);
  for (int c = 0; c < 3; ++c) a.frame(c, 7);
  EXPECT_EQ(told(a.line, 0), (Words{"begin 5", "frame 5", "frame 6", "frame 7"}));
  EXPECT_EQ(told(a.line, 3), (Words{"begin 5", "lost 5 no frame", "lost 6 no frame", "frame 7"}));
}

TEST(TriggerLine, DoesNotWaitForeverForACameraThatNeverBegins) {
  ALine a(quick());
  a.all(0, 14, true, {1});
  EXPECT_EQ(told(a.line, 1),
            (Words{"begin 0", "lost 0 too late", "lost 1 too late", "lost 2 too late", "lost 3 too late"}));
}

TEST(TriggerLine, StartsWithoutACameraThatIsDownFromTheStart) {
  ALine a(quick());
  a.line.setDown(0, "camera lost");
  a.all(0, 3, true, {0});
  EXPECT_EQ(told(a.line, 1), (Words{"begin 0", "frame 0", "frame 1", "frame 2"}));
  EXPECT_EQ(told(a.line, 0), (Words{"begin 0", "lost 0 camera lost", "lost 1 camera lost", "lost 2 camera lost"}));
}

TEST(TriggerLine, RepeatedFramesAreLeftOutAndCounted) {
  ALine a(quick());
  a.all(0, 2, true);
  a.frame(0, 2);
  a.frame(0, 2);
  a.frame(0, 1);
  for (int c = 1; c < 4; ++c) a.frame(c, 2);
  EXPECT_EQ(told(a.line, 0), (Words{"begin 0", "frame 0", "frame 1", "frame 2"}));
  EXPECT_EQ(a.line.counts().repeatedFrames, 1u);
  EXPECT_EQ(a.line.counts().lateFrames, 1u);
}

TEST(TriggerLine, CutsRailsAtTheirLengthAndEndsBehindTheLast) {
  TriggerLineSettings s = quick();
  s.lengthMm = 60;
  s.spacingMm = 15;
  s.rails = 2;
  ALine a(s);
  a.all(0, 20, true);
  EXPECT_EQ(told(a.line, 2), (Words{"begin 0", "frame 0", "frame 1", "frame 2", "frame 3", "end 4", "begin 4",
                                    "frame 4", "frame 5", "frame 6", "frame 7", "end 8", "over"}));
  EXPECT_EQ(a.line.counts().inRails, 8u);
}

TEST(TriggerLine, WhenAllCountsAreGoneTheRailEndsAndTriggersAreCountedOn) {
  ALine a(quick());
  a.all(0, 5, true);
  for (int c = 0; c < 4; ++c) a.line.setDown(c, "camera lost");
  a.line.restartCounts();
  EXPECT_EQ(told(a.line, 0).back(), "end 5");
  EXPECT_EQ(a.line.next(), 5u);
  for (int c = 0; c < 4; ++c) a.line.setUp(c);
  a.all(5, 8, true);
  EXPECT_EQ(told(a.line, 0), (Words{"begin 5", "frame 5", "frame 6", "frame 7"}));
}

TEST(TriggerLine, TellsSpeedFromWhenFramesCame) {
  ALine a(quick());
  a.all(0, 30, false);
  EXPECT_NEAR(a.line.triggersPerS(), 50, 1e-6);
  a.all(30, 33, true);
  const auto begin = a.line.take(0);
  ASSERT_TRUE(begin && std::holds_alternative<RailBegin>(*begin));
  EXPECT_NEAR(std::get<RailBegin>(*begin).speedMmPerS, 750, 1e-6);
}

TEST(TriggerLine, EveryTriggerIsInARailOrOutsideWhateverIsLost) {
  // A thousand triggers with a rail from 200 to 700; each camera loses what a simple generator says.
  ALine a(quick());
  std::uint32_t state = 7;
  const auto draw = [&state] {
    state = state * 1664525u + 1013904223u;
    return state >> 24;
  };
  std::array<std::uint64_t, 4> frames{};
  for (std::uint64_t t = 0; t < 1000; ++t)
    for (int c = 0; c < 4; ++c) {
      if (draw() < 40) continue;  // 16 %
      a.frame(c, t, t >= 200 && t < 700);
      ++frames[static_cast<std::size_t>(c)];
    }
  a.all(1000, 1001, false);
  const TriggerLineCounts counts = a.line.counts();
  EXPECT_EQ(counts.inRails + counts.outsideRails, 1001u);
  EXPECT_EQ(counts.rails, 1u);
  EXPECT_NEAR(static_cast<double>(counts.inRails), 500, 3);
  for (int c = 0; c < 4; ++c) {
    const Words words = told(a.line, c);
    EXPECT_EQ(words.size(), counts.inRails + 2);
  }
}

TEST(TriggerLine, BuffersAreLetGoOfOutsideRails) {
  ALine a(quick());
  std::vector<std::weak_ptr<const void>> leases;
  for (std::uint64_t t = 0; t < 50; ++t)
    for (int c = 0; c < 4; ++c) {
      Frame f;
      f.camera = c;
      f.trigger = t;
      f.lease = std::make_shared<int>(0);
      leases.push_back(f.lease);
      a.line.add(std::move(f), false, 0.02 * static_cast<double>(t));
    }
  const auto held = std::count_if(leases.begin(), leases.end(), [](const auto& lease) { return !lease.expired(); });
  EXPECT_EQ(held, 0);
}

}  // namespace
}  // namespace vignole
