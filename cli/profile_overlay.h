#pragma once
// A picture of a measured profile as in the paper's Fig. 5: section thin, points, fitted primitives, dimensions.

#include <span>
#include <string>

#include "engine/measurement/measurement.h"

namespace vignole::cli {

/// SVG text; x right, y up, mm, the section laid into the frame of the points.
[[nodiscard]] std::string overlaySvg(const Section& section, std::span<const ProfilePoint> points,
                                     const Registration& registration, const Measurement& measurement);
/// The same picture as PNG bytes.
[[nodiscard]] Expected<std::string> overlayPng(const Section& section, std::span<const ProfilePoint> points,
                                               const Registration& registration, const Measurement& measurement);

}  // namespace vignole::cli
