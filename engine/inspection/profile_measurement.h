#pragma once
// From the points of a profile to its dimensions, as an inspection does it: registered, compared with the other
// sections, measured with the whole uncertainty. Who does it again with the same points gets the same bits.

#include <memory>

#include "engine/acquisition/frame.h"
#include "engine/measurement/measurement.h"
#include "engine/optics/calibration.h"
#include "engine/profile/profile.h"
#include "engine/recipe/recipe.h"
#include "engine/registration/registration.h"

namespace vignole {

/// One per thread.
class ProfileMeasurement {
 public:
  /// The recipe's settings are those that its loader checked.
  ProfileMeasurement(const Recipe& recipe, const RigCalibration& calibration);
  ~ProfileMeasurement();
  ProfileMeasurement(ProfileMeasurement&&) noexcept;
  ProfileMeasurement& operator=(ProfileMeasurement&&) noexcept;

  void measure(const RailBegin& rail, const Profile& profile, Registration& registration, Measurement& measurement);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
