#pragma once
// The plate with protruding pins that brings the four range finders into one world (paper section III-B, Fig. 8a).
// Frame of the plate: that of the rail section it stands in for (x right, y up, mm), the pins along z towards the
// cameras; the lasers' plane cuts the pins, the plate's surface lies behind it.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"

namespace vignole {

struct Pin {
  int number = 0;  ///< 1, 2 ... as engraved
  Point2 centreMm{0, 0};
  double radiusMm = 0;
  double uCentreMm = 0;  ///< standard uncertainty of each coordinate of the centre
  double uRadiusMm = 0;
};

struct PinPlate {
  std::string id;
  bool measured = false;  ///< centres and radii from a coordinate measuring machine, not from the drawing
  std::vector<Pin> pins;
  double protrusionMm = 8;  ///< of the pins beyond the light plane
  double surfaceMm = 15;    ///< of the plate behind the light plane
};

/// TOML (format = 1, a [[pin]] each with number, x_mm, y_mm, radius_mm, u_mm, u_radius_mm; or tolerance_mm and
/// radius_tolerance_mm for all: rectangular, u = tolerance / sqrt(3), JCGM 100 4.3.7) or a JSON list of [x, y, radius].
/// Refuses fewer than 4 pins, pins on one line, pins that overlap, numbers that appear twice.
[[nodiscard]] Expected<PinPlate> loadPinPlate(const std::filesystem::path& file);
[[nodiscard]] Expected<void> savePinPlate(const PinPlate& plate, const std::filesystem::path& file);
/// The proposed plate of 13 pins (optics design, section 1.10), ideal, without uncertainty.
[[nodiscard]] PinPlate plate13();

}  // namespace vignole
