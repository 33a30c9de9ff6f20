#include "engine/stripe/band_window.h"

#include <algorithm>

namespace vignole {

BandPixels BandWindow::at(const ImageView& image, const RidgeFilter& filter, int column, int row, int width) {
  constexpr int kReadAhead = 64;  // the kernels read whole vectors
  const int left = column - filter.radius - 1, top = row - filter.radius - 1;
  const int across = width + 2 * filter.radius + 2 + kReadAhead, down = kBandHeight + 2 * filter.radius + 2;
  if (left >= 0 && top >= 0 && left + across <= image.width && top + down <= image.height)
    return {image.row(top) + left, image.stride};
  copy_.resize(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  std::uint8_t* out = copy_.data();
  for (int y = top; y < top + down; ++y) {
    const std::uint8_t* in = image.row(std::clamp(y, 0, image.height - 1));
    for (int x = left; x < left + across; ++x) *out++ = in[std::clamp(x, 0, image.width - 1)];
  }
  return {copy_.data(), across};
}

}  // namespace vignole
