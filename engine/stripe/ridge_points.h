#pragma once
// All ridge points of a frame, and which of them lies in a pixel.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/stripe/band_window.h"
#include "engine/stripe/block_scan.h"
#include "engine/stripe/ridge_kernel.h"

namespace vignole {

/// Buffers live from frame to frame.
class RidgePoints {
 public:
  RidgePoints();
  /// Works on the blocks the scan marked. Beyond the picture's border its edge is repeated.
  void find(const ImageView& image, const BlockScan& scan, const RidgeFilter& filter);

  [[nodiscard]] const std::vector<RidgePoint>& points() const { return points_; }
  /// Index of the point whose pixel this is, or -1.
  [[nodiscard]] int indexAt(int column, int row) const;

 private:
  static constexpr std::size_t kTilePixels = static_cast<std::size_t>(kBlock) * kBlock;
  using Tile = std::array<std::uint32_t, kTilePixels>;  // index + 1, 0 is no point
  [[nodiscard]] std::uint16_t tileAt(int column, int row) const;
  void findInBand(const ImageView& image, const RidgeFilter& filter, int column, int row, int width);

  int width_ = 0, height_ = 0, columns_ = 0;
  std::unique_ptr<RidgeBand> band_;
  BandWindow window_;
  std::vector<RidgePoint> points_;
  std::vector<std::uint16_t> tileOfBlock_;  // 0 is the tile without points
  std::vector<Tile> tiles_;
};

}  // namespace vignole
