#pragma once
// A rail section: a closed outline of named primitives (the paper's Table I), counter-clockwise, in the section frame:
// millimetres, origin at the centre of the foot bottom, x right, y up, looking along the rail's motion.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/primitive.h"
#include "engine/rail/dimension.h"

namespace vignole {

/// A primitive with its name after Table I: A arc, S segment; H head, W web, B base; T top, B bottom; L, R.
struct NamedPrimitive {
  std::string name;
  Primitive shape;
};

/// What a source publishes of a section; used to check the outline, never to measure.
struct PublishedValues {
  std::optional<double> areaCm2, massKgPerM, ixCm4, iyCm4, centroidYMm;
  double areaTolerancePercent = 0.05;
  std::string source;
};

/// Exact integrals over the outline; density 7850 kg/m3.
struct SectionProperties {
  double areaMm2 = 0, massKgPerM = 0, centroidXMm = 0, centroidYMm = 0, ixCm4 = 0, iyCm4 = 0, perimeterMm = 0;
  double maxGapMm = 0, maxKinkDeg = 0;
};

/// How far a section may be trusted.
enum class SectionStanding { Standard, Approximate, Invented };

/// Value type. Made by createSection only, so it is always closed and tangent.
struct Section {
  std::string name;
  std::string standard;
  SectionStanding standing = SectionStanding::Standard;
  std::string note;                        ///< provenance in one line, shown to people
  std::vector<NamedPrimitive> primitives;  ///< counter-clockwise, each starts where the previous ends
  double axisFromFootMiddleMm = 0;         ///< rails.md: 0 for symmetric rails, +10.5 for the asymmetric example
  DimensionParameters parameters;          ///< where this section's dimensions are taken, unless a recipe says else
  PublishedValues published;

  [[nodiscard]] std::optional<std::size_t> find(std::string_view primitiveName) const;
  /// x of the rail's axis in the section frame: the middle of the foot edges plus axisFromFootMiddleMm.
  [[nodiscard]] double axisXMm() const;
  /// Height of the crown on the axis.
  [[nodiscard]] double heightMm() const;
  /// Every primitive has its mirror image at the axis (to 1e-3 mm).
  [[nodiscard]] bool symmetric() const;
};

[[nodiscard]] SectionProperties properties(const Section& section);

/// Refuses (with the primitive's name): a gap >= 1e-3 mm, a kink >= 0.01 deg, clockwise or self-crossing outlines, a
/// primitive without which the dimensions have no meaning (SBB, SBL, SBR, SHL, SHR, SWBx, SHBx, AHT).
[[nodiscard]] Expected<Section> createSection(Section candidate);

/// The JSON form (resources/rails/*.json). `where` of an error names file, line or primitive and field.
[[nodiscard]] Expected<Section> loadSection(const std::filesystem::path& file);
/// The same from a text, as toJson() writes it.
[[nodiscard]] Expected<Section> parseSection(const std::string& text, const std::string& nameInErrors);
[[nodiscard]] std::string toJson(const Section& section);

}  // namespace vignole
