#pragma once
// What a fit's unknowns are uncertain by when neighbouring points share their errors. Independent points: the inverse
// of the normal equations. Shared errors: A^-1 B A^-1, B the covariance of J^T W r, for errors whose correlation over d
// points is exp(-d^2 / 4 s^2), as a Gaussian filter of standard deviation s makes it; s = c / (2 sqrt(pi)) for errors
// shared by c points. An offset over many points becomes c times as uncertain in variance, over few less, and the
// curvature of a short arc much less: shared errors hardly bend it.

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/measurement/normal_factor.h"

namespace vignole {

class SharedErrors {
 public:
  SharedErrors(std::size_t unknowns, double correlatedPoints)
      : unknowns_(unknowns), correlated_(std::max(1.0, correlatedPoints)) {}

  /// Points from .. to follow each other. slopes(i): of the residual of point i over its sigma, with the unknowns.
  template <typename SlopesAt>
  void addRun(std::size_t from, std::size_t to, SlopesAt slopes) {
    // Blocks of points, each standing for its middle: the slopes change slowly.
    const auto points = static_cast<double>(to - from);
    const double wanted = points * kBlocksPerShared / correlated_;
    const std::size_t blocks = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(kMaxBlocks)));
    const double size = points / static_cast<double>(blocks);
    std::array<UnknownVector, kMaxBlocks> at;
    for (std::size_t b = 0; b < blocks; ++b)
      at[b] = slopes(from + static_cast<std::size_t>((static_cast<double>(b) + 0.5) * size));
    add(at, blocks, size);
  }
  /// Factor M of A^-1 B A^-1 = (A^-1 M)(A^-1 M)^T, lower triangle.
  [[nodiscard]] UnknownMatrix factor(const NormalFactor& normal) const;

 private:
  static constexpr std::size_t kMaxBlocks = 12;
  static constexpr double kBlocksPerShared = 3;
  void add(const std::array<UnknownVector, kMaxBlocks>& slopes, std::size_t blocks, double size);

  std::size_t unknowns_;
  double correlated_;
  UnknownMatrix shared_{}, independent_{};  ///< B and A as the blocks give them, lower triangles
};

}  // namespace vignole
