// vignole-cli calibrate study: a factorial experiment over the settings of a rig's calibration.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "calibration/parameter_study/calibration_trial.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/report_files.h"
#include "cli/study_output.h"
#include "engine/optics/nominal_rig.h"
#include "engine/rail/catalogue.h"
#ifdef VIGNOLE_REPORT
#include "report/study_document.h"
#endif

namespace vignole::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string factors, plate, rail = "60E1", csv, json, report;
  std::vector<std::string> placements, intrinsics;
  bool list = false, quiet = false;
};

/// Beside the placements or above them: `simulate plate` writes plate.toml and intrinsics/ into the top folder.
std::optional<fs::path> besideOrAbove(const fs::path& placement, const fs::path& wanted) {
  std::error_code error;
  fs::path folder = fs::absolute(placement, error).lexically_normal();
  for (int level = 0; level < 4; ++level) {
    if (fs::exists(folder / wanted, error)) return folder / wanted;
    if (!folder.has_parent_path() || folder.parent_path() == folder) break;
    folder = folder.parent_path();
  }
  return {};
}

Expected<PinPlate> plateOf(const Options& options) {
  if (!options.plate.empty()) return loadPinPlate(options.plate);
  const auto found = besideOrAbove(options.placements.front(), "plate.toml");
  if (!found) return inputError("--plate", "is not given, and no plate.toml lies beside or above the placements");
  return loadPinPlate(*found);
}

Expected<std::array<CalibratedIntrinsics, kCameraCount>> intrinsicsOf(const Options& options) {
  std::array<CalibratedIntrinsics, kCameraCount> cameras;
  if (!options.intrinsics.empty() && options.intrinsics.size() != kCameraCount)
    return inputError("--intrinsics",
                      "needs four files, camera 1 first; " + std::to_string(options.intrinsics.size()) + " are given");
  for (std::size_t i = 0; i < kCameraCount; ++i) {
    std::optional<fs::path> file;
    const std::string name = "camera" + std::to_string(i + 1) + ".toml";
    if (!options.intrinsics.empty())
      file = options.intrinsics[i];
    else
      file = besideOrAbove(options.placements.front(), fs::path("intrinsics") / name);
    if (!file)
      return inputError("--intrinsics",
                        "are not given, and no intrinsics/" + name + " lies beside or above the placements");
    auto camera = loadIntrinsics(*file);
    if (!camera) return tl::unexpected(camera.error());
    cameras[i] = *std::move(camera);
  }
  return cameras;
}

Expected<TrialMaterial> materialOf(const Options& options) {
  TrialMaterial material;
  auto placements = findPlacements(std::vector<fs::path>(options.placements.begin(), options.placements.end()));
  if (!placements) return tl::unexpected(placements.error());
  material.placements = *std::move(placements);
  auto plate = plateOf(options);
  if (!plate) return tl::unexpected(plate.error());
  material.plate = *std::move(plate);
  auto cameras = intrinsicsOf(options);
  if (!cameras) return tl::unexpected(cameras.error());
  material.cameras = *std::move(cameras);
  const auto section = findSection(options.rail);
  if (!section) return tl::unexpected(section.error());
  auto jacobian = dimensionJacobian(*section, DimensionParameters{}, nominalRig());
  if (!jacobian) return tl::unexpected(jacobian.error());
  material.jacobian = *std::move(jacobian);
  return material;
}

Expected<ParameterStudy> study(const Options& options, const StudyPlan& plan) {
  auto material = materialOf(options);
  if (!material) return tl::unexpected(material.error());
  Progress progress(options.quiet, "study");
  const Job job{[&](double share, std::string_view doing) { progress.update(share, std::string(doing)); }, {}};
  return runCalibrationStudy(plan, *std::move(material), job);
}

#ifdef VIGNOLE_REPORT
Expected<void> report(const ParameterStudy& study, const std::string& file) {
  return writeDocumentReport(studyDocument(study, std::to_string(study.runs.size()) + " calibrations"), file);
}
#else
Expected<void> report(const ParameterStudy&, const std::string& file) { return writeDocumentReport({}, file); }
#endif

int run(const Options& options) {
  if (options.list) {
    std::string text;
    for (const std::string& line : studyFactorWords()) text += line + "\n";
    const auto written = writeResult("-", text);
    return written ? kDone : fail(written.error());
  }
  if (options.placements.empty())
    return fail(Error{"--placement", "is missing; give folders of camera1.png to camera4.png, or their top folder",
                      ErrorKind::Input});
  if (!options.report.empty())
    if (const auto possible = checkDocumentFile(options.report); !possible) return fail(possible.error());
  const auto plan = loadStudyPlan(options.factors.empty() ? resourceDirectory() / "studies" / "calibration.toml"
                                                          : fs::path(options.factors));
  if (!plan) return fail(plan.error());
  const auto result = study(options, *plan);
  if (!result) return fail(result.error());
  if (!options.report.empty())
    if (const auto written = report(*result, options.report); !written) return fail(written.error());
  if (!options.csv.empty())
    if (const auto written = writeResult(options.csv, toCsv(*result)); !written) return fail(written.error());
  if (!options.json.empty())
    if (const auto written = writeJson(options.json, toJson(*result, *plan)); !written) return fail(written.error());
  if (options.json != "-" && options.csv != "-")
    if (const auto written = writeResult("-", toTable(*result)); !written) return fail(written.error());
  return result->unitsFailed < result->unitsTried ? kDone : kVerdictFail;
}

constexpr const char* kFooter =
    "A file of factors (TOML, format = 1) has a [[factor]] with name and levels for each; resources/studies holds\n"
    "calibration.toml (the paper's experiment; taken without --factors) and methods.toml. --list names every factor.\n"
    "Every combination is a calibration; cameras and placements are its replicates. Told are: means at every level "
    "with\n"
    "standard errors, interactions of two factors, the analysis of variance, influence by eta^2, the best setting and\n"
    "whether its own run does what the other runs foretell. Cameras that fail are counted and told.\n"
    "Exit code 1: every camera failed in every run.\n\n"
    "Example: vignole-cli simulate plate --out plate --placements 2 --exposure 5 --exposure 10 --exposure 15 "
    "--exposure 20\n"
    "         vignole-cli calibrate study --placement plate --csv runs.csv --json study.json\n";

}  // namespace

void addCalibrateStudy(CLI::App& calibrate, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      calibrate.add_subcommand("study", "A factorial experiment over the settings of a rig's calibration.");
  command->add_option("--factors", options->factors, "TOML: what is varied (default: the paper's experiment)");
  command->add_option("--placement", options->placements,
                      "DIR of camera1.png to camera4.png, or a folder that holds placement* or exposure<NUMBER>ms/"
                      "placement*; repeated or several");
  command->add_option("--plate", options->plate, "Pin plate (default: plate.toml beside or above the placements)");
  command->add_option("--intrinsics", options->intrinsics,
                      "Four files, camera 1 first (default: intrinsics/camera1.toml ... there)");
  command->add_option("--rail", options->rail, "Section that the uncertainty of dimensions is told for")
      ->capture_default_str();
  command->add_option("--report", options->report, "FILE.pdf: verdict, influence, main effects, interactions");
  command->add_option("--csv", options->csv, "One row for every camera in every placement of every run; - is stdout");
  command->add_option("--json", options->json, "All results; - is stdout");
  command->add_flag("--list", options->list, "Name the factors there are, and end");
  command->add_flag("--quiet", options->quiet, "No progress");
  command->footer(kFooter);
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
