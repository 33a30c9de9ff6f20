#pragma once
// Pictures on disk (PNG, JPEG, BMP, TIFF, PGM ...) as 8-bit grey: the channel in which the laser stands out.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"

namespace vignole {

enum class Channel { Auto, Red, Green, Blue, Grey };

/// "auto", "red", "green", "blue", "grey".
[[nodiscard]] std::optional<Channel> channelNamed(std::string_view name);
[[nodiscard]] std::string_view channelName(Channel channel);

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< row-major, without padding
  Channel channel = Channel::Grey;   ///< the one that was taken, never Auto
  [[nodiscard]] ImageView view() const { return {pixels.data(), width, height, width}; }
};

/// Grey pictures are taken as they are. More than 8 bits are scaled down from the least of 8, 10, 12, 14, 16 bits that
/// holds the brightest value. Orientation tags and alpha are ignored. Errors (one line): missing, unreadable, empty,
/// unknown format, damaged or cut off. What the decoders would print on stderr is kept from it; while one decodes,
/// stderr of the whole process is held back, so calls are made one after the other.
[[nodiscard]] Expected<Picture> readPicture(const std::filesystem::path& file, Channel channel = Channel::Auto);

/// The channel of an interleaved red, green, blue picture in which narrow bright lines stand out most from what is
/// 10 px beside them; clipped light counts less. `stride` in bytes.
[[nodiscard]] Channel laserChannel(const std::uint8_t* rgb, int width, int height, std::ptrdiff_t stride);

}  // namespace vignole
