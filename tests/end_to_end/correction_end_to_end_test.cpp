// What the corrections of the extraction and of the translation are worth in millimetres of a rail.

#include <gtest/gtest.h>

#include "tests/end_to_end/virtual_rail.h"

namespace vignole {
namespace {

using namespace vignole::testing;

constexpr int kProfiles = 150;

class Corrections : public ::testing::Test {
 protected:
  void SetUp() override {
    VirtualRigSettings settings;
    settings.section = recipe.section;
    settings.parameters = recipe.parameters;
    settings.seed = 12;
    ASSERT_TRUE(applyWords(settings, {"speckle=off"}, {}, {}));
    rig = VirtualRig::create(std::move(settings)).value();
  }
  /// Mean error of single profiles.
  PerDimension<double> bias(const Recipe& with, const RigCalibration& calibration) const {
    VirtualSourceSettings source;
    source.lengthMm = kProfiles * 15;
    PerDimension<double> sum{};
    const InspectedRun run = inspect(rig, with, source, {}, calibration);
    EXPECT_EQ(run.profiles.size(), static_cast<std::size_t>(kProfiles));
    for (const InspectedProfile& p : run.profiles) {
      const Truth truth = rig->truth(p.trigger);
      for (std::size_t d = 0; d < kDimensionCount; ++d) {
        EXPECT_TRUE(p.valueMm[d]);
        sum[d] += (p.valueMm[d].value_or(0) - truth.valueMm[d]) / kProfiles;
      }
    }
    return sum;
  }
  static double at(const PerDimension<double>& bias, Dimension d) { return std::abs(bias[index(d)]); }

  Recipe recipe = findRecipe("60E1 X/A").value();
  std::shared_ptr<const VirtualRig> rig;
};

TEST_F(Corrections, LowerTheBiasOfTheCrownAndOfTheCorners) {
  Recipe plain = recipe;
  plain.stripe.correction = false;
  const auto off = bias(plain, rig->calibration()), on = bias(recipe, rig->calibration());
  EXPECT_GT(at(off, Dimension::HR), 1.5);
  EXPECT_LT(at(on, Dimension::HR), 1);
  EXPECT_GT(at(off, Dimension::HW), 0.003);
  EXPECT_LT(at(on, Dimension::HW), 0.002);
  EXPECT_LT(at(on, Dimension::RASl) + at(on, Dimension::RASr),
            0.5 * (at(off, Dimension::RASl) + at(off, Dimension::RASr)));
}

TEST_F(Corrections, TheThicknessOfTheLightIsTakenIntoAccount) {
  RigCalibration thin = rig->calibration();
  for (RangeFinderCalibration& finder : thin.rangeFinders) finder.lightPlane.thicknessMm = 0;
  const auto ignored = bias(recipe, thin), known = bias(recipe, rig->calibration());
  EXPECT_GT(at(ignored, Dimension::HW), 2 * at(known, Dimension::HW));
  EXPECT_GT(at(ignored, Dimension::HR), at(known, Dimension::HR));
}

}  // namespace
}  // namespace vignole
