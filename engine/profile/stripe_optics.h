#pragma once
// What the calibration of a range finder tells the extraction.

#include <Eigen/Core>

#include "engine/optics/calibration.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// The rectangle of the world's x and y (mm) in which the rail can be.
struct MeasuringField {
  Eigen::Vector2d low{0, 0}, high{0, 0};
};

/// StripeOptics::field is that rectangle as the camera sees it in its light plane; empty where part of it is behind the
/// camera, beyond its lens model, or the light plane stands on edge.
[[nodiscard]] StripeOptics stripeOptics(const RangeFinderCalibration& finder, const MeasuringField& field);

}  // namespace vignole
