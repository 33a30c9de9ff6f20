#pragma once
// Which primitive is nearest to a point: a grid whose cells list every primitive that can be nearest to any point of
// the cell, so that the answer is exact (it stands in for the R-tree of the paper's reference [18]).

#include <cstdint>
#include <vector>

#include "engine/registration/carrier.h"

namespace vignole {

class CandidateGrid {
 public:
  /// Covers the carriers with a margin; beyond it every primitive is tried.
  CandidateGrid(const std::vector<Carrier>& carriers, double cellMm, double marginMm);

  [[nodiscard]] std::uint16_t nearest(double x, double y) const {
    const double u = (x - x0_) * perCell_, v = (y - y0_) * perCell_;
    if (!(u >= 0 && v >= 0 && u < columns_ && v < rows_)) return nearestOf(all_.data(), all_.size(), x, y);
    const std::size_t cell =
        static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(u);
    const std::uint32_t first = first_[cell], count = first_[cell + 1] - first;
    return count == 1 ? candidates_[first] : nearestOf(&candidates_[first], count, x, y);
  }

 private:
  [[nodiscard]] std::uint16_t nearestOf(const std::uint16_t* list, std::size_t count, double x, double y) const;
  void keepNear(const std::vector<std::uint16_t>& from, double x, double y, double reachMm,
                std::vector<std::uint16_t>& kept);

  std::vector<Carrier> carriers_;
  double x0_ = 0, y0_ = 0, perCell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint16_t> candidates_, all_;
  std::vector<double> distances_;
};

}  // namespace vignole
