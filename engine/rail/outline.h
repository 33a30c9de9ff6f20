#pragma once
// From loose lines and arcs of a drawing to a section: stitched, turned the right way round, named after Table I.

#include <optional>
#include <string>
#include <vector>

#include "engine/rail/section.h"

namespace vignole {

/// A line or an arc of a drawing and what the drawing calls it ("ARC 3", "MPD4"), for errors.
struct Piece {
  Primitive shape;
  std::string label;
};

/// Pieces in any order and direction -> one closed outline, counter-clockwise, halves of the same line or circle
/// joined. Refuses an open outline (naming the first gap) and anything beside one outline.
[[nodiscard]] Expected<std::vector<Primitive>> stitch(std::vector<Piece> pieces);

/// Where an outline that stitch() refuses is open: the first free end, and the nearest other one.
struct OutlineGap {
  Point2 end;
  std::optional<Point2> other;
};
/// Empty: every end meets another one.
[[nodiscard]] std::optional<OutlineGap> firstGap(std::vector<Piece> pieces);

/// Moves the origin to the centre of the foot bottom and names the primitives by walking the outline up both sides.
/// Refuses what does not look like an upright rail with a foot, naming what was looked for.
[[nodiscard]] Expected<Section> sectionFromOutline(std::vector<Primitive> outline, const std::string& name);

/// The default parameters, but for RFH where 25 mm from the axis is not on both fishing surfaces: the middle of what
/// they have in common.
[[nodiscard]] DimensionParameters usualParameters(const Section& section);

/// Entities of a DXF file: LINE, ARC, LWPOLYLINE and POLYLINE with bulges, in mm ($INSUNITS heeded).
[[nodiscard]] Expected<std::vector<Piece>> readDxf(const std::filesystem::path& file);
/// MPDn lines of a MiniProf design file.
[[nodiscard]] Expected<std::vector<Piece>> readMiniprofDesign(const std::filesystem::path& file);

/// What is drawn in a .dxf or a MiniProf design, before anything is asked of it.
[[nodiscard]] Expected<std::vector<Piece>> readPieces(const std::filesystem::path& file);
/// A section from a file of users: .dxf, .json, or a MiniProf design (.ban, .prr).
[[nodiscard]] Expected<Section> importSection(const std::filesystem::path& file, const std::string& name);

}  // namespace vignole
