// Table I by walking an outline from the foot bottom up either side to the crown.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/rail/outline.h"

namespace vignole {

namespace {

using Names = std::vector<std::string>;

bool isSegment(const Primitive& p) { return std::holds_alternative<Segment>(p); }
double slopeDeg(const Primitive& p) {  // 0 to the right, 90 up
  const Point2 t = tangentAt(p, 0);
  return std::atan2(t.y(), t.x()) * 180 / std::numbers::pi;
}
bool risesSteeply(const Primitive& p) { return isSegment(p) && std::abs(slopeDeg(p) - 90) < 15; }
bool risesOutwards(const Primitive& p) { return isSegment(p) && slopeDeg(p) > 5 && slopeDeg(p) < 45; }
bool risesInwards(const Primitive& p) { return isSegment(p) && slopeDeg(p) > 135 && slopeDeg(p) < 179; }

/// Mirrored at x = 0 and run through backwards, so that the left side walks like the right.
Primitive mirrored(const Primitive& p) {
  if (const auto* s = std::get_if<Segment>(&p))
    return Segment{{-s->end.x(), s->end.y()}, {-s->start.x(), s->start.y()}};
  Arc arc = std::get<Arc>(p);
  arc.centre.x() = -arc.centre.x();
  arc.startAngleRad = std::numbers::pi - (arc.startAngleRad + arc.sweepRad);
  return arc;
}

/// Indices first .. last (not included) get base + side, numbered from the end that `fromFirst` tells.
void nameRun(Names& names, std::size_t first, std::size_t last, const std::string& base, char side, bool fromFirst,
             bool alwaysNumbered) {
  const std::size_t count = last - first;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t number = fromFirst ? i + 1 : count - i;
    const bool numbered = alwaysNumbered || count > 1;
    names[first + i] = base + side + (numbered ? std::to_string(number) : "");
  }
}

/// Foot top between the edge and the lower fishing surface: arcs and, mostly, a flatter segment.
void nameFootTop(Names& names, const std::vector<Primitive>& walk, std::size_t first, std::size_t last, char side) {
  int arcs = 0, segments = 0;
  const auto total = std::count_if(walk.begin() + static_cast<std::ptrdiff_t>(first),
                                   walk.begin() + static_cast<std::ptrdiff_t>(last), isSegment);
  for (std::size_t i = first; i < last; ++i) {
    if (isSegment(walk[i]))
      names[i] = std::string("SBT") + side + (total > 1 ? std::to_string(++segments) : "");
    else
      names[i] = std::string("ABT") + side + std::to_string(++arcs);
  }
}

/// The straight part of the web, or the arc that is vertical somewhere inside; else only where below meets above.
std::pair<std::size_t, std::size_t> webMiddle(const std::vector<Primitive>& walk, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i)
    if (risesSteeply(walk[i])) return {i, i + 1};
  constexpr double kInsideRad = 1e-3;
  for (std::size_t i = first; i < last; ++i) {
    const Point2 t0 = tangentAt(walk[i], 0), t1 = tangentAt(walk[i], length(walk[i]));
    if (t0.x() < -kInsideRad && t1.x() > kInsideRad) return {i, i + 1};  // inwards, then outwards again
    if (t0.x() >= -kInsideRad) return {i, i};
  }
  return {last, last};
}

template <typename Wanted>
std::optional<std::size_t> lastBefore(const std::vector<Primitive>& walk, std::size_t end, Wanted wanted) {
  for (std::size_t i = end; i-- > 0;)
    if (wanted(walk[i])) return i;
  return std::nullopt;
}

tl::unexpected<Error> notFound(const std::string& primitiveName, const std::string& looks) {
  return inputError("outline", "has no " + primitiveName + ": no " + looks + " was found where it should be");
}

