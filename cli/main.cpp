// vignole-cli: the headless face of the engine, for scripts, servers and acceptance tests.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/commands.h"
#include "cli/console.h"

int main(int argc, char** argv) {
  CLI::App app{"Vignole measures rail profiles. Every command has --help with an example."};
  app.set_version_flag("--version", "vignole-cli " VIGNOLE_VERSION);
  app.require_subcommand(1);
  int exitCode = vignole::cli::kDone;
  vignole::cli::addInspect(app, exitCode);
  vignole::cli::addMeasure(app, exitCode);
  vignole::cli::addExtract(app, exitCode);
  vignole::cli::addRails(app, exitCode);
  vignole::cli::addRecipes(app, exitCode);
  vignole::cli::addSimulate(app, exitCode);
  vignole::cli::addCalibrate(app, exitCode);
  vignole::cli::addStudy(app, exitCode);
  vignole::cli::addArchive(app, exitCode);
  vignole::cli::addRecording(app, exitCode);
  vignole::cli::addSite(app, exitCode);
  vignole::cli::addBench(app, exitCode);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {  // --help, --version
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    return vignole::cli::fail({"command line", std::string(e.what()) + " (see --help)"});
  } catch (const std::exception& e) {  // ours: no exception leaves the engine
    return vignole::cli::fail({"vignole-cli", e.what(), vignole::ErrorKind::World});
  }
  return exitCode;
}
