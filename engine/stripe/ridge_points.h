#pragma once
// All ridge points of a frame, and which of them lies in a pixel.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
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
  void begin(const ImageView& image, const RidgeFilter& filter);
  /// Works on these blocks too. Beyond the picture's border its edge is repeated.
  void find(std::span<const BlockRun> runs);
  /// When all blocks have been worked on, which were those of `runs`.
  void finish(std::span<const BlockRun> runs);

  [[nodiscard]] const RidgeArrays& points() const { return points_; }
  /// Whether a block that was worked on lies at most `px` (along a row or a column) from this pixel.
  [[nodiscard]] bool litWithin(int column, int row, int px) const;
  /// Index of the point whose pixel this is, or -1.
  [[nodiscard]] int indexAt(int column, int row) const;

  /// The map of the pixels around a point: `around(i)[dy * kMapPitch + dx]` is the index + 1 of the point in the pixel
  /// (dx, dy) away, |dx|, |dy| <= 1, or 0.
  static constexpr std::ptrdiff_t kMapPitch{kBlock + 2};
  [[nodiscard]] const std::uint16_t* around(std::size_t i) const { return maps_.data() + place_[i]; }

 private:
  static constexpr std::size_t kMap = std::size_t{kMapPitch} * std::size_t{kMapPitch};  // a block with one pixel around
  void enter(std::size_t i);
  [[nodiscard]] std::uint16_t& mapOfBlock(int column, int row) {
    const int block = (row + 1) * (columns_ + 2) + column + 1;
    return mapOfBlock_[static_cast<std::size_t>(block)];
  }

  ImageView image_;
  RidgeFilter filter_;
  int columns_ = 0;
  std::unique_ptr<RidgeBand> band_;
  BandWindow window_;
  RidgeCandidates candidates_;
  RidgeArrays points_;
  std::vector<std::uint16_t> mapOfBlock_;  // of every block and of one more all around; 0 is the map without points
  std::vector<std::uint16_t> maps_;
  std::vector<std::uint32_t> place_;  // of each point: its pixel in maps_
};

}  // namespace vignole
