// Registers, the control privilege and its heartbeat, with a clock that the test turns.

#include "engine/gige_device/control_channel.h"

#include <bit>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "engine/gige_device/feature_description.h"
#include "tests/gige_device/raw_client.h"

namespace vignole::gige_device {
namespace {

using namespace std::chrono_literals;
using Kind = ControlEvent::Kind;

class ControlChannelTest : public ::testing::Test {
 protected:
  ControlChannel::Answer ask(std::uint16_t command, const raw::Octets& payload, Peer from) {
    return channel.handle(raw::gvcp(command, payload, ++id), from, now);
  }
  std::uint16_t status(const ControlChannel::Answer& a) const {
    return a.datagram.empty() ? 0xffff : readBe16(a.datagram, 0);
  }
  std::uint16_t write(std::uint32_t address, std::uint32_t value, Peer from) {
    raw::Octets payload;
    raw::append32(payload, address);
    raw::append32(payload, value);
    auto answer = ask(0x0082, payload, from);
    events = answer.events;
    return status(answer);
  }
  std::optional<std::uint32_t> read(std::uint32_t address, Peer from) {
    raw::Octets payload;
    raw::append32(payload, address);
    const auto answer = ask(0x0080, payload, from);
    if (status(answer) != 0) return {};
    return readBe32(answer.datagram, 8);
  }

  static CameraIdentity identity() {
    CameraIdentity who;
    who.serial = "S1";
    who.userName = "camera1";
    who.address = 0x7f00000b;
    return who;
  }

  LiveValues live;
  ControlChannel channel{identity(), [this](ControlChannel::Time) { return live; }};
  ControlChannel::Time now{1000s};
  const Peer first{0x7f000001, 50000}, second{0x7f000001, 50001};
  std::uint16_t id = 0;
  std::vector<ControlEvent> events;
};

TEST_F(ControlChannelTest, DiscoveryTellsWhoItIs) {
  const auto answer = ask(0x0002, {}, first);
  ASSERT_EQ(answer.datagram.size(), 8u + 0xf8);
  EXPECT_EQ(readBe16(answer.datagram, 2), 0x0003);
  const auto text = [&](std::size_t at) {
    return std::string(reinterpret_cast<const char*>(&answer.datagram[8 + at]));
  };
  EXPECT_EQ(text(0x48), "DALSA");
  EXPECT_EQ(text(0x68), "Genie HM1400");
  EXPECT_EQ(text(0xd8), "S1");
  EXPECT_EQ(text(0xe8), "camera1");
  EXPECT_EQ(readBe32(answer.datagram, 8 + 0x24), 0x7f00000bu);
}

TEST_F(ControlChannelTest, WritesNeedThePrivilege) {
  EXPECT_EQ(write(reg::kWidth, 640, first), 0x8006);
  EXPECT_EQ(read(reg::kWidth, first), 1400u);
  EXPECT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  EXPECT_EQ(write(reg::kWidth, 640, first), 0);
  EXPECT_EQ(read(reg::kWidth, first), 640u);
  // A second application reads, but does not write, and cannot take over.
  EXPECT_EQ(read(reg::kWidth, second), 640u);
  EXPECT_EQ(write(reg::kWidth, 320, second), 0x8006);
  EXPECT_EQ(write(reg::kControlPrivilege, 2, second), 0x8006);
  EXPECT_EQ(write(reg::kControlPrivilege, 0, second), 0x8006);
  // The same address with another port is another application.
  EXPECT_EQ(read(reg::kControlPrivilege, second), 2u);
  EXPECT_EQ(read(reg::kPrimaryPort, second), 50000u);
  // Left by the first, it is free.
  EXPECT_EQ(write(reg::kControlPrivilege, 0, first), 0);
  EXPECT_EQ(write(reg::kControlPrivilege, 2, second), 0);
}

TEST_F(ControlChannelTest, ExclusiveAccessKeepsReadersOut) {
  EXPECT_EQ(write(reg::kControlPrivilege, 1, first), 0);
  EXPECT_FALSE(read(reg::kWidth, second));
  EXPECT_EQ(read(reg::kControlPrivilege, second), 1u);
  EXPECT_EQ(read(reg::kWidth, first), 1400u);
}

TEST_F(ControlChannelTest, ASilentControllerIsGivenUp) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  ASSERT_EQ(write(reg::kStreamPort, 1234, first), 0);
  now += 2900ms;
  EXPECT_TRUE(channel.expire(now).empty());
  EXPECT_EQ(read(reg::kControlPrivilege, first), 2u);  // the heartbeat: any command of the controller
  now += 2900ms;
  EXPECT_EQ(read(reg::kControlPrivilege, second), 2u);  // is not one of somebody else
  EXPECT_TRUE(channel.expire(now).empty());
  now += 200ms;
  const auto lost = channel.expire(now);
  ASSERT_FALSE(lost.empty());
  EXPECT_EQ(lost.front().kind, Kind::AcquisitionStop);
  EXPECT_FALSE(channel.controller());
  EXPECT_EQ(channel.streamSettings().port, 0);
  EXPECT_EQ(write(reg::kWidth, 640, first), 0x8006);
  EXPECT_EQ(write(reg::kControlPrivilege, 2, second), 0);
}

TEST_F(ControlChannelTest, TheHeartbeatsTimeIsWritable) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  EXPECT_EQ(write(reg::kHeartbeatTimeout, 1000, first), 0);
  now += 1001ms;
  EXPECT_FALSE(channel.expire(now).empty());
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  EXPECT_EQ(write(reg::kHeartbeatTimeout, 1, first), 0);  // the nearest that there is
  EXPECT_EQ(read(reg::kHeartbeatTimeout, first), 500u);
  now += 10s;
  channel.keepAlive(now);
  EXPECT_TRUE(channel.expire(now).empty());
}

