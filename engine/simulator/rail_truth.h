#pragma once
// The dimensions of an outline without noise, by the definitions of Table II as rails.md words them. Shares no code
// with the measurement: dense samples, its own small fits.

#include <array>
#include <span>
#include <vector>

#include "engine/rail/dimension.h"
#include "engine/rail/section.h"
#include "engine/simulator/displaced_outline.h"

namespace vignole::simulator {

struct TrueDimensions {
  PerDimension<double> mm{};  ///< NaN where the outline has no such place
  double hfMinMm = 0;
};

/// Immutable.
class TruthGauge {
 public:
  TruthGauge(const Section& nominal, const DimensionParameters& parameters);
  /// Vertices of a closed outline of the same section, densely sampled (a chord leaves it by < 1e-4 mm).
  [[nodiscard]] TrueDimensions measure(std::span<const OutlineVertex> outline) const;

 private:
  struct Lines;
  struct Sides {
    std::size_t edge, lowerFishing, upperFishing, headSide;
    std::vector<std::size_t> footTop, web, head;
  };
  [[nodiscard]] Sides findSides(char letter) const;
  [[nodiscard]] double crownHeight(const Lines& lines, double x) const;

  Section section_;
  DimensionParameters parameters_;
  std::size_t bottom_ = 0, top_ = 0;
  std::array<Sides, 2> sides_;  ///< right, left
  std::vector<std::size_t> crown_;
  double waistMm_ = 0;
  std::vector<double> nominalCrown_;  ///< height against the axis, at the places of HF
  std::vector<double> places_;
};

}  // namespace vignole::simulator
