#include "cli/commands.h"

namespace vignole::cli {

void addInspect(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
