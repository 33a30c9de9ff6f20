#pragma once
// Where the line filter finds the ridge of the light on a pin: not on the circle but up to 0.3 px to its inside, since
// filter, lens and the thickness of the sheet smooth the light over a tight bend, whose brightness changes along it.
// Predicted from the circle, the camera and the light; what remains of the pull on rendered pictures is below 2 %.

#include <array>
#include <vector>

#include "engine/optics/calibration.h"
#include "engine/geometry/transform2.h"

namespace vignole {

/// The light on one pin. World; the light plane is z = 0.
struct ArcScene {
  const RangeFinderCalibration* finder = nullptr;  ///< lens and pose
  Point2 centreMm{0, 0};
  double radiusMm = 0;
  Point2 laserMm{0, 0};             ///< where the light comes from
  double fromRad = 0, toRad = 0;    ///< the stretch that is lit and seen, as angles about the centre; from < to
  std::array<Point2, kCameraCount - 1> othersMm{};  ///< the lasers of the other cameras
  double otherShare = 0;            ///< of their light that comes through the filter
  double smoothingPx2 = 0;          ///< variance of filter and lens
  double thicknessMm = 0;           ///< standard deviation of the sheet
};

/// The light in the picture, after the line filter.
class ArcLight {
 public:
  explicit ArcLight(const ArcScene& scene);
  struct Ridge {
    bool found = false;
    Point2 px{0, 0};
    double variancePx2 = 0;  ///< of the smoothed light across the line
    double logLight = 0;     ///< of the smoothed light of the pixel
  };
  /// The point that the extraction makes of the pixel in which `px` lies, along the normal that it found there (near
  /// the ends of a line that is not the picture's own but the one the line comes from): from the smoothed light of the
  /// 3 x 3 pixels around, by the same differences.
  [[nodiscard]] Ridge ridgeBeside(const Point2& px, const Point2& normal) const;
  /// How far a step of 1 mm out of the plane, towards the camera, moves the light in the picture: px.
  [[nodiscard]] const Point2& pxPerMmOffPlane() const { return offPlane_; }
  /// Standard deviation of the smoothing along a direction of the picture (unit).
  [[nodiscard]] double smoothingPx(const Point2& direction) const;

 private:
  struct Sample {
    Point2 px;
    double light;
  };
  /// Of the pixels around (column, row), row by row.
  [[nodiscard]] std::array<double, 9> smoothedAround(double column, double row) const;
  std::vector<Sample> samples_;
  Eigen::Matrix2d covariance_, inverse_;
  Point2 offPlane_{0, 0};
};

/// Light that a stretch of a pin sends to the camera, by its angle about the centre; Lambert's law; 0 where it is turned
/// away. Shadows are not known here.
struct PinLight {
  double own = 0;     ///< of the camera's own laser
  double others = 0;  ///< of the other lasers, before the filter
  double all = 0;
};
[[nodiscard]] PinLight pinLight(const ArcScene& scene, double angleRad);

}  // namespace vignole
