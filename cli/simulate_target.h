#pragma once
// Flat targets before a camera of the virtual rig, as files: for `simulate target` and `simulate campaign`.

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/simulated_files.h"
#include "engine/simulator/virtual_target.h"

namespace CLI {
class App;
}

namespace vignole::cli {

struct TargetOptions {
  std::string target = kUsualTarget;
  int views = 16;
  bool lightDots = false, mirror = false, laser = false;
  double errorUm = 0;
  std::vector<std::string> effects;
};

void addTargetOptions(CLI::App& command, TargetOptions& options);

/// One camera's pictures.
struct SimulatedTarget {
  std::shared_ptr<const VirtualTarget> target;
  RangeFinderCalibration camera;
  std::vector<Extrinsics> views;
  bool laser = false;
};
/// `seed` draws the poses, the noise and (the same for all cameras) the print's errors.
[[nodiscard]] Expected<SimulatedTarget> makeTarget(const TargetOptions& options, const RangeFinderCalibration& camera,
                                                   int cameraIndex, std::uint64_t seed);

/// view01.png ..., and view01_laser.png ... with the laser.
[[nodiscard]] std::vector<PictureJob> targetJobs(const SimulatedTarget& target, const std::filesystem::path& out);
[[nodiscard]] std::string viewName(std::size_t view, bool laser);

/// Poses and pixels of the points; for truth.json.
[[nodiscard]] nlohmann::ordered_json targetTruth(const SimulatedTarget& target);

}  // namespace vignole::cli
