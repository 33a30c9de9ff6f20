// vignole-cli simulate plate: the pin plate before the virtual rig, placement by placement, with its truth.

#include "cli/simulate_plate.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/rig_truth.h"
#include "cli/simulate.h"
#include "cli/virtual_intrinsics.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUsualExposureMs = 15;
constexpr double kLeastUMm = 1e-4;  // an adjustment wants no plate without any uncertainty
constexpr double kRadiusShare = 0.2;

std::string plain(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

PinPlate mirrored(PinPlate plate) {
  for (Pin& pin : plate.pins) pin.centreMm.x() = -pin.centreMm.x();
  return plate;
}

Expected<PinPlate> statedPlate(const PlateOptions& options) {
  PinPlate plate = plate13();
  if (!options.plate.empty()) {
    auto loaded = loadPinPlate(options.plate);
    if (!loaded) return loaded;
    plate = *std::move(loaded);
  }
  for (Pin& pin : plate.pins) {
    if (options.plateErrorUm) {
      pin.uCentreMm = *options.plateErrorUm * 1e-3 / std::sqrt(3.0);
      pin.uRadiusMm = kRadiusShare * pin.uCentreMm;
    }
    pin.uCentreMm = std::max(pin.uCentreMm, kLeastUMm);
    pin.uRadiusMm = std::max(pin.uRadiusMm, kLeastUMm);
  }
  return plate;
}

}  // namespace

void addPlateOptions(CLI::App& command, PlateOptions& options) {
  command.add_option("--plate", options.plate, "Plate file, TOML or JSON (default: the plate with 13 pins)");
  command.add_option("--placements", options.placements, "Times that the plate is set down")->check(CLI::Range(1, 100));
  command.add_option("--plate-error-um", options.plateErrorUm,
                     "Each coordinate of a pin's centre errs uniformly within +- this, each radius within +- a fifth; "
                     "plate.toml states it (default: none)");
  command.add_option("--noise-px", options.noisePx,
                     "All noise (read noise, speckle contrast; variance of shot noise by the square) times the one "
                     "factor at which the median Cramer-Rao bound, along the normal, of a point that 1 px of line "
                     "gives is this many px: over all line visible in the first placement, exposed for 15 ms");
  command.add_option("--exposure", options.exposuresMs,
                     "ms (default 15); repeated: all placements at each, below exposureMSms/");
  command.add_option("--turn", options.turnDeg, "Degrees that the plate is turned in all placements")
      ->check(CLI::Range(-360.0, 360.0));
  command
      .add_option("--tilt", options.tiltDeg,
                  "Degrees that the plate leans out of the light plane, each placement in a direction of its own")
      ->check(CLI::Range(-30.0, 30.0));
  command.add_option("--lean", options.leanMrad, "Standard deviation of each pin's own lean, mrad");
  command.add_option("--missing-pin", options.missingPins, "Number of a pin that is not there (repeatable)");
  command.add_option("--spurious", options.spurious, "Bright arcs that are no pins, per picture");
  command.add_flag("--mirror", options.mirror, "The plate is the mirror image of what plate.toml states");
  command.add_option("--effect", options.effects,
                     "NAME=on|off|VALUE: read-noise, shot-noise, speckle, crosstalk, ambient, defocus, all");
  command.add_option("--fault", options.faults,
                     "KIND[=VALUE][@CAMERA][:FROM-TO], FROM and TO placements: black, saturated, move, turn");
  command.add_option("--seed", options.seed, "Draws the plate's errors, placements, intrinsics' errors and noise");
  command.add_option("--rig-seed", options.rigSeed, "Draws the rig: cameras and lasers (default: the seed)");
}

