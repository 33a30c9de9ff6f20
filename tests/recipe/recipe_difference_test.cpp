#include "engine/recipe/recipe_difference.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

TEST(RecipeDifference, NamesEveryKeyThatDiffersAndNoOther) {
  const Recipe a = *makeRecipe("60E1", "X", "A");
  EXPECT_TRUE(recipeDifferences(a, a).empty());
  Recipe b = a;
  b.name = "another name";
  b.version = 7;
  EXPECT_TRUE(recipeDifferences(a, b).empty()) << "which recipe it is, not what it does";
  b.limits[index(Dimension::WT)].upperMm = 0.75;
  b.stripe.sigma = 3.5;
  const auto different = recipeDifferences(a, b);
  ASSERT_EQ(different.size(), 2U);
  EXPECT_EQ(different[0].key, "stripe.sigma_px");
  EXPECT_EQ(different[0].after, "3.5");
  EXPECT_EQ(different[1].key, "tolerance.WT");
  EXPECT_NE(different[1].after.find("0.75"), std::string::npos) << different[1].after;
}

TEST(RecipeDifference, AClassChangesItsLimits) {
  EXPECT_GE(recipeDifferences(*makeRecipe("60E1", "X", "A"), *makeRecipe("60E1", "Y", "A")).size(), 3U);
}

TEST(ParseRecipe, ReadsWhatToTomlWrites) {
  const Recipe a = *makeRecipe("54E3", "Y", "B");
  const auto b = parseRecipe(toToml(a), "a text");
  ASSERT_TRUE(b) << b.error().message();
  EXPECT_TRUE(recipeDifferences(a, *b).empty());
  const auto bad = parseRecipe("format = 1\nsection = \"60E1\"\nsurprise = 2\n", "a text");
  ASSERT_FALSE(bad);
  EXPECT_NE(bad.error().message().find("surprise"), std::string::npos);
}

}  // namespace
}  // namespace vignole
