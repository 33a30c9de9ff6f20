// Cameras and encoder end to end, over loopback, through a client that is not ours.

#include "engine/gige_device/device_rig.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

#include "engine/gige_device/feature_description.h"
#include "tests/gige_device/raw_client.h"

namespace vignole::gige_device {
namespace {

using namespace std::chrono_literals;
using raw::Client;
using raw::Octets;
using raw::RawFrame;

constexpr int kWidth = 128, kHeight = 96;

std::uint8_t pixelAt(int camera, std::uint64_t trigger, int x, int y) {
  return static_cast<std::uint8_t>(static_cast<std::uint64_t>(x * 3 + y * 7 + camera * 50) + trigger * 11);
}

/// Pictures that tell which they are. Triggers of a rail: all but 5 to 7.
class Pattern final : public FrameProvider {
 public:
  bool prepare(std::uint64_t, std::stop_token) override { return true; }
  ProvidedFrame frame(int camera, std::uint64_t trigger, std::stop_token) override {
    const auto pixels = std::make_shared<Octets>(kWidth * kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        (*pixels)[static_cast<std::size_t>(y * kWidth + x)] = pixelAt(camera, trigger, x, y);
    return {{pixels->data(), kWidth, kHeight, kWidth}, pixels};
  }
  bool railPresent(std::uint64_t trigger) const override { return trigger < 5 || trigger > 7; }
  std::optional<std::uint64_t> triggers() const override { return end; }
  std::optional<std::uint64_t> end;
};

bool showsTrigger(const RawFrame& frame, int camera, std::uint64_t trigger) {
  const Octets pixels = frame.pixels();
  if (pixels.size() != static_cast<std::size_t>(frame.width) * frame.height) return false;
  for (std::uint32_t y = 0; y < frame.height; ++y)
    for (std::uint32_t x = 0; x < frame.width; ++x)
      if (pixels[y * frame.width + x] !=
          pixelAt(camera, trigger, static_cast<int>(x + frame.offsetX), static_cast<int>(y + frame.offsetY)))
        return false;
  return true;
}

struct Bench {
  explicit Bench(std::initializer_list<const char*> faults = {}, int cameras = 1, double rateHz = 100,
                 std::optional<std::uint64_t> triggers = {}) {
    settings.cameras = cameras;
    settings.firstAddress = raw::freeAddress();
    settings.rateHz = rateHz;
    settings.seed = 3;
    settings.widthPx = kWidth;
    settings.heightPx = kHeight;
    for (const char* text : faults) settings.faults.push_back(parseDeviceFault(text).value());
    pattern->end = triggers;
    auto started = DeviceRig::start(settings, pattern);
    if (!started) throw std::runtime_error(started.error().message());
    rig = std::move(*started);
    for (int c = 0; c < cameras; ++c)
      clients.push_back(std::make_unique<Client>(raw::addressPlus(settings.firstAddress, c)));
  }
  Client& client(int camera = 0) { return *clients[static_cast<std::size_t>(camera)]; }
  /// Controlled, streaming to its client, triggered by Line1, its timestamp the count of pulses.
  void connect(int camera, std::uint32_t packetBytes = 1500) {
    ASSERT_TRUE(client(camera).takeControl());
    client(camera).openStream(packetBytes);
    EXPECT_EQ(client(camera).write(reg::kTriggerMode, 1), 0);
    EXPECT_EQ(client(camera).write(reg::kExposureTime, std::bit_cast<std::uint32_t>(1000.0f)), 0);
    EXPECT_EQ(client(camera).write(reg::kTimestampCounter, 1), 0);
    EXPECT_EQ(client(camera).write(reg::kTimestampControl, 1), 0);
  }
  void start(int camera = 0) { EXPECT_EQ(client(camera).write(reg::kAcquisitionStart, 1), 0); }
  void stop(int camera = 0) { EXPECT_EQ(client(camera).write(reg::kAcquisitionStop, 1), 0); }
  void enableChunks(int camera) {
    for (std::uint32_t i = 1; i < kChunks.size(); ++i) EXPECT_EQ(client(camera).write(reg::kChunkEnable + 4 * i, 1), 0);
    EXPECT_EQ(client(camera).write(reg::kChunkModeActive, 1), 0);
  }
  bool eventually(const std::function<bool()>& condition) {
    for (const auto until = std::chrono::steady_clock::now() + 5s; std::chrono::steady_clock::now() < until;) {
      if (condition()) return true;
      std::this_thread::sleep_for(2ms);
    }
    return condition();
  }

