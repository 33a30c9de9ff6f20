#include "cli/calibrate.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/commands.h"

namespace vignole::cli {

void addCalibrate(CLI::App& app, int& exitCode) {
  CLI::App* calibrate = app.add_subcommand("calibrate", "Cameras, range finders, encoder: calibrated and assessed");
  calibrate->require_subcommand(1);
  addCalibrateExposure(*calibrate, exitCode);
}

}  // namespace vignole::cli
