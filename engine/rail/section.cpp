#include "engine/rail/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace vignole {

namespace {

constexpr double kMaxGapMm = 1e-3;
constexpr double kMaxKinkDeg = 0.01;
// Tangent neighbours whose coordinates are rounded may cross within a hair of their joint: sqrt(2 R 1e-6 mm).
constexpr double kJointMm = 0.1;
constexpr double kLargestMm = 10000;  // nothing on a rail is larger; a radius or a coordinate beyond is a slip of units

std::string printed(const char* format, double a, double b = 0, double c = 0) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, a, b, c);  // NOLINT: format is ours
  return text.data();
}

tl::unexpected<Error> refused(const Section& section, const std::string& primitive, std::string what) {
  return inputError("section " + section.name + (primitive.empty() ? "" : ", " + primitive), std::move(what));
}

bool finite(const Primitive& shape) {
  const auto small = [](double v) { return std::abs(v) < kLargestMm; };  // false for NaN as well
  if (const auto* s = std::get_if<Segment>(&shape))
    return small(s->start.x()) && small(s->start.y()) && small(s->end.x()) && small(s->end.y());
  const auto& arc = std::get<Arc>(shape);
  return small(arc.centre.x()) && small(arc.centre.y()) && small(arc.radiusMm) && std::isfinite(arc.startAngleRad) &&
         std::isfinite(arc.sweepRad);
}

Expected<void> checkShapes(const Section& section) {
  if (section.name.empty()) return inputError("section", "has no name");
  if (section.primitives.size() < 3) return refused(section, "", "has fewer than 3 primitives");
  for (std::size_t i = 0; i < section.primitives.size(); ++i) {
    const NamedPrimitive& p = section.primitives[i];
    if (p.name.empty()) return refused(section, "primitive " + std::to_string(i + 1), "has no name");
    if (!finite(p.shape)) return refused(section, p.name, "has a value that is not a number below 10 m");
    const auto* arc = std::get_if<Arc>(&p.shape);
    if (arc != nullptr && !(arc->radiusMm > 0)) return refused(section, p.name, "has a radius that is not above 0");
    if (arc != nullptr && std::abs(arc->sweepRad) >= 2 * std::numbers::pi)
      return refused(section, p.name, "turns by a whole circle or more");
    if (!(length(p.shape) > kMaxGapMm)) return refused(section, p.name, "has no length; remove it");
    if (section.find(p.name) != i) return refused(section, p.name, "is there twice; give every primitive its own name");
  }
  return {};
}

Expected<void> checkJoints(const Section& section) {
  const auto& all = section.primitives;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const NamedPrimitive& a = all[i];
    const NamedPrimitive& b = all[(i + 1) % all.size()];
    const Point2 end = endPoint(a.shape), start = startPoint(b.shape);
    const double gap = (start - end).norm();
    if (!(gap < kMaxGapMm))
      return refused(section, a.name + " to " + b.name,
                     printed("does not close: a gap of %.4g mm at (%.4f, %.4f); make ", gap, end.x(), end.y()) +
                         b.name + " start where " + a.name + " ends");
    const Point2 ta = tangentAt(a.shape, length(a.shape)), tb = tangentAt(b.shape, 0);
    const double kink = std::abs(std::atan2(ta.x() * tb.y() - ta.y() * tb.x(), ta.dot(tb))) * 180 / std::numbers::pi;
    if (!(kink < kMaxKinkDeg))
      return refused(section, a.name + " to " + b.name,
                     printed("has a kink of %.4g degrees at (%.4f, %.4f); neighbours must be tangent within 0.01", kink,
                             end.x(), end.y()));
  }
  return {};
}

Expected<void> checkCrossings(const Section& section) {
  const auto& all = section.primitives;
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      for (const Point2& p : intersect(all[i].shape, all[j].shape)) {
        const bool joint = (j == i + 1 && (p - endPoint(all[i].shape)).norm() < kJointMm) ||
                           ((j + 1) % n == i && (p - endPoint(all[j].shape)).norm() < kJointMm);
        if (!joint)
          return refused(section, all[i].name + " and " + all[j].name,
                         printed("cross at (%.4f, %.4f); an outline must not cross itself", p.x(), p.y()));
      }
    }
  return {};
}

