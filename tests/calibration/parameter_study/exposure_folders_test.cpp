#include "calibration/parameter_study/exposure_folders.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vignole {
namespace {

namespace fs = std::filesystem;

class ExposureFolders : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "vignole-study-XXXXXX").string();
    top_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(top_); }
  void touch(const std::string& file) const {
    fs::create_directories((top_ / file).parent_path());
    std::ofstream(top_ / file) << "x";
  }
  fs::path top_;
};

TEST(ExposureOfAPath, IsTheInnermostFoldersName) {
  EXPECT_EQ(exposureMsOf("a/exposure5ms/placement1"), 5.0);
  EXPECT_EQ(exposureMsOf("exposure5ms/b/exposure7.5ms/camera1.png"), 7.5);
  for (const char* none : {"a/placement1", "exposurems", "exposure-3ms", "exposure0ms", "exposure5", "myexposure5ms"})
    EXPECT_EQ(exposureMsOf(none), std::nullopt) << none;
  EXPECT_EQ(exposureFolder(7.5), "exposure7.5ms");
  EXPECT_EQ(exposureFolder(15), "exposure15ms");
}

TEST_F(ExposureFolders, PlacementsAreFoundFromTheTopAndInOrder) {
  for (const char* exposure : {"exposure15ms", "exposure5ms"})
    for (const char* placement : {"placement10", "placement2"})
      touch(std::string(exposure) + "/" + placement + "/camera1.png");
  const auto found = findPlacements({top_});
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_EQ(found->size(), 4U);
  EXPECT_EQ((*found)[0].exposureMs, 5.0);
  EXPECT_EQ((*found)[0].folder.filename(), "placement2");
  EXPECT_EQ((*found)[1].folder.filename(), "placement10");
  EXPECT_EQ((*found)[2].exposureMs, 15.0);
  EXPECT_EQ((*found)[0].place, (*found)[2].place) << "the same placement at two exposures";

  const auto named = findPlacements({top_ / "exposure5ms" / "placement2"});
  ASSERT_TRUE(named);
  EXPECT_EQ(named->front().exposureMs, 5.0);
}

TEST_F(ExposureFolders, PlacementsMayTellNoExposure) {
  touch("placement1/camera1.png");
  const auto found = findPlacements({top_});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->front().exposureMs, std::nullopt);
}

TEST_F(ExposureFolders, AFolderWithoutPlacementsIsRefused) {
  const auto none = findPlacements({top_});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message(), testing::HasSubstr("camera1.png"));
  EXPECT_FALSE(findPlacements({top_ / "nothing"}));
  touch("placement1/camera1.png");
  EXPECT_THAT(findPlacements({top_, top_ / "placement1"}).error().message(), testing::HasSubstr("given twice"));
}

TEST_F(ExposureFolders, PicturesKnowTheirCameraAndScene) {
  touch("exposure5ms/frame3/camera2.png");
  touch("exposure10ms/frame3/camera2.PNG");
  touch("exposure10ms/frame3/truth.json");
  touch("exposure10ms/camera4_00012.png");
  const auto found = findExposedPictures({top_});
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_EQ(found->size(), 3U);
  EXPECT_EQ((*found)[0].exposureMs, 5);
  EXPECT_EQ((*found)[0].camera, 1);
  EXPECT_EQ((*found)[1].camera, 3);
  EXPECT_EQ((*found)[2].camera, 1);
  EXPECT_EQ((*found)[2].exposureMs, 10);

  touch("exposure10ms/other.png");
  EXPECT_THAT(findExposedPictures({top_}).error().message(), testing::HasSubstr("camera1 to camera4"));
  touch("plain/camera1.png");
  EXPECT_THAT(findExposedPictures({top_ / "plain"}).error().message(), testing::HasSubstr("exposure<NUMBER>ms"));
}

TEST_F(ExposureFolders, TheSameSceneAtTwoExposuresIsOneScene) {
  touch("exposure5ms/frame3/camera2.png");
  touch("exposure10ms/frame3/camera2.png");
  touch("exposure10ms/frame3/camera1.png");
  const auto found = findExposedPictures({top_});
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0].scene, (*found)[1].scene);
  EXPECT_EQ((*found)[0].scene, (*found)[2].scene);
}

}  // namespace
}  // namespace vignole
