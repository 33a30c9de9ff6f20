// vignole-cli simulate rail: frames of the virtual rig as PNG, and the truth beside them.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/simulate.h"
#include "cli/simulated_files.h"
#include "engine/rail/catalogue.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole::cli {

namespace {

struct RailOptions {
  std::string out, rail = "60E1";
  int frames = 1;
  std::uint64_t first = 0, seed = 1;
  std::optional<std::uint64_t> rigSeed;
  double spacingMm = 15, speedMPerS = 1, temperatureC = 20;
  std::vector<std::string> effects, deviations, faults;
  bool quiet = false;
};

Expected<VirtualRigSettings> readSettings(const RailOptions& options) {
  VirtualRigSettings settings;
  auto section = findSection(options.rail);
  if (!section) return tl::unexpected<Error>(section.error());
  settings.section = *std::move(section);
  settings.parameters = settings.section.parameters;
  settings.seed = options.seed;
  settings.rigSeed = options.rigSeed;
  settings.spacingMm = options.spacingMm;
  settings.speedMmPerS = options.speedMPerS * 1000;
  settings.temperatureC = options.temperatureC;
  if (auto applied = applyWords(settings, options.effects, options.deviations, options.faults); !applied)
    return tl::unexpected<Error>(applied.error());
  return settings;
}

nlohmann::ordered_json truthOf(const VirtualRig& rig, std::uint64_t trigger, const std::string& folder) {
  const Truth truth = rig.truth(trigger);
  nlohmann::ordered_json frame;
  frame["trigger"] = trigger;
  frame["position_m"] = static_cast<double>(trigger) * rig.settings().spacingMm / 1000;
  frame["pose"] = {{"x_mm", truth.worldFromSection.xMm},
                   {"y_mm", truth.worldFromSection.yMm},
                   {"angle_deg", truth.worldFromSection.angleRad * 180 / 3.14159265358979323846}};
  for (const Dimension d : kDimensions) frame["dimensions_mm"][std::string(name(d))] = truth.valueMm[index(d)];
  frame["dimensions_mm"]["HF_min"] = truth.hfMinMm;
  for (int camera = 0; camera < kCameraCount; ++camera) {
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const auto& line : rig.visibleLines(camera, trigger)) {
      nlohmann::ordered_json points = nlohmann::ordered_json::array();
      // A ten-thousandth of a pixel is far below what any extraction resolves.
      for (const Point2& p : line) points.push_back({std::round(p.x() * 1e4) / 1e4, std::round(p.y() * 1e4) / 1e4});
      lines.push_back(std::move(points));
    }
    frame["cameras"].push_back({{"camera", camera + 1},
                                {"image", folder + "/camera" + std::to_string(camera + 1) + ".png"},
                                {"visible_lines_px", std::move(lines)}});
  }
  return frame;
}

int simulateRail(const RailOptions& options) {
  auto settings = readSettings(options);
  if (!settings) return fail(settings.error());
  const auto rig = VirtualRig::create(*std::move(settings));
  if (!rig) return fail(rig.error());

  nlohmann::ordered_json truth;
  truth["section"] = (*rig)->settings().section.name;
  truth["seed"] = options.seed;
  truth["rig_seed"] = options.rigSeed.value_or(options.seed);
  truth["temperature_c"] = options.temperatureC;
  truth["reference_temperature_c"] = 15;
  for (const auto& [effect, value] : list((*rig)->settings().effects)) truth["effects"][effect] = value;
  truth["frames"] = nlohmann::ordered_json::array();

  const std::filesystem::path out = options.out;
  const auto folderOf = [](std::uint64_t trigger) { return "trigger" + std::to_string(trigger); };
  std::vector<PictureJob> jobs;
  for (int i = 0; i < options.frames; ++i)
    for (int camera = 0; camera < kCameraCount; ++camera) {
      const std::uint64_t trigger = options.first + static_cast<std::uint64_t>(i);
      const Intrinsics& in = (*rig)->calibration().rangeFinders[static_cast<std::size_t>(camera)].intrinsics;
      jobs.push_back(
          {out / folderOf(trigger) / ("camera" + std::to_string(camera + 1) + ".png"), in.widthPx, in.heightPx,
           [rig = *rig, camera, trigger](const MutableImageView& image) { rig->render(camera, trigger, image); }});
    }
  Progress progress(options.quiet, "rendering");
  if (auto written = writePictures(jobs, progress); !written) return fail(written.error());
  for (int i = 0; i < options.frames; ++i) {
    const std::uint64_t trigger = options.first + static_cast<std::uint64_t>(i);
    truth["frames"].push_back(truthOf(**rig, trigger, folderOf(trigger)));
  }
  if (auto saved = saveCalibration((*rig)->calibration(), out / "calibration.toml"); !saved) return fail(saved.error());
  if (auto written = writeJson((out / "truth.json").string(), truth); !written) return fail(written.error());
  return kDone;
}

}  // namespace

void addSimulateRail(CLI::App& simulate, int& exitCode) {
  CLI::App* rail = simulate.add_subcommand(
      "rail",
      "Frames of a virtual rail: DIR/trigger0/camera1.png ... camera4.png, DIR/truth.json, DIR/calibration.toml.\n"
      "Example: vignole-cli simulate rail --out frames --frames 5 --rail 54E1 --deviation HW=0.3 --effect speckle=off");
  auto options = std::make_shared<RailOptions>();
  rail->add_option("--out", options->out, "Folder for the pictures and the truth")->required();
  rail->add_option("--frames", options->frames, "Number of triggers")->check(CLI::Range(1, 1000000));
  rail->add_option("--first", options->first, "First trigger");
  rail->add_option("--rail", options->rail, "Section of the catalogue, or a section file");
  rail->add_option("--seed", options->seed, "Draws the rail: how its dimensions vary, its surface, noise, movement");
  rail->add_option("--rig-seed", options->rigSeed, "Draws the rig: cameras and lasers (default: the seed)");
  rail->add_option("--spacing", options->spacingMm, "Travel between triggers, mm");
  rail->add_option("--speed", options->speedMPerS, "Speed of the rail, m/s");
  rail->add_option("--temperature", options->temperatureC, "Temperature of the rail, degrees C");
  rail->add_option("--effect", options->effects,
                   "NAME=on|off|VALUE: read-noise, shot-noise, speckle, scale, reflections, crosstalk, ambient, "
                   "defocus, motion, wander, vibration, all");
  rail->add_option("--deviation", options->deviations, "DIM=MM: constant deviation of a dimension from its nominal");
  rail->add_option("--fault", options->faults,
                   "KIND[=VALUE][@CAMERA][:FROM-TO]: black, saturated, move, turn, wrong-rail, scale");
  rail->add_flag("--quiet", options->quiet, "No progress");
  rail->callback([options, &exitCode] { exitCode = simulateRail(*options); });
}

}  // namespace vignole::cli
