#pragma once
// Points of a registered profile -> fitted primitives with their covariance (paper section II-F, thin red lines of
// Fig. 5), ready for the definitions.

#include <string>
#include <vector>

#include "engine/measurement/chain_fit.h"
#include "engine/measurement/definitions.h"
#include "engine/measurement/foot_bottom_fit.h"
#include "engine/measurement/measurement.h"
#include "engine/measurement/point_groups.h"

namespace vignole {

/// Unknowns of all fits together: an ordinary section has about 40.
inline constexpr std::size_t kMaxGlobalUnknowns = 48;
/// A reading's change as a sum of independent errors of standard deviation 1, one per unknown: the scalar product of
/// two is their covariance, mm^2.
using Deviations = std::array<double, kMaxGlobalUnknowns>;
[[nodiscard]] inline double covariance(const Deviations& a, const Deviations& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

class PrimitiveFits {
 public:
  PrimitiveFits(const Section& section, const SectionPlan& plan, const MeasurementSettings& settings);

  /// Fits everything to the points that the registration assigned. Frame of the shapes: the registered section.
  void fit(const Profile& profile, const Registration& registration, double cold);
  [[nodiscard]] const Shapes& shapes() const { return shapes_; }
  [[nodiscard]] Deviations deviations(const Reading& reading) const;
  [[nodiscard]] double variance(const Reading& reading) const {
    const Deviations d = deviations(reading);
    return covariance(d, d);
  }
  [[nodiscard]] int pointsOn(const PrimitiveSet& primitives) const;
  /// Fitted primitives in the world.
  void describe(const Transform2& worldFromSection, double cold, std::vector<FittedPrimitive>& fitted) const;

 private:
  static constexpr std::size_t kNoBlock = kMaxGlobalUnknowns;
  struct Block {
    const FitSolution* solution = nullptr;
    std::size_t base = 0;
    double factor = 1;  ///< on the variance for points of the given sigma
  };
  void fitFootBottom(double correlatedPoints);
  void fitChain(std::size_t chain, double correlatedPoints);
  void publishChain(std::size_t chain, std::size_t first, std::size_t last);
  [[nodiscard]] std::size_t nextBase() const;
  void pool();
  void miss(std::size_t primitive, std::string reason) { shapes_.missing[primitive] = std::move(reason); }
  [[nodiscard]] std::string tooFew(std::size_t primitive) const;

  MeasurementSettings settings_;
  std::vector<std::string> names_;
  std::vector<double> lengthMm_;  ///< of the section's primitives
  std::size_t footBottom_ = 0;
  Interval footSpanMm_;  ///< abscissae of the ends of the section's foot bottom
  std::vector<ChainFit> chains_;
  FootBottomFit footFit_;
  PointGroups groups_;
  Shapes shapes_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> blockOfFit_;  ///< the foot bottom is the last fit; kNoBlock where there is none
  std::vector<double> sorted_;
};

}  // namespace vignole
