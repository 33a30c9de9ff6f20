#include "engine/measurement/nominal.h"

#include <Eigen/Dense>

#include "engine/measurement/measurement.h"

namespace vignole {
namespace {

/// Parabola through the foot bottom; exact for a segment, least squares over samples for anything else.
Parabola footBottomParabola(const Primitive& shape) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  constexpr int kSamples = 200;
  for (int i = 0; i <= kSamples; ++i) {
    const Point2 p = pointAt(shape, length(shape) * i / kSamples);
    const Eigen::Vector3d row(1, p.x() / 100, p.x() * p.x() / 1e4);
    a += row * row.transpose();
    b += row * p.y();
  }
  const Eigen::Vector3d c = a.ldlt().solve(b);
  return {c(0), c(1) / 100, c(2) / 1e4};
}

}  // namespace

Shapes nominalShapes(const Section& section) {
  Shapes shapes;
  for (const auto& primitive : section.primitives)
    shapes.pieces.push_back(pieceOf(primitive.shape, length(primitive.shape) / 2));
  shapes.missing.resize(section.primitives.size());
  if (const auto bottom = section.find("SBB"))
    shapes.footBottom = footBottomParabola(section.primitives[*bottom].shape);
  return shapes;
}

Expected<PerDimension<std::optional<double>>> nominalDimensions(const Section& section, const SectionPlan& plan,
                                                                const DimensionParameters& parameters) {
  PerDimension<DefinedValue> values;
  Definitions(plan, parameters, 0).evaluate(nominalShapes(section), values);
  PerDimension<std::optional<double>> nominal;
  for (const Dimension d : kDimensions) {
    const DefinedValue& v = values[index(d)];
    const bool undefined = (d == Dimension::WT && !plan.webHeightMm) ||
                           (d == Dimension::HR && curvature(section.primitives[plan.headTop].shape) <= 0);
    if (!v.value && !undefined)
      return inputError(section.name, std::string(name(d)) + ": its parameter falls off the section's primitives (" +
                                          v.reason + "); choose one that lies on them");
    if (v.value) nominal[index(d)] = v.value->value;
  }
  return nominal;
}

Expected<PerDimension<std::optional<double>>> nominalDimensions(const Section& section,
                                                                const DimensionParameters& parameters) {
  if (section.primitives.size() > kMaxPrimitives)
    return inputError(section.name, "has more than " + std::to_string(kMaxPrimitives) + " primitives");
  const auto plan = planSection(section, parameters);
  if (!plan) return tl::unexpected(plan.error());
  return nominalDimensions(section, *plan, parameters);
}

}  // namespace vignole
