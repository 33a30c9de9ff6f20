#pragma once
// Pieces of one line that gaps have parted, found by the regression lines of their ends (paper section II-D, step 4).

#include <cstdint>
#include <span>
#include <vector>

#include "engine/stripe/line_linking.h"

namespace vignole {

struct GapSettings {
  double distance = 60;  ///< d: largest distance of the two ends, px
  double angleDeg = 15;  ///< alpha: largest angle between the regression lines, and of each with the way across
  double sigma = 3;      ///< of the filter, px: the regression lines are taken over 5 sigma
};

/// One piece on its way along a line.
struct ChainLink {
  std::uint32_t piece = 0;
  bool reversed = false;
};

/// Links `first` .. `first + count` of GapLinker::links(), in order along the line.
struct LineChain {
  std::uint32_t first = 0, count = 0;
};

/// The cheapest links first (short and straight); every end is used once. Buffers live from frame to frame.
class GapLinker {
 public:
  void link(const RidgeArrays& points, std::span<const LinePiece> pieces, const GapSettings& settings);
  [[nodiscard]] const std::vector<LineChain>& chains() const { return chains_; }
  [[nodiscard]] const std::vector<ChainLink>& links() const { return links_; }

 private:
  struct End {
    float x = 0, y = 0;    // px
    float dx = 0, dy = 0;  // unit vector that leaves the piece along its regression line
  };
  struct Bridge {
    float cost = 0;
    std::uint32_t a = 0, b = 0;  // ends; end 2 p is where piece p begins, 2 p + 1 where it stops
  };
  void findBridges(const GapSettings& settings);
  void chooseBridges();
  void followChains(std::size_t pieces);
  std::uint32_t root(std::uint32_t piece);

  std::vector<End> ends_;
  std::vector<std::uint32_t> byX_, partner_, parent_;
  std::vector<std::uint8_t> seen_;
  std::vector<Bridge> bridges_;
  std::vector<ChainLink> links_;
  std::vector<LineChain> chains_;
};

}  // namespace vignole