/// Names of what lies between SBB and AHT on one side, in walking order.
Expected<Names> nameSide(const std::vector<Primitive>& walk, char side) {
  const std::string letter(1, side);
  const auto edge = std::find_if(walk.begin(), walk.end(), risesSteeply);
  if (edge == walk.end()) return notFound("SB" + letter, "upright foot edge (a segment)");
  const auto footEdge = static_cast<std::size_t>(edge - walk.begin());
  const auto headSide = lastBefore(walk, walk.size(), risesSteeply);
  if (!headSide || *headSide == footEdge) return notFound("SH" + letter, "upright head side (a segment)");
  const auto headBottom = lastBefore(walk, *headSide, risesOutwards);
  if (!headBottom) return notFound("SHB" + letter, "segment under the head that rises outwards");
  const auto footTop = lastBefore(walk, *headBottom, risesInwards);
  if (!footTop || *footTop < footEdge) return notFound("SWB" + letter, "segment on the foot that rises inwards");

  Names names(walk.size());
  nameRun(names, 0, footEdge, "ABB", side, true, false);
  names[footEdge] = "SB" + letter;
  nameFootTop(names, walk, footEdge + 1, *footTop, side);
  names[*footTop] = "SWB" + letter;
  const auto [webFirst, webLast] = webMiddle(walk, *footTop + 1, *headBottom);
  nameRun(names, *footTop + 1, webFirst, "AWB", side, true, false);
  if (webLast > webFirst) names[webFirst] = (isSegment(walk[webFirst]) ? "SW" : "AW") + letter;
  nameRun(names, webLast, *headBottom, "AWT", side, false, false);
  names[*headBottom] = "SHB" + letter;
  nameRun(names, *headBottom + 1, *headSide, "AHB", side, true, false);
  names[*headSide] = "SH" + letter;
  nameRun(names, *headSide + 1, walk.size(), "AHT", side, true, true);

  for (std::size_t i = 0; i < walk.size(); ++i) {
    const bool wantsArc = names[i].front() == 'A';
    if (wantsArc == isSegment(walk[i]))
      return inputError("outline", "has a segment from (" + std::to_string(startPoint(walk[i]).x()) + ", " +
                                       std::to_string(startPoint(walk[i]).y()) + ") where the arc " + names[i] +
                                       " is expected" + (side == 'L' ? " (mirrored to the right)" : ""));
  }
  return names;
}

double highestY(const Primitive& p) {
  double top = std::max(startPoint(p).y(), endPoint(p).y());
  if (const auto* arc = std::get_if<Arc>(&p)) {
    const Nearest n = nearest(p, arc->centre + Point2(0, 2 * arc->radiusMm));
    top = std::max(top, n.point.y());
  }
  return top;
}

/// The crown: of the primitives that reach the top, the longest (a joint may lie right on it).
std::size_t crownOf(const std::vector<Primitive>& outline) {
  double top = -std::numeric_limits<double>::infinity();
  for (const Primitive& p : outline) top = std::max(top, highestY(p));
  std::size_t crown = 0;
  double longest = -1;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (highestY(outline[i]) < top - 1e-6 || length(outline[i]) <= longest) continue;
    crown = i;
    longest = length(outline[i]);
  }
  return crown;
}

/// The foot bottom: the longest level segment at the lowest height, run through to the right.
std::optional<std::size_t> footBottomOf(const std::vector<Primitive>& outline) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Primitive& p : outline) lowest = std::min({lowest, startPoint(p).y(), endPoint(p).y()});
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const bool level =
        isSegment(outline[i]) && std::abs(slopeDeg(outline[i])) < 0.01 && startPoint(outline[i]).y() < lowest + 0.01;
    if (level && (!found || length(outline[i]) > length(outline[*found]))) found = i;
  }
  return found;
}

double middleX(const Section& section, const char* left, const char* right) {
  const Primitive& l = section.primitives[*section.find(left)].shape;
  const Primitive& r = section.primitives[*section.find(right)].shape;
  return (pointAt(l, length(l) / 2).x() + pointAt(r, length(r) / 2).x()) / 2;
}

}  // namespace

