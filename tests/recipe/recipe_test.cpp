#include "engine/recipe/recipe.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

namespace fs = std::filesystem;

class RecipeFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("vignole_recipe_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  Expected<Recipe> load(const std::string& text) {
    EXPECT_TRUE(writeFile(folder_ / "r.toml", text));
    return loadRecipe(folder_ / "r.toml");
  }
  std::string refusal(const std::string& text) {
    const auto recipe = load(text);
    return recipe ? "accepted" : recipe.error().message();
  }
  void expectRefused(const std::string& text, const std::vector<std::string>& wanted) {
    const std::string message = refusal("format = 1\nsection = '60E1'\n" + text);
    for (const std::string& w : wanted) EXPECT_NE(message.find(w), std::string::npos) << message << " / " << w;
  }
  fs::path folder_;
};

void expectSame(const Recipe& a, const Recipe& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.version, b.version);
  EXPECT_EQ(a.note, b.note);
  EXPECT_EQ(a.section.name, b.section.name);
  EXPECT_EQ(a.sectionSource, b.sectionSource);
  EXPECT_EQ(a.profileClass, b.profileClass);
  EXPECT_EQ(a.straightnessClass, b.straightnessClass);
  for (const Dimension d : kDimensions) {
    EXPECT_EQ(a.limits.at(index(d)).lowerMm, b.limits.at(index(d)).lowerMm) << name(d);
    EXPECT_EQ(a.limits.at(index(d)).upperMm, b.limits.at(index(d)).upperMm) << name(d);
  }
  EXPECT_EQ(a.parameters.rfhFromAxisMm.left, b.parameters.rfhFromAxisMm.left);
  EXPECT_EQ(a.parameters.rfhFromAxisMm.right, b.parameters.rfhFromAxisMm.right);
  EXPECT_EQ(a.parameters.hwDepthMm, b.parameters.hwDepthMm);
  EXPECT_EQ(a.parameters.wtHeightMm, b.parameters.wtHeightMm);
  EXPECT_EQ(a.stripe.sigma, b.stripe.sigma);
  EXPECT_EQ(a.stripe.low, b.stripe.low);
  EXPECT_EQ(a.stripe.high, b.stripe.high);
  EXPECT_EQ(a.stripe.minLength, b.stripe.minLength);
  EXPECT_EQ(a.registration.inlierMm, b.registration.inlierMm);
  EXPECT_EQ(a.measurement.trimMm, b.measurement.trimMm);
  EXPECT_EQ(a.measurement.minPoints, b.measurement.minPoints);
  EXPECT_EQ(a.measurement.expansionPerK, b.measurement.expansionPerK);
}

TEST_F(RecipeFile, RoundTripKeepsEveryValue) {
  Recipe recipe = *makeRecipe("54E1", "Y", "B");
  recipe.name = "a \"name\" with \\ and\nlines";
  recipe.version = 7;
  recipe.note = "ü";
  recipe.parameters.hwDepthMm = 0.1 + 14;
  recipe.parameters.wtHeightMm = 76.2;
  recipe.parameters.rfhFromAxisMm = {24.5, 26};
  recipe.stripe.sigma = 2.7;
  recipe.stripe.minLength = 25;
  recipe.registration.inlierMm = 1.0 / 7;
  recipe.measurement.trimMm = 1.25;
  recipe.measurement.minPoints = 9;
  recipe.limits.at(index(Dimension::RH)) = {-0.123, std::nullopt};
  recipe.limits.at(index(Dimension::FW)) = {};
  const auto again = load(toToml(recipe));
  ASSERT_TRUE(again) << again.error().message();
  expectSame(*again, recipe);
}

TEST_F(RecipeFile, EveryCatalogueSectionMakesARecipe) {
  for (const std::string& section : catalogueNames()) {
    const auto recipe = makeRecipe(section);
    ASSERT_TRUE(recipe) << section << ": " << recipe.error().message();
    const auto again = load(toToml(*recipe));
    ASSERT_TRUE(again) << section << ": " << again.error().message();
    expectSame(*again, *recipe);
  }
}

TEST_F(RecipeFile, ShippedRecipesAreGoodAndTheExampleIsTheDefault) {
  for (const std::string& recipe : recipeNames()) EXPECT_TRUE(findRecipe(recipe)) << recipe;
  const auto example = findRecipe("60E1_XA");
  ASSERT_TRUE(example) << example.error().message();
  expectSame(*example, *makeRecipe("60E1", "X", "A"));
}

TEST_F(RecipeFile, WhatTheShippedExampleShowsAsDefaultsAreTheDefaults) {
  // Taking the # away must change nothing: the comments may not go stale.
  const auto text = readFile(resourceDirectory() / "recipes" / "60E1_XA.toml");
  ASSERT_TRUE(text);
  std::string uncommented;
  for (std::size_t at = 0, end = 0; at < text->size(); at = end + 1) {
    end = std::min(text->find('\n', at), text->size());
    const std::string line = text->substr(at, end - at);
    const bool setting = line.starts_with("# ") && line.find(" = ") != std::string::npos &&
                         line.find("= ?") == std::string::npos && line.find(' ', 2) == line.find(" = ");
    uncommented += (setting ? line.substr(2) : line) + "\n";
  }
  ASSERT_NE(uncommented.find("\nsigma_px"), std::string::npos);
  const auto recipe = load(uncommented);
  ASSERT_TRUE(recipe) << recipe.error().message();
  expectSame(*recipe, *makeRecipe("60E1", "X", "A"));
}

