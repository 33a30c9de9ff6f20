#include "cli/commands.h"

namespace vignole::cli {

void addSimulate(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
