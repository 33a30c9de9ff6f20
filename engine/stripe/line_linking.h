#pragma once
// From ridge points to ordered pieces of lines: hysteresis (paper section II-D, step 3).

#include <array>
#include <cstdint>
#include <vector>

#include "engine/stripe/ridge_points.h"

namespace vignole {

/// Points `first` .. `first + count`, in order along the line, of the list that belongs to it.
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
  /// Of all pieces, one after the other.
  [[nodiscard]] const std::vector<RidgePoint>& points() const { return points_; }

 private:
  void collectSeeds(const std::vector<RidgePoint>& points, float highRidge);
  void walk(const RidgePoints& ridges, std::uint32_t from, float tx, float ty, std::vector<std::uint32_t>& out);
  int successor(const RidgePoints& ridges, const RidgePoint& p, float tx, float ty);
  int successorBeyond(const RidgePoints& ridges, const RidgePoint& p, float tx, float ty) const;

  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> seeds_, forward_, backward_;
  std::vector<RidgePoint> points_;
  std::vector<std::uint8_t> seedLevel_;
  std::vector<LinePiece> pieces_;
};

}  // namespace vignole
