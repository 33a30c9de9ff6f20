#include "engine/synchronisation/rail_presence.h"

#include <algorithm>

namespace vignole {

namespace {
constexpr int kRowsApart = 8;
}

bool railInView(const ImageView& image, const RailPresenceSettings& settings) {
  if (image.empty()) return false;
  int found = 0;
  for (int y = kRowsApart / 2; y < image.height; y += kRowsApart) {
    const std::uint8_t* row = image.row(y);
    unsigned sum = 0;
    for (int x = 0; x < image.width; ++x) sum += row[x];
    const int level = static_cast<int>(sum) / image.width + settings.contrastDn;
    const auto bright = static_cast<std::uint8_t>(std::clamp(level, 1, 254));
    unsigned count = 0;
    for (int x = 0; x < image.width; ++x) count += row[x] > bright ? 1U : 0U;
    found += static_cast<int>(count);
    if (found >= settings.pixels) return true;
  }
  return false;
}

}  // namespace vignole
