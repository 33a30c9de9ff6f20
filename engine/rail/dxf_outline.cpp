#include <array>
#include <cmath>
#include <cstdlib>
#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <map>
#include <numbers>
#include <sstream>

#include "engine/files/atomic_file.h"
#include "engine/rail/outline.h"

namespace vignole {

namespace {

constexpr double kPi = std::numbers::pi;

/// $INSUNITS -> mm; drawings without units are taken to be in mm.
const std::map<int, double> kMmPerUnit = {{0, 1}, {1, 25.4}, {2, 304.8}, {4, 1}, {5, 10}, {6, 1000}};

struct Vertex {
  Point2 at;
  double bulge;
};

/// Collects what makes an outline; refuses curves that it could only approximate.
class Collector : public DL_CreationAdapter {
 public:
  std::vector<Piece> pieces;
  std::optional<std::string> refusal;
  double mmPerUnit = 1;

  void finishPolyline() {
    if (!inPolyline_) return;
    inPolyline_ = false;
    const std::size_t count = vertices_.size();
    for (std::size_t i = 0; i + (closed_ ? 0 : 1) < count; ++i) addSide(vertices_[i], vertices_[(i + 1) % count]);
    vertices_.clear();
  }

  using DL_CreationAdapter::setVariableInt;
  void setVariableInt(const std::string& key, int value, int /*code*/) override {
    if (key != "$INSUNITS") return;
    const auto known = kMmPerUnit.find(value);
    if (known == kMmPerUnit.end())
      refuse("is in a unit ($INSUNITS " + std::to_string(value) + ") that is not known; save it in mm");
    else
      mmPerUnit = known->second;
  }

  void addBlock(const DL_BlockData& /*data*/) override { inBlock_ = true; }
  void endBlock() override { inBlock_ = false; }
  void addLine(const DL_LineData& line) override {
    finishPolyline();
    add(Segment{{line.x1, line.y1}, {line.x2, line.y2}}, "LINE");
  }
  void addArc(const DL_ArcData& arc) override {
    finishPolyline();
    const double from = arc.angle1 * kPi / 180;
    double sweep = std::fmod((arc.angle2 - arc.angle1) * kPi / 180, 2 * kPi);
    if (sweep <= 0) sweep += 2 * kPi;
    if (mirrored())
      add(Arc{{-arc.cx, arc.cy}, arc.radius, kPi - from, -sweep}, "ARC");
    else
      add(Arc{{arc.cx, arc.cy}, arc.radius, from, sweep}, "ARC");
  }
  void addPolyline(const DL_PolylineData& polyline) override {
    finishPolyline();
    inPolyline_ = true;
    closed_ = (static_cast<unsigned>(polyline.flags) & 1U) != 0;
    mirrorPolyline_ = mirrored();
    ++polylines_;
  }
  void addVertex(const DL_VertexData& vertex) override {
    if (mirrorPolyline_)
      vertices_.push_back({{-vertex.x, vertex.y}, -vertex.bulge});
    else
      vertices_.push_back({{vertex.x, vertex.y}, vertex.bulge});
  }
  void endSequence() override { finishPolyline(); }

  void addSpline(const DL_SplineData& /*data*/) override { refuseEntity("a SPLINE"); }
  void addEllipse(const DL_EllipseData& /*data*/) override { refuseEntity("an ELLIPSE"); }
  void addCircle(const DL_CircleData& /*data*/) override { refuseEntity("a CIRCLE"); }
  void addInsert(const DL_InsertData& /*data*/) override { refuseEntity("a block (INSERT)"); }

