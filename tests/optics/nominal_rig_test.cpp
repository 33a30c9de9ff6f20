// The drawing of the rig: where the design says that its cameras stand, and what they look at.

#include "engine/optics/nominal_rig.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "engine/optics/camera_model.h"

namespace vignole {
namespace {

TEST(NominalRig, CamerasStandWhereTheDesignSays) {
  // Optics design, section 2, rig C: positions of cameras 2 and 3; 1 and 4 mirror them.
  const std::array<Point3, kCameraCount> expected = {Point3(-257, 295, 257), Point3(257, 295, 257),
                                                     Point3(271, -118, 257), Point3(-271, -118, 257)};
  for (std::size_t i = 0; i < kCameraCount; ++i)
    EXPECT_LT((cameraCentre(nominalRig().rangeFinders[i].cameraFromWorld) - expected[i]).norm(), 1) << i;
}

TEST(NominalRig, EachCameraSeesItsAimInTheMiddleOfItsPicture) {
  for (std::size_t i = 0; i < kCameraCount; ++i) {
    const RangeFinderCalibration& finder = nominalRig().rangeFinders[i];
    const Extrinsics& pose = finder.cameraFromWorld;
    EXPECT_LT((pose.rotation * pose.rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-12);
    const Point2 aim = nominalStations()[i].aim;
    const Eigen::Vector2d px =
        project<double>(lens(finder.intrinsics), pose.rotation, pose.translationMm, Point3(aim.x(), aim.y(), 0));
    EXPECT_LT((px - Eigen::Vector2d(699.5, 511.5)).norm(), 1e-9) << i;
  }
}

}  // namespace
}  // namespace vignole