Expected<SimulatedPlate> makePlate(const PlateOptions& options) {
  auto stated = statedPlate(options);
  if (!stated) return tl::unexpected<Error>(stated.error());
  SimulatedPlate made;
  made.stated = *std::move(stated);
  VirtualPlateSettings settings;
  settings.plate = options.mirror ? mirrored(made.stated) : made.stated;
  settings.seed = options.seed;
  settings.rigSeed = options.rigSeed;
  settings.plateErrorMm = options.plateErrorUm.value_or(0) * 1e-3;
  settings.radiusErrorMm = kRadiusShare * settings.plateErrorMm;
  settings.leanMrad = options.leanMrad;
  settings.placements = usualPlacements(options.placements, options.seed);
  for (std::size_t i = 0; i < settings.placements.size(); ++i) {
    PlatePlacement& placement = settings.placements[i];
    placement = turned(placement, options.turnDeg * kDegree);
    const double direction = 2.4 * static_cast<double>(i);  // rad: the golden angle, so no two are alike
    placement.tiltXRad = options.tiltDeg * kDegree * std::cos(direction);
    placement.tiltYRad = options.tiltDeg * kDegree * std::sin(direction);
  }
  settings.noisePx = options.noisePx;
  settings.missingPins = options.missingPins;
  settings.spurious = options.spurious;
  for (const std::string& effect : options.effects)
    if (auto applied = applyEffect(settings.effects, effect); !applied) return tl::unexpected<Error>(applied.error());
  for (const std::string& text : options.faults) {
    auto fault = parseFault(text);
    if (!fault) return tl::unexpected<Error>(fault.error());
    settings.faults.push_back(*std::move(fault));
  }
  std::vector<double> exposures = options.exposuresMs;
  if (exposures.empty()) exposures = {kUsualExposureMs};
  std::sort(exposures.begin(), exposures.end());
  if (std::adjacent_find(exposures.begin(), exposures.end()) != exposures.end())
    return inputError("--exposure", "names the same time twice; give each once");
  for (const double exposure : exposures) {
    settings.exposureMs = exposure;
    auto plate = VirtualPlate::create(settings);
    if (!plate) return tl::unexpected<Error>(plate.error());
    made.atExposures.push_back(*std::move(plate));
  }
  return made;
}

std::string placementFolder(const SimulatedPlate& plate, std::size_t exposure, std::size_t placement) {
  const std::string folder = "placement" + std::to_string(placement + 1);
  if (plate.atExposures.size() == 1) return folder;
  return "exposure" + plain(plate.atExposures[exposure]->settings().exposureMs) + "ms/" + folder;
}

Expected<void> writeStatedPlate(const SimulatedPlate& plate, const std::filesystem::path& out) {
  if (auto made = makeFolder(out); !made) return made;
  return savePinPlate(plate.stated, out / "plate.toml");
}

std::vector<PictureJob> plateJobs(const SimulatedPlate& plate, const std::filesystem::path& out) {
  std::vector<PictureJob> jobs;
  for (std::size_t e = 0; e < plate.atExposures.size(); ++e)
    for (std::size_t p = 0; p < plate.atExposures[e]->settings().placements.size(); ++p)
      for (int camera = 0; camera < kCameraCount; ++camera) {
        const auto& stand = plate.atExposures[e];
        const Intrinsics& in = stand->calibration().rangeFinders[static_cast<std::size_t>(camera)].intrinsics;
        jobs.push_back({out / placementFolder(plate, e, p) / ("camera" + std::to_string(camera + 1) + ".png"),
                        in.widthPx, in.heightPx, [stand, camera, p](const MutableImageView& image) {
                          stand->render(camera, static_cast<int>(p), image);
                        }});
      }
  return jobs;
}

