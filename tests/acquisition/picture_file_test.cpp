// Pictures on disk: what is read, which channel is taken, what is refused and how.

#include "engine/acquisition/picture_file.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>

namespace vignole {
namespace {

namespace fs = std::filesystem;

class PictureFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("vignole_picture_" + std::to_string(::getpid()) + "_" + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  static std::string shared(const std::string& name) {
    std::ifstream in(fs::path(VIGNOLE_SHARED_DATA) / "stripes" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /// Reads, and fails the test if anything but the result comes out.
  static Expected<Picture> quietly(const fs::path& path, Channel channel = Channel::Auto) {
    testing::internal::CaptureStderr();
    auto result = readPicture(path, channel);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    if (!result) {
      EXPECT_EQ(result.error().message().find('\n'), std::string::npos);
    }
    return result;
  }

  fs::path folder_;
};

std::string bigEndian16(int value) { return {static_cast<char>(value >> 8), static_cast<char>(value & 255)}; }

TEST_F(PictureFile, GreyIsTakenAsItIs) {
  const auto picture =
      quietly(file("a.pgm", std::string("P5\n3 2\n255\n") + std::string("\x00\x01\x02\x7F\x80\xFF", 6)));
  ASSERT_TRUE(picture.has_value()) << picture.error().message();
  EXPECT_EQ(picture->width, 3);
  EXPECT_EQ(picture->height, 2);
  EXPECT_EQ(picture->pixels, (std::vector<std::uint8_t>{0, 1, 2, 0x7F, 0x80, 0xFF}));
  EXPECT_EQ(picture->channel, Channel::Grey);
}

TEST_F(PictureFile, TheNamedChannelIsTaken) {
  const fs::path path = file("a.ppm", "P6\n1 1\n255\n\x0A\x14\x1E");
  const auto value = [&](Channel channel) { return quietly(path, channel)->pixels.at(0); };
  EXPECT_EQ(value(Channel::Red), 10);
  EXPECT_EQ(value(Channel::Green), 20);
  EXPECT_EQ(value(Channel::Blue), 30);
  EXPECT_EQ(value(Channel::Grey), 18);  // 0.299 R + 0.587 G + 0.114 B
}

TEST_F(PictureFile, SixteenBitsAreScaledFromTheLeastDepthThatHoldsThem) {
  const auto read = [&](int a, int b) {
    const auto picture = quietly(file("a.pgm", "P5\n2 1\n65535\n" + bigEndian16(a) + bigEndian16(b)));
    return picture->pixels;
  };
  EXPECT_EQ(read(0, 65535), (std::vector<std::uint8_t>{0, 255}));
  EXPECT_EQ(read(2048, 4095), (std::vector<std::uint8_t>{128, 255}));  // 12 bits
  EXPECT_EQ(read(512, 1023), (std::vector<std::uint8_t>{128, 255}));   // 10 bits
}

TEST_F(PictureFile, WhatCannotBeReadIsSaidInOneLine) {
  const auto refused = [](const fs::path& path, const std::string& words) {
    const auto picture = quietly(path);
    ASSERT_FALSE(picture.has_value()) << path;
    EXPECT_EQ(picture.error().where, path.string());
    EXPECT_NE(picture.error().what.find(words), std::string::npos) << picture.error().message();
    EXPECT_EQ(picture.error().kind, ErrorKind::Input);
  };
  refused(folder_ / "none.png", "no such file");
  refused(folder_, "folder");
  refused(file("zero.png", ""), "empty");
  refused(file("text.png", "this is not a picture"), "not a picture");
  refused(file("short.pgm", "P5\n300 200\n255\nxx"), "cut off");
  refused(file("huge.pgm", "P5\n99999999 99999999\n255\nxx"), "");
}

TEST_F(PictureFile, CutOffFilesAreRefusedWithoutChatter) {
  for (const char* name : {"bust_laser.png", "tunnel_wall.jpg", "coil_on_cloth.bmp"}) {
    const std::string bytes = shared(name);
    if (bytes.empty()) GTEST_SKIP() << "no " << VIGNOLE_SHARED_DATA << "/stripes/" << name;
    for (const double share : {0.0001, 0.02, 0.5, 0.97}) {
      const auto length = static_cast<std::size_t>(share * static_cast<double>(bytes.size())) + 2;
      const auto picture = quietly(file(name, bytes.substr(0, length)));
      EXPECT_FALSE(picture.has_value()) << name << " cut at " << length;
    }
    EXPECT_TRUE(quietly(file(name, bytes)).has_value()) << name;
  }
}

TEST_F(PictureFile, DamagedFilesAreRefusedWithoutChatter) {
  for (const char* name : {"bust_laser.png", "tunnel_wall.jpg"}) {
    std::string bytes = shared(name);
    if (bytes.empty()) GTEST_SKIP() << "no " << VIGNOLE_SHARED_DATA << "/stripes/" << name;
    for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 4000; ++i) bytes[i] = '\x33';
    EXPECT_FALSE(quietly(file(name, bytes)).has_value()) << name;
  }
}

TEST_F(PictureFile, TheLaserChannelOfRealPictures) {
  const std::string bytes = shared("bust_laser.png");
  if (bytes.empty()) GTEST_SKIP() << "no " << VIGNOLE_SHARED_DATA << "/stripes/bust_laser.png";
  EXPECT_EQ(quietly(file("bust.png", bytes))->channel, Channel::Red);
}

/// A picture of `background` with a vertical line of `line` (r, g, b) DN on top, clipped at 255.
Channel channelOf(std::array<int, 3> background, std::array<int, 3> line) {
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        rgb.push_back(static_cast<std::uint8_t>(
            std::min(255.0, background[c] + line[c] * std::exp(-(x - 90.0) * (x - 90.0) / 18))));
  return laserChannel(rgb.data(), 200, 100, 600);
}

TEST(LaserChannel, IsWhereTheLineStandsOut) {
  EXPECT_EQ(channelOf({20, 20, 20}, {150, 30, 20}), Channel::Red);
  EXPECT_EQ(channelOf({20, 20, 20}, {30, 150, 20}), Channel::Green);
  EXPECT_EQ(channelOf({20, 20, 20}, {30, 40, 150}), Channel::Blue);
  EXPECT_EQ(channelOf({200, 40, 40}, {55, 120, 20}), Channel::Green) << "not the brightest but the one that stands out";
}

TEST(LaserChannel, PrefersAnUnclippedOne) { EXPECT_EQ(channelOf({20, 20, 20}, {900, 200, 60}), Channel::Green); }

TEST(Channels, HaveNames) {
  for (const Channel c : {Channel::Auto, Channel::Red, Channel::Green, Channel::Blue, Channel::Grey})
    EXPECT_EQ(channelNamed(channelName(c)), c);
  EXPECT_FALSE(channelNamed("infrared").has_value());
}

}  // namespace
}  // namespace vignole
