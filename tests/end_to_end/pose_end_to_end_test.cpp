// Is the pose as sure as it says? On rendered frames, whose points share their errors along the line.

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/end_to_end/virtual_rail.h"

namespace vignole {
namespace {

using namespace vignole::testing;

TEST(PoseEndToEnd, ErrorsOnRenderedFramesAreWhatTheCovarianceSays) {
  constexpr int kProfiles = 300;
  const Recipe recipe = findRecipe("60E1 X/A").value();
  double squares = 0;
  for (const char* speckle : {"speckle=on", "speckle=off"}) {
    VirtualRigSettings settings;
    settings.section = recipe.section;
    settings.parameters = recipe.parameters;
    settings.seed = 23;
    settings.varyDimensions = false;  // the pose of a rail that is another shape than the section is no one's
    settings.temperatureC = 15;
    ASSERT_TRUE(applyWords(settings, {speckle}, {}, {}));
    const std::shared_ptr<const VirtualRig> rig = VirtualRig::create(std::move(settings)).value();
    VirtualSourceSettings source;
    source.lengthMm = kProfiles * 15;
    const InspectedRun run = inspect(rig, recipe, source);
    ASSERT_EQ(run.profiles.size(), static_cast<std::size_t>(kProfiles));
    squares = 0;
    for (const InspectedProfile& p : run.profiles) {
      const Transform2 truth = rig->truth(p.trigger).worldFromSection;
      const Point2 middle(0, recipe.section.heightMm() / 2);
      const Point2 moved = p.worldFromSection * middle - truth * middle;
      const double turned = std::remainder(p.worldFromSection.angleRad - truth.angleRad, 2 * std::numbers::pi);
      const Eigen::Vector3d error(moved.x(), moved.y(), turned);
      squares += error.dot(p.poseCovariance.inverse() * error) / 3 / kProfiles;
    }
    // Within 15 % in u.
    EXPECT_GT(squares, 0.72) << speckle;
    EXPECT_LT(squares, 1.38) << speckle;
  }
}

}  // namespace
}  // namespace vignole
