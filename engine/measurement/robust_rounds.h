#pragma once
// Rounds of weighting and solving that the fits share: soft weights on some of the points until the steps are small,
// then a hard cut on all of them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "engine/measurement/fit_sums.h"
#include "engine/measurement/normal_factor.h"
#include "engine/measurement/shared_errors.h"
#include "engine/profile/profile.h"

namespace vignole {

/// How well the points of each camera lie on a fit: sum of (residual / sigma)^2 over the points that were kept.
struct FitScatter {
  std::array<double, kCameraCount> chi2{};
  std::array<double, kCameraCount> points{};
  [[nodiscard]] double total() const {
    double n = 0;
    for (const double p : points) n += p;
    return n;
  }
  [[nodiscard]] double sum() const {
    double s = 0;
    for (const double c : chi2) s += c;
    return s;
  }
};

/// Unknowns of a fit and what they are uncertain by, for points of the given sigmas.
struct FitSolution {
  bool valid = false;
  std::size_t unknowns = 0;
  NormalFactor normal;
  UnknownMatrix shared{};  ///< SharedErrors::factor
  double absorbed = 0;     ///< by how much the fit lowers the expected sum of chi2, in points
  FitScatter scatter;
  double meanSquareMm2 = 0;  ///< of the residuals of the points that were kept

  void setShared(const SharedErrors& errors) {
    shared = errors.factor(normal);
    absorbed = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      UnknownVector column{};
      for (std::size_t k = i; k < unknowns; ++k) column[k] = shared[k][i];
      for (const double w : normal.whitened(column)) absorbed += w * w;
    }
  }
  /// A quantity with this gradient as a sum of independent errors of standard deviation 1.
  [[nodiscard]] UnknownVector deviations(const UnknownVector& gradient) const {
    const UnknownVector h = normal.solve(gradient);
    UnknownVector d{};
    for (std::size_t i = 0; i < unknowns; ++i)
      for (std::size_t k = i; k < unknowns; ++k) d[i] += shared[k][i] * h[k];
    return d;
  }
};

class RobustRounds {
 public:
  /// residual(points, i): of one point, mm. round(points, weighting, free): its step in mm, negative if it failed; not
  /// free: the curvatures stay, far from the points they would run away.
  template <typename Residual, typename Round>
  bool run(const FitPoints& points, Residual residual, Round round) {
    choose(points);
    double scale = scaleOf(points, residual);
    for (int i = 0; i < kShiftRounds && scale > kFarOff; ++i) {
      if (!(round(subset_, Weighting{kTukey * scale * kTukey * scale, false}, false) >= 0)) return false;
      scale = scaleOf(points, residual);
    }
    for (int i = 0; i < kSoftRounds; ++i) {
      const double step = round(subset_, Weighting{kTukey * scale * kTukey * scale, false}, true);
      if (!(step >= 0)) return false;
      if (scale > 1) scale = scaleOf(points, residual);
      if (step < kSettledMm) break;
    }
    const Weighting hard{kHardCut * scale * kHardCut * scale, true};
    for (int i = 0; i < kHardRounds; ++i) {
      const double step = round(points, hard, true);
      if (!(step >= 0)) return false;
      if (step < kRefinedMm) break;
    }
    return true;
  }

 private:
  static constexpr double kTukey = 4.685;  // 95 % efficiency on normal errors
  static constexpr double kHardCut = 4;    // standard deviations, in the last rounds
  static constexpr double kFarOff = 3;     // a robust scale, in standard uncertainties: the curve lies elsewhere
  static constexpr int kShiftRounds = 4;
  static constexpr int kSoftRounds = 6;
  static constexpr int kHardRounds = 3;
  static constexpr std::size_t kSoftPoints = 120;
  static constexpr double kSettledMm = 2e-3;  // a step this small: on to the last rounds
  // A last step this small needs no other: the fits are linear in it to a nanometre, and no point changes sides.
  static constexpr double kRefinedMm = 5e-3;
  static constexpr std::size_t kScaleSamples = 63;

  void choose(const FitPoints& points) {
    const std::size_t stride = std::max<std::size_t>(1, points.count / kSoftPoints);
    subset_.resize(0);
    for (std::size_t i = 0; i < points.count; i += stride) subset_.append(points, i);
    subset_.runs.assign(1, {0, subset_.count, 0});
  }
  /// Of the residuals in standard uncertainties, at least 1; from their median.
  template <typename Residual>
  double scaleOf(const FitPoints& points, Residual residual) {
    squares_.clear();
    const std::size_t stride = points.count / kScaleSamples + 1;
    for (std::size_t i = stride / 2; i < points.count; i += stride) {
      const double r = residual(points, i);
      squares_.push_back(r * r * static_cast<double>(points.weight[i]));
    }
    if (squares_.empty()) return 1;
    const auto middle = squares_.begin() + static_cast<std::ptrdiff_t>(squares_.size() / 2);
    std::nth_element(squares_.begin(), middle, squares_.end());
    return std::max(1.0, 1.4826 * std::sqrt(*middle));
  }

  FitPoints subset_;
  std::vector<double> squares_;
};

/// Takes the sums of one camera's points into a scatter.
inline void addTo(FitScatter& scatter, std::uint8_t camera, const ResidualSums& sums) {
  scatter.chi2[camera] += sums.chi2;
  scatter.points[camera] += sums.count;
}

}  // namespace vignole
