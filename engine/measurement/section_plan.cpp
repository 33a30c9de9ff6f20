#include "engine/measurement/section_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/measurement/curve_piece.h"
#include "engine/measurement/measurement.h"

namespace vignole {
namespace {

constexpr double kOnPrimitiveMm = 1e-6;
constexpr double kJointMm = 3.0;        // a web height nearer than this to a joint is measured on both primitives
constexpr double kFishingEdgeMm = 0.3;  // a default parameter stays this far inside the fishing surfaces

std::string millimetres(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", v);
  return text;
}

/// The outline from SBB on, counter-clockwise, with the stations that a rail passes.
class Walk {
 public:
  static Expected<Walk> along(const Section& section) {
    Walk walk(section);
    const auto start = section.find("SBB");
    if (!start) return inputError(section.name, "has no primitive SBB");
    const std::size_t n = section.primitives.size();
    for (std::size_t k = 0; k < n; ++k) walk.order_.push_back((*start + k) % n);
    static constexpr const char* kStations[] = {"SBB", "SBR", "SWBR", "SHBR", "SHR",
                                                "AHT", "SHL", "SHBL", "SWBL", "SBL"};
    std::size_t previous = 0;
    for (const char* station : kStations) {
      const auto found = section.find(station);
      if (!found) return inputError(section.name, std::string("has no primitive ") + station);
      const std::size_t position = (*found + n - *start) % n;
      if (position < previous)
        return inputError(section.name, std::string(station) +
                                            " is out of order: an outline runs counter-clockwise "
                                            "SBB, SBR, SWBR, SHBR, SHR, AHT, SHL, SHBL, SWBL, SBL");
      previous = position;
    }
    return walk;
  }
  [[nodiscard]] std::size_t at(const char* name) const { return *section_->find(name); }
  /// Primitives between two stations, each included or not.
  [[nodiscard]] std::vector<std::size_t> between(const char* from, bool withFrom, const char* to, bool withTo) const {
    std::size_t a = position(from), b = position(to);
    if (!withFrom) ++a;
    if (withTo) ++b;
    std::vector<std::size_t> result;
    for (std::size_t k = a; k < b; ++k) result.push_back(order_[k]);
    return result;
  }

 private:
  explicit Walk(const Section& section) : section_(&section) {}
  [[nodiscard]] std::size_t position(const char* name) const {
    return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), at(name)) - order_.begin());
  }
  const Section* section_;
  std::vector<std::size_t> order_;
};

bool within(const CurvePiece& piece, double x, double y) {
  const double s = arcPosition(piece, x, y);
  return s >= piece.fromMm - kOnPrimitiveMm && s <= piece.toMm + kOnPrimitiveMm;
}

/// Height of the primitive over x, if x lies over it.
std::optional<double> heightOver(const Section& section, std::size_t primitive, double x) {
  const Primitive& shape = section.primitives[primitive].shape;
  const CurvePiece piece = pieceOf(shape, length(shape) / 2);
  const auto y = ordinateAt(piece, x);
  return y && within(piece, x, *y) ? y : std::nullopt;
}

std::optional<double> xAtHeight(const Section& section, std::size_t primitive, double y) {
  const Primitive& shape = section.primitives[primitive].shape;
  const CurvePiece piece = pieceOf(shape, length(shape) / 2);
  const auto x = abscissaAt(piece, y);
  return x && within(piece, *x, y) ? x : std::nullopt;
}

std::optional<std::size_t> primitiveOver(const Section& section, const std::vector<std::size_t>& candidates, double x) {
  for (const std::size_t p : candidates)
    if (heightOver(section, p, x)) return p;
  return std::nullopt;
}

struct WebFace {
  double x = 0;
  std::size_t primitive = 0;
};

std::optional<WebFace> webFace(const Section& section, const std::vector<std::size_t>& web, double y) {
  for (const std::size_t p : web)
    if (const auto x = xAtHeight(section, p, y)) return WebFace{*x, p};
  return std::nullopt;
}

