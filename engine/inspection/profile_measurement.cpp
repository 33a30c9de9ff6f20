#include "engine/inspection/profile_measurement.h"

#include "engine/rail/catalogue.h"
#include "engine/registration/rail_matcher.h"
#include "engine/systematic/calibration_error.h"

namespace vignole {

namespace {

/// Through such a calibration that the rail cannot be found nothing is measured, so its uncertainty does not matter.
PerDimension<double> uncertaintyBy(const RigCalibration& calibration, const Recipe& recipe) {
  return calibrationUncertainty(recipe.section, recipe.parameters, calibration).value_or(PerDimension<double>{});
}

}  // namespace

struct ProfileMeasurement::Impl {
  Impl(const Recipe& recipe, const RigCalibration& calibration)
      : registrar(recipe.section, recipe.registration),
        matcher(recipe.section, catalogueSections(), recipe.registration),
        measurer(recipe.section, recipe.parameters, recipe.limits, recipe.measurement,
                 uncertaintyBy(calibration, recipe)) {}

  Registrar registrar;
  RailMatcher matcher;
  Measurer measurer;
};

ProfileMeasurement::ProfileMeasurement(const Recipe& recipe, const RigCalibration& calibration)
    : impl_(std::make_unique<Impl>(recipe, calibration)) {}
ProfileMeasurement::~ProfileMeasurement() = default;
ProfileMeasurement::ProfileMeasurement(ProfileMeasurement&&) noexcept = default;
ProfileMeasurement& ProfileMeasurement::operator=(ProfileMeasurement&&) noexcept = default;

void ProfileMeasurement::measure(const RailBegin& rail, const Profile& profile, Registration& registration,
                                 Measurement& measurement) {
  const auto correlated = static_cast<double>(profile.correlatedPoints);
  // No start from an earlier profile: what is lost or late must not change what is measured next.
  impl_->registrar.registerProfile(profile.points, registration, {}, correlated);
  impl_->matcher.check(profile.points, correlated, registration);
  impl_->measurer.measure(profile, registration, {rail.temperatureC, rail.temperatureUncertaintyC}, measurement);
}

}  // namespace vignole