  DeviceRigSettings settings;
  std::shared_ptr<Pattern> pattern = std::make_shared<Pattern>();
  std::unique_ptr<DeviceRig> rig;
  std::vector<std::unique_ptr<Client>> clients;
};

TEST(DeviceRig, FourCamerasAreTriggeredTogetherFromZero) {
  Bench bench({}, 4);
  for (int c = 0; c < 4; ++c) bench.connect(c);
  for (int c = 0; c < 4; ++c) bench.enableChunks(c);
  for (int c = 0; c < 3; ++c) bench.start(c);
  // Three are not all: the encoder rests.
  EXPECT_FALSE(bench.client(0).nextFrame(300ms));
  EXPECT_EQ(bench.rig->nextTrigger(), 0u);
  bench.start(3);
  for (std::uint64_t t = 0; t < 12; ++t)
    for (int c = 0; c < 4; ++c) {
      const auto frame = bench.client(c).nextFrame();
      ASSERT_TRUE(frame) << "camera " << c << " trigger " << t;
      EXPECT_TRUE(frame->complete());
      EXPECT_EQ(frame->id, t + 1);
      EXPECT_EQ(frame->timestamp, t);
      EXPECT_EQ(frame->payloadType, 0x4001);
      EXPECT_EQ(frame->width, static_cast<std::uint32_t>(kWidth));
      EXPECT_TRUE(showsTrigger(*frame, c, t));
      EXPECT_EQ(frame->chunk(ChunkId::EncoderCount), t);
      EXPECT_EQ(frame->chunk(ChunkId::EncoderPosition), t * 15000);
      EXPECT_EQ(frame->chunk(ChunkId::LineStatus), (t < 5 || t > 7 ? 3u : 1u));
      EXPECT_TRUE(frame->chunk(ChunkId::Clock));
      EXPECT_FALSE(frame->chunk(static_cast<ChunkId>(0x1009)));
    }
  for (int c = 0; c < 4; ++c) bench.stop(c);
  EXPECT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() == 0; }));
}

TEST(DeviceRig, TheCountBeginsAgainWhenAllHaveStopped) {
  Bench bench;
  bench.connect(0);
  bench.enableChunks(0);
  bench.start();
  for (int t = 0; t < 3; ++t) ASSERT_TRUE(bench.client().nextFrame());
  bench.stop();
  ASSERT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() == 0; }));
  while (bench.client().nextFrame(100ms)) {
  }
  const DeviceCounters before = bench.rig->counters(0);
  bench.client().frames.clear();
  bench.start();
  const auto frame = bench.client().nextFrame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->chunk(ChunkId::EncoderCount), 0u);
  EXPECT_TRUE(showsTrigger(*frame, 0, 0));
  EXPECT_EQ(frame->id, before.framesTaken + 1);  // ids go on
  EXPECT_EQ(frame->timestamp, before.pulses);    // so does the counter, until it is reset
  EXPECT_EQ(bench.rig->encoder().runs, 2u);
}

TEST(DeviceRig, AResetAtRestMakesTheNextPulseZero) {
  Bench bench;
  bench.connect(0);
  bench.start();
  for (int t = 0; t < 3; ++t) ASSERT_TRUE(bench.client().nextFrame());
  bench.stop();
  ASSERT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() == 0; }));
  while (bench.client().nextFrame(100ms)) {
  }
  EXPECT_EQ(bench.client().write(reg::kTimestampControl, 1), 0);
  bench.start();
  const auto frame = bench.client().nextFrame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->timestamp, 0u);
}