TEST_F(ControlChannelTest, RegistersRefuseWhatTheyCannotDo) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  EXPECT_EQ(write(reg::kWidth, 1404, first), 0x8002);
  EXPECT_EQ(write(reg::kWidth, 0, first), 0x8002);
  EXPECT_EQ(write(reg::kWidth, 402, first), 0x8002);
  EXPECT_EQ(write(reg::kOffsetX, 4, first), 0x8002);  // no room at full width
  EXPECT_EQ(write(reg::kWidth, 1000, first), 0);
  EXPECT_EQ(write(reg::kOffsetX, 400, first), 0);
  EXPECT_EQ(write(reg::kWidth, 1004, first), 0x8002);
  EXPECT_EQ(write(reg::kPacketSize, 575, first), 0x8002);
  EXPECT_EQ(write(reg::kPacketSize, 9004, first), 0x8002);
  EXPECT_EQ(write(reg::kPacketSize, 8192, first), 0);
  EXPECT_EQ(write(reg::kPixelFormat, 0x01100003, first), 0x8002);
  EXPECT_EQ(write(reg::kExposureTime, std::bit_cast<std::uint32_t>(std::nanf("")), first), 0x8002);
  EXPECT_EQ(write(reg::kExposureTime, std::bit_cast<std::uint32_t>(-1.0f), first), 0x8002);
  EXPECT_EQ(write(reg::kExposureTime, std::bit_cast<std::uint32_t>(15000.0f), first), 0);
  EXPECT_DOUBLE_EQ(channel.streamSettings().exposureUs, 15000);
  EXPECT_EQ(write(reg::kTriggerSource, 3, first), 0x8002);
  EXPECT_EQ(write(reg::kVendor, 0, first), 0x8004);
  EXPECT_EQ(write(reg::kSensorWidth, 1, first), 0x8004);
  EXPECT_EQ(write(0xa001, 1, first), 0x8005);
  EXPECT_EQ(write(0x5000, 1, first), 0x8003);
  EXPECT_EQ(write(0xfffffffc, 1, first), 0x8003);
  EXPECT_FALSE(read(0x5000, first));
  EXPECT_FALSE(read(0xfffffffc, first));
  EXPECT_EQ(status(ask(0x0090, {}, first)), 0x8001);
}

TEST_F(ControlChannelTest, WhatMakesAFrameIsLockedWhileFramesCome) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  channel.setAcquiring(true);
  EXPECT_EQ(write(reg::kWidth, 640, first), 0x8007);
  EXPECT_EQ(write(reg::kChunkModeActive, 1, first), 0x8007);
  EXPECT_EQ(write(reg::kGain, std::bit_cast<std::uint32_t>(3.0f), first), 0);
  channel.setAcquiring(false);
  EXPECT_EQ(write(reg::kWidth, 640, first), 0);
}

