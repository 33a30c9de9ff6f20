// GVSP packets, byte by byte.

#include "engine/gige_device/gvsp.h"

#include <gtest/gtest.h>

namespace vignole::gige_device {
namespace {

TEST(Gvsp, HeadersOfBothKindsOfIds) {
  Bytes standard(8);
  putGvspHeader(standard.data(), false, 0, 0xfff0, 0x010203, GvspContent::Payload);
  EXPECT_EQ(standard, (Bytes{0, 0, 0xff, 0xf0, 0x03, 0x01, 0x02, 0x03}));
  Bytes extended(20);
  putGvspHeader(extended.data(), true, 0x800c, 0x0102030405060708, 0x0a0b0c0d, GvspContent::Leader);
  EXPECT_EQ(extended, (Bytes{0x80, 0x0c, 0, 0, 0x81, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0x0a, 0x0b, 0x0c, 0x0d}));
}

TEST(Gvsp, SixteenBitIdsGoFrom65535To1) {
  EXPECT_EQ(idOnWire(1, false), 1u);
  EXPECT_EQ(idOnWire(65535, false), 65535u);
  EXPECT_EQ(idOnWire(65536, false), 1u);
  EXPECT_EQ(idOnWire(131070, false), 65535u);
  EXPECT_EQ(idOnWire(65536, true), 65536u);
}

TEST(Gvsp, LeaderAndTrailerOfAnImage) {
  ImageInfo info;
  info.timestamp = 0x1122334455667788;
  info.pixelFormat = 0x01080001;
  info.width = 1400;
  info.height = 1024;
  info.offsetX = 4;
  info.offsetY = 8;
  const Bytes leader = leaderContent(info);
  EXPECT_EQ(leader, (Bytes{0, 0,    0, 1, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88, 0x01, 0x08, 0, 1, 0, 0,
                           5, 0x78, 0, 0, 4,    0,    0,    0,    0,    4,    0,    0,    0,    8,    0, 0, 0, 0}));
  EXPECT_EQ(trailerContent(info), (Bytes{0, 0, 0, 1, 0, 0, 4, 0}));
  info.chunkBytes = 24;
  EXPECT_EQ(leaderContent(info)[2], 0x40);
  const Bytes trailer = trailerContent(info);
  ASSERT_EQ(trailer.size(), 16u);
  EXPECT_EQ(readBe16(trailer, 2), 0x4001);
  EXPECT_EQ(readBe32(trailer, 8), 1400u * 1024 + 24);
}

TEST(Gvsp, ChunkTagsStandBehindTheirData) {
  Bytes chunks = {9, 9};
  appendChunkTag(chunks, 0x1001, 2);
  EXPECT_EQ(chunks, (Bytes{9, 9, 0, 0, 0x10, 0x01, 0, 0, 0, 2}));
}

}  // namespace
}  // namespace vignole::gige_device
