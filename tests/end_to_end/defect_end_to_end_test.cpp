// A defect of a rendered rail shows in its own dimension and leaves the others alone: registration must not carry it
// into them.

#include <cctype>
#include <gtest/gtest.h>
#include <map>

#include "tests/end_to_end/virtual_rail.h"

namespace vignole {
namespace {

using namespace vignole::testing;

constexpr int kProfiles = 60;

using MeanMm = PerDimension<double>;

/// Mean over a short rail that is as it should be but for `deviations`. The same seed: rig, poses and noise are those
/// of every other such rail.
MeanMm meanOfRail(const std::vector<std::string>& deviations) {
  const Recipe recipe = findRecipe("60E1 X/A").value();
  VirtualRigSettings settings;
  settings.section = recipe.section;
  settings.parameters = recipe.parameters;
  settings.seed = 31;
  settings.varyDimensions = false;
  EXPECT_TRUE(applyWords(settings, {}, deviations, {}));
  const std::shared_ptr<const VirtualRig> rig = VirtualRig::create(std::move(settings)).value();
  VirtualSourceSettings source;
  source.lengthMm = kProfiles * 15;
  const InspectedRun run = inspect(rig, recipe, source);
  EXPECT_EQ(run.profiles.size(), static_cast<std::size_t>(kProfiles));
  MeanMm mean{};
  for (const InspectedProfile& p : run.profiles)
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      EXPECT_TRUE(p.valueMm[d]) << name(kDimensions[d]);
      mean[d] += p.valueMm[d].value_or(0) / kProfiles;
    }
  return mean;
}

/// What must change, and by how much; everything else must not.
struct Defect {
  const char* word;
  std::map<Dimension, double> changesMm;
};

class RenderedDefect : public ::testing::TestWithParam<Defect> {
 protected:
  static void SetUpTestSuite() { sound_ = meanOfRail({}); }
  static MeanMm sound_;
};
MeanMm RenderedDefect::sound_{};

TEST_P(RenderedDefect, LeavesTheOtherDimensionsAlone) {
  const MeanMm found = meanOfRail({GetParam().word});
  for (const Dimension d : kDimensions) {
    const auto change = GetParam().changesMm.find(d);
    const double expected = change == GetParam().changesMm.end() ? 0 : change->second;
    // HR: 2 micrometres in the sagitta of its arc.
    EXPECT_NEAR(found[index(d)] - sound_[index(d)], expected, d == Dimension::HR ? 3 : 0.005) << name(d);
  }
}

INSTANTIATE_TEST_SUITE_P(
    DefectEndToEnd, RenderedDefect,
    ::testing::Values(Defect{"RH=1", {{Dimension::RH, 1}}}, Defect{"RH=-2", {{Dimension::RH, -2}}},
                      Defect{"FW=1", {{Dimension::FW, 1}, {Dimension::RASl, 0.5}, {Dimension::RASr, 0.5}}},
                      Defect{"RFH=0.6", {{Dimension::RFH, 0.6}}},
                      Defect{"HW=0.6",
                             {{Dimension::HW, 0.6},
                              {Dimension::HWA, 0.604},  // the sides lean 1 in 20, and a wider head leans a little more
                              {Dimension::RASl, -0.3},
                              {Dimension::RASr, -0.3}}}),
    [](const auto& defect) {
      std::string word = defect.param.word;
      for (char& c : word)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
      return word;
    });

}  // namespace
}  // namespace vignole
