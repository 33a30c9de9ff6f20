#include "gui/main_window/options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "engine/recipe/recipe.h"
#include "gui/languages/languages.h"

namespace vignole {

namespace {

struct RawOptions {
  std::string page = "monitor", theme = "light", size = "1920x1080", recipe = "60E1";
  std::vector<std::string> effects, faults, deviations;
};

Expected<QSize> parseSize(const std::string& text) {
  const QStringList parts = QString::fromStdString(text).split('x');
  bool okWidth = false, okHeight = false;
  const int width = parts.value(0).toInt(&okWidth), height = parts.value(1).toInt(&okHeight);
  if (parts.size() != 2 || !okWidth || !okHeight || width < 1280 || height < 720 || width > 15360 || height > 8640)
    return inputError("--size", "\"" + text + "\" is not WIDTHxHEIGHT from 1280x720 to 15360x8640, as in 1920x1080");
  return QSize(width, height);
}

Expected<void> fillLine(VirtualLineSettings& line, const RawOptions& raw) {
  auto recipe = findRecipe(raw.recipe);
  if (!recipe) return tl::unexpected(recipe.error());
  line.recipe = *std::move(recipe);
  line.rig.section = line.recipe.section;
  line.rig.parameters = line.recipe.parameters;
  return applyWords(line.rig, raw.effects, raw.deviations, raw.faults);
}

Expected<void> finish(Options& options, const RawOptions& raw) {
  bool found = false;
  for (int i = 0; i < kPageCount; ++i)
    if (raw.page == pageName(static_cast<PageId>(i)).option) {
      options.page = static_cast<PageId>(i);
      found = true;
    }
  if (!found) return inputError("--page", "there is no page \"" + raw.page + "\" (see --help)");
  if (raw.theme != "light" && raw.theme != "dark")
    return inputError("--theme", "\"" + raw.theme + "\" is neither light nor dark");
  options.dark = raw.theme == "dark";
  if (!options.language.empty() &&
      std::none_of(Languages::all().begin(), Languages::all().end(),
                   [&](const Language& l) { return l.code.toStdString() == options.language; }))
    return inputError("--language", "\"" + options.language + "\" is none of en, es, de, fr, pl, zh");
  if (!options.chosenDimension.empty() && !dimensionFromName(options.chosenDimension))
    return inputError("--choose", "no dimension \"" + options.chosenDimension + "\"");
  const auto size = parseSize(raw.size);
  if (!size) return tl::unexpected(size.error());
  options.size = *size;
  return fillLine(options.line, raw);
}

}  // namespace

OptionsOutcome readOptions(int argc, const char* const* argv, const std::string& version) {
  CLI::App app{
      "The HMI of Vignole on the virtual rig.\n"
      "Example: vignole --theme dark --deviation WT=1.03"};
  app.set_version_flag("--version", "vignole " + version);
  RawOptions raw;
  Options options;
  VirtualRigSettings& rig = options.line.rig;
  double lengthM = options.line.railLengthMm / 1000, speedMPerS = rig.speedMmPerS / 1000;
  std::uint64_t rigSeed = 0;
  app.add_option("--page", raw.page,
                 "monitor, stripes, charts, rails, calibration, recipes, quality, alarms, diagnostics or settings");
  app.add_option("--archive", options.archive, "FILE or URL of the archive (default: in the user's own data)");
  app.add_option("--theme", raw.theme, "light or dark");
  app.add_option("--language", options.language, "en, es, de, fr, pl or zh (default: as chosen before)");
  app.add_option("--recipe", raw.recipe, "name or file of the recipe (default 60E1)");
  app.add_option("--seed", rig.seed, "of the virtual rail (default 1)");
  auto* rigSeedOption = app.add_option("--rig-seed", rigSeed, "of the virtual rig (default: the seed)");
  app.add_option("--length", lengthM, "of a virtual rail in m (default 60)")->check(CLI::Range(0.1, 1000.0));
  app.add_option("--speed", speedMPerS, "of the virtual rail in m/s (default 1)")->check(CLI::Range(0.001, 20.0));
  app.add_option("--spacing", rig.spacingMm, "of the profiles in mm (default 15)")->check(CLI::Range(0.1, 10000.0));
  app.add_option("--effect", raw.effects, "NAME=on|off|VALUE, an effect of the virtual rig; may be repeated");
  app.add_option("--fault", raw.faults, "KIND[=VALUE][@CAMERA][:FROM-TO]; may be repeated");
  app.add_option("--deviation", raw.deviations, "DIM=MM from nominal; may be repeated");
  app.add_option("--screenshot", options.screenshot, "render the page offscreen into this PNG and leave");
  app.add_option("--screens", options.screens,
                 "render every page offscreen, both themes, 1366x768 and 1920x1080, into this folder and leave");
  app.add_option("--size", raw.size, "of the window, WIDTHxHEIGHT (default 1920x1080)");
  app.add_option("--after", options.afterS, "seconds before the (first) screenshot (default 5)")
      ->check(CLI::Range(0.0, 86400.0));
  app.add_flag("--tour", options.tour, "show the tour, even with --screenshot");
  app.add_option("--choose", options.chosenDimension, "dimension whose row is chosen at the start");
  app.add_option("--switch-pages", options.switchPagesS, "show the next page every SECONDS: with --self-test")
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--self-test", options.selfTestS, "run SECONDS, print one JSON document and leave")
      ->check(CLI::Range(0.1, 86400.0));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& e) {
    return {{}, std::string(e.what()) + "\n", 0};
  } catch (const CLI::Success&) {
    return {{}, app.help(), 0};
  } catch (const CLI::ParseError& e) {
    return {{}, "vignole: command line: " + std::string(e.what()) + " (see --help)\n", 2};
  }
  options.line.railLengthMm = lengthM * 1000;
  rig.speedMmPerS = speedMPerS * 1000;
  if (rigSeedOption->count() > 0) rig.rigSeed = rigSeed;
  if (auto done = finish(options, raw); !done) return {{}, "vignole: " + done.error().message() + "\n", 2};
  return {std::move(options), {}, 0};
}

}  // namespace vignole
