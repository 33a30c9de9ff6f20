#pragma once
// First look at a frame, at the speed of memory: where is there light, how noisy is a pixel. Works on 8 x 8 blocks, of
// which every second row of pixels is read: half of the way to memory, and a line of 1 px still shows in full.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/image_view.h"

namespace vignole {

inline constexpr int kBlock = 8;  ///< side of a block, px

struct BlockScanSettings {
  int radius = 3;            ///< the background of a block is the darkest of the blocks that far around it (<= 8)
  double leastContrast = 2;  ///< a block counts when its mean is that far above its background, DN ...
  /// ... and at least this many standard deviations of its mean: noise marks 1 in 1,500. It must have a neighbour that
  /// counts: a line passes from block to block, noise stands alone.
  double noiseFactor = 3.2;
  int maxBlocks = 3000;  ///< budget; of more blocks the brightest are kept and the scan says `overloaded`
};

/// Blocks `first` .. `first + count` of block row `row`, side by side.
struct BlockRun {
  std::uint16_t row = 0, first = 0, count = 0;
};

/// `radius` for a filter of so many px: its light reaches 3 sd of the stripe to both sides, the background is looked for
/// beyond that.
[[nodiscard]] int scanRadius(double sigma);

/// Block rows at which noise and background are measured: `first`, `first` + `every` ... of so many whole ones.
struct NoiseSampling {
  int first = 0, every = 1;
  [[nodiscard]] bool takes(int row) const { return row >= first && (row - first) % every == 0; }
};
[[nodiscard]] NoiseSampling noiseSampling(int wholeRows);

/// How far the darkest block of the window lies below its mean because of noise, DN.
[[nodiscard]] double minimumBias(const BlockScanSettings& settings, float noiseDn);
/// A block counts when its sum lies more than that above the least of the window.
[[nodiscard]] std::uint16_t blockFloor(const BlockScanSettings& settings, float noiseDn);

/// Row by row, so that the pixels of the rows to come are on their way from memory while the next stage works on those
/// that are settled. Buffers live from frame to frame. Blocks cut by the right or lower edge have their sums scaled to
/// those of whole ones.
class BlockScan {
 public:
  /// Measures noise and background on a sample of the block rows; every later call is about this image.
  void begin(const ImageView& image, const BlockScanSettings& settings);
  /// Finds the candidates of block row `row`, which must be 0, 1, 2 ... in turn. Looks `radius` + 2 rows ahead.
  void settle(int row);
  /// Of a row that is settled.
  [[nodiscard]] std::span<const BlockRun> runsOf(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return std::span(runs_).subspan(beginOfRow_[r], beginOfRow_[r + 1] - beginOfRow_[r]);
  }
  /// After the last row of a frame that is overloaded: keeps the brightest maxBlocks and leaves them in runs().
  void cap();

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  /// Of all rows settled so far.
  [[nodiscard]] const std::vector<BlockRun>& runs() const { return runs_; }
  [[nodiscard]] std::size_t candidates() const { return candidates_; }
  /// More than maxBlocks so far.
  [[nodiscard]] bool overloaded() const { return candidates_ > static_cast<std::size_t>(settings_.maxBlocks); }
  /// Standard deviation of a pixel, DN, from neighbours in the median block; at least that of rounding, 1/sqrt(12).
  [[nodiscard]] float noiseDn() const { return noiseDn_; }
  /// Median of the blocks, DN.
  [[nodiscard]] float backgroundDn() const { return backgroundDn_; }
  /// Mean of the background around the block that holds pixel (x, y), DN.
  [[nodiscard]] float backgroundAt(int x, int y) const;

  // For who keeps a frame: what the noise and the background were read from, and the grids of all rows once settled.
  [[nodiscard]] std::uint16_t medianDifference() const { return medianDifference_; }  ///< of 32 pairs of pixels
  [[nodiscard]] std::uint16_t medianSum() const { return medianSum_; }  ///< a quarter of the sum of 32 pixels
  /// One row of columns() entries with a margin of kGridMargin on both sides.
  [[nodiscard]] const std::uint16_t* sumsOf(int row) const { return sums_.data() + offset(row); }
  [[nodiscard]] const std::uint16_t* leastSumsOf(int row) const { return background_.data() + offset(row); }

 private:
  using Grid = std::vector<std::uint16_t>;
  void resize(const ImageView& image);
  void sumRow(int row);
  void sample();
  void measureNoise();
  void findBackground(int row);
  void mark(int row);
  void dropLonely(int row);
  void collectRuns(int row);
  void askFor(const BlockRun& run) const;
  [[nodiscard]] std::uint16_t* at(Grid& grid, int row) { return grid.data() + offset(row); }
  [[nodiscard]] std::size_t offset(int row) const;

  int width_ = 0, height_ = 0, columns_ = 0, rows_ = 0;
  std::size_t pitch_ = 0, candidates_ = 0;
  ImageView image_;
  BlockScanSettings settings_;
  std::uint16_t floor_ = 0;                  // a candidate's sum lies that far above its background
  int summed_ = 0, bordered_ = 0, lit_ = 0;  // rows up to there have their minima, their backgrounds, their first marks
  std::vector<std::uint8_t> sampledRow_;
  std::uint16_t medianDifference_ = 0, medianSum_ = 0;
  float noiseDn_ = 0, backgroundDn_ = 0;
  float minimumBiasDn_ = 0;  // how far the darkest of a window lies below its mean because of noise
  // Grids with a margin around them, so that windows need no bounds.
  Grid sums_, rowMinima_, background_, excess_;
  // One bit a block, words_ of them a row; those of bright blocks have a row above the first and one below the last.
  std::vector<std::uint64_t> bright_, marks_;
  std::size_t words_ = 0;
  std::vector<std::uint16_t> differences_, sampled_;  // of the block rows that are sampled for the noise
  std::vector<std::uint32_t> histogram_;
  std::vector<BlockRun> runs_;
  std::vector<std::size_t> beginOfRow_;  // of each settled row in runs_, and one more
};

}  // namespace vignole
