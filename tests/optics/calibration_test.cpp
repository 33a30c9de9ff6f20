#include "engine/optics/calibration.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

#include "engine/optics/rig_uncertainty.h"

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

/// As a rig adjustment leaves it: interval, plate, pins, and a covariance over all but what was not estimated.
RigCalibration fullSample() {
  RigCalibration c = sample();
  c.intervalDays = 90;
  c.plate = "plate \\ 7";
  c.pins = {{1, 1.0 / 3, 86, 8, 0.003, 0.002}, {7, -40.1, 2.0 / 7, 5 + 1e-9, 0.029, 0}};
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd effects = Eigen::MatrixXd::Zero(kRigParameters, kRigParameters);
  for (int i = 0; i < kRigParameters; ++i)
    if (i % kCameraParameters != static_cast<int>(CameraParameter::PixelHeight))
      for (int j = 0; j < kRigParameters; ++j) effects(i, j) = std::pow(10.0, -(i % 7)) * normal(random);
  const Eigen::MatrixXd square = effects * effects.transpose();
  c.covariance = (square + square.transpose()) / 2;
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
    return errorAfter(toToml(sample()), from, to);
  }
  std::string errorAfter(std::string text, const std::string& from, const std::string& to) {
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

TEST_F(CalibrationFile, KeepsPinsAndUncertaintyToTheLastBit) {
  const RigCalibration c = fullSample();
  ASSERT_TRUE(saveCalibration(c, file_).has_value());
  const auto loaded = loadCalibration(file_);
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message();
  EXPECT_EQ(loaded->intervalDays, 90);
  EXPECT_EQ(loaded->plate, c.plate);
  ASSERT_EQ(loaded->pins.size(), 2U);
  EXPECT_EQ(loaded->pins[1].number, 7);
  EXPECT_EQ(loaded->pins[1].xMm, c.pins[1].xMm);
  EXPECT_EQ(loaded->pins[1].yMm, c.pins[1].yMm);
  EXPECT_EQ(loaded->pins[1].radiusMm, c.pins[1].radiusMm);
  EXPECT_EQ(loaded->pins[0].uRadiusMm, 0.002);
  EXPECT_EQ(loaded->covariance, c.covariance);
  EXPECT_EQ(toToml(*loaded), toToml(c));
}

TEST_F(CalibrationFile, WithoutUncertaintyThereIsNone) {
  ASSERT_TRUE(saveCalibration(sample(), file_).has_value());
  const auto loaded = loadCalibration(file_);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->covariance.size(), 0);
  EXPECT_TRUE(loaded->pins.empty());
  EXPECT_EQ(loaded->intervalDays, 0);
}

TEST_F(CalibrationFile, RefusesPinsThatCannotBe) {
  const std::string text = toToml(fullSample());
  EXPECT_NE(errorAfter(text, "number = 7", "number = 1").find("another pin"), std::string::npos);
  EXPECT_NE(errorAfter(text, "radius_mm = 8.0", "radius_mm = -8.0").find("radius_mm"), std::string::npos);
  EXPECT_NE(errorAfter(text, "u_mm = 0.003", "u_mm = nan").find("u_mm"), std::string::npos);
  EXPECT_NE(errorAfter(text, "u_mm = 0.003\n", "").find("missing"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesAnIntervalThatCannotBeWatched) {
  const std::string text = toToml(fullSample());
  EXPECT_NE(errorAfter(text, "interval_days = 90", "interval_days = -1").find("interval_days"), std::string::npos);
  EXPECT_NE(errorAfter(text, "2026-01-02T03:04:05Z", "in spring").find("created"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesAnUncertaintyThatCannotBe) {
  RigCalibration c = sample();
  c.covariance = Eigen::MatrixXd::Zero(kRigParameters, kRigParameters);
  c.covariance(0, 0) = 4;
  c.covariance(2, 2) = 9;
  c.covariance(2, 0) = c.covariance(0, 2) = -5.5;
  const std::string text = toToml(c);
  const std::string names = "[\"camera1.f\", \"camera1.u_0\"]";
  EXPECT_NE(errorAfter(text, names, "[\"camera1.f\", \"camera5.u_0\"]").find("camera5.u_0"), std::string::npos);
  EXPECT_NE(errorAfter(text, names, "[\"camera1.f\", \"camera1.f\"]").find("twice"), std::string::npos);
  EXPECT_NE(errorAfter(text, names, "[\"camera1.f\", 3]").find("no text"), std::string::npos);
  EXPECT_NE(errorAfter(text, names, "[\"camera1.f\"]").find("list of 1"), std::string::npos);
  EXPECT_NE(errorAfter(text, names, "[]").find("list of 0"), std::string::npos);
  EXPECT_NE(errorAfter(text, "9.0", "0.0").find("not positive"), std::string::npos);
  EXPECT_NE(errorAfter(text, "9.0", "-9.0").find("not positive"), std::string::npos);
  EXPECT_NE(errorAfter(text, "-5.5", "-6.5").find("beyond"), std::string::npos);
  EXPECT_NE(errorAfter(text, "parameters = " + names + "\n", "").find("parameters"), std::string::npos);
  EXPECT_NE(errorAfter(text, "[uncertainty]", "[uncertainty]\nlevel = 0.95").find("level"), std::string::npos);
}

TEST_F(CalibrationFile, RefusesCorrelationsThatNoErrorsCanHave) {
  RigCalibration c = sample();
  c.covariance = Eigen::MatrixXd::Zero(kRigParameters, kRigParameters);
  c.covariance.topLeftCorner<3, 3>() << 1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1;
  ASSERT_TRUE(saveCalibration(c, file_).has_value());
  const auto loaded = loadCalibration(file_);
  ASSERT_FALSE(loaded.has_value());
  EXPECT_NE(loaded.error().message().find("semi-definite"), std::string::npos) << loaded.error().message();
}

TEST_F(CalibrationFile, MissingFileIsAnError) { EXPECT_FALSE(loadCalibration(directory_ / "absent.toml").has_value()); }

}  // namespace
}  // namespace vignole
