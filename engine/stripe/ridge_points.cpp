#include "engine/stripe/ridge_points.h"

#include <algorithm>
#include <limits>

namespace vignole {

RidgePoints::RidgePoints() : band_(std::make_unique<RidgeBand>()) {}

int RidgePoints::indexAt(int column, int row) const {
  if (column < 0 || row < 0 || column >= image_.width || row >= image_.height) return -1;
  const int block = (row / kBlock + 1) * (columns_ + 2) + column / kBlock + 1;
  const std::ptrdiff_t pixel = (row % kBlock + 1) * kMapPitch + column % kBlock + 1;
  return static_cast<int>(
             maps_[mapOfBlock_[static_cast<std::size_t>(block)] * kMap + static_cast<std::size_t>(pixel)]) -
         1;
}

bool RidgePoints::litWithin(int column, int row, int px) const {
  const int left = std::max(0, column - px) / kBlock, right = std::min(image_.width - 1, column + px) / kBlock;
  const int top = std::max(0, row - px) / kBlock, bottom = std::min(image_.height - 1, row + px) / kBlock;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      if (mapOfBlock_[static_cast<std::size_t>((y + 1) * (columns_ + 2) + x + 1)] != 0) return true;
  return false;
}

// Into the map of its own block, and into those of the blocks that border on its pixel.
void RidgePoints::enter(std::size_t i) {
  const int column = columnOf(points_.pixel[i]), row = rowOf(points_.pixel[i]);
  const int bx = column / kBlock, by = row / kBlock, x = column % kBlock, y = row % kBlock;
  const auto index = static_cast<std::uint16_t>(i + 1);
  const auto put = [&](int blockColumn, int blockRow, int px, int py) {
    const std::size_t map = mapOfBlock(blockColumn, blockRow);
    const std::size_t at = map * kMap + static_cast<std::size_t>((py + 1) * kMapPitch + px + 1);
    if (map != 0) maps_[at] = index;
    return at;
  };
  place_[i] = static_cast<std::uint32_t>(put(bx, by, x, y));
  const int besideX = x == 0 ? -1 : (x == kBlock - 1 ? 1 : 0), besideY = y == 0 ? -1 : (y == kBlock - 1 ? 1 : 0);
  if (besideX != 0) put(bx + besideX, by, x - besideX * kBlock, y);
  if (besideY != 0) put(bx, by + besideY, x, y - besideY * kBlock);
  if (besideX != 0 && besideY != 0) put(bx + besideX, by + besideY, x - besideX * kBlock, y - besideY * kBlock);
}

void RidgePoints::begin(const ImageView& image, const RidgeFilter& filter) {
  image_ = image;
  filter_ = filter;
  columns_ = (image.width + kBlock - 1) / kBlock;
  candidates_.size = 0;
}

void RidgePoints::find(std::span<const BlockRun> runs) {
  constexpr int kStep = kMaxBandWidth / kBlock;
  for (const BlockRun& run : runs)
    for (int c = 0; c < run.count; c += kStep) {
      const int column = (run.first + c) * kBlock, row = run.row * kBlock;
      const int width = std::min(std::min(kStep, run.count - c) * kBlock, image_.width - column);
      const int height = std::min(kBlock, image_.height - row);
      const auto [pixels, stride] = window_.at(image_, filter_, column, row, width);
      candidates_.reserve(candidates_.size + static_cast<std::size_t>(width * height));
      findRidgeCandidates(pixels, stride, width, height, column, row, filter_, *band_, candidates_);
    }
}

void RidgePoints::finish(std::span<const BlockRun> runs) {
  testRidgeCandidates(candidates_, filter_.leastRidge, points_);
  // An index must fit into a map; so many points are texture, and what is over is left out.
  points_.size = std::min<std::size_t>(points_.size, std::numeric_limits<std::uint16_t>::max() - 1);
  const int rows = (image_.height + kBlock - 1) / kBlock;
  mapOfBlock_.assign(static_cast<std::size_t>(columns_ + 2) * static_cast<std::size_t>(rows + 2), 0);
  std::uint16_t map = 0;
  for (const BlockRun& run : runs)
    for (int c = 0; c < run.count; ++c) mapOfBlock(run.first + c, run.row) = ++map;
  maps_.assign((map + std::size_t{1}) * kMap, 0);
  place_.resize(std::max(place_.size(), points_.size));
  for (std::size_t i = 0; i < points_.size; ++i) enter(i);
}

}  // namespace vignole
