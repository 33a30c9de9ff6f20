#include "calibration/detection/picture_levels.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace vignole {

PictureLevel::PictureLevel(std::vector<std::uint8_t> pixels, int width, int height, int factor)
    : view_{nullptr, width, height, width}, pixels_(std::move(pixels)), factor_(factor) {}

ImageView PictureLevel::view() const {
  ImageView view = view_;
  if (!pixels_.empty()) view.data = pixels_.data();
  return view;
}

PictureLevel PictureLevel::half() const {
  const ImageView from = view();
  const int width = from.width / 2, height = from.height / 2;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const std::uint8_t *above = from.row(2 * y), *below = from.row(2 * y + 1);
    std::uint8_t* to = pixels.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x)
      to[x] = static_cast<std::uint8_t>((above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1] + 2) / 4);
  }
  return {std::move(pixels), width, height, 2 * factor_};
}

double noiseOf(const ImageView& image) {
  // a - 2 b + c has a standard deviation of sqrt(6) noises; half of its magnitudes lie below 0.6745 of that.
  constexpr double kPerNoise = 2.449489743 * 0.6744897502;
  std::array<std::size_t, 1024> counts{};
  std::size_t all = 0;
  const int step = std::max(1, image.height / 256);
  for (int y = 0; y < image.height; y += step) {
    const std::uint8_t* row = image.row(y);
    for (int x = 1; x + 1 < image.width; x += 2) {
      const int second = std::abs(row[x - 1] - 2 * row[x] + row[x + 1]);
      ++counts[static_cast<std::size_t>(second)];
      ++all;
    }
  }
  if (all == 0) return 0;
  // The median within the steps of whole numbers.
  std::size_t below = 0, level = 0;
  while (below + counts[level] < (all + 1) / 2) below += counts[level++];
  const double within = counts[level] > 0 ? (0.5 * static_cast<double>(all) - static_cast<double>(below)) /
                                                static_cast<double>(counts[level])
                                          : 0.5;
  return std::max(0.0, static_cast<double>(level) - 0.5 + within) / kPerNoise;
}

}  // namespace vignole
