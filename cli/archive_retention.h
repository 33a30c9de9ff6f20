#pragma once
// vignole-cli archive prune, hold: how long rails stay.

namespace CLI {
class App;
}

namespace vignole::cli {

void addRetention(CLI::App& archive, int& exitCode);

}  // namespace vignole::cli