 private:
  void refuse(std::string what) {
    if (!refusal) refusal = std::move(what);
  }
  void refuseEntity(const std::string& what) {
    if (!inBlock_)
      refuse("holds " + what + "; explode or convert it to lines and arcs, and leave nothing but the outline");
  }
  /// Entities drawn from behind (extrusion 0, 0, -1) have x the other way round; lines never.
  [[nodiscard]] bool mirrored() {
    std::array<double, 3> direction{0, 0, 1};
    getExtrusion()->getDirection(direction.data());
    return direction[2] < 0;
  }
  void add(const Primitive& shape, const std::string& kind) {
    if (inBlock_) return;
    if (const auto* arc = std::get_if<Arc>(&shape); arc != nullptr && !(arc->radiusMm > 0))
      return refuse("holds an arc with a radius that is not above 0");
    pieces.push_back({shape, kind + " " + std::to_string(++counts_[kind])});
  }
  /// A bulge is the tangent of a quarter of the arc's sweep (DXF reference, LWPOLYLINE, group 42).
  void addSide(const Vertex& a, const Vertex& b) {
    const std::string kind = "side of polyline " + std::to_string(polylines_);
    if (a.bulge == 0 || (b.at - a.at).norm() == 0) return add(Segment{a.at, b.at}, kind);
    const Point2 chord = b.at - a.at;
    const double sweep = 4 * std::atan(a.bulge);
    const Point2 left(-chord.y(), chord.x());
    const Point2 centre = (a.at + b.at) / 2 + left * (1 - a.bulge * a.bulge) / (4 * a.bulge);
    const Point2 radial = a.at - centre;
    add(Arc{centre, radial.norm(), std::atan2(radial.y(), radial.x()), sweep}, kind);
  }

  bool inBlock_ = false, inPolyline_ = false, closed_ = false, mirrorPolyline_ = false;
  int polylines_ = 0;
  std::vector<Vertex> vertices_;
  std::map<std::string, int> counts_;
};

/// dxflib reads text where a number should be as 0 and says nothing, so the pairs of lines (code, value) are read
/// before.
Expected<void> checkNumbers(const std::string& text, const std::string& file) {
  std::istringstream lines(text);
  std::string code, value;
  for (int line = 2; std::getline(lines, code) && std::getline(lines, value); line += 2) {
    const int group = std::atoi(code.c_str());  // NOLINT(cert-err34-c): no number is 0, which is not checked
    if (group < 10 || group > 59) continue;
    if (!value.empty() && value.back() == '\r') value.pop_back();
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    while (*end == ' ') ++end;
    if (end == value.c_str() || *end != '\0' || !std::isfinite(number))
      return inputError(file + ":" + std::to_string(line),
                        "has \"" + value + "\" where group " + std::to_string(group) + " needs a number");
  }
  return {};
}

Primitive scaled(const Primitive& shape, double factor) {
  if (const auto* s = std::get_if<Segment>(&shape)) return Segment{s->start * factor, s->end * factor};
  Arc arc = std::get<Arc>(shape);
  arc.centre *= factor;
  arc.radiusMm *= factor;
  return arc;
}

}  // namespace

Expected<std::vector<Piece>> readDxf(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  if (text->starts_with("AutoCAD Binary DXF")) return inputError(file.string(), "is binary DXF; save it as text DXF");
  if (text->find("EOF") == std::string::npos || text->find("ENTITIES") == std::string::npos)
    return inputError(file.string(), "is not a complete DXF file (no ENTITIES section, or no EOF at its end)");
  if (auto good = checkNumbers(*text, file.string()); !good) return tl::unexpected(good.error());

  Collector collector;
  DL_Dxf reader;
  std::istringstream stream(*text);
  if (!reader.in(stream, &collector)) return inputError(file.string(), "cannot be read as DXF");
  collector.finishPolyline();
  if (collector.refusal) return inputError(file.string(), *collector.refusal);
  if (collector.pieces.empty())
    return inputError(file.string(), "holds no LINE, ARC, LWPOLYLINE or POLYLINE; a closed outline is expected");
  for (Piece& piece : collector.pieces) piece.shape = scaled(piece.shape, collector.mmPerUnit);
  return std::move(collector.pieces);
}

}  // namespace vignole
