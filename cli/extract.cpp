#include "cli/commands.h"

namespace vignole::cli {

void addExtract(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
