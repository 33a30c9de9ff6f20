#include <algorithm>
#include <cmath>

#include "engine/measurement/extreme_error.h"
#include "engine/measurement/measurement.h"
#include "engine/measurement/nominal.h"
#include "engine/measurement/primitive_fits.h"
#include "engine/measurement/verdict.h"

namespace vignole {
namespace {

constexpr double kReferenceCelsius = 15;
constexpr double kJointSlackMm = 2;  // as far as a defect may move a joint

/// ": camera 3: frame lost" for every camera that is missing; a missing camera explains missing points.
std::string missingCameras(const Profile& profile) {
  std::string text;
  for (std::size_t c = 0; c < profile.missing.size(); ++c)
    if (!profile.missing[c].empty())
      text += (text.empty() ? "" : "; ") + ("camera " + std::to_string(c + 1)) + ": " + profile.missing[c];
  return text;
}

}  // namespace

struct Measurer::Impl {
  Impl(const Section& given, const DimensionParameters& p, const PerDimension<ToleranceLimits>& l,
       const MeasurementSettings& s, const PerDimension<double>& calibrationU)
      : section(given), parameters(p), limits(l), settings(s), calibrationUMm(calibrationU) {
    auto planned = planSection(section, parameters);
    if (!planned) {
      refusal = planned.error().message();
      return;
    }
    plan = std::make_unique<SectionPlan>(std::move(*planned));
    if (const auto nominals = nominalDimensions(section, *plan, parameters)) {
      nominal = *nominals;
    } else {
      refusal = nominals.error().message();
      return;
    }
    fits = std::make_unique<PrimitiveFits>(section, *plan, settings);
    definitions = std::make_unique<Definitions>(*plan, parameters, kJointSlackMm);
  }

  void measure(const Profile& profile, const Registration& registration, const RailTemperature& temperature,
               Measurement& m) {
    m.fitted.clear();
    for (std::size_t d = 0; d < kDimensionCount; ++d) reset(m.dimensions[d], nominal[d].value_or(0));
    if (const std::string why = refuses(profile, registration, temperature); !why.empty()) {
      for (DimensionResult& d : m.dimensions) d.reason = why;
    } else {
      fits->fit(profile, registration, coldOf(temperature));
      definitions->evaluate(fits->shapes(), values);
      const std::string cameras = missingCameras(profile);
      for (const Dimension d : kDimensions) publish(d, registration, temperature, cameras, m.dimensions[index(d)]);
      fits->describe(registration.worldFromSection, coldOf(temperature), m.fitted);
    }
    for (const Dimension d : kDimensions) judge(d, limits[index(d)], m.dimensions[index(d)]);
    m.verdict = worstOf(m.dimensions);
  }

  static void reset(DimensionResult& d, double nominalMm) {
    d.valueMm.reset();
    d.secondMm.reset();
    d.leftMm.reset();
    d.rightMm.reset();
    d.nominalMm = nominalMm;
    d.uMm = d.secondUMm = d.uCalibrationMm = 0;
    d.points = 0;
    d.reason.clear();
    d.anchors.clear();
  }

  [[nodiscard]] std::string refuses(const Profile& profile, const Registration& registration,
                                    const RailTemperature& temperature) const {
    if (!refusal.empty()) return refusal;
    if (!(temperature.celsius <= settings.maxTemperatureC)) {
      char text[120];
      std::snprintf(text, sizeof text, "rail at %.0f C: above %.0f C no cold size is given", temperature.celsius,
                    settings.maxTemperatureC);
      return text;
    }
    if (!registration.valid || registration.primitiveOfPoint.size() != profile.points.size()) {
      const std::string cameras = missingCameras(profile);
      const std::string why = registration.reason.empty() ? "the profile is not registered" : registration.reason;
      return cameras.empty() ? why : why + " (" + cameras + ")";
    }
    return {};
  }

  /// A length l at the rail's temperature is l times this at 15 degrees C.
  [[nodiscard]] double coldOf(const RailTemperature& temperature) const {
    return 1 / (1 + settings.expansionPerK * (temperature.celsius - kReferenceCelsius));
  }

  void publish(Dimension dimension, const Registration& registration, const RailTemperature& temperature,
               const std::string& cameras, DimensionResult& out) {
    const DefinedValue& v = values[index(dimension)];
    out.points = fits->pointsOn(v.used);
    if (!v.value) {
      out.reason = cameras.empty() ? v.reason : v.reason + " (" + cameras + ")";
      return;
    }
    const double cold = coldOf(temperature), thermal = settings.expansionPerK * temperature.uncertaintyK;
    const double calibration = calibrationUMm[index(dimension)];
    const auto total = [&](const Reading& quantity, double variance) {
      const double u = thermal * quantity.value;
      return std::sqrt(variance + u * u + calibration * calibration);
    };
    out.uCalibrationMm = calibration;
    out.valueMm = v.value->value;
    const auto variance = [&](const Reading& quantity, double sign) {
      return dimension == Dimension::HF ? extremeVariance(quantity, v, sign) : fits->variance(quantity);
    };
    out.uMm = total(*v.value, variance(*v.value, 1));
    if (v.second) {
      out.secondMm = v.second->value;
      out.secondUMm = total(*v.second, variance(*v.second, -1));
    }
    if (v.hasParts) {
      out.leftMm = v.left;
      out.rightMm = v.right;
    }
    const Datum& datum = definitions->datum();
    const Point2 origin(datum.origin.x, datum.origin.y);
    const Point2 along(datum.along.x, datum.along.y), up(-along.y(), along.x());
    for (std::size_t k = 0; k < v.anchorCount; ++k)
      out.anchors.push_back(registration.worldFromSection *
                            ((origin + v.anchors[k].x * along + v.anchors[k].y * up) / cold));
  }

  /// An extreme may lie at any of the places whose deviation cannot be told from it (on a nominal crown: all of them).
  /// Its error is the largest of theirs.
  [[nodiscard]] double extremeVariance(const Reading& extreme, const DefinedValue& v, double sign) {
    extremes.begin(extreme, *fits);
    extremes.consider(Reading(0), sign);  // the axis itself
    for (const Reading& candidate : v.candidates) extremes.consider(candidate, sign);
    return extremes.meanSquareError();
  }

  Section section;
  DimensionParameters parameters;
  PerDimension<ToleranceLimits> limits;
  MeasurementSettings settings;
  PerDimension<double> calibrationUMm;
  std::string refusal;  ///< why nothing can be measured with this section and these parameters
  std::unique_ptr<SectionPlan> plan;
  PerDimension<std::optional<double>> nominal;
  std::unique_ptr<PrimitiveFits> fits;
  std::unique_ptr<Definitions> definitions;
  PerDimension<DefinedValue> values;
  ExtremeError extremes;
};

Measurer::Measurer(const Section& section, const DimensionParameters& parameters,
                   const PerDimension<ToleranceLimits>& limits, const MeasurementSettings& settings,
                   const PerDimension<double>& calibrationUMm)
    : impl_(std::make_unique<Impl>(section, parameters, limits, settings, calibrationUMm)) {}
Measurer::~Measurer() = default;
Measurer::Measurer(Measurer&&) noexcept = default;
Measurer& Measurer::operator=(Measurer&&) noexcept = default;

void Measurer::measure(const Profile& profile, const Registration& registration, const RailTemperature& temperature,
                       Measurement& result) {
  impl_->measure(profile, registration, temperature, result);
}

}  // namespace vignole
