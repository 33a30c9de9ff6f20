#pragma once
// The table of `rails check`: how well an outline closes, is tangent, and meets what is published of its section.

#include <optional>
#include <string>
#include <vector>

#include "engine/rail/section.h"

namespace vignole {

struct SectionCheck {
  std::string what;  ///< "area", "Ix" ...
  std::string unit;
  double value = 0;                 ///< of the outline
  std::optional<double> published;  ///< empty for what is judged by `tolerance` alone (gap, kink)
  double tolerance = 0;             ///< largest allowed |value - published|, in `unit`
  bool pass = false;
};

/// Gap and kink, then every published value: area, mass and moments within the section's area tolerance (moments: and
/// half of their last printed digit), the centroid's height within 0.05 mm (1 mm where the section is approximate).
[[nodiscard]] std::vector<SectionCheck> checkSection(const Section& section);

}  // namespace vignole
