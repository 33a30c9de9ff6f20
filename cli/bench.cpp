#include "cli/commands.h"

namespace vignole::cli {

void addBench(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
