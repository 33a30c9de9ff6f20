#pragma once
// The subcommands of `simulate`, one file each.

namespace CLI {
class App;
}

namespace vignole::cli {

void addSimulateRail(CLI::App& simulate, int& exitCode);
void addSimulatePlate(CLI::App& simulate, int& exitCode);
void addSimulateTarget(CLI::App& simulate, int& exitCode);
void addSimulateCampaign(CLI::App& simulate, int& exitCode);
void addSimulateServe(CLI::App& simulate, int& exitCode);

}  // namespace vignole::cli
