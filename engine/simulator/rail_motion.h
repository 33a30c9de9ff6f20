#pragma once
// How the rail moves across its line of travel while it passes: slow wander of the roller table and vibration.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole::simulator {

/// Mean pose over the exposure and the covariance of (x mm, y mm, angle rad) within it.
struct ExposedPose {
  Transform2 worldFromSection;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

struct MotionSettings {
  double wander = 1;     ///< multiple of +-5 mm and +-1 deg
  double vibration = 1;  ///< multiple of 0.05 mm rms
  double exposureS = 0;
};

/// Sums of sines of time: wander at 0.05-0.3 Hz that never leaves +-5 mm and +-1 deg, vibration at 5-30 Hz of 0.05 mm
/// rms in x and in y. Immutable.
class RailMotion {
 public:
  RailMotion(std::uint64_t seed, const MotionSettings& settings);
  [[nodiscard]] Transform2 at(double timeS) const;
  /// Averaged over the exposure that begins at timeS.
  [[nodiscard]] ExposedPose exposed(double timeS) const;

 private:
  struct Sine {
    double amplitude, omega, phase;
  };
  using Sines = std::vector<Sine>;
  static double sum(const Sines& sines, double timeS);
  Sines x_, y_, angle_;
  double exposureS_;
};

}  // namespace vignole::simulator
