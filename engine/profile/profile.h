#pragma once
// A complete transverse profile in the world, made of the partial contours of four range finders (paper section II-E).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/optics/calibration.h"

namespace vignole {

/// World coordinates in the light plane, mm.
struct ProfilePoint {
  double x = 0, y = 0;
  float nx = 0, ny = 1;  ///< unit normal of the contour, sign arbitrary
  float sigmaMm = 0;     ///< standard uncertainty along the normal
  float strength = 0;    ///< contrast of the line, DN
  std::uint8_t camera = 0;
  std::uint8_t flags = 0;  ///< StripeFlag
  /// The ridge that the line filter found is (x, y) - shiftMm (nx, ny), with a standard uncertainty of its own
  /// (StripePoint); who fits curves starts from there.
  float shiftMm = 0;
  float ridgeSigmaMm = 0;  ///< 0: as sigmaMm
  /// StripeResult::smoothingPx along the contour, in mm: the ridge lies smoothingMm^2 / 2 * curvature too far inside a
  /// bend. 0: nothing to take off.
  float smoothingMm = 0;
};

/// What one camera contributes, or why it contributes nothing.
struct PartialContour {
  int camera = 0;
  std::uint64_t trigger = 0;
  std::vector<ProfilePoint> points;     ///< in order along each line; rejected lines left out
  std::vector<std::uint32_t> lineEnds;  ///< one past the last point of each line
  float correlatedPoints = 1;           ///< StripeResult::correlatedPoints
  float backgroundDn = 0, noiseDn = 0, saturatedShare = 0;
  bool overloaded = false;
  std::string missing;  ///< empty, or why there is no contour: "frame lost", "no stripe", ...
};

struct Profile {
  std::uint64_t trigger = 0;
  double positionMm = 0;                ///< along the rail, from its head
  std::vector<ProfilePoint> points;     ///< camera 1 first; in order along each line
  std::vector<std::uint32_t> lineEnds;  ///< one past the last point of each line
  std::array<std::uint32_t, kCameraCount> pointsOfCamera{};
  std::array<std::string, kCameraCount> missing;  ///< per camera: empty or the reason
  std::array<bool, kCameraCount> overloaded{};    ///< the camera's frame was too busy: what it gave may lack parts
  float correlatedPoints = 1;                     ///< a point's error is shared with this many neighbours
  [[nodiscard]] bool complete() const {
    for (const auto& reason : missing)
      if (!reason.empty()) return false;
    return true;
  }
};

}  // namespace vignole
