#pragma once
// From ridge points to ordered pieces of lines: hysteresis (paper section II-D, step 3).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/stripe/ridge_points.h"

namespace vignole {

/// Entries `first` .. `first + count`, in order along the line, of the list that belongs to it.
struct LinePiece {
  std::uint32_t first = 0, count = 0;
};

struct LinkingSettings {
  float highRidge = 0;  ///< a piece begins at a point of at least this second derivative, DN/px^2
  int minLength = 10;   ///< points; shorter pieces are dropped
};

/// Walks from the strongest points along the line's direction, both ways; points abreast of the walk belong to the
/// same place of the line and are left out. Buffers live from frame to frame.
class LineLinker {
 public:
  void link(const RidgePoints& ridges, const LinkingSettings& settings);
  [[nodiscard]] const std::vector<LinePiece>& pieces() const { return pieces_; }
  /// Indices of the ridge points of one piece, in order.
  [[nodiscard]] std::span<const std::uint32_t> order(const LinePiece& piece) const {
    return std::span(order_).subspan(piece.first, piece.count);
  }

 private:
  /// Where a walk is, and the unit vector on which it goes on.
  struct Step {
    std::uint32_t at = 0;
    float tx = 0, ty = 0;
  };
  void linkFrom(const RidgePoints& ridges, std::uint32_t seed, int minLength);
  void walk(const RidgePoints& ridges, Step from, std::vector<std::uint32_t>& out);
  int successor(const RidgePoints& ridges, const Step& from);
  [[nodiscard]] int successorBeyond(const RidgePoints& ridges, const Step& from) const;

  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> backward_, order_;
  std::vector<LinePiece> pieces_;
};

}  // namespace vignole
