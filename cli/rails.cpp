#include "cli/commands.h"

namespace vignole::cli {

void addRails(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
