#include "engine/optics/calibration.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace vignole {
namespace {

RigCalibration sample() {
  RigCalibration c;
  c.id = "test \"rig\"";
  c.created = "2026-01-02T03:04:05Z";
  c.method = "joint";
  for (int i = 0; i < kCameraCount; ++i) {
    RangeFinderCalibration& f = c.rangeFinders[static_cast<std::size_t>(i)];
    f.serial = "CAM" + std::to_string(i);
    f.intrinsics.focalMm = 16 + 0.1 / 3 * i;
    f.intrinsics.model = i % 2 == 0 ? DistortionModel::Division : DistortionModel::Polynomial;
    if (i % 2 == 0) {
      f.intrinsics.kappa = -1.0 / 3e3;
    } else {
      f.intrinsics.k1 = 1.0 / 7e3;
      f.intrinsics.p2 = -1e-5;
    }
    f.cameraFromWorld.rotation = Eigen::AngleAxisd(0.3 + i, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    f.cameraFromWorld.translationMm = {1.0 / 3, -2, 400};
    f.lightPlane.normal = Eigen::Vector3d(0.01, 0.02, 1).normalized();
    f.lightPlane.distanceMm = 0.25;
    if (i > 0) f.lightPlane.thicknessMm = 0.1 * i;  // known of some, as is the blur
    if (i > 1) f.blurPx = 1.0 / 3;
  }
  return c;
}

class CalibrationFile : public testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        std::filesystem::temp_directory_path() / ("vignole_calibration_" + std::to_string(::getpid()) + "_" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(directory_);
    file_ = directory_ / "rig.toml";
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  /// The sample's file with one piece of text replaced; the error that loading it gives.
  std::string errorAfter(const std::string& from, const std::string& to) {
    std::string text = toToml(sample());
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at == std::string::npos) return {};
    text.replace(at, from.size(), to);
    std::ofstream(file_) << text;
    const auto loaded = loadCalibration(file_);
    EXPECT_FALSE(loaded.has_value());
    return loaded ? std::string() : loaded.error().message();
  }
  std::filesystem::path directory_, file_;
};

TEST_F(CalibrationFile, SurvivesTheRoundTripToTheLastBit) {
  const RigCalibration c = sample();
  ASSERT_TRUE(saveCalibration(c, file_).has_value());
  const auto loaded = loadCalibration(file_);
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message();
  EXPECT_EQ(toToml(*loaded), toToml(c));
  EXPECT_EQ(loaded->id, c.id);
  EXPECT_EQ(loaded->rangeFinders[0].lightPlane.thicknessMm, 0);
  EXPECT_EQ(loaded->rangeFinders[3].lightPlane.thicknessMm, c.rangeFinders[3].lightPlane.thicknessMm);
  EXPECT_EQ(loaded->rangeFinders[3].blurPx, c.rangeFinders[3].blurPx);
  EXPECT_EQ(loaded->rangeFinders[1].intrinsics.k1, c.rangeFinders[1].intrinsics.k1);
  EXPECT_EQ(loaded->rangeFinders[2].cameraFromWorld.rotation, c.rangeFinders[2].cameraFromWorld.rotation);
  EXPECT_EQ(loaded->rangeFinders[3].lightPlane.normal, c.rangeFinders[3].lightPlane.normal);
}

TEST_F(CalibrationFile, KeepsThePreviousVersion) {
  RigCalibration c = sample();
  ASSERT_TRUE(saveCalibration(c, file_).has_value());
  c.id = "second";
  ASSERT_TRUE(saveCalibration(c, file_).has_value());
  const auto previous = loadCalibration(file_.string() + "~");
  ASSERT_TRUE(previous.has_value());
  EXPECT_EQ(previous->id, sample().id);
}

TEST_F(CalibrationFile, RefusesAnUnknownKey) {
  EXPECT_NE(errorAfter("cx_px", "colour = 1\ncx_px").find("colour"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesAValueOutOfRange) {
  EXPECT_NE(errorAfter("focal_mm = 16.0", "focal_mm = -16.0").find("focal_mm"), std::string::npos);
  EXPECT_NE(errorAfter("cx_px = 699.5", "cx_px = 1500.0").find("cx_px"), std::string::npos);
  EXPECT_NE(errorAfter("kappa_per_mm2 = -0.000", "kappa_per_mm2 = -9.000").find("kappa"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesARotationThatIsNone) {
  EXPECT_NE(errorAfter("rotation = [0.", "rotation = [0.1").find("rotation"), std::string::npos);
  // A reflection is orthonormal, too.
  RigCalibration c = sample();
  c.rangeFinders[0].cameraFromWorld.rotation.row(0) *= -1;
  ASSERT_TRUE(saveCalibration(c, file_).has_value());
  EXPECT_FALSE(loadCalibration(file_).has_value());
}

TEST_F(CalibrationFile, RefusesAPlaneNormalThatIsNotUnit) {
  EXPECT_NE(errorAfter("distance_mm = 0.25", "distance_mm = 99999.0").find("distance_mm"), std::string::npos);
  EXPECT_NE(errorAfter("normal = [0.00999", "normal = [0.9").find("normal"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesAnUnknownModel) {
  EXPECT_NE(errorAfter("\"division\"", "\"fisheye\"").find("model"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesFewerThanFourRangeFinders) {
  std::string text = toToml(sample());
  text.resize(text.rfind("\n[[range_finder]]"));
  std::ofstream(file_) << text;
  const auto loaded = loadCalibration(file_);
  ASSERT_FALSE(loaded.has_value());
  EXPECT_NE(loaded.error().message().find("3 times"), std::string::npos) << loaded.error().message();
}

TEST_F(CalibrationFile, MissingFileIsAnError) { EXPECT_FALSE(loadCalibration(directory_ / "absent.toml").has_value()); }

}  // namespace
}  // namespace vignole
