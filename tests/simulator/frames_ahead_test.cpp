// Frames rendered ahead are those of the rig, in any order.

#include "engine/simulator/frames_ahead.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

std::shared_ptr<const VirtualRig> rig() {
  VirtualRigSettings s;
  if (auto section = findSection("60E1")) s.section = *std::move(section);
  s.parameters = s.section.parameters;
  auto made = VirtualRig::create(std::move(s));
  EXPECT_TRUE(made.has_value());
  return made ? *made : nullptr;
}

std::vector<std::uint8_t> rendered(const VirtualRig& of, int camera, std::uint64_t trigger) {
  std::vector<std::uint8_t> pixels(1400 * 1024);
  of.render(camera, trigger, {pixels.data(), 1400, 1024, 1400});
  return pixels;
}

bool same(const ProvidedFrame& frame, const std::vector<std::uint8_t>& pixels) {
  return frame.image.width == 1400 && frame.image.height == 1024 && frame.image.stride == 1400 &&
         std::equal(pixels.begin(), pixels.end(), frame.image.data);
}

TEST(FramesAhead, EveryTriggerShowsItsOwnPixels) {
  const auto of = rig();
  const auto frames = FramesAhead::create(of, {});
  ASSERT_TRUE(frames) << frames.error().message();
  std::vector<ProvidedFrame> kept;
  for (std::uint64_t t = 0; t < 9; ++t) {
    ASSERT_TRUE((*frames)->prepare(t, {}));
    for (int c = 0; c < 4; ++c) {
      const ProvidedFrame frame = (*frames)->frame(c, t, {});
      EXPECT_TRUE(same(frame, rendered(*of, c, t))) << c << " " << t;
      if (c == 1) kept.push_back(frame);
    }
  }
  // What is held stays as it was, however far the others have gone on.
  for (std::uint64_t t = 0; t < 9; ++t) EXPECT_TRUE(same(kept[t], rendered(*of, 1, t))) << t;
  // Out of order, back and unprepared.
  for (const std::uint64_t t : {100u, 7u, 0u, 5u}) EXPECT_TRUE(same((*frames)->frame(2, t, {}), rendered(*of, 2, t)));
  for (const std::uint64_t t : {50u, 51u, 0u, 1u}) {
    ASSERT_TRUE((*frames)->prepare(t, {}));
    EXPECT_TRUE(same((*frames)->frame(3, t, {}), rendered(*of, 3, t))) << t;
  }
  EXPECT_TRUE((*frames)->frame(4, 0, {}).image.empty());
}

TEST(FramesAhead, BetweenRailsThereIsNone) {
  const auto of = rig();
  FramesAheadSettings settings;
  settings.schedule = {3, 2, 2};
  const auto frames = FramesAhead::create(of, settings);
  ASSERT_TRUE(frames) << frames.error().message();
  EXPECT_EQ((*frames)->triggers(), 10u);
  const auto brightest = [&](std::uint64_t t) {
    const ProvidedFrame frame = (*frames)->frame(0, t, {});
    return *std::max_element(frame.image.data, frame.image.data + 1400 * 1024);
  };
  for (std::uint64_t t = 0; t < 10; ++t) {
    ASSERT_TRUE((*frames)->prepare(t, {}));
    const bool rail = t % 5 < 3;
    EXPECT_EQ((*frames)->railPresent(t), rail) << t;
    if (rail)
      EXPECT_GT(brightest(t), 100) << t;
    else
      EXPECT_LT(brightest(t), 60) << t;
  }
  EXPECT_FALSE((*frames)->railPresent(10));
}

TEST(FramesAhead, WithoutLengthThereIsOneRail) {
  const RailSchedule endless;
  EXPECT_TRUE(endless.present(1000000));
  EXPECT_FALSE(endless.triggers());
  const RailSchedule manyRails{100, 20, 0};
  EXPECT_FALSE(manyRails.triggers());
  EXPECT_FALSE(manyRails.present(119));
  EXPECT_TRUE(manyRails.present(120 * 5000));
}

TEST(FramesAhead, AStopEndsTheWaiting) {
  const auto frames = FramesAhead::create(rig(), {});
  ASSERT_TRUE(frames);
  std::stop_source stop;
  stop.request_stop();
  (void)(*frames)->prepare(5000, stop.get_token());  // whatever it says, it comes back
  EXPECT_TRUE((*frames)->frame(0, 7000, stop.get_token()).image.empty());
}

}  // namespace
}  // namespace vignole
