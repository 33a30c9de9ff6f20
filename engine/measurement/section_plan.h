#pragma once
// Which primitives of a section each dimension is taken at, found by walking the outline once: nothing about the number
// or kind of primitives between the named ones (Table I) is assumed.

#include <array>
#include <optional>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

/// Index of a side in the arrays below.
enum Side : std::size_t { kLeft = 0, kRight = 1 };

/// A place on the crown where HF compares, x from the axis in mm.
struct CrownSample {
  double xMm = 0;
  std::size_t primitive = 0;
  double nominalDropMm = 0;  ///< nominal height minus the nominal height on the axis
  bool candidate = false;    ///< an end of the width, or next to a joint of primitives
};

struct SectionPlan {
  std::size_t footBottom = 0;
  std::array<std::size_t, 2> footEdge{};
  std::array<double, 2> footEdgeMidHeightMm{};
  std::array<std::size_t, 2> footTop{};              ///< the primitive above the point where FT is taken
  std::array<std::size_t, 2> fishingLower{};         ///< SWB
  std::array<std::size_t, 2> fishingUpper{};         ///< SHB
  std::array<std::vector<std::size_t>, 2> headSide;  ///< from SH upwards, AHT left out
  std::array<std::vector<std::size_t>, 2> web;       ///< at the height of WT: one primitive, two where they meet there
  std::optional<double> webHeightMm;
  std::size_t crownOnAxis = 0;
  std::size_t headTop = 0;  ///< AHT
  std::vector<CrownSample> crown;
  double axisFromFootMiddleMm = 0;
};

/// Refuses a section whose named primitives do not follow each other as on a rail, and parameters off the outline.
[[nodiscard]] Expected<SectionPlan> planSection(const Section& section, const DimensionParameters& parameters);

}  // namespace vignole