TEST_F(ControlChannelTest, ThePayloadFollowsRegionAndChunks) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  EXPECT_EQ(read(reg::kPayloadSize, first), 1400u * 1024);
  ASSERT_EQ(write(reg::kHeight, 512, first), 0);
  EXPECT_EQ(read(reg::kPayloadSize, first), 1400u * 512);
  ASSERT_EQ(write(reg::kChunkEnable + 4, 1, first), 0);  // changes nothing until the mode is on
  EXPECT_EQ(read(reg::kPayloadSize, first), 1400u * 512);
  ASSERT_EQ(write(reg::kChunkModeActive, 1, first), 0);
  EXPECT_EQ(read(reg::kPayloadSize, first), 1400u * 512 + 8 + 16);
  EXPECT_EQ(write(reg::kChunkEnable, 0, first), 0);  // the image cannot be left out
  EXPECT_EQ(read(reg::kChunkEnable, first), 1u);
}

TEST_F(ControlChannelTest, CommandsBecomeEvents) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  const auto kindOf = [&](std::uint32_t address, std::uint32_t value) {
    EXPECT_EQ(write(address, value, first), 0);
    return events.size() == 1 ? std::optional(events.front().kind) : std::nullopt;
  };
  EXPECT_EQ(kindOf(reg::kAcquisitionStart, 1), Kind::AcquisitionStart);
  EXPECT_EQ(kindOf(reg::kAcquisitionStop, 1), Kind::AcquisitionStop);
  EXPECT_EQ(kindOf(reg::kTriggerSoftware, 1), Kind::SoftwareTrigger);
  EXPECT_EQ(kindOf(reg::kPacketSize, 0x80000000u | 2000), Kind::FireTestPacket);
  EXPECT_EQ(read(reg::kPacketSize, first), 2000u);  // the bit does not stay
  EXPECT_EQ(kindOf(reg::kTimestampControl, 1), Kind::TimestampReset);
  EXPECT_EQ(kindOf(reg::kStreamPort, 0), Kind::StreamClosed);
  live.timestamp = 0x123456789a;
  EXPECT_EQ(kindOf(reg::kTimestampControl, 2), std::nullopt);  // latched
  EXPECT_EQ(read(reg::kTimestampHigh, first), 0x12u);
  EXPECT_EQ(read(reg::kTimestampLow, first), 0x3456789au);
}

TEST_F(ControlChannelTest, ARepeatedWriteHappensOnce) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  raw::Octets payload;
  raw::append32(payload, reg::kTriggerSoftware);
  raw::append32(payload, 1);
  const raw::Octets datagram = raw::gvcp(0x0082, payload, 77);
  EXPECT_EQ(channel.handle(datagram, first, now).events.size(), 1u);
  now += 400ms;
  const auto again = channel.handle(datagram, first, now);
  EXPECT_TRUE(again.events.empty());
  EXPECT_EQ(status(again), 0);
  now += 1s;
  EXPECT_EQ(channel.handle(datagram, first, now).events.size(), 1u);
}

TEST_F(ControlChannelTest, SeveralRegistersAtOnce) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  raw::Octets payload;
  for (const std::uint32_t v : {reg::kWidth, 640u, reg::kHeight, 2000u}) raw::append32(payload, v);
  EXPECT_EQ(status(ask(0x0082, payload, first)), 0x8002);
  payload.clear();
  for (const std::uint32_t v : {reg::kWidth, reg::kHeight}) raw::append32(payload, v);
  const auto answer = ask(0x0080, payload, first);
  ASSERT_EQ(answer.datagram.size(), 16u);
  EXPECT_EQ(readBe32(answer.datagram, 8), 640u);
  EXPECT_EQ(readBe32(answer.datagram, 12), 1024u);
}

TEST_F(ControlChannelTest, MemoryHoldsTheDescriptionAndTheUsersName) {
  // The URL says where the description is; read in pieces it is the one that was made.
  raw::Octets payload;
  raw::append32(payload, reg::kFirstUrl);
  raw::append32(payload, 512);
  auto answer = ask(0x0084, payload, first);
  ASSERT_EQ(answer.datagram.size(), 8u + 4 + 512);
  const std::string url(reinterpret_cast<const char*>(&answer.datagram[12]));
  unsigned address = 0, size = 0;
  ASSERT_EQ(std::sscanf(url.c_str(), "Local:vignole_genie.xml;%x;%x", &address, &size), 2) << url;
  std::string description;
  for (unsigned at = 0; at < size; at += 512) {
    payload.clear();
    raw::append32(payload, address + at);
    raw::append32(payload, std::min(512u, size - at));
    answer = ask(0x0084, payload, first);
    ASSERT_EQ(status(answer), 0);
    description.append(answer.datagram.begin() + 12, answer.datagram.end());
  }
  EXPECT_EQ(description, featureDescription(1400, 1024));

  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  payload.clear();
  raw::append32(payload, reg::kUserName);
  for (const char c : std::string("north foot\0\0", 12)) payload.push_back(static_cast<std::uint8_t>(c));
  EXPECT_EQ(status(ask(0x0086, payload, first)), 0);
  const auto found = ask(0x0002, {}, second);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(&found.datagram[8 + 0xe8])), "north foot");
}

