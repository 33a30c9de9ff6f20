#pragma once
// Which primitive is nearest to a point: a grid whose cells list every primitive that can be nearest to any point of
// the cell, so that the answer is exact (it stands in for the R-tree of the paper's reference [18]).

#include <cstdint>
#include <span>
#include <vector>

#include "engine/registration/carrier.h"
#include "engine/registration/pose_kernels.h"

namespace vignole {

class CandidateGrid {
 public:
  /// Covers the carriers (a closed outline, each starts where the one before ends) with a margin; beyond it every
  /// primitive is tried. Cells further than `reachMm` from the outline are marked as far away.
  CandidateGrid(const std::vector<Carrier>& carriers, double cellMm, double marginMm, double reachMm);

  /// Exact, anywhere.
  [[nodiscard]] std::uint16_t nearest(double x, double y) const {
    const double u = (x - x0_) * perCell_, v = (y - y0_) * perCell_;
    if (!(u >= 0 && v >= 0 && u < columns_ && v < rows_)) return nearestOf(all_, x, y);
    return nearestOf(
        candidatesOf(static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(u)), x,
        y);
  }

  /// For locate(), which names the cell of many points at once.
  [[nodiscard]] CellFrame frame() const;
  /// The primitive nearest to about the middle of a cell, with kFarAway added if the cell is far away.
  [[nodiscard]] std::int32_t roughly(std::int32_t cell) const {
    return codes_[static_cast<std::size_t>(cell)] & kRough;
  }
  /// The primitive nearest to a point of the cell, or the number of primitives if the cell is far away.
  [[nodiscard]] std::uint16_t within(std::int32_t cell, float x, float y) const {
    const std::uint16_t code = codes_[static_cast<std::size_t>(cell)];
    const auto k = static_cast<std::uint16_t>(code & kIndex);
    switch (code & ~kIndex) {
      case kSingle:
        return k;
      case kJoint: {
        const Joint& joint = joints_[k];
        return joint.tx * x + joint.ty * y < joint.at ? joint.before : k;
      }
      case kSeveral:
        return nearestOf(candidatesOf(static_cast<std::size_t>(cell)), static_cast<double>(x), static_cast<double>(y));
      default:
        return static_cast<std::uint16_t>(carriers_.size());
    }
  }

 private:
  // Codes of cells: an index and what it means.
  static constexpr int kIndex = 0x1fff, kSingle = 0, kJoint = 0x2000, kSeveral = 0x4000, kRough = kFarAway | kIndex;
  /// Where a primitive begins: points beyond it along the outline belong to it, the others to the one before.
  struct Joint {
    float tx = 0, ty = 0, at = 0;
    std::uint16_t before = 0;
  };

  [[nodiscard]] std::span<const std::uint16_t> candidatesOf(std::size_t cell) const {
    return {&candidates_[first_[cell]], first_[cell + 1] - first_[cell]};
  }
  [[nodiscard]] std::uint16_t nearestOf(std::span<const std::uint16_t> list, double x, double y) const;
  /// Returns the distance of the nearest.
  double keepNear(const std::vector<std::uint16_t>& from, double x, double y, double reachMm,
                  std::vector<std::uint16_t>& kept);
  [[nodiscard]] std::uint16_t codeOf(const std::vector<std::uint16_t>& kept, double x, double y,
                                     double halfDiagonalMm) const;

  std::vector<Carrier> carriers_;
  std::vector<Joint> joints_;
  double x0_ = 0, y0_ = 0, perCell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint16_t> codes_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint16_t> candidates_, all_;
  std::vector<double> distances_;
};

}  // namespace vignole