TEST(DeviceRig, AFreeCameraNeedsNoEncoder) {
  Bench bench({}, 2);
  ASSERT_TRUE(bench.client().takeControl());
  bench.client().openStream();
  EXPECT_EQ(bench.client().write(reg::kFrameRate, std::bit_cast<std::uint32_t>(50.0f)), 0);
  bench.start();
  std::uint64_t before = 0;
  for (std::uint64_t n = 0; n < 4; ++n) {
    const auto frame = bench.client().nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(showsTrigger(*frame, 0, n));
    EXPECT_GT(frame->timestamp, before);  // nanoseconds
    before = frame->timestamp;
  }
  EXPECT_EQ(bench.rig->nextTrigger(), 0u);
}

TEST(DeviceRig, SoftwareTriggersAndSingleFrames) {
  Bench bench;
  ASSERT_TRUE(bench.client().takeControl());
  bench.client().openStream();
  EXPECT_EQ(bench.client().write(reg::kTriggerMode, 1), 0);
  EXPECT_EQ(bench.client().write(reg::kTriggerSource, 2), 0);
  EXPECT_EQ(bench.client().write(reg::kExposureTime, std::bit_cast<std::uint32_t>(10.0f)), 0);
  bench.start();
  EXPECT_FALSE(bench.client().nextFrame(100ms));
  for (std::uint64_t n = 0; n < 3; ++n) {
    EXPECT_EQ(bench.client().write(reg::kTriggerSoftware, 1), 0);
    const auto frame = bench.client().nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(showsTrigger(*frame, 0, n));
  }
  bench.stop();
  EXPECT_EQ(bench.client().write(reg::kTriggerSoftware, 1), 0);
  EXPECT_FALSE(bench.client().nextFrame(100ms));

  EXPECT_EQ(bench.client().write(reg::kTriggerMode, 0), 0);
  EXPECT_EQ(bench.client().write(reg::kAcquisitionMode, 1), 0);
  bench.start();
  EXPECT_TRUE(bench.client().nextFrame());
  EXPECT_FALSE(bench.client().nextFrame(150ms));
  EXPECT_EQ(bench.client().write(reg::kAcquisitionMode, 2), 0);
  EXPECT_EQ(bench.client().write(reg::kAcquisitionFrames, 3), 0);
  bench.start();
  for (int n = 0; n < 3; ++n) EXPECT_TRUE(bench.client().nextFrame());
  EXPECT_FALSE(bench.client().nextFrame(150ms));
}

TEST(DeviceRig, ARegionIsCutOut) {
  Bench bench;
  bench.connect(0, 576);
  bench.enableChunks(0);
  for (const auto& [address, value] : std::vector<std::pair<reg::Address, std::uint32_t>>{
           {reg::kWidth, 40}, {reg::kHeight, 24}, {reg::kOffsetX, 20}, {reg::kOffsetY, 12}})
    EXPECT_EQ(bench.client().write(address, value), 0);
  bench.start();
  const auto frame = bench.client().nextFrame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->width, 40u);
  EXPECT_EQ(frame->offsetX, 20u);
  EXPECT_EQ(frame->payload().size(), *bench.client().read(reg::kPayloadSize));
  EXPECT_TRUE(showsTrigger(*frame, 0, 0));
  EXPECT_EQ(frame->chunk(ChunkId::EncoderCount), 0u);
}

TEST(DeviceRig, PacketsAreAsLongAsAskedFor) {
  Bench bench;
  bench.connect(0, 8192);
  EXPECT_EQ(bench.client().write(reg::kPacketSize, 0xc0000000u | 4000), 0);  // fires a test packet
  ASSERT_NE(bench.client().receivePacket(), nullptr);
  EXPECT_EQ(bench.client().lastDatagramBytes, 4000u - 28);
  bench.client().frames.clear();
  bench.start();
  const auto frame = bench.client().nextFrame();
  ASSERT_TRUE(frame);
  std::size_t longest = 0;
  for (const auto& [number, bytes] : frame->packets) longest = std::max(longest, bytes.size());
  EXPECT_EQ(longest, 4000u - 28 - 8);
}

