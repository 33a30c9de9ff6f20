#pragma once
// A frame with what extraction reads of it and nothing else: 5 to 7 % of the pixels, and for every block left out what
// the scan must find there. Unpacked it is a picture again, and extraction gives the same result on it to the last bit.
//
// Why that holds (block_scan.h, stripe_extractor.h): pixels decide only within reachPx() of blocks that the scan takes,
// and these have a neighbour that lies above the noise. Kept are therefore the blocks with a neighbour whose sum lies
// above the lowest floor that any thresholds give, with two blocks all around. Of the others the scan reads
// - sums, for the least of a window: each block left out gets a sum between the morphological opening of the sums (by
//   the smallest window) and its own, so the least of every window that any sigma uses stays what it was, and no block
//   rises above its surroundings that did not before;
// - in the rows where noise and background are measured, medians: of the differences of neighbouring pixels every such
//   block gets the median; its sum stays on its side of the median of the sums.
// It holds for sigma up to kSparseMaxSigma, and for all other settings.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"

namespace vignole {

using PackedBytes = std::vector<std::uint8_t>;

inline constexpr double kSparseMaxSigma = 4;

enum class FrameKind : std::uint8_t {
  Sparse = 1,
  Whole = 2,  ///< every pixel, zstd
};

/// A picture of at most so many pixels, as a guard against files that lie.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 24U;

/// One per thread; buffers live from frame to frame.
class FramePacker {
 public:
  FramePacker();
  ~FramePacker();
  FramePacker(const FramePacker&) = delete;
  FramePacker& operator=(const FramePacker&) = delete;

  /// `out` is overwritten. A frame with light in more than a third of it (texture everywhere), or whose noise no
  /// picture shows, is packed whole. At least 32 x 32 pixels.
  FrameKind pack(const ImageView& image, FrameKind wished, PackedBytes& out);
  /// Of the last frame: share of its pixels that was kept.
  [[nodiscard]] double keptShare() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

struct FrameSize {
  FrameKind kind = FrameKind::Sparse;
  int width = 0, height = 0;
};
/// What the first bytes say; refuses what no frame has.
[[nodiscard]] Expected<FrameSize> packedSize(std::span<const std::uint8_t> packed);

/// One per thread. Never reads or writes beyond what is there, whatever the bytes say.
class FrameUnpacker {
 public:
  FrameUnpacker();
  ~FrameUnpacker();
  FrameUnpacker(const FrameUnpacker&) = delete;
  FrameUnpacker& operator=(const FrameUnpacker&) = delete;

  /// Into an image of packedSize().
  [[nodiscard]] Expected<void> unpack(std::span<const std::uint8_t> packed, const MutableImageView& image);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
