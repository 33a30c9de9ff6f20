#include "engine/systematic/calibration_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/measurement/nominal.h"
#include "engine/measurement/primitive_fits.h"
#include "engine/optics/plane_map.h"

namespace vignole {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kJointSlackMm = 2;  // as the measurement has it
/// By how much the outline is moved for a derivative: small beside the points' uncertainty, so that no robust weight
/// changes; large beside the rounding of single precision (1e-5 mm a point).
constexpr double kStepMm = 0.01;

}  // namespace

/// Registration and measurement without what they give beside the values. Its parts know each other's addresses.
struct SectionBeforeRig::Impl {
  Impl(const Section& section, const DimensionParameters& p, SectionPlan sectionPlan,
       const PerDimension<std::optional<double>>& nominals, SeenLines lines)
      : seen(std::move(lines)),
        nominal(nominals),
        parameters(p),
        plan(std::move(sectionPlan)),
        registrar(section, {}),
        fits(section, plan, {}),
        definitions(plan, parameters, kJointSlackMm) {}

  Expected<Values> measure(const Profile& profile) {
    registrar.registerProfile(profile.points, registration, {}, static_cast<double>(profile.correlatedPoints));
    if (!registration.valid) return inputError("the section as the rig sees it", registration.reason);
    fits.fit(profile, registration, 1);
    definitions.evaluate(fits.shapes(), defined);
    Values values;
    for (std::size_t d = 0; d < kDimensionCount; ++d) values.mm[d] = defined[d].value ? defined[d].value->value : kNan;
    const DefinedValue& crown = defined[index(Dimension::HF)];
    values.hfEndsMm = {kNan, kNan};
    if (crown.value) values.hfEndsMm = {crown.candidates.front().value, crown.candidates.back().value};
    return values;
  }

  SeenLines seen;
  PerDimension<std::optional<double>> nominal;
  DimensionParameters parameters;
  SectionPlan plan;
  Registrar registrar;
  Registration registration;
  PrimitiveFits fits;
  Definitions definitions;
  PerDimension<DefinedValue> defined;
};

