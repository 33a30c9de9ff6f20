#include "cli/commands.h"

namespace vignole::cli {

void addRecipes(CLI::App& /*app*/, int& /*exitCode*/) {}

}  // namespace vignole::cli