TEST(DeviceRig, LostPacketsComeWhenAskedFor) {
  Bench bench({"packet-loss=0.2"}, 1, 10);
  bench.connect(0, 576);
  bench.start();
  std::size_t lost = 0;
  for (std::uint64_t t = 0; t < 8; ++t) {
    // Frames are told apart by the leader of the next, as their own last packets may be lost.
    RawFrame* frame = nullptr;
    const auto& frames = bench.client().frames;
    while (frames.count(t + 2) == 0) ASSERT_NE(bench.client().receivePacket(), nullptr);
    frame = &bench.client().frames[t + 1];
    const std::uint32_t packets = (kWidth * kHeight + 576 - 37) / (576 - 36);
    for (int round = 0; round < 50; ++round) {
      std::vector<std::uint32_t> missing;
      if (!frame->leader) missing.push_back(0);
      for (std::uint32_t p = 1; p <= packets; ++p)
        if (frame->packets.count(p) == 0) missing.push_back(p);
      if (!frame->trailer) missing.push_back(packets + 1);
      if (missing.empty()) break;
      lost += round == 0 ? missing.size() : 0;
      for (const std::uint32_t p : missing) bench.client().requestResend(t + 1, p, p);
      while (bench.client().receivePacket(20ms) != nullptr && !frame->complete()) {
      }
    }
    EXPECT_TRUE(frame->complete());
    EXPECT_TRUE(showsTrigger(*frame, 0, t));
  }
  EXPECT_GT(lost, 10u);
  bench.stop();
  const StreamCounters counters = bench.rig->counters(0).stream;
  EXPECT_GE(counters.packetsDropped, lost);
  EXPECT_GE(counters.packetsResent, lost);
  // What is forgotten is said to be unavailable.
  bench.client().requestResend(4000, 1, 2);
  EXPECT_TRUE(bench.eventually([&] {
    bench.client().receivePacket(10ms);
    return bench.client().frames[4000].unavailable;
  }));
}

TEST(DeviceRig, TheSamePacketsAreLostInEveryRun) {
  const auto lostPackets = [] {
    Bench bench({"packet-loss=0.1", "missed-trigger=0.2", "frame-loss=0.2"});
    bench.connect(0, 576);
    bench.start();
    EXPECT_TRUE(bench.eventually([&] {
      while (bench.client().receivePacket(1ms) != nullptr) {
      }
      return bench.rig->nextTrigger() > 30;
    }));
    bench.stop();
    while (bench.client().receivePacket(50ms) != nullptr) {
    }
    std::map<std::uint64_t, std::set<std::uint32_t>> got;
    for (const auto& [id, frame] : bench.client().frames)
      if (id <= 15)
        for (const auto& [packet, bytes] : frame.packets) got[id].insert(packet);
    return got;
  };
  const auto first = lostPackets();
  EXPECT_GT(first.size(), 5u);
  EXPECT_LT(first.size(), 15u);  // frames were lost
  EXPECT_EQ(first, lostPackets());
}

TEST(DeviceRig, AMissedTriggerLeavesNoGapInTheIdsButInTheCount) {
  Bench bench({"missed-trigger=1:3-4", "frame-loss=1:6-6"});
  bench.connect(0);
  bench.enableChunks(0);
  bench.start();
  std::vector<std::uint64_t> ids, counts;
  for (int n = 0; n < 6; ++n) {
    const auto frame = bench.client().nextFrame();
    ASSERT_TRUE(frame);
    ids.push_back(frame->id);
    counts.push_back(frame->timestamp);
    EXPECT_EQ(frame->chunk(ChunkId::EncoderCount), frame->timestamp);
    EXPECT_TRUE(showsTrigger(*frame, 0, frame->timestamp));
  }
  EXPECT_EQ(counts, (std::vector<std::uint64_t>{0, 1, 2, 5, 7, 8}));
  EXPECT_EQ(ids, (std::vector<std::uint64_t>{1, 2, 3, 4, 6, 7}));
  EXPECT_EQ(bench.rig->counters(0).triggersMissed, 2u);
  EXPECT_EQ(bench.rig->counters(0).framesLost, 1u);
}

