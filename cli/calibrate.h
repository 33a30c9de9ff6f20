#pragma once
// The subcommands of `calibrate`, one file each.

namespace CLI {
class App;
}

namespace vignole::cli {

void addCalibrateIntrinsics(CLI::App& calibrate, int& exitCode);
void addCalibrateLightPlane(CLI::App& calibrate, int& exitCode);
void addCalibrateRig(CLI::App& calibrate, int& exitCode);
void addCalibrateEncoder(CLI::App& calibrate, int& exitCode);
void addCalibrateAssess(CLI::App& calibrate, int& exitCode);
void addCalibrateStudy(CLI::App& calibrate, int& exitCode);
void addCalibrateExposure(CLI::App& calibrate, int& exitCode);

}  // namespace vignole::cli
