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
  std::uint64_t seed = 1;         ///< draws errors and noise
  double readNoiseDn = 3, shotNoise = 1, defocus = 1;
  double brightDn = 180, darkDn = 40;
};

/// Immutable; member functions may be called from any thread.
class VirtualTarget {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<const VirtualTarget>> create(VirtualTargetSettings settings);
  ~VirtualTarget();
  VirtualTarget(const VirtualTarget&) = delete;
  VirtualTarget& operator=(const VirtualTarget&) = delete;
  /// `view` draws the noise; cameraFromTarget: the target's frame as planar_target.h has it.
  void render(const Extrinsics& cameraFromTarget, int view, bool laser, const MutableImageView& image) const;
  /// Where the target's true points are seen, px.
  [[nodiscard]] std::vector<Point2> truePixels(const Extrinsics& cameraFromTarget) const;

 private:
  struct Impl;
  explicit VirtualTarget(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Poses that a technician would show: the target fills much of the picture, moved over it, tilted to all sides up to
/// 35 degrees, within the depth of field; every point in the picture but for a few views.
[[nodiscard]] std::vector<Extrinsics> usualViews(const PlanarTarget& target, const Intrinsics& in, int count,
                                                 std::uint64_t seed);

}  // namespace vignole
