// vignole-cli simulate campaign: all pictures of one calibration of the virtual rig, and the commands that calibrate
// it.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/rig_truth.h"
#include "cli/simulate.h"
#include "cli/simulate_plate.h"
#include "cli/simulate_target.h"
#include "engine/files/atomic_file.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  PlateOptions plate;
  TargetOptions target;
  std::string out;
  bool quiet = false;
};

std::string cameraName(std::size_t camera) { return "camera" + std::to_string(camera + 1); }

/// To be run in the campaign's folder, by a shell.
std::string commands(const Options& options, const SimulatedPlate& plate, std::uint64_t rigSeed) {
  std::string text = "# In this folder: sh commands.txt\n";
  std::string intrinsics, placements;
  for (std::size_t camera = 0; camera < kCameraCount; ++camera) {
    const std::string name = cameraName(camera);
    text += "vignole-cli calibrate intrinsics " + name + "/view*.png --target " + options.target.target + " --out " +
            name + ".toml\n";
    intrinsics += " " + name + ".toml";
  }
  // At several exposures: the usual one, or the first.
  std::size_t exposure = 0;
  for (std::size_t e = 0; e < plate.atExposures.size(); ++e)
    if (plate.atExposures[e]->settings().exposureMs == VirtualPlateSettings{}.exposureMs) exposure = e;
  for (std::size_t p = 0; p < plate.atExposures[exposure]->settings().placements.size(); ++p)
    placements += " " + placementFolder(plate, exposure, p);
  text += "vignole-cli calibrate rig --plate plate.toml --placement" + placements + " --intrinsics" + intrinsics +
          " --out rig.toml\n";
  return text + "vignole-cli inspect --rig-seed " + std::to_string(rigSeed) + " --calibration rig.toml\n";
}

Expected<void> simulateCampaign(const Options& options) {
  const auto plate = makePlate(options.plate);
  if (!plate) return tl::unexpected<Error>(plate.error());
  const RigCalibration& rig = plate->atExposures.front()->calibration();
  const std::filesystem::path out = options.out;
  std::vector<PictureJob> jobs = plateJobs(*plate, out);
  Json targets = Json::array();
  for (std::size_t camera = 0; camera < kCameraCount; ++camera) {
    const auto target =
        makeTarget(options.target, rig.rangeFinders[camera], static_cast<int>(camera), options.plate.seed);
    if (!target) return tl::unexpected<Error>(target.error());
    for (PictureJob& job : targetJobs(*target, out / cameraName(camera))) jobs.push_back(std::move(job));
    targets.push_back({{"camera", camera + 1}, {"folder", cameraName(camera)}, {"views", targetTruth(*target)}});
  }
  if (auto written = writeStatedPlate(*plate, out); !written) return written;
  Progress progress(options.quiet, "rendering");
  if (auto written = writePictures(jobs, progress); !written) return written;
  const std::uint64_t rigSeed = options.plate.rigSeed.value_or(options.plate.seed);
  if (auto saved = saveCalibration(rig, out / "true_calibration.toml"); !saved) return saved;
  if (auto written = writeFile(out / "commands.txt", commands(options, *plate, rigSeed)); !written) return written;
  Json truth = {{"seed", options.plate.seed}, {"rig_seed", rigSeed}};
  truth["plate"] = plateTruth(*plate);
  truth["target"] = {
      {"words", options.target.target}, {"target_error_um", options.target.errorUm}, {"cameras", std::move(targets)}};
  truth["rig"] = rigTruth(rig);
  return writeJson((out / "truth.json").string(), truth);
}

}  // namespace

void addSimulateCampaign(CLI::App& simulate, int& exitCode) {
  CLI::App* command = simulate.add_subcommand(
      "campaign",
      "All pictures of one calibration of the rig: targets before each camera (DIR/camera1/view01.png ...), the pin\n"
      "plate (DIR/plate.toml, DIR/placement1/camera1.png ...), DIR/truth.json, DIR/true_calibration.toml, and\n"
      "DIR/commands.txt, which calibrates it.\n"
      "Example: vignole-cli simulate campaign --out campaign --plate-error-um 50 --noise-px 0.1 --rig-seed 7");
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Folder for the pictures and the truth")->required();
  addTargetOptions(*command, options->target);
  addPlateOptions(*command, options->plate);
  command->add_flag("--quiet", options->quiet, "No progress");
  command->callback([options, &exitCode] {
    options->target.effects = options->plate.effects;
    const auto done = simulateCampaign(*options);
    exitCode = done ? kDone : fail(done.error());
  });
}

}  // namespace vignole::cli
