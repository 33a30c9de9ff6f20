#include "engine/stripe/ridge_points.h"

#include <algorithm>

namespace vignole {

RidgePoints::RidgePoints() : band_(std::make_unique<RidgeBand>()) {}

namespace {

std::size_t pixelOfTile(int column, int row) {
  const int pixel = (row % kBlock) * kBlock + column % kBlock;
  return static_cast<std::size_t>(pixel);
}

}  // namespace

std::uint16_t RidgePoints::tileAt(int column, int row) const {
  const int block = (row / kBlock) * columns_ + column / kBlock;
  return tileOfBlock_[static_cast<std::size_t>(block)];
}

int RidgePoints::indexAt(int column, int row) const {
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return -1;
  return static_cast<int>(tiles_[tileAt(column, row)][pixelOfTile(column, row)]) - 1;
}

void RidgePoints::findInBand(const ImageView& image, const RidgeFilter& filter, int column, int row, int width) {
  const auto [pixels, stride] = window_.at(image, filter, column, row, width);
  for (const RidgePoint& p : findRidgePoints(pixels, stride, width, column, row, filter, *band_)) {
    if (p.column >= image.width || p.row >= image.height) continue;  // of a block that the edge cuts
    points_.push_back(p);
    tiles_[tileAt(p.column, p.row)][pixelOfTile(p.column, p.row)] = static_cast<std::uint32_t>(points_.size());
  }
}

void RidgePoints::find(const ImageView& image, const BlockScan& scan, const RidgeFilter& filter) {
  width_ = image.width;
  height_ = image.height;
  columns_ = scan.columns();
  points_.clear();
  tileOfBlock_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(scan.rows()), 0);
  tiles_.resize(scan.candidates() + 1);
  std::fill(tiles_.begin(), tiles_.end(), Tile{});
  std::uint16_t tile = 0;
  for (const BlockRun& run : scan.runs()) {
    for (int c = 0; c < run.count; ++c)
      tileOfBlock_[static_cast<std::size_t>(run.row) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(run.first + c)] = ++tile;
    constexpr int kStep = kMaxBandWidth / kBlock;
    for (int c = 0; c < run.count; c += kStep)
      findInBand(image, filter, (run.first + c) * kBlock, run.row * kBlock, std::min(kStep, run.count - c) * kBlock);
  }
}

}  // namespace vignole