Expected<Section> sectionFromOutline(std::vector<Primitive> outline, const std::string& name) {
  const auto bottom = footBottomOf(outline);
  if (!bottom)
    return inputError("outline", "has no level foot bottom at its lowest edge; turn the rail upright, y upwards");
  std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(*bottom), outline.end());
  const std::size_t crown = crownOf(outline);
  if (isSegment(outline[crown])) return inputError("outline", "has a flat top; the crown AHT must be an arc");

  const std::vector<Primitive> right(outline.begin() + 1, outline.begin() + static_cast<std::ptrdiff_t>(crown));
  std::vector<Primitive> left;
  for (std::size_t i = outline.size(); --i > crown;) left.push_back(mirrored(outline[i]));
  const auto rightNames = nameSide(right, 'R');
  if (!rightNames) return tl::unexpected(rightNames.error());
  const auto leftNames = nameSide(left, 'L');
  if (!leftNames) return tl::unexpected(leftNames.error());

  Section section;
  section.name = name;
  section.primitives.push_back({"SBB", outline.front()});
  for (std::size_t i = 0; i < right.size(); ++i) section.primitives.push_back({(*rightNames)[i], right[i]});
  section.primitives.push_back({"AHT", outline[crown]});
  for (std::size_t i = left.size(); i-- > 0;)
    section.primitives.push_back({(*leftNames)[i], outline[outline.size() - 1 - i]});

  const Transform2 toOrigin{-middleX(section, "SBL", "SBR"), -startPoint(outline.front()).y(), 0};
  for (NamedPrimitive& p : section.primitives) p.shape = transformed(toOrigin, p.shape);
  // The axis of a rail whose head is not over the middle of its foot goes through the middle of the head.
  const double headMiddle = middleX(section, "SHL", "SHR");
  section.axisFromFootMiddleMm = std::abs(headMiddle) < 1e-3 ? 0 : headMiddle;
  auto created = createSection(std::move(section));
  if (created) created->parameters = usualParameters(*created);
  return created;
}

DimensionParameters usualParameters(const Section& section) {
  DimensionParameters parameters;
  const auto choose = [&](const char* head, const char* foot, double& fromAxis) {
    double low = 0, high = std::numeric_limits<double>::infinity();
    for (const char* surface : {head, foot}) {
      const Primitive& p = section.primitives[*section.find(surface)].shape;
      const double a = std::abs(startPoint(p).x() - section.axisXMm()),
                   b = std::abs(endPoint(p).x() - section.axisXMm());
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    if (low < high && (fromAxis < low || fromAxis > high)) fromAxis = (low + high) / 2;
  };
  choose("SHBL", "SWBL", parameters.rfhFromAxisMm.left);
  choose("SHBR", "SWBR", parameters.rfhFromAxisMm.right);
  return parameters;
}

namespace {

std::string kindOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

Expected<std::vector<Piece>> readPieces(const std::filesystem::path& file) {
  const std::string kind = kindOf(file);
  if (kind == ".dxf") return readDxf(file);
  if (kind == ".ban" || kind == ".prr") return readMiniprofDesign(file);
  return inputError(file.string(), "is of an unknown kind; give a .dxf, a .json or a MiniProf design (.ban, .prr)");
}

Expected<Section> importSection(const std::filesystem::path& file, const std::string& name) {
  if (kindOf(file) == ".json") {
    auto section = loadSection(file);
    if (section) section->name = name;
    return section;
  }
  auto pieces = readPieces(file);
  if (!pieces) return tl::unexpected(pieces.error());
  auto outline = stitch(std::move(*pieces));
  auto section =
      outline ? sectionFromOutline(std::move(*outline), name) : Expected<Section>(tl::unexpected(outline.error()));
  if (!section) return inputError(file.string() + ": " + section.error().where, section.error().what);
  section->standing = SectionStanding::Approximate;
  section->standard = "imported";
  section->note = "Imported from " + file.filename().string() + "; check it against its drawing.";
  return section;
}

}  // namespace vignole
