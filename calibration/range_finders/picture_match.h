#pragma once
// One picture's arcs beside the plate, from where the drawing has a camera.

#include <vector>

#include "calibration/range_finders/association.h"
#include "calibration/range_finders/pattern_match.h"

namespace vignole {

/// The circles of a picture in the light plane of a camera that stands as drawn.
struct PlaneCircles {
  std::vector<FoundCircle> circles;
  std::vector<std::size_t> arcs;  ///< index in PinPicture::arcs, of each
};
/// Lines that do not bend like a pin, or not towards the camera, are left out.
[[nodiscard]] PlaneCircles planeCircles(const PinPicture& picture, const Intrinsics& intrinsics,
                                        const Extrinsics& drawing, const PinPlate& plate);

/// An answer that may be believed, or why there is none.
struct PictureMatch {
  bool found = false;
  Extrinsics cameraFromPlate;  ///< by the pins' centres
  int circles = 0;             ///< how many there were
  int pins = 0;                ///< that have their arcs by the best answer
  bool ambiguous = false;      ///< another answer is as good
  bool looksAlikeTurned = false;  ///< another answer is as good with the plate turned by half a turn or so
};
[[nodiscard]] PictureMatch matchPicture(const PinPicture& picture, const Intrinsics& intrinsics,
                                        const Extrinsics& drawing, const PinPlate& plate,
                                        const AssociationSettings& settings);

/// Gives each arc of the picture the pin on whose circle it lies, by picture.cameraFromPlate.
void assignArcs(PinPicture& picture, const Intrinsics& intrinsics, const PinPlate& plate);

}  // namespace vignole
