// vignole-cli calibrate assess: a calibration that is in use, judged on placements of the plate that it has not seen.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "calibration/assessment/existing_calibration.h"
#include "calibration/range_finders/association.h"
#include "cli/assessment_output.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/placement_pictures.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"

namespace vignole::cli {

namespace {

struct Options {
  std::string calibration, plate, section = "60E1", previous, json;
  std::vector<std::string> placements;
  bool quiet = false;
};

/// Refuses in the words of the pictures.
Expected<void> refuseUnusable(const RigInputs& inputs) {
  for (const PlacementLines& placement : inputs.placements)
    for (const PinPicture& picture : placement.pictures)
      if (!picture.usable()) return inputError(picture.file, picture.refusal);
  return {};
}

int run(const Options& o) {
  const auto calibration = loadCalibration(o.calibration);
  if (!calibration) return fail(calibration.error());
  const auto section = findSection(o.section);
  if (!section) return fail(section.error());
  std::optional<RigCalibration> previous;
  if (!o.previous.empty()) {
    auto loaded = loadCalibration(o.previous);
    if (!loaded) return fail(loaded.error());
    previous = std::move(*loaded);
  }
  std::optional<PinPlate> plate;
  if (!o.plate.empty()) {
    auto loaded = loadPinPlate(o.plate);
    if (!loaded) return fail(loaded.error());
    plate = std::move(*loaded);
  }
  auto inputs = inputsFor(*calibration, plate);
  if (!inputs) return fail({o.calibration, inputs.error().message()});

  std::optional<Progress> progress(std::in_place, o.quiet, "assessing");
  const Job job{[&](double share, std::string_view doing) { progress->update(share, std::string(doing)); }, {}};
  std::array<Intrinsics, kCameraCount> cameras;
  for (std::size_t c = 0; c < kCameraCount; ++c) cameras[c] = inputs->cameras[c].intrinsics;
  auto placements = readPlacements(o.placements, cameras, job);
  if (!placements) return fail(placements.error());
  inputs->placements = std::move(*placements);
  AssociationSettings association;
  association.drawing = *calibration;
  associate(*inputs, association);
  if (const auto usable = refuseUnusable(*inputs); !usable) return fail(usable.error());
  const auto adjusted = adjustRig(*inputs, {}, job);
  if (!adjusted) return fail(adjusted.error());
  if (!adjusted->refusals.empty()) return fail({o.placements.front(), adjusted->refusals.front()});
  const DimensionParameters parameters = defaultParameters(*section);
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const auto judged = judgeExisting(*calibration, *inputs, *adjusted, *section, parameters, now);
  if (!judged) return fail(judged.error());
  std::optional<Comparison> withPrevious;
  if (previous) {
    auto compared = compare(*previous, *calibration, *section, parameters);
    if (!compared) return fail({o.previous, compared.error().message()});
    withPrevious = *compared;
  }
  progress.reset();

  const std::vector<std::string> refusals = refusalsOf(judged->checks);
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, assessmentJson(*calibration, *judged, withPrevious, *section)); !written)
      return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", assessmentText(*calibration, *judged, withPrevious)); !written)
      return fail(written.error());
  for (const std::string& refusal : refusals) fail({o.calibration, refusal});
  return refusals.empty() ? kDone : kVerdictFail;
}

}  // namespace

void addCalibrateAssess(CLI::App& calibrate, int& exitCode) {
  auto o = std::make_shared<Options>();
  CLI::App* command = calibrate.add_subcommand("assess", "Judge a calibration on placements that it has not seen");
  command->footer(
      "A placement is a folder of camera1.png ... camera4.png of the plate that the calibration was made with.\n"
      "Exit code 1: the calibration should not be used any more.\n"
      "Example: vignole-cli calibrate assess --calibration rig.toml --placement monday --json -");
  command->add_option("--calibration", o->calibration, "the calibration to judge")->required();
  command->add_option("--placement", o->placements, "DIR of camera1.png ... camera4.png (several)")->required();
  command->add_option("--plate", o->plate, "plate file; default: the pins as the calibration found them");
  command->add_option("--section", o->section, "whose dimensions are judged")->capture_default_str();
  command->add_option("--previous", o->previous, "an older calibration of the rig to compare it with");
  command->add_option("--json", o->json, "file, or - for stdout");
  command->add_flag("--quiet", o->quiet, "no progress on the terminal");
  command->callback([o, &exitCode] { exitCode = run(*o); });
}

}  // namespace vignole::cli