TEST(DeviceRig, IdsWrapStartAnywhereAndMayBeLong) {
  Bench bench({"start-id=65534@1", "start-id=4294967296@2", "ids-64@2"}, 2);
  for (int c = 0; c < 2; ++c) bench.connect(c);
  for (int c = 0; c < 2; ++c) bench.start(c);
  std::vector<std::uint64_t> ids, longIds;
  for (int n = 0; n < 4; ++n) {
    const auto shortFrame = bench.client(0).nextFrame(), longFrame = bench.client(1).nextFrame();
    ASSERT_TRUE(shortFrame && longFrame);
    EXPECT_FALSE(shortFrame->extended);
    EXPECT_TRUE(longFrame->extended);
    ids.push_back(shortFrame->id);
    longIds.push_back(longFrame->id);
    EXPECT_TRUE(showsTrigger(*longFrame, 1, static_cast<std::uint64_t>(n)));
  }
  EXPECT_EQ(ids, (std::vector<std::uint64_t>{65534, 65535, 1, 2}));
  EXPECT_EQ(longIds, (std::vector<std::uint64_t>{4294967296, 4294967297, 4294967298, 4294967299}));
}

TEST(DeviceRig, LongIdsByRequestAndResent) {
  Bench bench({"packet-loss=1:2-2"});
  bench.connect(0);
  EXPECT_EQ(bench.client().write(reg::kExtendedIds, 1), 0);
  bench.start();
  ASSERT_TRUE(bench.client().nextFrame()->extended);
  ASSERT_TRUE(bench.client().nextFrame());
  EXPECT_EQ(bench.client().nextFrame()->id, 4u);  // nothing of the third has come
  bench.client().requestResend(3, 0, 3, true);    // and it is lost again, at that rate
  EXPECT_TRUE(bench.eventually([&] { return bench.rig->counters(0).stream.resendRequests == 1; }));
  EXPECT_EQ(bench.rig->counters(0).stream.packetsResent, 0u);
  bench.client().requestResend(4, 0, 3, true);
  EXPECT_TRUE(bench.eventually([&] { return bench.rig->counters(0).stream.packetsResent == 4; }));
}

TEST(DeviceRig, ResetIdsBeginAgainWithEveryStart) {
  Bench bench({"reset-ids"});
  bench.connect(0);
  for (int round = 0; round < 2; ++round) {
    bench.start();
    EXPECT_EQ(bench.client().nextFrame()->id, 1u);
    bench.stop();
    ASSERT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() == 0; }));
    while (bench.client().receivePacket(50ms) != nullptr) {
    }
    bench.client().frames.clear();
  }
}

TEST(DeviceRig, ResendsMayBeMissingOrIgnored) {
  Bench bench({"no-resend@1", "ignore-resend@2", "packet-loss=0.3"}, 2);
  for (int c = 0; c < 2; ++c) {
    bench.connect(c);
    EXPECT_EQ((*bench.client(c).read(reg::kCapability) & reg::kCapabilityResend) != 0, c == 1);
  }
  for (int c = 0; c < 2; ++c) bench.start(c);
  for (int c = 0; c < 2; ++c) {
    ASSERT_NE(bench.client(c).receivePacket(), nullptr);
    bench.client(c).requestResend(1, 0, 5);
  }
  EXPECT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() > 20; }));
  for (int c = 0; c < 2; ++c) EXPECT_EQ(bench.rig->counters(c).stream.packetsResent, 0u);
}

