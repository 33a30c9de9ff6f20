#pragma once
// The settings of a recipe in words and as texts that people edit. Ranges and rules are the recipe's own
// (parseRecipe).

#include <QString>
#include <string>
#include <vector>

#include "engine/recipe/recipe.h"

namespace vignole {

struct RecipeSetting {
  std::string key;  ///< as in the file: "stripe.sigma_px"
  QString text;     ///< "2.2", "25 / 25" (left and right), "yes", "–" (none)
};

/// What a key of the file means: "Line: smoothing sigma, px"; an unknown key is shown as it is.
[[nodiscard]] QString settingWords(const std::string& key);
/// Of a value as the file has it: "-0.6 to +0.6" for limits, "25 / 25" for left and right.
[[nodiscard]] QString settingValue(const std::string& fileText);

/// All but tolerances, in the order of the file.
[[nodiscard]] std::vector<RecipeSetting> settingsOf(const Recipe& recipe);
/// False: the text is not of the setting's kind (a number, two numbers, yes or no); nothing is changed then.
[[nodiscard]] bool setSetting(Recipe& recipe, const std::string& key, const QString& text);

}  // namespace vignole
