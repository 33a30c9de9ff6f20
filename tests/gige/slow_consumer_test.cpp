// Who takes frames too slowly, and frames that outlive their source: the source itself in this process.

#include <array>
#include <atomic>

#include "engine/gige_camera/gige_source.h"
#include "engine/site/site.h"
#include "tests/gige/served_line.h"

namespace vignole {
namespace {

using namespace testing;

GigeSourceSettings settingsFor(const std::string& address) {
  const auto site = siteFrom(address);
  GigeSourceSettings settings = sourceSettings(*site);
  settings.line.rails = 1;
  settings.line.lengthMm = 100 * 15;
  return settings;
}

/// Triggers of a camera's stream in order; each exactly once from begin to end, or the test fails.
struct Stream {
  std::uint64_t begin = 0, end = 0, next = 0, frames = 0;
  std::map<std::string, std::uint64_t> lost;
  bool ended = false;
  void add(const FrameMessage& message) {
    if (const auto* b = std::get_if<RailBegin>(&message)) begin = next = b->firstTrigger;
    if (const auto* f = std::get_if<Frame>(&message)) {
      EXPECT_EQ(f->trigger, next++);
      ++frames;
    }
    if (const auto* l = std::get_if<FrameLost>(&message)) {
      EXPECT_EQ(l->trigger, next++);
      ++lost[l->reason];
    }
    if (const auto* e = std::get_if<RailEnd>(&message)) end = e->endTrigger;
    ended = ended || std::holds_alternative<SourceEnd>(message);
  }
};

TEST(GigeFaults, SlowConsumer_OverflowIsCountedAndEveryTriggerIsToldOnce) {
  ServedCameras cameras("127.0.60.11", {"--rate", "20"});
  auto source = GigeSource::open(settingsFor(cameras.address()));
  ASSERT_TRUE(source) << source.error().message();
  std::array<Stream, 4> streams;
  {
    std::array<std::jthread, 4> threads;
    for (int c = 0; c < 4; ++c)
      threads[static_cast<std::size_t>(c)] = std::jthread([&, c] {
        Stream& stream = streams[static_cast<std::size_t>(c)];
        for (bool heldUp = false; !stream.ended;) {
          stream.add((*source)->next(c, {}));
          // Camera 2's reader is held up once for longer than its inbox is deep.
          if (c != 1 || heldUp || stream.frames < 20) continue;
          heldUp = true;
          std::this_thread::sleep_for(std::chrono::milliseconds(2500));
        }
      });
  }
  for (const Stream& s : streams) {
    EXPECT_EQ(s.end - s.begin, 100u);
    EXPECT_EQ(s.next, s.end);
  }
  EXPECT_EQ(streams[0].frames, 100u);
  EXPECT_LT(streams[1].frames, 100u);
  EXPECT_GT((*source)->cameras()[1].counters.overflow, 5u);
  EXPECT_EQ((*source)->counts().inRails, 100u);
}

TEST(GigeFaults, FramesThatAreHeldBack_StarveTheCameraAndAreValidAfterTheSourceIsGone) {
  ServedCameras cameras("127.0.61.11", {"--rate", "20"});
  GigeSourceSettings settings = settingsFor(cameras.address());
  for (GigeCameraSettings& camera : settings.cameras) camera.buffers = 40;
  std::vector<Frame> held;
  std::array<Stream, 4> streams;
  {
    auto source = GigeSource::open(settings);
    ASSERT_TRUE(source) << source.error().message();
    std::array<std::jthread, 4> threads;
    for (int c = 0; c < 4; ++c)
      threads[static_cast<std::size_t>(c)] = std::jthread([&, c] {
        Stream& stream = streams[static_cast<std::size_t>(c)];
        while (!stream.ended) {
          FrameMessage message = (*source)->next(c, {});
          stream.add(message);
          if (c != 2) continue;
          if (auto* f = std::get_if<Frame>(&message)) held.push_back(std::move(*f));
          if (stream.next == 70) held.erase(held.begin() + 10, held.end());
        }
      });
    for (std::jthread& thread : threads) thread.join();
    EXPECT_EQ((*source)->counts().inRails, 100u);
    EXPECT_GT((*source)->cameras()[2].counters.underrunPackets, 0u);
  }
  for (const Stream& s : streams) EXPECT_EQ(s.next, s.end);
  EXPECT_LT(streams[2].frames, 100u);
  EXPECT_GT(streams[2].frames, 45u) << "goes on when the buffers are back";
  unsigned sum = 0;
  for (const Frame& frame : held)
    for (int y = 0; y < frame.image.height; y += 64) sum += frame.image.row(y)[0];
  EXPECT_GT(sum, 0u) << "their pixels are still there";
}

TEST(GigeFaults, StopInTheMiddle_EndsSoonAndANewSourceOpensAtOnce) {
  ServedCameras cameras("127.0.62.11", {"--rate", "20"});
  for (int i = 0; i < 3; ++i) {
    auto source = GigeSource::open(settingsFor(cameras.address()));
    ASSERT_TRUE(source) << source.error().message();
    std::stop_source stop;
    std::atomic<int> frames = 0;
    std::array<std::jthread, 4> threads;
    for (int c = 0; c < 4; ++c)
      threads[static_cast<std::size_t>(c)] = std::jthread([&, c] {
        for (;;) {
          const FrameMessage message = (*source)->next(c, stop.get_token());
          if (std::holds_alternative<SourceEnd>(message)) return;
          if (std::holds_alternative<Frame>(message) && ++frames == 20) stop.request_stop();
        }
      });
    for (std::jthread& thread : threads) thread.join();
    EXPECT_GE(frames, 20);
  }
}

}  // namespace
}  // namespace vignole
