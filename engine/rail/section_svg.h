#pragma once
// A section as a picture for people: the outline, every primitive in turn dark and light, with its name.

#include <string>

#include "engine/rail/section.h"

namespace vignole {

/// SVG text, 4 px per mm, y up as in the section frame; segments blue, arcs orange.
[[nodiscard]] std::string toSvg(const Section& section);

}  // namespace vignole
