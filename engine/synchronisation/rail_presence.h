#pragma once
// Whether a camera sees anything that a laser shines on: every eighth row is searched for light. Made so that a rail
// cannot be missed; what else is taken for one costs a rail without profiles, not a profile.

#include "engine/geometry/image_view.h"

namespace vignole {

struct RailPresenceSettings {
  int contrastDn = 35;  ///< brighter than the row's mean by this much is light
  int pixels = 24;      ///< so many in the rows searched are a rail
};

[[nodiscard]] bool railInView(const ImageView& image, const RailPresenceSettings& settings);

}  // namespace vignole
