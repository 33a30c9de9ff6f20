// vignole-cli simulate target: a flat target before one camera of the virtual rig, with its truth.

#include "cli/simulate_target.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/rig_truth.h"
#include "cli/simulate.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/rig_geometry.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

/// How well the points are known that stand on a target of that tolerance; never without any doubt.
double standardUncertaintyMm(double errorUm) { return std::max(1e-4, errorUm * 1e-3 / std::sqrt(3.0)); }

}  // namespace

Expected<SimulatedTarget> makeTarget(const TargetOptions& options, const RangeFinderCalibration& camera,
                                     int cameraIndex, std::uint64_t seed) {
  auto target = parseTarget(options.target);
  if (!target) return tl::unexpected<Error>(target.error());
  target->lightDots = options.lightDots;
  target->uMm = standardUncertaintyMm(options.errorUm);
  Effects effects;
  for (const std::string& effect : options.effects)
    if (auto applied = applyEffect(effects, effect); !applied) return tl::unexpected<Error>(applied.error());
  VirtualTargetSettings settings;
  settings.target = *target;
  settings.camera = camera;
  settings.targetErrorMm = options.errorUm * 1e-3;
  settings.mirrored = options.mirror;
  settings.seed = seed;
  settings.noiseKey = static_cast<std::uint64_t>(cameraIndex);
  settings.readNoiseDn = effects.readNoiseDn;
  settings.shotNoise = effects.shotNoise;
  settings.defocus = effects.defocus;
  settings.speckle = effects.speckle;
  auto made = VirtualTarget::create(settings);
  if (!made) return tl::unexpected<Error>(made.error());
  const std::uint64_t poses = simulator::hash(seed, simulator::Stream::View, {static_cast<std::uint64_t>(cameraIndex)});
  return SimulatedTarget{*std::move(made), camera, usualViews(*target, camera.intrinsics, options.views, poses),
                         options.laser};
}

std::string viewName(std::size_t view, bool laser) {
  const std::string number = std::to_string(view + 1);
  return "view" + std::string(number.size() < 2 ? 1 : 0, '0') + number + (laser ? "_laser.png" : ".png");
}

std::vector<PictureJob> targetJobs(const SimulatedTarget& target, const std::filesystem::path& out) {
  std::vector<PictureJob> jobs;
  const Intrinsics& in = target.camera.intrinsics;
  for (std::size_t v = 0; v < target.views.size(); ++v)
    for (const bool laser : {false, true})
      if (!laser || target.laser)
        jobs.push_back({out / viewName(v, laser), in.widthPx, in.heightPx,
                        [shown = target.target, pose = target.views[v], v, laser](const MutableImageView& image) {
                          shown->render(pose, static_cast<int>(v), laser, image);
                        }});
  return jobs;
}

Json targetTruth(const SimulatedTarget& target) {
  Json views = Json::array();
  for (std::size_t v = 0; v < target.views.size(); ++v) {
    Json view = {{"image", viewName(v, false)}};
    if (target.laser) view["laser_image"] = viewName(v, true);
    view["camera_from_target"] = poseTruth(target.views[v]);
    view["points_px"] = pixelsTruth(target.target->truePixels(target.views[v]));
    views.push_back(std::move(view));
  }
  return views;
}

namespace {

struct Options {
  TargetOptions target;
  std::string out;
  int camera = 1;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> rigSeed;
  bool quiet = false;
};

Expected<void> simulateTarget(const Options& options) {
  const auto rig = simulator::drawRig(options.rigSeed.value_or(options.seed));
  const int index = options.camera - 1;
  const RangeFinderCalibration& camera = rig.calibration.rangeFinders[static_cast<std::size_t>(index)];
  const auto target = makeTarget(options.target, camera, index, options.seed);
  if (!target) return tl::unexpected<Error>(target.error());
  const std::filesystem::path out = options.out;
  Progress progress(options.quiet, "rendering");
  if (auto written = writePictures(targetJobs(*target, out), progress); !written) return written;
  const Eigen::Vector3d normal = camera.cameraFromWorld.rotation * camera.lightPlane.normal;
  const double distance = camera.lightPlane.distanceMm + normal.dot(camera.cameraFromWorld.translationMm);
  Json truth = {
      {"seed", options.seed},
      {"rig_seed", options.rigSeed.value_or(options.seed)},
      {"camera", options.camera},
      {"target", words(target->target->settings().target)},
      {"light_dots", options.target.lightDots},
      {"mirrored", options.target.mirror},
      {"target_error_um", options.target.errorUm},
      {"intrinsics", intrinsicsTruth(camera.intrinsics)},
      {"light_plane_in_camera", {{"normal", {normal.x(), normal.y(), normal.z()}}, {"distance_mm", distance}}}};
  truth["views"] = targetTruth(*target);
  return writeJson((out / "truth.json").string(), truth);
}

}  // namespace

void addTargetOptions(CLI::App& command, TargetOptions& options) {
  command.add_option("--target", options.target,
                     "chessboard:COLSxROWS:MM, circles:COLSxROWS:PITCH[:DIAMETER], acircles:..., dotplate:...");
  command.add_option("--views", options.views, "Poses of the target")->check(CLI::Range(1, 999));
  command.add_flag("--light-dots", options.lightDots, "Light print on dark");
  command.add_option("--target-error-um", options.errorUm,
                     "Each coordinate of a point errs uniformly within +- this, the same in all pictures");
}

void addSimulateTarget(CLI::App& simulate, int& exitCode) {
  CLI::App* command = simulate.add_subcommand(
      "target",
      "A flat target before one camera of the rig: DIR/view01.png ..., DIR/truth.json; with --laser also\n"
      "DIR/view01_laser.png ..., where the laser's line crosses it.\n"
      "Example: vignole-cli simulate target --out views --target chessboard:13x9:10 --views 12 --camera 2 --laser");
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Folder for the pictures and the truth")->required();
  addTargetOptions(*command, options->target);
  command->add_option("--camera", options->camera, "Camera of the rig")->check(CLI::Range(1, kCameraCount));
  command->add_flag("--laser", options->target.laser, "Each view once more, with the laser on and the lamp dimmed");
  command->add_flag("--mirror", options->target.mirror, "The target is printed as its mirror image");
  command->add_option("--effect", options->target.effects,
                      "NAME=on|off|VALUE: read-noise, shot-noise, defocus, speckle (of the laser), all");
  command->add_option("--seed", options->seed, "Draws the poses, the print's errors and the noise");
  command->add_option("--rig-seed", options->rigSeed, "Draws the rig: cameras and lasers (default: the seed)");
  command->add_flag("--quiet", options->quiet, "No progress");
  command->callback([options, &exitCode] {
    const auto done = simulateTarget(*options);
    exitCode = done ? kDone : fail(done.error());
  });
}

}  // namespace vignole::cli