/// Where the web is thinnest: the middle of all heights within a rounding error of the minimum.
std::optional<double> thinnestHeight(const Section& section, const std::array<std::vector<std::size_t>, 2>& web) {
  constexpr double kStepMm = 0.1, kFlatMm = 2e-5;
  std::vector<std::pair<double, double>> thickness;
  double least = 1e300;
  for (double y = 0; y < section.heightMm(); y += kStepMm) {
    const auto left = webFace(section, web[kLeft], y), right = webFace(section, web[kRight], y);
    if (!left || !right) continue;
    thickness.emplace_back(y, right->x - left->x);
    least = std::min(least, thickness.back().second);
  }
  double low = 0, high = 0;
  bool any = false;
  for (const auto& [y, t] : thickness) {
    if (t > least + kFlatMm) continue;
    if (!any) low = y;
    high = y;
    any = true;
  }
  if (!any) return std::nullopt;
  return (low + high) / 2;
}

/// The primitive at the height, with its neighbour where the height lies next to their joint.
std::vector<std::size_t> webPrimitives(const Section& section, const std::vector<std::size_t>& web, double y) {
  const auto face = webFace(section, web, y);
  if (!face) return {};
  std::vector<std::size_t> result{face->primitive};
  const auto it = std::find(web.begin(), web.end(), face->primitive);
  const Primitive& shape = section.primitives[face->primitive].shape;
  if (std::holds_alternative<Segment>(shape)) return result;  // a line bears a little extrapolation
  const double s = nearest(shape, {face->x, y}).arcLengthMm;
  if (s < kJointMm && it != web.begin())
    result.insert(result.begin(), *(it - 1));
  else if (length(shape) - s < kJointMm && it + 1 != web.end())
    result.push_back(*(it + 1));
  return result;
}

std::string off(const Section& section, Dimension dimension, const std::string& parameter, const std::string& where) {
  return std::string(name(dimension)) + ": the parameter " + parameter + " falls off " + where + " of " + section.name +
         "; choose one that lies on it";
}

Expected<void> planCrown(const Section& section, const DimensionParameters& parameters, const Walk& walk,
                         SectionPlan& plan) {
  const auto crown = walk.between("SHR", false, "SHL", false);
  const auto onAxis = primitiveOver(section, crown, 0);
  if (!onAxis) return inputError(section.name, "has no crown over its axis");
  plan.crownOnAxis = *onAxis;
  const double top = *heightOver(section, *onAxis, 0);
  for (double x = -std::floor(parameters.hfHalfWidthMm.left); x <= parameters.hfHalfWidthMm.right + 1e-9; x += 1) {
    const auto p = primitiveOver(section, crown, x);
    if (!p) return inputError(section.name, off(section, Dimension::HF, millimetres(std::abs(x)), "the crown"));
    plan.crown.push_back({x, *p, *heightOver(section, *p, x) - top, false});
  }
  for (std::size_t k = 0; k < plan.crown.size(); ++k) {
    const bool end = k == 0 || k + 1 == plan.crown.size();
    plan.crown[k].candidate = end || plan.crown[k - 1].primitive != plan.crown[k].primitive ||
                              plan.crown[k + 1].primitive != plan.crown[k].primitive;
  }
  return {};
}

Expected<void> planFootTop(const Section& section, const DimensionParameters& parameters, const Walk& walk,
                           SectionPlan& plan) {
  const std::array<std::vector<std::size_t>, 2> tops = {walk.between("SWBL", true, "SBL", false),
                                                        walk.between("SBR", false, "SWBR", true)};
  const std::array<double, 2> inside = {parameters.ftInsideMm.left, parameters.ftInsideMm.right};
  const std::array<Dimension, 2> dimension = {Dimension::FTl, Dimension::FTr};
  for (const std::size_t side : {kLeft, kRight}) {
    const auto edge = xAtHeight(section, plan.footEdge[side], plan.footEdgeMidHeightMm[side]);
    if (!edge) return inputError(section.name, "foot edge is not a side of the foot");
    const double x = *edge + (side == kLeft ? inside[side] : -inside[side]);
    const auto top = primitiveOver(section, tops[side], x);
    if (!top)
      return inputError(section.name, off(section, dimension[side], millimetres(inside[side]), "the foot's top"));
    plan.footTop[side] = *top;
  }
  return {};
}

