#pragma once
// One function per command, each in a file of its own; each sets `exitCode` when its command was run.

namespace CLI {
class App;
}

namespace vignole::cli {

void addInspect(CLI::App& app, int& exitCode);
void addMeasure(CLI::App& app, int& exitCode);
void addExtract(CLI::App& app, int& exitCode);
void addRails(CLI::App& app, int& exitCode);
void addRecipes(CLI::App& app, int& exitCode);
void addSimulate(CLI::App& app, int& exitCode);
void addCalibrate(CLI::App& app, int& exitCode);
void addStudy(CLI::App& app, int& exitCode);
void addArchive(CLI::App& app, int& exitCode);
void addRecording(CLI::App& app, int& exitCode);
void addSite(CLI::App& app, int& exitCode);
void addBench(CLI::App& app, int& exitCode);

}  // namespace vignole::cli
