#pragma once
// A target's print: where black meets white beside the laser's line, it takes light from one side and pulls the line
// aside.

#include <array>

#include "engine/target/planar_target.h"

namespace vignole {

/// Of dots that are light on dark the ground is black.
[[nodiscard]] bool isBlack(const PlanarTarget& target, const Point2& onTargetMm);

/// The print under a Gaussian line of light, across it.
class PrintAcross {
 public:
  /// `widthMm`: standard deviation of the light, a vector across the line.
  PrintAcross(const PlanarTarget& target, const Point2& onTargetMm, const Point2& widthMm);
  /// How far the middle of the line's light lies from where the light falls, in widths, since black gives back only
  /// `blackShare` of what white does.
  [[nodiscard]] double pull(double blackShare) const;
  /// White, or black, two widths to either side.
  [[nodiscard]] bool white() const;
  [[nodiscard]] bool black() const;

 private:
  static constexpr int kTaps = 12;  // to either side
  std::array<bool, 2 * kTaps + 1> black_{};
};

/// What belongs to the board for sure: the outer squares of a chessboard, half a gap beyond the outer circles, a dot
/// plate's frame.
[[nodiscard]] TargetRectangle printedArea(const PlanarTarget& target);

}  // namespace vignole
