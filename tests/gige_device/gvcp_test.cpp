// GVCP by hand-made datagrams.

#include "engine/gige_device/gvcp.h"

#include <gtest/gtest.h>

namespace vignole::gige_device {
namespace {

TEST(Gvcp, ReadsACommand) {
  const Bytes datagram = {0x42, 0x01, 0x00, 0x80, 0x00, 0x04, 0x12, 0x34, 0x00, 0x00, 0x0a, 0x00};
  const auto command = readCommand(datagram);
  ASSERT_TRUE(command);
  EXPECT_EQ(command->command, 0x0080);
  EXPECT_EQ(command->id, 0x1234);
  EXPECT_TRUE(command->answerWanted());
  EXPECT_TRUE(command->complete);
  ASSERT_EQ(command->payload.size(), 4u);
  EXPECT_EQ(readBe32(command->payload, 0), 0x0a00u);
}

TEST(Gvcp, WhatIsNoCommandIsNone) {
  EXPECT_FALSE(readCommand(Bytes{}));
  EXPECT_FALSE(readCommand(Bytes{0x42, 0x01, 0x00, 0x80, 0x00, 0x00, 0x00}));        // 7 bytes
  EXPECT_FALSE(readCommand(Bytes{0x41, 0x01, 0x00, 0x80, 0x00, 0x00, 0x00, 0x01}));  // key
  EXPECT_FALSE(readCommand(Bytes{0x42, 0x01, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00}));  // id 0
}

TEST(Gvcp, ACutCommandIsKnownAsSuch) {
  const auto command = readCommand(Bytes{0x42, 0x01, 0x00, 0x80, 0x00, 0x08, 0x00, 0x01, 1, 2, 3});
  ASSERT_TRUE(command);
  EXPECT_FALSE(command->complete);
  EXPECT_EQ(command->payload.size(), 3u);
  // What comes behind the announced payload is not of it.
  const auto longer = readCommand(Bytes{0x42, 0x01, 0x00, 0x80, 0x00, 0x01, 0x00, 0x01, 1, 2, 3});
  ASSERT_TRUE(longer);
  EXPECT_TRUE(longer->complete);
  EXPECT_EQ(longer->payload.size(), 1u);
}

TEST(Gvcp, AcknowledgesWithStatusCommandLengthAndId) {
  GvcpCommand command;
  command.command = 0x0084;
  command.id = 0xabcd;
  const Bytes payload = {1, 2, 3, 4};
  EXPECT_EQ(acknowledge(command, GvcpStatus::Success, payload),
            (Bytes{0x00, 0x00, 0x00, 0x85, 0x00, 0x04, 0xab, 0xcd, 1, 2, 3, 4}));
  EXPECT_EQ(acknowledge(command, GvcpStatus::AccessDenied, payload),
            (Bytes{0x80, 0x06, 0x00, 0x85, 0x00, 0x00, 0xab, 0xcd}));
}

TEST(Gvcp, ReadsResendRequestsOfBothKindsOfIds) {
  GvcpCommand command;
  const Bytes standard = {0, 0, 0x12, 0x34, 0xff, 0, 0, 5, 0, 0, 0, 9};
  command.payload = standard;
  auto request = readResendRequest(command);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->frameId, 0x1234u);
  EXPECT_EQ(request->firstPacket, 5u);  // 24 bits
  EXPECT_EQ(request->lastPacket, 9u);

  command.flags = 0x10;
  EXPECT_FALSE(readResendRequest(command));  // lacks its 64 bits
  const Bytes extended = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 7, 0, 0, 0, 8};
  command.payload = extended;
  request = readResendRequest(command);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->frameId, 0x700000008u);

  command.flags = 0;
  const Bytes otherStream = {0, 1, 0x12, 0x34, 0, 0, 0, 5, 0, 0, 0, 9},
              backwards = {0, 0, 0, 1, 0, 0, 0, 5, 0, 0, 0, 4};
  command.payload = otherStream;
  EXPECT_FALSE(readResendRequest(command));
  command.payload = backwards;
  EXPECT_FALSE(readResendRequest(command));
  command.payload = ByteView(standard).first(11);
  EXPECT_FALSE(readResendRequest(command));
}

}  // namespace
}  // namespace vignole::gige_device
