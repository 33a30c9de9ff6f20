// vignole-cli calibrate convert: a camera's lens from the file of one program to that of another.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibration/lens_files/lens_files.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/intrinsics_output.h"

namespace vignole::cli {
namespace {

struct Options {
  std::string in, out, json;
  double pixelUm = 7.4;
};

int run(const Options& options) {
  const auto lens = importLens(options.in, options.pixelUm * 1e-3);
  if (!lens) return fail(lens.error());
  const auto residual = exportLens(lens->camera, options.out);
  if (!residual) return fail(residual.error());
  nlohmann::ordered_json document = lensJson(lens->camera.intrinsics);
  document["read_residual_px"] = lens->maxResidualPx;
  document["written_residual_px"] = *residual;
  if (!options.json.empty())
    if (const auto done = writeJson(options.json, document); !done) return fail(done.error());
  if (options.json == "-") return kDone;
  char text[160];
  std::snprintf(text, sizeof text, "largest difference over the picture: %.4f px reading, %.4f px writing\n",
                lens->maxResidualPx, *residual);
  if (const auto done = writeResult("-", text); !done) return fail(done.error());
  return kDone;
}

}  // namespace

void addCalibrateConvert(CLI::App& calibrate, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command = calibrate.add_subcommand("convert", "A lens from the file of one program to that of another");
  command->footer(
      "By the names' ends: .toml ours, .yaml or .yml OpenCV, .dat HALCON, .cameramodel mrcal. OpenCV and mrcal say\n"
      "distortion the other way round: it is fitted over 50 x 40 points of the picture, and what is left is told.\n"
      "Example: vignole-cli calibrate convert camera1.toml camera1.yaml");
  command->add_option("IN", options->in, "file to read")->required();
  command->add_option("OUT", options->out, "file to write")->required();
  command->add_option("--pixel-um", options->pixelUm, "width of a pixel where IN does not say, um (default 7.4)")
      ->check(CLI::Range(0.1, 100.0));
  command->add_option("--json", options->json, "JSON to a file, or - for stdout");
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
