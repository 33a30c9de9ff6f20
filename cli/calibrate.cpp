#include "cli/calibrate.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/commands.h"

namespace vignole::cli {

void addCalibrate(CLI::App& app, int& exitCode) {
  CLI::App* calibrate = app.add_subcommand("calibrate", "Cameras, range finders, encoder: calibrated and assessed");
  calibrate->require_subcommand(1);
  addCalibrateIntrinsics(*calibrate, exitCode);
  addCalibrateConvert(*calibrate, exitCode);
  addCalibrateLightPlane(*calibrate, exitCode);
  addCalibrateExposure(*calibrate, exitCode);
  addCalibrateRig(*calibrate, exitCode);
  addCalibrateEncoder(*calibrate, exitCode);
  addCalibrateStudy(*calibrate, exitCode);
  addCalibrateAssess(*calibrate, exitCode);
}

}  // namespace vignole::cli