Json plateTruth(const SimulatedPlate& plate) {
  const VirtualPlate& first = *plate.atExposures.front();
  const VirtualPlateSettings& s = first.settings();
  Json truth;
  truth["noise_factor"] = first.noiseFactor();
  if (s.noisePx) truth["noise_px"] = *s.noisePx;
  for (const auto& [effect, value] : list(s.effects)) truth["effects"][effect] = value;
  for (const Pin& pin : first.truePlate().pins) {
    Json entry = {
        {"number", pin.number}, {"x_mm", pin.centreMm.x()}, {"y_mm", pin.centreMm.y()}, {"radius_mm", pin.radiusMm}};
    if (std::find(s.missingPins.begin(), s.missingPins.end(), pin.number) != s.missingPins.end())
      entry["missing"] = true;
    truth["pins"].push_back(std::move(entry));
  }
  for (std::size_t p = 0; p < s.placements.size(); ++p) {
    const PlatePlacement& placed = s.placements[p];
    Json placement;
    for (std::size_t e = 0; e < plate.atExposures.size(); ++e)
      placement["folders"].push_back(placementFolder(plate, e, p));
    placement["world_from_plate"] = {{"x_mm", placed.worldFromPlate.xMm},
                                     {"y_mm", placed.worldFromPlate.yMm},
                                     {"angle_deg", placed.worldFromPlate.angleRad / kDegree},
                                     {"tilt_x_deg", placed.tiltXRad / kDegree},
                                     {"tilt_y_deg", placed.tiltYRad / kDegree}};
    for (int camera = 0; camera < kCameraCount; ++camera) {
      Json arcs = Json::array();
      for (const Pin& pin : first.truePlate().pins) {
        const auto arc = first.visibleArc(camera, static_cast<int>(p), pin.number);
        if (!arc.empty()) arcs.push_back({{"pin", pin.number}, {"px", pixelsTruth(arc)}});
      }
      placement["cameras"].push_back({{"camera", camera + 1}, {"visible_arcs", std::move(arcs)}});
    }
    truth["placements"].push_back(std::move(placement));
  }
  return truth;
}

namespace {

struct Options {
  PlateOptions plate;
  std::string out;
  bool exactIntrinsics = false, quiet = false;
};

Expected<void> simulatePlate(const Options& options) {
  const auto plate = makePlate(options.plate);
  if (!plate) return tl::unexpected<Error>(plate.error());
  const std::filesystem::path out = options.out;
  if (auto written = writeStatedPlate(*plate, out); !written) return written;
  const RigCalibration& rig = plate->atExposures.front()->calibration();
  if (auto made = makeFolder(out / "intrinsics"); !made) return made;
  for (int camera = 0; camera < kCameraCount; ++camera) {
    const auto found = virtualIntrinsics(rig.rangeFinders[static_cast<std::size_t>(camera)], camera, options.plate.seed,
                                         options.exactIntrinsics);
    const auto file = out / "intrinsics" / ("camera" + std::to_string(camera + 1) + ".toml");
    if (auto saved = saveIntrinsics(found, file); !saved) return saved;
  }
  Progress progress(options.quiet, "rendering");
  if (auto written = writePictures(plateJobs(*plate, out), progress); !written) return written;
  if (auto saved = saveCalibration(rig, out / "true_calibration.toml"); !saved) return saved;
  Json truth = {{"seed", options.plate.seed}, {"rig_seed", options.plate.rigSeed.value_or(options.plate.seed)}};
  truth["plate"] = plateTruth(*plate);
  truth["rig"] = rigTruth(rig);
  return writeJson((out / "truth.json").string(), truth);
}

}  // namespace

void addSimulatePlate(CLI::App& simulate, int& exitCode) {
  CLI::App* command = simulate.add_subcommand(
      "plate",
      "The pin plate before the rig: DIR/placement1/camera1.png ... camera4.png, DIR/plate.toml (as stated),\n"
      "DIR/intrinsics/camera1.toml ... (as a calibration would have found them), DIR/true_calibration.toml,\n"
      "DIR/truth.json.\n"
      "Example: vignole-cli simulate plate --out plate --placements 4 --plate-error-um 50 --noise-px 0.1 --rig-seed 7");
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Folder for the pictures and the truth")->required();
  addPlateOptions(*command, options->plate);
  command->add_flag("--exact-intrinsics", options->exactIntrinsics,
                    "Write the true intrinsics; otherwise they err as a calibration does, with that covariance");
  command->add_flag("--quiet", options->quiet, "No progress");
  command->callback([options, &exitCode] {
    const auto done = simulatePlate(*options);
    exitCode = done ? kDone : fail(done.error());
  });
}

}  // namespace vignole::cli
