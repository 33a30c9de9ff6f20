// vignole-cli calibrate exposure: which exposure for rails, from pictures taken at several.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "calibration/parameter_study/exposure_adviser.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/exposure_output.h"
#include "cli/report_files.h"
#ifdef VIGNOLE_REPORT
#include "report/study_document.h"
#endif

namespace vignole::cli {
namespace {

struct Options {
  std::vector<std::string> images;
  std::string calibration, json, report;
  ExposureSettings settings;
  double rateHz = 0, mmPerPx = 0;
  bool noOverlap = false, quiet = false;
};

Expected<ExposureAdvice> advise(const Options& options) {
  ExposureSettings settings = options.settings;
  settings.timing.overlap = !options.noOverlap;
  if (options.rateHz > 0) settings.rateHz = options.rateHz;
  if (options.mmPerPx > 0) settings.mmPerPx = options.mmPerPx;
  std::optional<RigCalibration> rig;
  if (!options.calibration.empty()) {
    auto loaded = loadCalibration(options.calibration);
    if (!loaded) return tl::unexpected(loaded.error());
    rig = *std::move(loaded);
  }
  const auto pictures = findExposedPictures({options.images.begin(), options.images.end()});
  if (!pictures) return tl::unexpected(pictures.error());
  Progress progress(options.quiet, "exposure");
  const Job job{[&](double share, std::string_view doing) { progress.update(share, std::string(doing)); }, {}};
  return adviseExposure(*pictures, rig ? &*rig : nullptr, settings, job);
}

#ifdef VIGNOLE_REPORT
Expected<void> report(const ExposureAdvice& advice, const std::string& file) {
  return writeDocumentReport(exposureDocument(advice, std::to_string(advice.readings.size()) + " pictures"), file);
}
#else
Expected<void> report(const ExposureAdvice&, const std::string& file) { return writeDocumentReport({}, file); }
#endif

int run(const Options& options) {
  if (!options.report.empty())
    if (const auto possible = checkDocumentFile(options.report); !possible) return fail(possible.error());
  const auto advice = advise(options);
  if (!advice) return fail(advice.error());
  if (!options.report.empty())
    if (const auto written = report(*advice, options.report); !written) return fail(written.error());
  if (!options.json.empty())
    if (const auto written = writeJson(options.json, toJson(*advice)); !written) return fail(written.error());
  if (options.json != "-")
    if (const auto written = writeResult("-", toTable(*advice)); !written) return fail(written.error());
  return advice->exposureMs ? kDone : kVerdictFail;
}

constexpr const char* kFooter =
    "Pictures lie in folders exposure<NUMBER>ms and have camera1 to camera4 in their path, as `simulate plate` and\n"
    "`simulate rail` write them; take them on the surfaces that pass (bright, scaled), moving as in production.\n\n"
    "The model. A rail that moves along z slides through the light plane: its section does not change, only what\n"
    "changes along z smears (slope * speed * t, evenly), and what moves across: a vibration of standard deviation a\n"
    "and frequency f has the variance a^2 (1 - sinc^2(pi f t)) within an exposure t. A line of width s under a filter\n"
    "sigma that is smeared by b is located ((s^2 + b^2 + sigma^2) / (s^2 + sigma^2))^1.5 times worse; pictures taken\n"
    "at rest get that added (--at-rest), others hold it already. The next trigger is taken after the exposure and not\n"
    "before the last picture is read out: 15 ms are 66 triggers a second.\n"
    "Recommended is the shortest exposure that breaks no limit and whose uncertainty is nearly that of the best.\n"
    "Columns: clipped (worst picture), S/N (median contrast over the noise of a pixel), weak (of the weakest 5 % of a\n"
    "line, worst picture), found (points against the unclipped exposure that shows most), u (standard uncertainty of "
    "a\n"
    "point across the line; clipped lines hide their noise), blur (by motion), max Hz, mm/prof (profiles along the "
    "rail at that rate), u/m (mean over a\n"
    "metre).\n"
    "Exit code 1: every exposure breaks a limit.\n\n"
    "Example: vignole-cli calibrate exposure rails/exposure* --calibration rig.toml --speed 1 --rate 66\n";

}  // namespace

void addCalibrateExposure(CLI::App& calibrate, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command = calibrate.add_subcommand(
      "exposure", "Which exposure for rails: light, noise, motion and trigger rate over pictures taken at several.");
  ExposureSettings& s = options->settings;
  const auto positive = CLI::PositiveNumber;
  command->add_option("IMAGE", options->images, "Pictures, or folders that are searched for them")->required();
  command->add_option("--calibration", options->calibration, "Of the rig: gives millimetres");
  command->add_option("--mm-per-px", options->mmPerPx, "Scale across the line, where no calibration is given")
      ->check(positive);
  command->add_option("--speed", s.motion.speedMPerS, "Of the rail, m/s")->check(positive)->capture_default_str();
  command->add_option("--rate", options->rateHz, "Triggers a second that are wanted, Hz")->check(positive);
  command->add_option("--vibration", s.motion.vibrationMm, "Standard deviation across the line, mm")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--vibration-hz", s.motion.vibrationHz, "Its frequency, Hz")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--slope", s.motion.slopeMmPerM,
                   "How the rail moves across its way: bends, wander on the roller table, mm/m")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_flag("--at-rest", s.takenAtRest, "The pictures were taken at rest: the smear by motion is added");
  command->add_option("--sigma", s.stripe.sigma, "Standard deviation of the Gaussian, px")->capture_default_str();
  command->add_option("--readout-ms", s.timing.readoutMs, "Of a picture, ms; default: 1400 x 1024 bytes by 1 Gbit/s")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--dead-ms", s.timing.deadMs, "Between exposures, ms")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_flag("--no-overlap", options->noOverlap, "The camera does not expose while it reads out");
  command->add_option("--max-saturated", s.maxSaturated, "Share of a picture's line that may be clipped")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--min-weak-snr", s.minWeakSnr, "Contrast over noise at the weakest 5 % of a line, at least")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--max-blur-px", s.maxBlurPx, "Smear by motion, at most")->check(positive)->capture_default_str();
  command->add_option("--min-found", s.minCoverage, "Share of the line's points, at least")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--report", options->report, "FILE.pdf: verdict, table, plots");
  command->add_option("--json", options->json, "All results; - is stdout");
  command->add_flag("--quiet", options->quiet, "No progress");
  command->footer(kFooter);
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