Expected<void> checkNeeded(const Section& section) {
  struct Needed {
    const char* name;
    bool arc;
    const char* why;
  };
  constexpr std::array<Needed, 10> kNeeded = {{{"SBB", false, "foot bottom"},
                                               {"SBL", false, "left foot edge"},
                                               {"SBR", false, "right foot edge"},
                                               {"SWBL", false, "left lower fishing surface"},
                                               {"SWBR", false, "right lower fishing surface"},
                                               {"SHBL", false, "left upper fishing surface"},
                                               {"SHBR", false, "right upper fishing surface"},
                                               {"SHL", false, "left head side"},
                                               {"SHR", false, "right head side"},
                                               {"AHT", true, "crown"}}};
  for (const Needed& needed : kNeeded) {
    const auto at = section.find(needed.name);
    const std::string role = std::string(" (") + needed.why + ")";
    if (!at) return refused(section, needed.name, "is missing; without it" + role + " the dimensions have no meaning");
    if (std::holds_alternative<Arc>(section.primitives[*at].shape) != needed.arc)
      return refused(section, needed.name, (needed.arc ? "must be an arc" : "must be a segment") + role);
  }
  const auto middle = [&](const char* name) {
    const Primitive& p = section.primitives[*section.find(name)].shape;
    return pointAt(p, length(p) / 2);
  };
  if (middle("SBL").x() >= middle("SBR").x() || middle("SHL").x() >= middle("SHR").x())
    return refused(section, "", "has left and right exchanged; x runs to the right, looking along the rail's motion");
  if (middle("AHT").y() <= middle("SBB").y()) return refused(section, "", "stands on its head; y runs upwards");
  return {};
}

}  // namespace

std::optional<std::size_t> Section::find(std::string_view primitiveName) const {
  for (std::size_t i = 0; i < primitives.size(); ++i)
    if (primitives[i].name == primitiveName) return i;
  return std::nullopt;
}

double Section::axisXMm() const {
  const auto left = find("SBL"), right = find("SBR");
  if (!left || !right) return axisFromFootMiddleMm;
  const double leftX = startPoint(primitives[*left].shape).x() + endPoint(primitives[*left].shape).x();
  const double rightX = startPoint(primitives[*right].shape).x() + endPoint(primitives[*right].shape).x();
  return (leftX + rightX) / 4 + axisFromFootMiddleMm;
}

double Section::heightMm() const {
  double top = 0;
  for (const NamedPrimitive& p : primitives)
    for (const Point2& hit : intersectLine(p.shape, {axisXMm(), 0}, {0, 1})) top = std::max(top, hit.y());
  return top;
}

bool Section::symmetric() const {
  constexpr double kSameMm = 1e-3;
  const double axis = axisXMm();
  const auto mirrored = [axis](const Point2& p) { return Point2(2 * axis - p.x(), p.y()); };
  return std::all_of(primitives.begin(), primitives.end(), [&](const NamedPrimitive& a) {
    return std::any_of(primitives.begin(), primitives.end(), [&](const NamedPrimitive& b) {
      return (mirrored(startPoint(a.shape)) - endPoint(b.shape)).norm() < kSameMm &&
             (mirrored(endPoint(a.shape)) - startPoint(b.shape)).norm() < kSameMm &&
             std::abs(curvature(a.shape) - curvature(b.shape)) < 1e-6;
    });
  });
}

Expected<Section> createSection(Section candidate) {
  if (auto good = checkShapes(candidate); !good) return tl::unexpected(good.error());
  if (!(properties(candidate).areaMm2 > 0))
    return refused(candidate, "", "runs clockwise; list its primitives counter-clockwise");
  if (auto good = checkJoints(candidate); !good) return tl::unexpected(good.error());
  if (auto good = checkCrossings(candidate); !good) return tl::unexpected(good.error());
  if (auto good = checkNeeded(candidate); !good) return tl::unexpected(good.error());
  if (!(std::abs(candidate.axisFromFootMiddleMm) < 100))
    return refused(candidate, "axis_from_foot_middle_mm", "is not between -100 and 100 mm");
  return candidate;
}

}  // namespace vignole
