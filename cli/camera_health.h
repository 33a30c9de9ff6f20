#pragma once
// What the profiles of a run tell of the four cameras: one that showed nothing, one that is overexposed.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"

namespace vignole::cli {

class CameraHealth {
 public:
  void add(const Profile& profile);
  /// One line a camera without a single contour: what it showed and what to look at. They make the run a failure.
  [[nodiscard]] std::vector<Error> blind() const;
  /// One line a camera most of whose line is saturated; its centre is uncertain there, but measured.
  [[nodiscard]] std::vector<Error> overexposed() const;

 private:
  struct Camera {
    std::uint64_t contours = 0, points = 0, saturated = 0;
    std::string missing;  ///< the most recent reason
  };
  std::array<Camera, kCameraCount> cameras_;
  std::uint64_t profiles_ = 0;
};

}  // namespace vignole::cli