TEST(DeviceRig, ACameraDiesAndComesBackWithoutMemory) {
  Bench bench({"die@2:10-39"}, 2);
  for (int c = 0; c < 2; ++c) bench.connect(c);
  for (int c = 0; c < 2; ++c) bench.enableChunks(c);
  for (int c = 0; c < 2; ++c) bench.start(c);
  for (std::uint64_t t = 0; t < 10; ++t) EXPECT_EQ(bench.client(1).nextFrame()->timestamp, t);
  ASSERT_TRUE(bench.eventually([&] { return bench.rig->counters(1).deaths == 1; }));
  EXPECT_FALSE(bench.client(1).ask(0x0002, {}, 100ms));  // not even to who it is
  // It comes back as it was made, free for anybody, while the other goes on.
  ASSERT_TRUE(bench.eventually([&] { return bench.client(1).ask(0x0002, {}, 50ms).has_value(); }));
  EXPECT_GE(bench.rig->nextTrigger(), 40u);
  EXPECT_EQ(bench.client(1).read(reg::kControlPrivilege), 0u);
  EXPECT_EQ(bench.client(1).read(reg::kTriggerMode), 0u);
  bench.client(1).frames.clear();
  bench.connect(1);
  bench.enableChunks(1);
  bench.start(1);
  const auto frame = bench.client(1).nextFrame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->id, 1u);
  EXPECT_LT(frame->timestamp, 40u);  // its own counter has begun again
  const auto count = frame->chunk(ChunkId::EncoderCount);
  ASSERT_TRUE(count);
  EXPECT_GE(*count, 40u);  // the encoder's has not
  EXPECT_TRUE(showsTrigger(*frame, 1, *count));
  EXPECT_EQ(bench.rig->counters(1).deaths, 1u);
  // The other has missed nothing.
  for (std::uint64_t t = 0; t <= *count; ++t) {
    const auto other = bench.client(0).nextFrame();
    ASSERT_TRUE(other);
    EXPECT_EQ(other->timestamp, t);
  }
}

TEST(DeviceRig, TheOnlyCameraComesBackIntoTheSameRun) {
  Bench bench({"die:5-20"});
  bench.connect(0);
  bench.start();
  for (int t = 0; t < 5; ++t) ASSERT_TRUE(bench.client().nextFrame());
  ASSERT_TRUE(bench.eventually([&] { return bench.rig->counters(0).deaths == 1; }));
  ASSERT_TRUE(bench.eventually([&] { return bench.client().ask(0x0002, {}, 30ms).has_value(); }));
  bench.client().frames.clear();
  bench.connect(0);
  bench.enableChunks(0);
  bench.start();
  const auto frame = bench.client().nextFrame();
  ASSERT_TRUE(frame);
  EXPECT_GT(*frame->chunk(ChunkId::EncoderCount), 20u);
  EXPECT_EQ(bench.rig->encoder().runs, 1u);
}

TEST(DeviceRig, AMuteCameraStreamsOn) {
  Bench bench({"mute-control:5-60"});
  bench.connect(0);
  EXPECT_EQ(bench.client().write(reg::kHeartbeatTimeout, 500), 0);
  bench.start();
  std::uint64_t last = 0;
  while (last < 10) last = bench.client().nextFrame()->timestamp;
  EXPECT_FALSE(bench.client().ask(0x0080, {0, 0, 0x0a, 0}, 100ms));
  while (last < 60) {
    const auto frame = bench.client().nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->timestamp, last + 1);
    last = frame->timestamp;
  }
  // It hears again, and the controller is still known.
  ASSERT_TRUE(bench.eventually([&] { return bench.client().ask(0x0002, {}, 30ms).has_value(); }));
  EXPECT_EQ(bench.client().read(reg::kControlPrivilege), 2u);
  EXPECT_TRUE(bench.client().nextFrame());
}

TEST(DeviceRig, ASilentClientIsGivenUpAndTheNextMayCome) {
  Bench bench;
  bench.connect(0);
  EXPECT_EQ(bench.client().write(reg::kHeartbeatTimeout, 500), 0);
  bench.start();
  ASSERT_TRUE(bench.client().nextFrame());
  Client second(bench.rig->address(0));
  EXPECT_EQ(second.write(reg::kControlPrivilege, 2), 0x8006);
  EXPECT_EQ(second.write(reg::kGain, 0), 0x8006);
  EXPECT_EQ(second.read(reg::kTriggerMode), 1u);
  EXPECT_TRUE(bench.eventually([&] { return second.write(reg::kControlPrivilege, 2) == 0; }));
  EXPECT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() == 0; }));
}

