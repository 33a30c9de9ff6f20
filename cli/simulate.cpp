#include "cli/simulate.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/commands.h"

namespace vignole::cli {

void addSimulate(CLI::App& app, int& exitCode) {
  CLI::App* simulate = app.add_subcommand("simulate", "Pictures of the virtual rig with their truth");
  simulate->require_subcommand(1);
  addSimulateRail(*simulate, exitCode);
  addSimulatePlate(*simulate, exitCode);
  addSimulateTarget(*simulate, exitCode);
  addSimulateCampaign(*simulate, exitCode);
  addSimulateServe(*simulate, exitCode);
}

}  // namespace vignole::cli
