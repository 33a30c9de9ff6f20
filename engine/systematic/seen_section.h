#pragma once
// What the cameras of a rig see of a section that nothing disturbs: the lines that a perfect extraction would find.

#include <array>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"
#include "engine/profile/profile.h"
#include "engine/rail/section.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// Each point with the same uncertainty in the image.
inline constexpr float kSeenSigmaPx = 0.1F;
/// Centre lines in the images of the four cameras, a point every `stepPx` along them. A place is seen where neither the
/// camera nor its laser look at it too obliquely and nothing of the outline stands before it. A calibration does not
/// know where its lasers stand: taken as beside their cameras, 480 mm from the middle of the section (optics design,
/// section 2).
using SeenLines = std::array<StripeResult, kCameraCount>;
[[nodiscard]] SeenLines seenLines(const Section& section, const Transform2& worldFromSection, const RigCalibration& rig,
                                  double stepPx = 2);
/// The profile that a rig believes in when its cameras see these lines.
[[nodiscard]] Profile profileOf(const SeenLines& lines, const RigCalibration& rig);

}  // namespace vignole
