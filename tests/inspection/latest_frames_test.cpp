// Who looks at the frames: sees each camera's latest with its own line, holds no more than is said, slows nobody.

#include "engine/inspection/latest_frames.h"

#include <gtest/gtest.h>
#include <thread>

#include "tests/inspection/scripted_source.h"

namespace vignole {
namespace {

using namespace vignole::testing;

StripeResult stripeAt(std::uint64_t trigger) {
  StripeResult stripe;
  StripePoint point;
  point.x = static_cast<float>(trigger);
  stripe.points.assign(1, point);
  return stripe;
}

void offer(LatestFrames& frames, int camera, std::uint64_t trigger) {
  frames.offer(frame(camera, trigger), stripeAt(trigger), 0.5);
}

TEST(LatestFramesOfThePipeline, NothingIsHeldWhileNobodyLooks) {
  LatestFrames frames;
  const Frame shown = frame(1, 7);
  frames.offer(shown, {}, 0);
  EXPECT_EQ(frames.latest(1), nullptr);
  EXPECT_EQ(shown.lease.use_count(), 1);
}

TEST(LatestFramesOfThePipeline, TheLastFewAreHeldAndAllLetGoWhenNobodyLooksAnyMore) {
  LatestFrames frames;
  frames.addWatcher();
  std::vector<Frame> shown;
  for (std::uint64_t t = 0; t < 20; ++t) {
    shown.push_back(frame(2, t));
    frames.offer(shown.back(), stripeAt(t), 0.5);
  }
  EXPECT_EQ(frames.latest(2)->frame.trigger, 19U);
  EXPECT_EQ(frames.latest(2)->frame.image.data, shown.back().image.data) << "the pixels themselves, no copy";
  EXPECT_EQ(frames.latest(0), nullptr);
  for (std::uint64_t t = 0; t < 20; ++t) {
    const bool held = t >= 20 - LatestFrames::kHeld;
    EXPECT_EQ(frames.at(2, t) != nullptr, held) << t;
    EXPECT_EQ(shown[t].lease.use_count(), held ? 2 : 1) << t;
  }
  const auto kept = frames.latest(2);
  frames.removeWatcher();
  EXPECT_EQ(frames.latest(2), nullptr);
  EXPECT_EQ(shown[15].lease.use_count(), 1);
  EXPECT_EQ(shown[19].lease.use_count(), 2) << "who has taken it keeps it";
  EXPECT_EQ(kept->stripe.points.front().x, 19.0F);
}

TEST(LatestFramesOfThePipeline, FourPicturesOfOneTrigger) {
  LatestFrames frames;
  frames.addWatcher();
  for (std::uint64_t t = 0; t < 10; ++t)
    for (int c = 0; c < 4; ++c)
      if (t < 10 - static_cast<std::uint64_t>(c)) offer(frames, c, t);  // camera 4 is three behind
  for (const auto& held : frames.together()) {
    ASSERT_NE(held, nullptr);
    EXPECT_EQ(held->frame.trigger, 6U);
  }
  for (std::uint64_t t = 10; t < 30; ++t)
    for (const int c : {0, 1, 3}) offer(frames, c, t);  // camera 3 is lost
  const auto together = frames.together();
  EXPECT_EQ(together[2], nullptr);
  for (const std::size_t c : {0U, 1U, 3U}) EXPECT_EQ(together[c]->frame.trigger, 29U);
}

TEST(LatestFramesOfThePipeline, AfterARestartCountsFromZeroAreTheNewest) {
  LatestFrames frames;
  frames.addWatcher();
  for (int c = 0; c < 4; ++c) offer(frames, c, 5000);
  frames.restart();
  EXPECT_EQ(frames.together()[0], nullptr);
  for (const int c : {0, 1, 2}) offer(frames, c, 0);
  EXPECT_EQ(frames.together()[0]->frame.trigger, 0U);
  EXPECT_EQ(frames.together()[3], nullptr);
}

struct Watched {
  Told told;
  std::vector<StageStatistics> stages;
};

/// The same rail, with somebody who takes and holds as many frames as there are, or with nobody.
Watched run(bool tappedToo, const std::shared_ptr<LatestFrames>& frames, bool live) {
  Watched r;
  ScriptedSource source(wholeRail(0, 2000));
  source.isLive = live;
  InspectionSettings settings;
  // As fast as it can: nothing is given up only because a camera is ahead.
  if (live) settings = {4000, 4000};
  InspectionObserver observer = r.told.observer();
  if (tappedToo) observer = tapped(std::move(observer), frames);
  Pipeline pipeline(source, simpleWork(), std::move(observer), settings);
  std::uint64_t seen = 0;
  std::jthread looker([&](const std::stop_token& stop) {
    std::array<LatestFrames::Held, kCameraCount> held;
    while (!stop.stop_requested()) {
      for (int c = 0; c < kCameraCount; ++c) {
        if (auto latest = frames->latest(c)) held[static_cast<std::size_t>(c)] = std::move(latest);
        const auto& mine = held[static_cast<std::size_t>(c)];
        if (!mine) continue;
        ++seen;
        std::uint64_t inPixels = 0;
        std::memcpy(&inPixels, mine->frame.image.data, sizeof inPixels);
        EXPECT_EQ(inPixels, mine->frame.trigger);
        EXPECT_EQ(mine->frame.image.data[8], c);
        EXPECT_EQ(mine->stripe.points.front().x, static_cast<float>(inPixels)) << "the line of another picture";
      }
      if (seen % 64 == 63) frames->removeWatcher(), frames->addWatcher();  // comes and goes
    }
  });
  pipeline.start();
  pipeline.wait();
  looker.request_stop();
  looker.join();
  r.stages = pipeline.stages();
  return r;
}

TEST(LatestFramesOfThePipeline, WhoLooksChangesNothing) {
  for (const bool live : {false, true}) {
    SCOPED_TRACE(live ? "live" : "held back");
    const auto frames = std::make_shared<LatestFrames>();
    const Watched alone = run(false, frames, live);
    frames->addWatcher();
    const Watched looked = run(true, frames, live);
    EXPECT_EQ(alone.told.events, looked.told.events);
    EXPECT_EQ(alone.told.values, looked.told.values);
    EXPECT_EQ(looked.told.triggers.size(), 2000U);
  }
}

TEST(LatestFramesOfThePipeline, AnObserverThatThrowsCostsNoFrame) {
  Told told;
  ScriptedSource source(wholeRail(0, 50));
  InspectionObserver observer = told.observer();
  observer.frameExtracted = [](const Frame&, const StripeResult&, double) { throw std::bad_alloc(); };
  Pipeline pipeline(source, simpleWork(), std::move(observer), {});
  pipeline.start();
  pipeline.wait();
  EXPECT_EQ(pipeline.triggers().measured, 50U);
}

}  // namespace
}  // namespace vignole
