#pragma once
// The laser lines on the pins of a plate in one picture: arcs of about 8 to 46 px radius, 20 to 90 px long (paper
// section III-B, Fig. 8c).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// A point of the ridge as the filter found it: no bend is corrected for. Pixels.
struct ArcPoint {
  Point2 px{0, 0};
  Point2 normal{0, 1};
  double sigmaPx = 0;      ///< standard uncertainty along the normal
  double lightDn = 0;      ///< smoothed brightness above the ground
  double variancePx2 = 0;  ///< of the smoothed light across the line, filter included; no less than filter + 0.25
  std::uint8_t flags = 0;  ///< StripeFlag
};

/// One stretch of line that bends like a circle.
struct PinArc {
  std::vector<ArcPoint> points;  ///< in order along the line
  int pin = 0;                   ///< number of the pin it belongs to; 0: none was found, or the arc is of no use
  std::string reason;            ///< why it is of no use
  [[nodiscard]] bool usable() const { return reason.empty(); }
};

/// What one camera sees of the plate in one placement.
struct PinPicture {
  std::string file;
  std::vector<PinArc> arcs;
  double filterVariancePx2 = 0;  ///< of the line filter
  double noiseDn = 0;
  double saturatedShare = 0;  ///< of the points
  std::string refusal;        ///< "refused, because ..., do ..."; empty: may be used
  Extrinsics cameraFromPlate;  ///< where the camera stands, roughly: by association
  [[nodiscard]] bool usable() const { return refusal.empty(); }
};

/// One placement of the plate.
struct PlacementLines {
  std::string folder;
  std::array<PinPicture, kCameraCount> pictures;
};

struct PinLineSettings {
  StripeSettings stripe = pinStripe();
  int minPoints = 12;              ///< of an arc
  double maxSaturatedShare = 0.3;  ///< of an arc's points: more, and the arc is of no use
  double leastShare = 0.12;        ///< of the median strength of the picture's lines: weaker is another laser's light
  double straightness = 0.35;      ///< px: what a line may leave a conic by before it is split, standard deviation

  /// Narrower than for rails, no gap bridged: pins are small and stand apart.
  [[nodiscard]] static StripeSettings pinStripe();
};

/// Never fails: what is of no use says why. `settings.stripe`: checked().
[[nodiscard]] PinPicture findPinLines(const ImageView& image, const PinLineSettings& settings);

}  // namespace vignole