TEST(DeviceRig, ATriggerWithinTheExposureIsIgnored) {
  Bench bench;  // 100 Hz
  bench.connect(0);
  EXPECT_EQ(bench.client().write(reg::kExposureTime, std::bit_cast<std::uint32_t>(10000.0f)), 0);
  bench.start();
  for (std::uint64_t t = 0; t < 5; ++t) EXPECT_EQ(bench.client().nextFrame()->timestamp, t);
  EXPECT_EQ(bench.client().write(reg::kExposureTime, std::bit_cast<std::uint32_t>(10500.0f)), 0);
  ASSERT_TRUE(bench.eventually([&] { return bench.rig->counters(0).triggersIgnored > 3; }));
  std::vector<std::uint64_t> counts;
  while (counts.size() < 10) counts.push_back(bench.client().nextFrame()->timestamp);
  EXPECT_EQ(counts[9] - counts[8], 2u);
}

TEST(DeviceRig, ASlowCameraIgnoresTriggersAndHoldsNobodyUp) {
  Bench bench({"slow=60@2"}, 2);
  for (int c = 0; c < 2; ++c) bench.connect(c);
  for (int c = 0; c < 2; ++c) bench.start(c);
  for (std::uint64_t t = 0; t < 40; ++t) EXPECT_EQ(bench.client(0).nextFrame()->timestamp, t);
  EXPECT_GT(bench.rig->counters(1).triggersIgnored, 10u);
  EXPECT_EQ(bench.rig->counters(0).triggersIgnored, 0u);
  std::uint64_t id = 0;
  for (int n = 0; n < 4; ++n) {
    const auto frame = bench.client(1).nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->id, ++id);
    EXPECT_TRUE(showsTrigger(*frame, 1, frame->timestamp));
  }
}

TEST(DeviceRig, ACorruptLeaderIsOnlyThat) {
  Bench bench({"corrupt-leader:1-1"});
  bench.connect(0);
  bench.start();
  const auto good = bench.client().nextFrame(), bad = bench.client().nextFrame(), next = bench.client().nextFrame();
  ASSERT_TRUE(good && bad && next);
  EXPECT_EQ(good->width, static_cast<std::uint32_t>(kWidth));
  EXPECT_NE(bad->width, static_cast<std::uint32_t>(kWidth));
  EXPECT_EQ(bad->payload().size(), static_cast<std::size_t>(kWidth * kHeight));
  EXPECT_TRUE(showsTrigger(*next, 0, 2));
}

TEST(DeviceRig, FaultsCanBeAddedWhileItRuns) {
  Bench bench;
  bench.connect(0);
  bench.start();
  ASSERT_TRUE(bench.client().nextFrame());
  const std::uint64_t from = bench.rig->nextTrigger() + 5;
  bench.rig->addFaults(
      *parseFaultLine(std::to_string(from) + "-" + std::to_string(from + 2) + ": missed-trigger=1", 0, "test"));
  std::vector<std::uint64_t> counts;
  while (counts.empty() || counts.back() < from + 6) counts.push_back(bench.client().nextFrame()->timestamp);
  for (std::uint64_t t = from; t <= from + 2; ++t) EXPECT_EQ(std::count(counts.begin(), counts.end(), t), 0) << t;
  EXPECT_EQ(bench.rig->counters(0).triggersMissed, 3u);
}

TEST(DeviceRig, TheEncoderRestsBehindTheLastRail) {
  Bench bench({}, 1, 100, 6);
  bench.connect(0);
  bench.start();
  for (std::uint64_t t = 0; t < 6; ++t) EXPECT_EQ(bench.client().nextFrame()->timestamp, t);
  EXPECT_FALSE(bench.client().nextFrame(150ms));
  EXPECT_EQ(bench.rig->nextTrigger(), 6u);
  EXPECT_EQ(bench.client().read(reg::kEncoderCount + 4), 6u);
  bench.stop();
  EXPECT_TRUE(bench.eventually([&] { return bench.rig->nextTrigger() == 0; }));
}

