#include "calibration/intrinsics/calibrated_intrinsics.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/optics/intrinsics_toml.h"

namespace vignole {
namespace {

constexpr auto index(CameraParameter p) { return static_cast<int>(p); }

CalibratedIntrinsics sample() {
  CalibratedIntrinsics camera;
  camera.serial = "CAM \"1\"";
  camera.created = "2026-01-02T03:04:05Z";
  camera.intrinsics.focalMm = 16 + 1.0 / 3;
  camera.intrinsics.pixelHeightMm = 0.00741;
  camera.intrinsics.model = DistortionModel::Polynomial;
  camera.intrinsics.k1 = 1.0 / 7e3;
  camera.intrinsics.p2 = -1e-5;
  camera.rmsPx = 1.0 / 9;
  camera.meanPx = 0.1;
  const std::array<CameraParameter, 4> estimated = {CameraParameter::F, CameraParameter::U0, CameraParameter::K1,
                                                    CameraParameter::P2};
  Eigen::Matrix4d factor;
  factor << 1e-3, 0, 0, 0, 0.2, 0.3, 0, 0, 1e-6, -2e-6, 1.0 / 3e6, 0, 1e-6, 1e-6, 1e-7, 1e-6;
  const Eigen::Matrix4d covariance = factor * factor.transpose();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      camera.covariance(index(estimated[static_cast<std::size_t>(i)]), index(estimated[static_cast<std::size_t>(j)])) =
          covariance(i, j);
  return camera;
}

class IntrinsicsFile : public testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        std::filesystem::temp_directory_path() / ("vignole_intrinsics_" + std::to_string(::getpid()) + "_" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(directory_);
    file_ = directory_ / "camera1.toml";
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
    const auto loaded = loadIntrinsics(file_);
    EXPECT_FALSE(loaded.has_value());
    return loaded ? std::string() : loaded.error().message();
  }
  std::filesystem::path directory_, file_;
};

TEST_F(IntrinsicsFile, SurvivesTheRoundTripToTheLastBit) {
  const CalibratedIntrinsics camera = sample();
  ASSERT_TRUE(saveIntrinsics(camera, file_).has_value());
  const auto loaded = loadIntrinsics(file_);
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message();
  EXPECT_EQ(toToml(*loaded), toToml(camera));
  EXPECT_EQ(loaded->serial, camera.serial);
  EXPECT_EQ(loaded->created, camera.created);
  EXPECT_EQ(loaded->intrinsics.focalMm, camera.intrinsics.focalMm);
  EXPECT_EQ(loaded->intrinsics.p2, camera.intrinsics.p2);
  EXPECT_EQ(loaded->rmsPx, camera.rmsPx);
  EXPECT_EQ(loaded->meanPx, camera.meanPx);
  EXPECT_EQ(loaded->covariance, camera.covariance);
}

TEST_F(IntrinsicsFile, WorksWithoutUncertaintySerialAndDate) {
  std::ofstream(file_) << "format = 1\n[intrinsics]\n" + toToml(Intrinsics{});
  const auto loaded = loadIntrinsics(file_);
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message();
  EXPECT_TRUE(loaded->covariance.isZero(0));
  EXPECT_EQ(loaded->intrinsics.focalMm, 16);

  ASSERT_TRUE(saveIntrinsics(*loaded, file_).has_value());
  EXPECT_EQ(toToml(*loaded).find("uncertainty"), std::string::npos);
  EXPECT_TRUE(loadIntrinsics(file_).has_value());
}

TEST_F(IntrinsicsFile, KeepsThePreviousVersion) {
  CalibratedIntrinsics camera = sample();
  ASSERT_TRUE(saveIntrinsics(camera, file_).has_value());
  camera.serial = "second";
  ASSERT_TRUE(saveIntrinsics(camera, file_).has_value());
  EXPECT_EQ(loadIntrinsics(file_)->serial, "second");
  EXPECT_EQ(loadIntrinsics(file_.string() + "~")->serial, sample().serial);
}

TEST_F(IntrinsicsFile, RefusesWhatIsWrongWithFileKeyAndRemedy) {
  EXPECT_NE(errorAfter("focal_mm", "focus_mm").find("focal_mm"), std::string::npos);
  EXPECT_NE(errorAfter("rms_px = ", "rms_px = -").find("rms_px"), std::string::npos);
  EXPECT_NE(errorAfter("serial", "seriel").find("did you mean serial"), std::string::npos);
  EXPECT_NE(errorAfter("f u_0", "f w_0").find("w_0"), std::string::npos);
  EXPECT_NE(errorAfter("f u_0", "u_0 f").find("in this order"), std::string::npos);
  EXPECT_NE(errorAfter("f u_0", "f s_y u_0").find("15 numbers"), std::string::npos);
  EXPECT_NE(errorAfter("covariance = [", "covariance = [-").find("no covariance"), std::string::npos);
  EXPECT_NE(errorAfter("format = 1", "format = 2").find("format"), std::string::npos);
}

TEST_F(IntrinsicsFile, RefusesCorrelationsBeyondOne) {
  CalibratedIntrinsics camera = sample();
  camera.covariance(0, 2) = camera.covariance(2, 0) = 1;
  ASSERT_TRUE(saveIntrinsics(camera, file_).has_value());
  const auto loaded = loadIntrinsics(file_);
  ASSERT_FALSE(loaded.has_value());
  EXPECT_NE(loaded.error().message().find("no covariance"), std::string::npos);
}

TEST_F(IntrinsicsFile, SaysThatAFileIsMissing) {
  const auto loaded = loadIntrinsics(directory_ / "none.toml");
  ASSERT_FALSE(loaded.has_value());
  EXPECT_NE(loaded.error().message().find("none.toml"), std::string::npos);
}

}  // namespace
}  // namespace vignole
