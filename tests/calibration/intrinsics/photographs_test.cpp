// Photographs that others took: nobody knows their truth, but another program's answer, and OpenCV's to the same
// points.

#include <filesystem>
#include <gtest/gtest.h>

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "engine/acquisition/picture_file.h"

namespace vignole {
namespace {

const std::filesystem::path kPhotographs = std::filesystem::path(VIGNOLE_SHARED_DATA) / "calibration";

std::vector<TargetView> viewsIn(const std::string& folder, const PlanarTarget& target) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kPhotographs / folder))
    if (entry.path().extension() == ".jpg") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<TargetView> views;
  for (const auto& file : files) {
    const auto picture = readPicture(file, Channel::Grey);
    EXPECT_TRUE(picture.has_value()) << file;
    if (!picture) continue;
    views.push_back(findTarget(picture->view(), target));
    views.back().file = file.filename().string();
  }
  return views;
}

class Photographs : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kPhotographs)) GTEST_SKIP() << "no shared data beside the checkout";
  }
  static IntrinsicsCalibration calibrated(const std::string& folder, const std::string& words) {
    const PlanarTarget target = *parseTarget(words);
    const auto c = calibrateIntrinsics(viewsIn(folder, target), target);
    EXPECT_TRUE(c.has_value());
    return c ? *c : IntrinsicsCalibration{};
  }
};

TEST_F(Photographs, ChessboardAgreesWithAnotherProgramAndWithOpenCv) {
  const IntrinsicsCalibration c = calibrated("chessboard_sony", "chessboard:4x6:30");
  EXPECT_TRUE(c.accepted());
  const Intrinsics& in = c.camera.intrinsics;
  EXPECT_NEAR(in.focalMm / in.pixelWidthMm, 701.01, 7.01);
  EXPECT_NEAR(in.focalMm / in.pixelHeightMm, 698.65, 6.99);
  ASSERT_TRUE(c.openCv);
  EXPECT_NEAR(c.camera.rmsPx, c.openCv->rmsPx, 0.01);
  EXPECT_NEAR(in.focalMm / in.pixelWidthMm, c.openCv->fxPx, 0.01 * c.openCv->fxPx);
  std::printf("chessboard_sony: %s, %.4f px RMS, OpenCV %.4f; f %.2f px, OpenCV %.2f\n", name(c.variant).c_str(),
              c.camera.rmsPx, c.openCv->rmsPx, in.focalMm / in.pixelWidthMm, c.openCv->fxPx);
}

TEST_F(Photographs, CirclesOnABentBoard) {
  const IntrinsicsCalibration c = calibrated("circles_sony", "circles:10x8:25:15");
  EXPECT_TRUE(c.accepted());
  EXPECT_GT(c.targetBendMm, 0) << "0.2 px are left if it is taken as flat";
  EXPECT_LT(c.camera.rmsPx, 0.08);
  ASSERT_TRUE(c.openCv);
  EXPECT_NEAR(c.camera.rmsPx, c.openCv->rmsPx, 0.01);
  std::printf("circles_sony: %s, %.4f px RMS, OpenCV %.4f; board bent by %.2f mm\n", name(c.variant).c_str(),
              c.camera.rmsPx, c.openCv->rmsPx, c.targetBendMm);
}

TEST_F(Photographs, ChessboardUnderALaserHasPixelsThatAreNotSquare) {
  const IntrinsicsCalibration c = calibrated("laser_chessboard", "chessboard:8x6:40");
  EXPECT_TRUE(c.accepted());
  EXPECT_TRUE(c.variant.aspect) << name(c.variant);
  EXPECT_LT(c.camera.rmsPx, 0.1);
}

}  // namespace
}  // namespace vignole