SectionBeforeRig::SectionBeforeRig(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SectionBeforeRig::SectionBeforeRig(SectionBeforeRig&&) noexcept = default;
SectionBeforeRig& SectionBeforeRig::operator=(SectionBeforeRig&&) noexcept = default;
SectionBeforeRig::~SectionBeforeRig() = default;

Expected<SectionBeforeRig> SectionBeforeRig::create(const Section& section, const DimensionParameters& parameters,
                                                    const RigCalibration& trueRig) {
  auto plan = planSection(section, parameters);
  if (!plan) return tl::unexpected(plan.error());
  const auto nominal = nominalDimensions(section, *plan, parameters);
  if (!nominal) return tl::unexpected(nominal.error());
  return SectionBeforeRig(
      std::make_unique<Impl>(section, parameters, std::move(*plan), *nominal, seenLines(section, {}, trueRig)));
}

Expected<SectionBeforeRig::Values> SectionBeforeRig::measuredBy(const RigCalibration& assumedRig) {
  return impl_->measure(profileOf(impl_->seen, assumedRig));
}
const SeenLines& SectionBeforeRig::seen() const { return impl_->seen; }
const PerDimension<std::optional<double>>& SectionBeforeRig::nominal() const { return impl_->nominal; }

namespace {

/// How far one camera's points move at most, along the outline's normal, by a unit of one parameter, mm.
double largestMove(const SeenLines& seen, const RigCalibration& rig, int camera, int parameter) {
  const auto c = static_cast<std::size_t>(camera);
  // Relative to what moves the picture by about a pixel, so that no parameter leaves the range where it is linear.
  static const CameraChange kSmall = [] {
    CameraChange s;
    s << 1e-5, 1e-8, 1e-2, 1e-2, 1e-8, 1e-8, 1e-10, 1e-12, 1e-8, 1e-8, 1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3;
    return s;
  }();
  CameraChange change = CameraChange::Zero();
  change[parameter] = kSmall[parameter];
  RangeFinderCalibration changed = rig.rangeFinders[c];
  apply(change, changed);
  const PlaneMap before(rig.rangeFinders[c]), after(changed);
  double most = 0;
  for (const StripePoint& p : seen[c].points) {
    const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
    const PlanePoint a = before(x, y), b = after(x, y);
    const Point2 along(-a.dxdc * static_cast<double>(p.ny) + a.dxdr * static_cast<double>(p.nx),
                       -a.dydc * static_cast<double>(p.ny) + a.dydr * static_cast<double>(p.nx));
    const double across = std::abs((b.x - a.x) * along.y() - (b.y - a.y) * along.x()) / along.norm();
    most = std::max(most, across);
  }
  return most / kSmall[parameter];
}

}  // namespace

Expected<DimensionJacobian> dimensionJacobian(const Section& section, const DimensionParameters& parameters,
                                              const RigCalibration& rig) {
  auto before = SectionBeforeRig::create(section, parameters, rig);
  if (!before) return tl::unexpected(before.error());
  const auto exact = before->measuredBy(rig);
  if (!exact) return tl::unexpected(exact.error());
  DimensionJacobian jacobian = DimensionJacobian::Zero();
  Eigen::Matrix<double, 2, kRigParameters> hfEnds = Eigen::Matrix<double, 2, kRigParameters>::Zero();
  Eigen::Vector2d hfMoves(0, 0);
  for (int column = 0; column < kRigParameters; ++column) {
    const double move = largestMove(before->seen(), rig, column / kCameraParameters, column % kCameraParameters);
    if (!(move > 0)) continue;  // no part of this camera's lens model, or nothing seen
    const double step = kStepMm / move;
    const auto changed = [&](double by) {
      RigCalibration other = rig;
      RigChange change = RigChange::Zero();
      change[column] = by;
      apply(change, other);
      return before->measuredBy(other);
    };
    const auto less = changed(-step), more = changed(step);
    if (!less) return tl::unexpected(less.error());
    if (!more) return tl::unexpected(more.error());
    for (std::size_t d = 0; d < kDimensionCount; ++d)
      jacobian(static_cast<int>(d), column) = (more->mm[d] - less->mm[d]) / (2 * step);
    for (const int end : {0, 1}) {
      const auto e = static_cast<std::size_t>(end);
      const double difference = more->hfEndsMm[e] - less->hfEndsMm[e];
      hfEnds(end, column) = difference / (2 * step);
      hfMoves[end] += difference * difference;
    }
  }
  jacobian.row(static_cast<int>(index(Dimension::HF))) = hfEnds.row(hfMoves[1] > hfMoves[0] ? 1 : 0);
  for (std::size_t d = 0; d < kDimensionCount; ++d)
    if (std::isnan(exact->mm[d])) jacobian.row(static_cast<int>(d)).setConstant(kNan);
  return jacobian;
}

Expected<PerDimension<double>> measuredDimensions(const Section& section, const DimensionParameters& parameters,
                                                  const RigCalibration& trueRig, const RigCalibration& assumedRig) {
  auto before = SectionBeforeRig::create(section, parameters, trueRig);
  if (!before) return tl::unexpected(before.error());
  const auto measured = before->measuredBy(assumedRig);
  if (!measured) return tl::unexpected(measured.error());
  PerDimension<double> error{};
  for (std::size_t d = 0; d < kDimensionCount; ++d) error[d] = measured->mm[d] - before->nominal()[d].value_or(kNan);
  return error;
}

Expected<PerDimension<double>> calibrationUncertainty(const Section& section, const DimensionParameters& parameters,
                                                      const RigCalibration& rig) {
  PerDimension<double> u{};
  if (rig.covariance.size() == 0) return u;
  const auto jacobian = dimensionJacobian(section, parameters, rig);
  if (!jacobian) return tl::unexpected(jacobian.error());
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const auto row = jacobian->row(static_cast<int>(d));
    const double variance = (row * rig.covariance * row.transpose()).value();
    u[d] = variance > 0 ? std::sqrt(variance) : 0;  // not for NaN either
  }
  return u;
}

}  // namespace vignole
