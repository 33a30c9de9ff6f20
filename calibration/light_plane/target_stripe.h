#pragma once
// The laser's line on a flat target: straight, since two planes meet in it.

#include <optional>
#include <string>
#include <vector>

#include "calibration/light_plane/target_pose.h"
#include "engine/stripe/stripe.h"

namespace vignole {

struct StripeSample {
  Point2 px{0, 0};
  Point2 normalPx{0, 1};  ///< unit normal of the line
  double sigmaPx = 0;     ///< along the normal, shared errors of neighbours counted
  Point2 onTargetMm{0, 0};
};

/// A straight line of light on the target.
struct TargetLine {
  std::vector<StripeSample> samples;
  double lengthMm = 0;    ///< covered by light
  double contrastDn = 0;  ///< median
  double rmsMm = 0;       ///< of the samples' distances from the straight line, on the target
};

struct TargetStripe {
  std::string file;  ///< of the picture with the laser
  TargetView view;   ///< of the target
  TargetPose pose;
  std::vector<TargetLine> lines;  ///< likeliest first; a reflection may be among them
  std::string refusal;            ///< empty, or why there is none and what to do
  [[nodiscard]] bool usable() const { return refusal.empty(); }
};

struct TargetStripeSettings {
  StripeSettings stripe;
  /// The picture shows the print by other light as well, which laserAlone() would take off.
  bool printSeen = false;
  double leastLengthShare = 0.15;  ///< of the target's shorter side
  std::size_t mostLines = 4;
  /// A straight line has no bend to correct, and its points are kept independent.
  TargetStripeSettings() {
    stripe.sigma = 2;
    stripe.correction = false;
  }
};

/// `laser`: the picture in which the line is bright, at least 32 x 32; of a colour picture best the laser's channel
/// less another (laserAlone()). The view's refusal becomes the stripe's.
[[nodiscard]] TargetStripe findTargetStripe(const ImageView& laser, const TargetView& view, const PlanarTarget& target,
                                            const Intrinsics& in, const TargetStripeSettings& settings = {});

/// Laser's channel less another that sees as much of the print and none of the laser: the line without the print.
/// Both of the same size; row-major without padding.
[[nodiscard]] std::vector<std::uint8_t> laserAlone(const ImageView& laser, const ImageView& other);

/// A pixel's ray meets the target's plane there, camera's frame, mm; nothing where it does not.
[[nodiscard]] std::optional<Eigen::Vector3d> onTargetPlane(const Point2& px, const Extrinsics& cameraFromTarget,
                                                           const Intrinsics& in);

}  // namespace vignole