TEST_F(RecipeFile, LeavesOutWhatItLikes) {
  const auto recipe =
      load("format = 1\nsection = '60E1'\n[stripe]\nsigma_px = 4\n[tolerance.RH]\nlower_mm = -0.2\nupper_mm = 0.3\n");
  ASSERT_TRUE(recipe) << recipe.error().message();
  EXPECT_EQ(recipe->name, "60E1 X/A");
  EXPECT_EQ(recipe->stripe.sigma, 4);
  EXPECT_EQ(recipe->limits.at(index(Dimension::RH)).lowerMm, -0.2);
  EXPECT_EQ(recipe->limits.at(index(Dimension::RH)).upperMm, 0.3);
  EXPECT_EQ(recipe->limits.at(index(Dimension::HW)).upperMm, 0.5) << "the rest is the class's";
}

TEST_F(RecipeFile, RefusalsNameFileLineKeyAndRemedy) {
  const std::string file = (folder_ / "r.toml").string();
  expectRefused("[stripe]\nsigma_px = 400\n", {file + ":4:", "stripe.sigma_px", "400", "give a number from 1 to 8"});
  expectRefused("[stripe]\nsigna_px = 3\n", {file + ":4:", "stripe.signa_px", "did you mean stripe.sigma_px"});
  expectRefused("[strip]\nsigma_px = 3\n", {"strip", "not known"});
  expectRefused("[stripe]\nt_l_dn = 20\nt_h_dn = 10\n", {file + ":4:", "t_l_dn", "exchange"});
  expectRefused("[tolerance.RH]\nlower_mm = 0.5\nupper_mm = -0.5\n",
                {file + ":4:", "tolerance.RH.lower_mm", "exchange"});
  expectRefused("[tolerance.RH]\nlower_mm = 'a'\n", {file + ":4:", "is text"});
  expectRefused("[tolerance.RH]\nlower_mm = nan\n", {file + ":4:", "nan"});
  expectRefused("[tolerance.RH]\n", {"no limit"});
  expectRefused("[tolerance.RX]\nlower_mm = 1\n", {"RX", "RH, RFH"});
  expectRefused("[tolerance.RH]\njudged = false\nupper_mm = 1\n", {"judged"});
  expectRefused("[parameters]\nrfh_from_axis_mm = [25]\n", {"rfh_from_axis_mm", "list of 2"});
  expectRefused("[parameters]\nrfh_from_axis_mm = [25, -3]\n", {"rfh_from_axis_mm", "outside 1 to 100"});
  expectRefused("[measurement]\nmin_points = 2.5\n", {"min_points", "whole number"});
  expectRefused("profile_class = 'Z'\n", {file + ":3:", "profile_class", "there are AREMA, IRS-T12, X, Y"});
  expectRefused("straightness_class = 'Z'\n", {"straightness_class", "there are A, B"});
  expectRefused("version = 0\n", {"version"});
  EXPECT_NE(refusal("format = 1\nsection = '61E9'\n").find("61E9"), std::string::npos);
  EXPECT_NE(refusal("format = 1\n").find("section"), std::string::npos);
  EXPECT_NE(refusal("section = '60E1'\n").find("format"), std::string::npos);
  EXPECT_NE(refusal("format = 1\nsection = \n").find("r.toml:2:"), std::string::npos);
}

TEST_F(RecipeFile, RefusesParametersThatFallOffTheirPrimitive) {
  expectRefused("[parameters]\nrfh_from_axis_mm = [25, 60]\n", {"RFH", "60E1"});
  expectRefused("[parameters]\nhw_depth_mm = 60\n", {"HW"});
}

TEST_F(RecipeFile, SectionFileBesideTheRecipe) {
  Section mine = *findSection("60E2");
  mine.name = "MINE";
  ASSERT_TRUE(writeFile(folder_ / "mine.json", toJson(mine)));
  const auto recipe = load("format = 1\nsection = 'mine.json'\n");
  ASSERT_TRUE(recipe) << recipe.error().message();
  EXPECT_EQ(recipe->name, "MINE X/A");
  EXPECT_EQ(recipe->sectionSource, (folder_ / "mine.json").string());
  const auto again = load(toToml(*recipe));
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->section.name, "MINE");
  EXPECT_EQ(findRecipe((folder_ / "mine.json").string())->section.name, "MINE");
}

TEST_F(RecipeFile, FoundByFileNameOrSectionAndClasses) {
  EXPECT_EQ(findRecipe("60e1")->name, "60E1 X/A");
  EXPECT_EQ(findRecipe("54E3 Y/B")->name, "54E3 Y/B");
  EXPECT_EQ(findRecipe("54E3 Y/B")->limits.at(index(Dimension::HF)).lowerMm, -0.6);
  ASSERT_TRUE(load(toToml(*makeRecipe("49E1"))));
  EXPECT_EQ(findRecipe((folder_ / "r.toml").string())->section.name, "49E1");
  EXPECT_FALSE(findRecipe("60E1 Z/A"));
  EXPECT_FALSE(findRecipe("none.toml"));
  const auto missing = findRecipe("nothing");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find("60E1_XA"), std::string::npos) << missing.error().message();
}

}  // namespace
}  // namespace vignole