TEST(DeviceRig, Line2TriggersOnTheHeadOfARail) {
  Bench bench({}, 1, 100, 20);
  bench.connect(0);
  EXPECT_EQ(bench.client().write(reg::kTriggerSource, 1), 0);
  bench.start();
  const auto first = bench.client().nextFrame(), second = bench.client().nextFrame();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->timestamp, 0u);
  EXPECT_EQ(second->timestamp, 8u);
  EXPECT_FALSE(bench.client().nextFrame(200ms));
}

TEST(DeviceRig, AFrameTakesTheTimeOfItsWire) {
  DeviceRigSettings s;
  s.cameras = 1;
  s.firstAddress = raw::freeAddress();
  s.widthPx = kWidth;
  s.heightPx = kHeight;
  s.gbps = 0.001;  // 12,288 bytes and what goes with them: 0.1 s
  auto rig = DeviceRig::start(s, std::make_shared<Pattern>());
  ASSERT_TRUE(rig) << rig.error().message();
  Client client((*rig)->address(0));
  ASSERT_TRUE(client.takeControl());
  client.openStream(1500);
  EXPECT_EQ(client.write(reg::kAcquisitionMode, 1), 0);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(client.write(reg::kAcquisitionStart, 1), 0);
  ASSERT_TRUE(client.nextFrame());
  const double wireS = (9 * (38 + 28 + 8) + kWidth * kHeight + 2 * (38 + 28 + 8) + 36 + 8) * 8 / 1e6;
  EXPECT_GE(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), wireS - 1e-3);
}

TEST(DeviceRig, StrangeDatagramsDoNotDisturbIt) {
  Bench bench;
  bench.connect(0);
  bench.start();
  raw::Socket stranger;
  std::uint64_t last = 0;
  for (int i = 0; i < 300; ++i) {
    Octets datagram(static_cast<std::size_t>(i * 7 % 600));
    for (std::size_t k = 0; k < datagram.size(); ++k) datagram[k] = static_cast<std::uint8_t>(i * 31 + k * k);
    if (i % 2 == 0 && !datagram.empty()) datagram[0] = 0x42;
    stranger.send(bench.rig->address(0), datagram);
  }
  for (int n = 0; n < 20; ++n) {
    const auto frame = bench.client().nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(n == 0 || frame->timestamp == last + 1);
    last = frame->timestamp;
  }
}

TEST(DeviceRig, SaysWhatItCannotDo) {
  const auto refused = [](const std::string& address, int cameras, double rate) {
    DeviceRigSettings s;
    s.firstAddress = address;
    s.cameras = cameras;
    s.rateHz = rate;
    auto rig = DeviceRig::start(s, std::make_shared<Pattern>());
    EXPECT_FALSE(rig);
    return rig ? std::string() : rig.error().message();
  };
  EXPECT_NE(refused("192.168.1.1", 4, 20).find("loopback"), std::string::npos);
  EXPECT_NE(refused("127.0.0", 4, 20).find("no address"), std::string::npos);
  EXPECT_NE(refused("127.255.255.254", 4, 20).find("loopback"), std::string::npos);
  refused("127.0.0.11", 5, 20);
  refused("127.0.0.11", 4, 0);
  Bench bench;
  const std::string taken = refused(bench.settings.firstAddress, 1, 20);
  EXPECT_NE(taken.find("taken"), std::string::npos) << taken;
}

TEST(DeviceRig, IsGoneAtOnceWhileItStreams) {
  const auto begin = std::chrono::steady_clock::now();
  {
    Bench bench({"slow=60000@1"}, 2);
    for (int c = 0; c < 2; ++c) bench.connect(c);
    for (int c = 0; c < 2; ++c) bench.start(c);
    ASSERT_TRUE(bench.client(1).nextFrame());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

}  // namespace
}  // namespace vignole::gige_device
