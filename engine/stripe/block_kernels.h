#pragma once
// The inner loops of the block scan, for the best SIMD target of the machine they run on.

#include <cstddef>
#include <cstdint>

namespace vignole {

/// Sums of the pixels of every second row (the first, the third ...) in `blocks` blocks of 8 x 8 side by side, from the
/// eight rows that start at `pixels`. Asks for the same rows of the blocks below on the way.
void sumBlockRow(const std::uint8_t* pixels, std::ptrdiff_t stride, std::size_t blocks, std::uint16_t* sums);

/// Sums of |upper - lower| over four pairs of neighbouring rows (0-1, 2-3, 4-5, 6-7): 32 differences a block.
void sumBlockDifferences(const std::uint8_t* pixels, std::ptrdiff_t stride, std::size_t blocks, std::uint16_t* sums);

// The others work on grids of blocks with a margin: they may read and write up to kGridMargin entries beyond both ends.
inline constexpr std::size_t kGridMargin = 64;

/// out[i] = least of in[i - radius] .. in[i + radius], radius <= 8.
void minimumAlongRow(const std::uint16_t* in, int radius, std::size_t count, std::uint16_t* out);

/// background[i] = least of rows[0][i] .. rows[rowCount - 1][i]; excess[i] = sums[i] - background[i].
void backgroundAndExcess(const std::uint16_t* const* rows, int rowCount, const std::uint16_t* sums, std::size_t count,
                         std::uint16_t* background, std::uint16_t* excess);

/// Bit i of `marks` (bit i % 64 of word i / 64) is set where excess[i] is above `floor` and above 1/8 of the largest of
/// its 3 x 3 neighbours. `pitch`: entries from one row of the grid to the next. Words behind `count` bits are cleared
/// as far as (count + 63) / 64.
void markBlocks(const std::uint16_t* excess, std::ptrdiff_t pitch, std::uint16_t floor, std::size_t count,
                std::uint64_t* marks);

}  // namespace vignole
