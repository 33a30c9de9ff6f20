// vignole-cli recipes: list, show, check, make.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "engine/measurement/measurement.h"
#include "engine/recipe/recipe.h"

namespace vignole::cli {

namespace {

int listRecipes() {
  int code = kDone;
  std::printf("%-16s %-16s %-8s %-7s %s\n", "file", "name", "section", "class", "version");
  for (const std::string& file : recipeNames()) {
    const auto recipe = findRecipe(file);
    if (!recipe) {
      std::fflush(stdout);
      code = std::max(code, fail(recipe.error()));
      continue;
    }
    const std::string classes = recipe->profileClass + "/" + recipe->straightnessClass;
    std::printf("%-16s %-16s %-8s %-7s %d\n", file.c_str(), recipe->name.c_str(), recipe->section.name.c_str(),
                classes.c_str(), recipe->version);
  }
  return code;
}

void printDeviation(const std::optional<double>& limit) {
  if (limit)
    std::printf(" %10.3f", *limit);
  else
    std::printf(" %10s", "-");
}

int showRecipe(const std::string& nameOrFile) {
  const auto recipe = findRecipe(nameOrFile);
  if (!recipe) return fail(recipe.error());
  const auto nominals = nominalDimensions(recipe->section, recipe->parameters);
  if (!nominals) return fail(nominals.error());
  std::printf("%s   section %s   class %s/%s   version %d\n%s\n\n", recipe->name.c_str(), recipe->section.name.c_str(),
              recipe->profileClass.c_str(), recipe->straightnessClass.c_str(), recipe->version, recipe->note.c_str());
  std::printf("%-6s %-24s %12s %10s %10s\n", "dim", "title", "nominal_mm", "lower_mm", "upper_mm");
  for (const Dimension d : kDimensions) {
    std::printf("%-6s %-24s ", name(d).data(), title(d).data());
    if (const auto& nominal = nominals->at(index(d)))
      std::printf("%12.3f", *nominal);
    else
      std::printf("%12s", "undefined");
    printDeviation(recipe->limits.at(index(d)).lowerMm);
    printDeviation(recipe->limits.at(index(d)).upperMm);
    std::printf("\n");
  }
  std::printf("\nlimits are deviations from nominal; the whole recipe as a file: vignole-cli recipes new --out FILE\n");
  return kDone;
}

int checkRecipes(const std::vector<std::string>& files) {
  int code = kDone;
  for (const std::string& file : files) {
    const auto recipe = findRecipe(file);
    if (recipe) {
      std::printf("%s: good (%s)\n", file.c_str(), recipe->name.c_str());
      continue;
    }
    std::fflush(stdout);
    code = std::max(code, fail(recipe.error()));
  }
  return code;
}

}  // namespace

void addRecipes(CLI::App& app, int& exitCode) {
  CLI::App* recipes = app.add_subcommand("recipes", "What is measured and how: section, tolerances, settings");
  recipes->require_subcommand(1);
  recipes->footer("Example: vignole-cli recipes new --rail 60E1 --class X --straightness A --out 60E1.toml");

  struct Options {
    std::string name, rail, profileClass = "X", straightness = "A", out;
    std::vector<std::string> files;
  };
  const auto o = std::make_shared<Options>();

  CLI::App* list = recipes->add_subcommand("list", "Recipes that come with the program");
  list->footer("Example: vignole-cli recipes list");
  list->callback([&exitCode] { exitCode = listRecipes(); });

  CLI::App* show = recipes->add_subcommand("show", "Nominal dimensions and limits of a recipe");
  show->add_option("NAME", o->name, "A recipe, a recipe file, or a rail and its classes (\"60E1 X/A\")")->required();
  show->footer("Example: vignole-cli recipes show \"60E1 X/A\"");
  show->callback([o, &exitCode] { exitCode = showRecipe(o->name); });

  CLI::App* check = recipes->add_subcommand("check", "Read recipe files and say what is wrong with them");
  check->add_option("FILE", o->files, "Recipe files")->required();
  check->footer("Example: vignole-cli recipes check 60E1.toml 54E1.toml");
  check->callback([o, &exitCode] { exitCode = checkRecipes(o->files); });

  CLI::App* make = recipes->add_subcommand("new", "Write the recipe of a rail and its classes, to be edited");
  make->add_option("--rail", o->rail, "A name of the catalogue or a section file")->required();
  make->add_option("--class", o->profileClass, "Profile class: X, Y, IRS-T12 or AREMA")->capture_default_str();
  make->add_option("--straightness", o->straightness, "Straightness class: A or B; governs HF")->capture_default_str();
  make->add_option("--out", o->out, "Recipe file to write (- is stdout)")->required();
  make->footer("Example: vignole-cli recipes new --rail 60E1 --class X --straightness A --out 60E1.toml");
  make->callback([o, &exitCode] {
    const auto recipe = makeRecipe(o->rail, o->profileClass, o->straightness);
    if (!recipe) {
      exitCode = fail(recipe.error());
      return;
    }
    const auto written = writeResult(o->out, toToml(*recipe));
    exitCode = written ? kDone : fail(written.error());
  });
}

}  // namespace vignole::cli
