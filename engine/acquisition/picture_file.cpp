#include "engine/acquisition/picture_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace vignole {
namespace {

constexpr std::array<std::pair<Channel, std::string_view>, 5> kNames{{{Channel::Auto, "auto"},
                                                                      {Channel::Red, "red"},
                                                                      {Channel::Green, "green"},
                                                                      {Channel::Blue, "blue"},
                                                                      {Channel::Grey, "grey"}}};

/// Holds back what libraries write to stderr (libpng and libjpeg know no other way) and hands it over as text.
class HeldStderr {
 public:
  HeldStderr() : lock_(mutex()) {
    std::fflush(stderr);
    held_ = memfd_create("held-stderr", MFD_CLOEXEC);
    saved_ = held_ < 0 ? -1 : fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (saved_ >= 0) dup2(held_, STDERR_FILENO);
  }
  ~HeldStderr() {
    release();
    if (held_ >= 0) close(held_);
  }
  HeldStderr(const HeldStderr&) = delete;
  HeldStderr& operator=(const HeldStderr&) = delete;

  std::string release() {
    if (saved_ < 0) return {};
    std::fflush(stderr);
    dup2(saved_, STDERR_FILENO);
    close(saved_);
    saved_ = -1;
    std::string text(static_cast<std::size_t>(std::max<off_t>(0, lseek(held_, 0, SEEK_END))), '\0');
    const ssize_t got = pread(held_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
    return text;
  }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  std::lock_guard<std::mutex> lock_;
  int held_ = -1, saved_ = -1;
};

Expected<std::vector<char>> bytesOf(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return inputError(file.string(), "no such file");
  if (std::filesystem::is_directory(file, error)) return inputError(file.string(), "is a folder, not a picture");
  std::ifstream in(file, std::ios::binary);
  if (!in) return inputError(file.string(), "cannot be read; check its permissions");
  std::vector<char> bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) return inputError(file.string(), "cannot be read to its end");
  if (bytes.empty()) return inputError(file.string(), "is empty (0 bytes)");
  return bytes;
}

/// Whether a JPEG goes on to its end-of-image marker; OpenCV's decoder fills what is missing without a word.
bool reachesEndOfJpeg(const std::vector<char>& bytes) {
  const auto at = [&bytes](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  bool inScan = false;
  for (std::size_t i = 2; i + 1 < bytes.size();) {
    const bool marker = at(i) == 0xFF && at(i + 1) != 0x00 && at(i + 1) != 0xFF;
    const bool restart = marker && at(i + 1) >= 0xD0 && at(i + 1) <= 0xD7;
    if (!marker || restart) {
      if (!inScan && !restart && at(i) != 0xFF) return false;  // outside of a scan there are only segments
      i += restart ? 2 : 1;
      if (at(i - 1) == 0xFF && i < bytes.size() && at(i) == 0x00) ++i;
      continue;
    }
    if (at(i + 1) == 0xD9) return true;
    if (i + 3 >= bytes.size()) return false;
    inScan = at(i + 1) == 0xDA;
    i += 2U + (static_cast<std::size_t>(at(i + 2)) << 8U | at(i + 3));
  }
  return false;
}

/// The decoders go on after damage and fill the rest with grey; only their complaints tell.
bool tellsDamage(const std::string& complaints) {
  return std::ranges::any_of(std::array{"Premature end", "Corrupt JPEG", "libpng error", "Read Error", "Bogus",
                                        "Unsupported marker", "read error"},
                             [&](const char* words) { return complaints.find(words) != std::string::npos; });
}

Expected<cv::Mat> decoded(const std::filesystem::path& file) {
  auto bytes = bytesOf(file);
  if (!bytes) return tl::unexpected(bytes.error());
  cv::Mat picture;
  std::string complaints;
  {
    HeldStderr held;
    try {
      picture = cv::imdecode(*bytes, cv::IMREAD_UNCHANGED);
    } catch (const std::exception&) {
      picture.release();
    }
    complaints = held.release();
  }
  if (picture.empty())
    return inputError(file.string(),
                      "is not a picture that can be decoded (PNG, JPEG, BMP, TIFF, PGM), or is damaged or cut off");
  const bool isJpeg = bytes->size() > 2 && bytes->at(0) == '\xFF' && bytes->at(1) == '\xD8';
  if (tellsDamage(complaints) || (isJpeg && !reachesEndOfJpeg(*bytes)))
    return inputError(file.string(), "is damaged or cut off; take the picture again");
  return picture;
}

/// 16 bits to 8: cameras of 10, 12 or 14 bits leave the upper bits empty.
cv::Mat toEightBits(const cv::Mat& picture) {
  double brightest = 0;
  cv::minMaxIdx(picture.reshape(1), nullptr, &brightest);
  int bits = 8;
  while (bits < 16 && brightest >= (1 << bits)) bits += 2;
  cv::Mat result;
  picture.convertTo(result, CV_8U, 255.0 / ((1 << bits) - 1));
  return result;
}

Picture channelOf(const cv::Mat& picture, Channel channel) {
  Picture result{picture.cols, picture.rows, {}, channel};
  result.pixels.reserve(static_cast<std::size_t>(picture.cols) * static_cast<std::size_t>(picture.rows));
  const int channels = picture.channels();
  for (int y = 0; y < picture.rows; ++y) {
    const auto* p = picture.ptr<std::uint8_t>(y);
    for (int x = 0; x < picture.cols; ++x, p += channels) {
      // OpenCV's order is blue, green, red; grey is Rec. 601 in 1/1000.
      const int grey = channels < 3 ? p[0] : (114 * p[0] + 587 * p[1] + 299 * p[2] + 500) / 1000;
      const int value = channels < 3 || channel == Channel::Grey ? grey
                        : channel == Channel::Red                ? p[2]
                        : channel == Channel::Green              ? p[1]
                                                                 : p[0];
      result.pixels.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return result;
}

}  // namespace

std::optional<Channel> channelNamed(std::string_view name) {
  for (const auto& [channel, word] : kNames)
    if (word == name) return channel;
  return std::nullopt;
}

std::string_view channelName(Channel channel) {
  for (const auto& [value, word] : kNames)
    if (value == channel) return word;
  return "?";
}

Channel laserChannel(const std::uint8_t* rgb, int width, int height, std::ptrdiff_t stride) {
  constexpr int kBeside = 10;       // px; further than the light of a stripe reaches
  constexpr double kShare = 0.005;  // of the pixels: a stripe covers about that much
  constexpr double kClipped = 0.6;  // of what a clipped pixel stands out: the line is there, but its top is missing
  double best = -1;
  int bestChannel = 0;
  for (int c = 0; c < 3; ++c) {
    std::array<double, 256> weights{};  // how many pixels stand out by so many DN
    std::size_t looked = 0;
    for (int y = kBeside; y < height - kBeside; y += 2) {
      const std::uint8_t* row = rgb + y * stride;
      for (int x = kBeside; x < width - kBeside; x += 2, ++looked) {
        const auto at = [&](int dx, int dy) {
          return static_cast<int>(row[dy * stride + std::ptrdiff_t{3} * (x + dx) + c]);
        };
        const int across = std::min(at(0, 0) - at(-kBeside, 0), at(0, 0) - at(kBeside, 0));
        const int down = std::min(at(0, 0) - at(0, -kBeside), at(0, 0) - at(0, kBeside));
        const int out = std::max(across, down);
        if (out > 0) ++weights[static_cast<std::size_t>(at(0, 0) >= 254 ? kClipped * out : out)];
      }
    }
    double left = kShare * static_cast<double>(looked), sum = 0;
    for (std::size_t out = 255; out > 0 && left > 0; --out) {
      const double taken = std::min(left, weights[out]);
      sum += taken * static_cast<double>(out);
      left -= taken;
    }
    if (sum > best) {
      best = sum;
      bestChannel = c;
    }
  }
  return bestChannel == 0 ? Channel::Red : bestChannel == 1 ? Channel::Green : Channel::Blue;
}

Expected<Picture> readPicture(const std::filesystem::path& file, Channel channel) {
  auto picture = decoded(file);
  if (!picture) return tl::unexpected(picture.error());
  if (picture->depth() == CV_16U) *picture = toEightBits(*picture);
  if (picture->depth() != CV_8U)
    return inputError(file.string(), "has pixels that are not 8 or 16 bit whole numbers; convert it");
  if (picture->channels() < 3) return channelOf(*picture, Channel::Grey);
  if (channel != Channel::Auto) return channelOf(*picture, channel);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture->total() * 3);
  const int channels = picture->channels();
  for (int y = 0; y < picture->rows; ++y) {
    const auto* p = picture->ptr<std::uint8_t>(y);
    for (int x = 0; x < picture->cols; ++x, p += channels) rgb.insert(rgb.end(), {p[2], p[1], p[0]});
  }
  return channelOf(*picture, laserChannel(rgb.data(), picture->cols, picture->rows, std::ptrdiff_t{3} * picture->cols));
}

}  // namespace vignole
