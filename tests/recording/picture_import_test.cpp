#include "engine/recording/picture_import.h"

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "engine/recording/verify_recording.h"
#include "tests/recording/recorded_rail.h"

namespace vignole {
namespace {

using namespace vignole::testing;

void writePicture(const std::filesystem::path& file, const VirtualRig& rig, int camera, std::uint64_t trigger) {
  std::filesystem::create_directories(file.parent_path());
  cv::Mat picture(1024, 1400, CV_8U);
  rig.render(camera, trigger, {picture.data, 1400, 1024, 1400});
  ASSERT_TRUE(cv::imwrite(file.string(), picture));
}

ImportSettings settingsOf(const VirtualRig& rig) {
  ImportSettings settings;
  settings.rail.id = "pictures";
  settings.rail.temperatureUncertaintyC = 0;  // as the rig's own
  settings.setup = setupOf(rig);
  return settings;
}

TEST(PictureImport, TheNamesOfSimulateRailGiveTheRailsOwnNumbers) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  for (std::uint64_t t = 3; t < 6; ++t)
    for (int c = 0; c < kCameraCount; ++c)
      writePicture(folder.file("in/trigger" + std::to_string(t) + "/camera" + std::to_string(c + 1) + ".png"), *rig, c,
                   t);
  std::ofstream(folder.file("in/truth.json")) << "{}";
  const auto pictures = findPictures(folder.file("in"));
  ASSERT_TRUE(pictures) << pictures.error().message();
  EXPECT_EQ(pictures->size(), 3U);
  ASSERT_TRUE(importPictures(*pictures, settingsOf(*rig), folder.file("out.vgr"), [](double) {}));
  EXPECT_TRUE(verifyRecording(*opened(folder.file("out.vgr")), [](double) {}).good());
  const RunResult again = replay(folder.file("out.vgr"));
  ASSERT_EQ(again.profiles.size(), 3U);
  const auto live = makeVirtualSource(rig, {1, 15.0 * 6, false});
  const RunResult expected = run(*live, recipe60(), rig->calibration());
  for (std::size_t i = 0; i < 3; ++i) {  // but for the place on the rail, which the pictures do not tell
    const auto dimensions = [](const std::string& word) { return word.substr(word.find(' ')); };
    EXPECT_EQ(dimensions(again.profiles[i]), dimensions(expected.profiles[i + 3]));
  }
}

TEST(PictureImport, GapsAreRefusedOrCountedAsLost) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  for (const std::uint64_t t : {0U, 1U, 3U})
    for (int c = 0; c < kCameraCount; ++c)
      if (t != 1 || c != 2)
        writePicture(folder.file("in/camera" + std::to_string(c + 1) + "_" + std::to_string(t) + ".pgm"), *rig, c, t);
  const auto pictures = findPictures(folder.file("in"));
  ASSERT_TRUE(pictures);
  ImportSettings settings = settingsOf(*rig);
  const auto refused = importPictures(*pictures, settings, folder.file("out.vgr"), [](double) {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("camera 3 at trigger 1"), std::string::npos) << refused.error().message();
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in"});
  settings.missingIsLost = true;
  ASSERT_TRUE(importPictures(*pictures, settings, folder.file("out.vgr"), [](double) {}));
  const RunResult again = replay(folder.file("out.vgr"));
  EXPECT_EQ(again.triggers.seen, 4U);
  EXPECT_EQ(again.triggers.measured, 2U);
  EXPECT_EQ(again.triggers.incomplete, 1U);
  EXPECT_EQ(again.triggers.lost, 1U);
  EXPECT_EQ(again.triggers.reasons.at("camera 3: no picture"), 2U);
}

TEST(PictureImport, WhatCannotBeIsRefusedAndLeavesNothing) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  EXPECT_FALSE(findPictures(folder.file("none")));
  std::filesystem::create_directories(folder.file("empty"));
  std::ofstream(folder.file("empty/camera9.png")) << "x";
  std::ofstream(folder.file("empty/cameraman.png")) << "x";
  EXPECT_FALSE(findPictures(folder.file("empty")));
  for (int c = 0; c < kCameraCount; ++c)
    writePicture(folder.file("twice/camera" + std::to_string(c + 1) + ".png"), *rig, c, 0);
  std::ofstream(folder.file("twice/camera2.pgm")) << "x";
  EXPECT_FALSE(findPictures(folder.file("twice")));
  std::filesystem::remove(folder.file("twice/camera2.pgm"));
  const auto pictures = findPictures(folder.file("twice"));
  ASSERT_TRUE(pictures);
  ImportSettings settings = settingsOf(*rig);
  settings.setup.calibration.rangeFinders[3].intrinsics.widthPx = 640;
  const auto size = importPictures(*pictures, settings, folder.file("out.vgr"), [](double) {});
  ASSERT_FALSE(size);
  EXPECT_NE(size.error().message().find("camera4.png"), std::string::npos);
  std::ofstream(folder.file("twice/camera3.png")) << "no picture";
  EXPECT_FALSE(importPictures(*pictures, settingsOf(*rig), folder.file("out.vgr"), [](double) {}));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"empty", "twice"}));
}

}  // namespace
}  // namespace vignole
