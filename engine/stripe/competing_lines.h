#pragma once
// Ghosts: weak lines beside a stronger one that they follow (its reflection in the rail or in the lens).

#include <cstdint>
#include <span>
#include <vector>

#include "engine/stripe/uncertainty.h"

namespace vignole {

/// Points `first` .. `first + count` of one line among the points of a frame.
struct LineOfChain {
  std::uint32_t first = 0, count = 0;
  bool rejected = false;
};

struct CompetitionSettings {
  float strengthRatio = 0.35F;   ///< a ghost is weaker than this share of the line beside it
  float distancePx = 40;         ///< and so near to it
  float parallelCosine = 0.94F;  ///< and parallel within 20 degrees
  float leastShare = 0.7F;       ///< over at least this share of its length; a doubtful line is kept
};

/// Marks the lines that lose.
void rejectGhosts(std::span<const ChainPoint> points, std::span<LineOfChain> lines,
                  const CompetitionSettings& settings);

}  // namespace vignole
