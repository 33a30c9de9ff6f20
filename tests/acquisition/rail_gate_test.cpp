// The gate between two rails: readers take turns, all four streams the same, nothing lost between them.

#include "engine/acquisition/rail_gate.h"

#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

namespace vignole {
namespace {

/// Rails of three triggers, without end.
class Rails : public FrameSource {
 public:
  FrameMessage next(int camera, std::stop_token /*stop*/) override {
    std::size_t& step = steps_[static_cast<std::size_t>(camera)];
    const std::uint64_t rail = step / 5, within = step % 5;
    ++step;
    if (within == 0) {
      RailBegin begin;
      begin.firstTrigger = 3 * rail;
      return begin;
    }
    if (within == 4) return RailEnd{3 * rail + 3};
    Frame frame;
    frame.camera = camera;
    frame.trigger = 3 * rail + within - 1;
    return frame;
  }
  [[nodiscard]] bool live() const override { return true; }

 private:
  std::array<std::size_t, 4> steps_{};
};

/// Triggers of one stream until it ends, at most `most` messages.
std::vector<std::uint64_t> read(RailGate& gate, int camera, int most = 1000) {
  std::vector<std::uint64_t> triggers;
  for (int i = 0; i < most; ++i) {
    const FrameMessage message = gate.next(camera, {});
    if (std::holds_alternative<SourceEnd>(message)) break;
    if (const Frame* frame = std::get_if<Frame>(&message)) triggers.push_back(frame->trigger);
  }
  return triggers;
}

TEST(RailGateSource, PassesEverythingOnWhileItIsOpen) {
  Rails rails;
  RailGate gate(rails);
  EXPECT_TRUE(gate.live());
  EXPECT_EQ(read(gate, 2, 11), (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}));
}

TEST(RailGateSource, StreamsThatAreApartEndBehindTheSameRailAndGoOnWithTheNext) {
  Rails rails;
  RailGate gate(rails);
  (void)read(gate, 0, 12);  // in its third rail
  (void)read(gate, 1, 3);   // in its first
  gate.close();
  EXPECT_EQ(read(gate, 1), (std::vector<std::uint64_t>{2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(read(gate, 0), (std::vector<std::uint64_t>{7, 8}));
  EXPECT_EQ(read(gate, 2).back(), 8U);
  EXPECT_EQ(read(gate, 3).back(), 8U);
  EXPECT_TRUE(std::holds_alternative<SourceEnd>(gate.next(0, {}))) << "stays ended until it is opened";

  gate.open();
  for (int c = 0; c < 4; ++c) {
    const FrameMessage message = gate.next(c, {});
    ASSERT_TRUE(std::holds_alternative<RailBegin>(message)) << c;
    EXPECT_EQ(std::get<RailBegin>(message).firstTrigger, 9U);
  }
}

TEST(RailGateSource, AClosingThatIsTakenBackEndsNothing) {
  Rails rails;
  RailGate gate(rails);
  gate.close();
  gate.open();
  EXPECT_EQ(read(gate, 3, 10).size(), 6U);
}

TEST(RailGateSource, ClosedAndOpenedBesideFourReadersLosesNoTrigger) {
  Rails rails;
  RailGate gate(rails);
  std::array<std::vector<std::uint64_t>, 4> seen;
  for (int turn = 0; turn < 200; ++turn) {
    std::array<std::vector<std::uint64_t>, 4> now;
    {
      std::vector<std::jthread> readers;
      for (int c = 0; c < 4; ++c)
        readers.emplace_back([&, c] { now[static_cast<std::size_t>(c)] = read(gate, c, 1 << 30); });
      gate.close();
    }
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(now[c].back(), now[0].back()) << "turn " << turn;
      seen[c].insert(seen[c].end(), now[c].begin(), now[c].end());
    }
    gate.open();
  }
  for (const auto& stream : seen)
    for (std::size_t i = 0; i < stream.size(); ++i) ASSERT_EQ(stream[i], i);
}

}  // namespace
}  // namespace vignole
