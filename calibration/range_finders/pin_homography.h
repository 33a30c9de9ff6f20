#pragma once
// Which ellipse is which pin when nothing is known of where the camera stands: homographies of four pairs.

#include "calibration/range_finders/association.h"

namespace vignole {

/// The pose of the camera before the plate. The error is a refusal for a person.
[[nodiscard]] Expected<Extrinsics> poseByHomography(const PinPicture& picture, const Intrinsics& intrinsics,
                                                    const PinPlate& plate, const AssociationSettings& settings);

}  // namespace vignole