TEST_F(ControlChannelTest, ResendsAreAskedForByTheStreamsOwner) {
  raw::Octets payload = {0, 0, 0, 7, 0, 0, 0, 1, 0, 0, 0, 2};
  EXPECT_TRUE(channel.handle(raw::gvcp(0x0040, payload, ++id, 0), first, now).events.empty());
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  ASSERT_EQ(write(reg::kStreamAddress, first.address, first), 0);
  const auto answer = channel.handle(raw::gvcp(0x0040, payload, ++id, 0), {first.address, 4711}, now);
  ASSERT_EQ(answer.events.size(), 1u);
  EXPECT_EQ(answer.events.front().resend.frameId, 7u);
  EXPECT_TRUE(answer.datagram.empty());
  EXPECT_TRUE(channel.handle(raw::gvcp(0x0040, payload, ++id, 0), {0x7f000009, 4711}, now).events.empty());
}

TEST_F(ControlChannelTest, ResendCapabilityIsAsTheFaultHasIt) {
  EXPECT_NE(*read(reg::kCapability, first) & reg::kCapabilityResend, 0u);
  live.resendOffered = false;
  EXPECT_EQ(*read(reg::kCapability, first) & reg::kCapabilityResend, 0u);
}

TEST_F(ControlChannelTest, PowerOffForgetsAll) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  ASSERT_EQ(write(reg::kWidth, 640, first), 0);
  channel.reset();
  EXPECT_FALSE(channel.controller());
  EXPECT_EQ(read(reg::kWidth, second), 1400u);
}

TEST_F(ControlChannelTest, MalformedDatagramsAreAnsweredOrIgnoredButNeverKill) {
  ASSERT_EQ(write(reg::kControlPrivilege, 2, first), 0);
  std::mt19937 random(1);
  const std::vector<std::uint16_t> commands = {0x0002, 0x0004, 0x0040, 0x0080, 0x0082, 0x0084, 0x0086, 0x00c0, 0xffff};
  std::size_t answered = 0;
  for (int i = 0; i < 200000; ++i) {
    raw::Octets payload(random() % 24);
    for (auto& byte : payload) byte = static_cast<std::uint8_t>(random());
    // Half of them near real addresses, or they would all end at the first check.
    if (payload.size() >= 4 && i % 2 == 0) {
      const std::uint32_t near[] = {0x0000, 0x0d00, 0x0a00, 0x0ff8, 0xa000, 0xa0c0, 0xa1fc, 0x80000, 0x87ff0};
      const std::uint32_t address = near[random() % 9] + random() % 64;
      putBe32(payload.data(), address);
    }
    raw::Octets datagram = raw::gvcp(commands[random() % commands.size()], payload,
                                     static_cast<std::uint16_t>(random()), static_cast<std::uint8_t>(random()));
    if (i % 5 == 0) putBe16(&datagram[4], static_cast<std::uint16_t>(random()));
    if (i % 7 == 0) datagram.resize(random() % (datagram.size() + 1));
    const auto answer = channel.handle(datagram, i % 3 == 0 ? second : first, now);
    EXPECT_LE(answer.datagram.size(), 8u + 4 + kMaxMemoryBytes);
    answered += answer.datagram.empty() ? 0 : 1;
  }
  EXPECT_GT(answered, 10000u);
  // It still is a camera, with a frame that it can make.
  const StreamSettings s = channel.streamSettings();
  EXPECT_GT(s.width, 0);
  EXPECT_LE(s.offsetX + s.width, 1400);
  EXPECT_LE(s.offsetY + s.height, 1024);
  EXPECT_GE(s.packetBytes, kMinPacketSize);
  EXPECT_FALSE(ask(0x0002, {}, first).datagram.empty());
}

}  // namespace
}  // namespace vignole::gige_device
