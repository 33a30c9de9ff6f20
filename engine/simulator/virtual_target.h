#pragma once
// Flat targets before a camera of the virtual rig, in any pose, lit evenly; and the laser line on them where asked.

#include <memory>
#include <vector>

#include "engine/simulator/virtual_rig.h"
#include "engine/target/planar_target.h"

namespace vignole {

struct VirtualTargetSettings {
  PlanarTarget target;
  RangeFinderCalibration camera;  ///< lens, light plane; its pose counts for the light plane alone
  double targetErrorMm = 0;       ///< each coordinate of a point uniform within +- this, the same in all views
  bool mirrored = false;          ///< printed as its mirror image: point 0 where the row's last should be
  std::uint64_t seed = 1;         ///< draws errors and noise
  std::uint64_t noiseKey = 0;     ///< tells cameras of the same seed apart: noise of its own, the same print
  double readNoiseDn = 3, shotNoise = 1, defocus = 1;
  double brightDn = 180, darkDn = 40;
  double gradient = 0.06;  ///< how much brighter one side of the picture is lit than the other, share
  double laserDn = 170;    ///< peak of the laser line on white, in focus
  double speckle = 0.22;   ///< contrast, of the laser's light
};

/// Immutable; member functions may be called from any thread.
class VirtualTarget {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<const VirtualTarget>> create(VirtualTargetSettings settings);
  ~VirtualTarget();
  VirtualTarget(const VirtualTarget&) = delete;
  VirtualTarget& operator=(const VirtualTarget&) = delete;
  /// `view` draws the noise; cameraFromTarget: the target's frame as planar_target.h has it. With the laser the other
  /// light is dimmed, so that the line stands out. Areas are exact to about 0.1 % of a pixel, then blurred as by a thin
  /// lens at f/8 that is focused at 400 mm.
  void render(const Extrinsics& cameraFromTarget, int view, bool laser, const MutableImageView& image) const;
  /// Where the target's true points are seen, px.
  [[nodiscard]] std::vector<Point2> truePixels(const Extrinsics& cameraFromTarget) const;

  [[nodiscard]] const VirtualTargetSettings& settings() const;

 private:
  struct Impl;
  explicit VirtualTarget(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// What the rig's cameras are shown where nothing else is asked for: half of their view at 400 mm.
inline constexpr const char* kUsualTarget = "circles:13x9:12:6";

/// Poses that a technician would show: the target fills much of the picture, moved over it, tilted to all sides up to
/// 35 degrees, within the depth of field; every point in the picture but for a few views.
[[nodiscard]] std::vector<Extrinsics> usualViews(const PlanarTarget& target, const Intrinsics& in, int count,
                                                 std::uint64_t seed);

}  // namespace vignole
