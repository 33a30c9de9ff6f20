#pragma once
// Points of a registered profile -> fitted primitives with their covariance (paper section II-F, thin red lines of
// Fig. 5), ready for the definitions.

#include <string>
#include <vector>

#include "engine/measurement/chain_fit.h"
#include "engine/measurement/definitions.h"
#include "engine/measurement/measurement.h"

namespace vignole {

/// Unknowns of all fits together: an ordinary section has about 40.
inline constexpr std::size_t kMaxGlobalUnknowns = 48;
using GlobalDual = Dual<kMaxGlobalUnknowns>;

class PrimitiveFits {
 public:
  PrimitiveFits(const Section& section, const SectionPlan& plan, const MeasurementSettings& settings);

  /// Fits everything to the points that the registration assigned. Frame of the shapes: the registered section.
  void fit(const Profile& profile, const Registration& registration);
  [[nodiscard]] const Shapes<GlobalDual>& shapes() const { return shapes_; }
  /// Variance of a quantity with this gradient, mm^2.
  [[nodiscard]] double variance(const GlobalDual& quantity) const { return covariance(quantity, quantity); }
  [[nodiscard]] double covariance(const GlobalDual& a, const GlobalDual& b) const;
  [[nodiscard]] int pointsOn(const PrimitiveSet& primitives) const;
  /// Fitted primitives in the world.
  void describe(const Transform2& worldFromSection, std::vector<FittedPrimitive>& fitted) const;

 private:
  /// Where a primitive ends and which of its ends are left out of its fit.
  struct Border {
    Point2 start{0, 0}, startTangent{1, 0}, end{0, 0}, endTangent{1, 0}, chord{1, 0};
    double lengthMm = 0, chordMm = 0, curvature = 0;
    bool trimStart = true, trimEnd = true;
    int fit = -1;              ///< index into chains_, kFootBottom, or -1: not needed
    std::size_t position = 0;  ///< in the chain
  };
  static constexpr int kFootBottom = 1000;
  struct Assigned {
    FitPoint point;
    std::uint16_t primitive = 0;
    float marginMm = 0;  ///< to the nearest end that is trimmed
    float alongMm = 0;   ///< along the chord
  };
  struct Coverage {
    int points = 0;
    double lowMm = 1e300, highMm = -1e300;  ///< along the chord
  };
  void makeBorders(const Section& section);
  void gather(const Profile& profile, const Registration& registration);
  [[nodiscard]] double trimOf(std::size_t primitive) const;
  void distribute();
  void fitFootBottom();
  void fitChain(std::size_t chain);
  void publishChain(std::size_t chain, std::size_t first, std::size_t last, std::size_t base);
  void pool(double correlatedPoints);
  void miss(std::size_t primitive, std::string reason) { shapes_.missing[primitive] = std::move(reason); }
  [[nodiscard]] std::string tooFew(std::size_t primitive) const;
  [[nodiscard]] double arcLengthAt(const Border& border, double alongChordMm) const;

  MeasurementSettings settings_;
  std::vector<std::string> names_;
  std::size_t footBottom_ = 0;
  std::vector<ChainFit> chains_;
  FootBottomFit footFit_;
  std::vector<Border> borders_;
  std::vector<Assigned> assigned_;
  std::vector<std::array<int, 4>> counts_;  ///< points left at each degree of trimming
  std::vector<Coverage> coverage_;
  Shapes<GlobalDual> shapes_;
  struct Block {
    const FitSolution* solution = nullptr;
    std::size_t base = 0;
    double factor = 1;  ///< on the covariance for independent points of the given sigma
  };
  std::vector<Block> blocks_;
  std::vector<double> sorted_;
};

}  // namespace vignole
