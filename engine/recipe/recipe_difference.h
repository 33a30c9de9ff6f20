#pragma once
// What differs between two recipes, key by key as their files name them.

#include <string>
#include <vector>

#include "engine/recipe/recipe.h"

namespace vignole {

struct RecipeDifference {
  std::string key;            ///< "tolerance.WT", "stripe.sigma_px"
  std::string before, after;  ///< as in the file; empty: not there
};

/// In the order of the keys. Name, version and note are left out: they say which recipe it is, not what it does.
[[nodiscard]] std::vector<RecipeDifference> recipeDifferences(const Recipe& before, const Recipe& after);

}  // namespace vignole