Expected<void> planWeb(const Section& section, const DimensionParameters& parameters, const Walk& walk,
                       SectionPlan& plan) {
  const std::array<std::vector<std::size_t>, 2> web = {walk.between("SHBL", false, "SWBL", false),
                                                       walk.between("SWBR", false, "SHBR", false)};
  plan.webHeightMm = parameters.wtHeightMm ? parameters.wtHeightMm : thinnestHeight(section, web);
  if (!plan.webHeightMm) return {};  // no web: WT is not defined on this section
  for (const std::size_t side : {kLeft, kRight}) {
    plan.web[side] = webPrimitives(section, web[side], *plan.webHeightMm);
    if (plan.web[side].empty())
      return inputError(section.name, off(section, Dimension::WT, millimetres(*plan.webHeightMm), "the web"));
  }
  return {};
}

}  // namespace

Expected<SectionPlan> planSection(const Section& section, const DimensionParameters& parameters) {
  const auto walk = Walk::along(section);
  if (!walk) return tl::unexpected(walk.error());
  SectionPlan plan;
  plan.axisFromFootMiddleMm = section.axisFromFootMiddleMm;
  plan.footBottom = walk->at("SBB");
  plan.headTop = walk->at("AHT");
  plan.footEdge = {walk->at("SBL"), walk->at("SBR")};
  plan.fishingLower = {walk->at("SWBL"), walk->at("SWBR")};
  plan.fishingUpper = {walk->at("SHBL"), walk->at("SHBR")};
  plan.headSide[kRight] = walk->between("SHR", true, "AHT", false);
  plan.headSide[kLeft] = walk->between("AHT", false, "SHL", true);
  std::reverse(plan.headSide[kLeft].begin(), plan.headSide[kLeft].end());
  for (const std::size_t side : {kLeft, kRight}) {
    const Primitive& edge = section.primitives[plan.footEdge[side]].shape;
    plan.footEdgeMidHeightMm[side] = (startPoint(edge).y() + endPoint(edge).y()) / 2;
  }
  if (auto ok = planFootTop(section, parameters, *walk, plan); !ok) return tl::unexpected(ok.error());
  if (auto ok = planWeb(section, parameters, *walk, plan); !ok) return tl::unexpected(ok.error());
  if (auto ok = planCrown(section, parameters, *walk, plan); !ok) return tl::unexpected(ok.error());
  return plan;
}

DimensionParameters defaultParameters(const Section& section) {
  DimensionParameters parameters;
  const auto place = [&](const char* lower, const char* upper, double& fromAxis) {
    const auto a = section.find(lower), b = section.find(upper);
    if (!a || !b) return;
    double low = 0, high = 1e9;
    for (const std::size_t p : {*a, *b}) {
      const double x0 = std::abs(startPoint(section.primitives[p].shape).x());
      const double x1 = std::abs(endPoint(section.primitives[p].shape).x());
      low = std::max(low, std::min(x0, x1));
      high = std::min(high, std::max(x0, x1));
    }
    if (fromAxis >= low && fromAxis <= high) return;
    if (low >= high) return;  // nothing fits: nominalDimensions says so
    const double edge = std::min(kFishingEdgeMm, (high - low) / 2);
    fromAxis = std::round(std::clamp(fromAxis, low + edge, high - edge) * 100) / 100;
  };
  place("SWBL", "SHBL", parameters.rfhFromAxisMm.left);
  place("SWBR", "SHBR", parameters.rfhFromAxisMm.right);
  return parameters;
}

}  // namespace vignole
