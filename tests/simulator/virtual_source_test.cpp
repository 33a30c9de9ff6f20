// Every trigger of a rail is told of by every camera, in order, whatever fails.

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "engine/rail/catalogue.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const VirtualRig> rigWith(std::vector<std::string> faults) {
  VirtualRigSettings s;
  if (auto section = findSection("60E1")) s.section = *std::move(section);
  s.parameters = s.section.parameters;
  for (const std::string& text : faults) s.faults.push_back(*parseFault(text));
  auto rig = VirtualRig::create(std::move(s));
  EXPECT_TRUE(rig.has_value());
  return rig ? *rig : nullptr;
}

struct Account {
  std::uint64_t frames = 0, lost = 0, missed = 0;
  int rails = 0;
  std::string reason, error;
};

/// Takes one camera's stream to its end, checking order; frames are let go at once.
Account takeAll(FrameSource& source, int camera) {
  Account account;
  std::uint64_t next = 0;
  const auto advance = [&](std::uint64_t trigger) {
    EXPECT_GE(trigger, next);
    account.missed += trigger - next;
    next = trigger + 1;
  };
  while (true) {
    FrameMessage message = source.next(camera, {});
    if (const auto* frame = std::get_if<Frame>(&message)) {
      EXPECT_EQ(frame->camera, camera);
      EXPECT_EQ(frame->image.width, 1400);
      advance(frame->trigger);
      ++account.frames;
    } else if (const auto* lost = std::get_if<FrameLost>(&message)) {
      advance(lost->trigger);
      account.reason = lost->reason;
      ++account.lost;
    } else if (const auto* begin = std::get_if<RailBegin>(&message)) {
      EXPECT_EQ(begin->firstTrigger, next);
      EXPECT_EQ(begin->sectionName, "60E1");
      ++account.rails;
    } else if (const auto* end = std::get_if<RailEnd>(&message)) {
      account.missed += end->endTrigger - next;
      next = end->endTrigger;
    } else {
      account.error = std::get<SourceEnd>(message).error;
      return account;
    }
  }
}

Account run(std::vector<std::string> faults, int camera, int rails = 2, double lengthMm = 300) {
  const auto source = makeVirtualSource(rigWith(std::move(faults)), {rails, lengthMm, false, 4});
  return takeAll(*source, camera);
}

TEST(VirtualSource, HealthyRailsAreComplete) {
  for (int camera = 0; camera < kCameraCount; ++camera) {
    const Account a = run({}, camera);
    EXPECT_EQ(a.rails, 2);
    EXPECT_EQ(a.frames, 40U);
    EXPECT_EQ(a.lost + a.missed, 0U);
    EXPECT_EQ(a.error, "");
  }
}

TEST(VirtualSource, LostFramesAreTold) {
  const Account a = run({"frame-loss=1@2:5-14"}, 1);
  EXPECT_EQ(a.lost, 10U);
  EXPECT_EQ(a.frames, 30U);
  EXPECT_EQ(a.reason, "frame lost");
  EXPECT_EQ(run({"frame-loss=1@2:5-14"}, 0).lost, 0U);
  const Account half = run({"frame-loss=0.5"}, 0, 1, 3000);
  EXPECT_GT(half.lost, 70U);
  EXPECT_LT(half.lost, 130U);
  EXPECT_EQ(half.lost + half.frames, 200U);
}

TEST(VirtualSource, MissedTriggersAreSilent) {
  const Account a = run({"missed-trigger=1@1:3-4"}, 0);
  EXPECT_EQ(a.missed, 2U);
  EXPECT_EQ(a.lost, 0U);
  EXPECT_EQ(a.frames, 38U);
}

TEST(VirtualSource, ADeadCameraComesBackWhenRevived) {
  const Account dead = run({"die@3:10-"}, 2);
  EXPECT_EQ(dead.frames, 10U);
  EXPECT_EQ(dead.lost, 30U);
  EXPECT_EQ(dead.reason, "camera gone");
  const Account revived = run({"die@3:10-", "revive@3:25-"}, 2);
  EXPECT_EQ(revived.frames, 25U);
  EXPECT_EQ(revived.lost, 15U);
}

TEST(VirtualSource, ASlowCameraTakesItsTime) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run({"slow=20@1:0-4"}, 0, 1).frames, 20U);
  EXPECT_GE(std::chrono::steady_clock::now() - start, 100ms);
}

TEST(VirtualSource, ABufferComesBackWhenTheLeaseEnds) {
  const auto source = makeVirtualSource(rigWith({}), {1, 300, false, 1});
  (void)source->next(0, {});  // the rail begins
  auto first = std::make_unique<FrameMessage>(source->next(0, {}));
  const std::uint8_t* pixels = std::get<Frame>(*first).image.data;
  std::jthread release([&] {
    std::this_thread::sleep_for(20ms);
    first.reset();
  });
  const FrameMessage second = source->next(0, {});  // waits for the only buffer
  EXPECT_EQ(std::get<Frame>(second).image.data, pixels);
}

TEST(VirtualSource, AFrameOutlivesItsSource) {
  auto source = makeVirtualSource(rigWith({}), {1, 300, false, 2});
  (void)source->next(0, {});
  const FrameMessage message = source->next(0, {});
  source.reset();
  EXPECT_GT(std::get<Frame>(message).image.row(500)[700], 0);
}

TEST(VirtualSource, StopEndsWaitingForABuffer) {
  const auto source = makeVirtualSource(rigWith({}), {1, 300, false, 1});
  (void)source->next(0, {});
  const FrameMessage held = source->next(0, {});
  FrameMessage last;
  {
    std::jthread waiter([&](std::stop_token stop) { last = source->next(0, stop); });
    std::this_thread::sleep_for(10ms);
  }  // stopped and joined
  EXPECT_TRUE(std::holds_alternative<SourceEnd>(last));
}

TEST(VirtualSource, PacedFramesComeByTheClock) {
  const auto source = makeVirtualSource(rigWith({}), {1, 300, true, 24});
  EXPECT_TRUE(source->live());
  const auto start = std::chrono::steady_clock::now();
  const Account a = takeAll(*source, 0);
  EXPECT_GE(std::chrono::steady_clock::now() - start, 299ms);  // the end of the rail: 20 triggers of 15 ms
  EXPECT_EQ(a.frames + a.lost, 20U);
  EXPECT_EQ(a.missed, 0U);
}

TEST(VirtualSource, APacedSourceDropsWhatNobodyTakes) {
  const auto source = makeVirtualSource(rigWith({}), {1, 600, true, 2});
  (void)source->next(0, {});
  (void)source->next(0, {});
  std::this_thread::sleep_for(300ms);  // 20 periods with 2 buffers
  const Account rest = takeAll(*source, 0);
  EXPECT_GT(rest.lost, 10U);
  EXPECT_EQ(rest.reason, "queue overflow");
}

}  // namespace
}  // namespace vignole
