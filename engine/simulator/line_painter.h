#pragma once
// Light on outlines in the light plane, edge after edge, as samples for the canvas of one camera.

#include <array>
#include <cstdint>
#include <vector>

#include "engine/simulator/camera_view.h"
#include "engine/simulator/light_kernels.h"

namespace vignole::simulator {

inline constexpr double kGrazingCosine = 0.17364817766693033;  ///< 80 degrees from the normal: too little for a line

/// Which lasers reach a place.
using LitBy = std::array<bool, kCameraCount>;

/// Of an edge that runs counter-clockwise around the body: unit, outwards.
[[nodiscard]] inline Point2 outwardNormal(const Point2& from, const Point2& to) {
  return Point2(to.y() - from.y(), from.x() - to.x()) / (to - from).norm();
}

/// Samples of one picture.
struct LightSamples {
  std::vector<Splat> splats;
  std::vector<SplatKernel> kernels;
  void clear() {
    splats.clear();
    kernels.clear();
  }
};

/// A stretch of an outline that the camera sees and the same lasers light, painted edge by edge.
class LinePainter {
 public:
  /// `exposure`: multiple of the usual one. What is handed over must outlive the painter.
  LinePainter(const RigGeometry& rig, const CameraView& view, const ExposedPose& pose, double exposure,
              LightSamples& samples)
      : rig_(rig), view_(view), pose_(pose), exposure_(exposure), samples_(samples) {}
  void startStretch(const LitBy& lit);
  /// Goes on to the next edge; returns the light that a white edge would send to the camera.
  double step(const Point2& from, const Point2& to, const Point2& normal);
  /// Light of a white edge that faces a laser at its usual distance and the camera.
  [[nodiscard]] double frontalLight(double lengthMm) const;
  [[nodiscard]] const Point2& middle() const { return middle_; }
  /// Light on the edge, times a reflectance that changes evenly along it.
  void paint(double light, double reflectanceFrom, double reflectanceTo);
  /// Light that meets the edge at that distance from the light plane, spread more widely.
  void paintGhost(double light, double reflectanceFrom, double reflectanceTo, double offPlaneMm);

 private:
  void spread(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double light, double r0, double r1, double stepPx,
              std::uint32_t kernel);

  const RigGeometry& rig_;
  const CameraView& view_;
  const ExposedPose& pose_;
  double exposure_;
  LightSamples& samples_;
  LitBy lit_{};
  bool first_ = true;
  Point2 from_{0, 0}, to_{0, 0}, middle_{0, 0};
  Eigen::Vector2d fromPx_{0, 0}, toPx_{0, 0};
  Point2 kernelPlace_{0, 0};
  bool ghostKernel_ = false;
  std::uint32_t kernel_ = 0;
};

}  // namespace vignole::simulator
