#include "cli/commands.h"

namespace vignole::cli {

void addMeasure(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
