#include "calibration/lens_files/lens_files.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "calibration/lens_files/lens_file_readers.h"
#include "calibration/intrinsics/lens_variant.h"
#include "calibration/lens_files/opencv_lens.h"
#include "engine/files/atomic_file.h"
#include "engine/optics/camera_model.h"

namespace vignole {
namespace {

constexpr double kPixelMm = 0.0074;

const std::filesystem::path kFormats = std::filesystem::path(VIGNOLE_SHARED_DATA) / "formats";

#define SKIP_WITHOUT_FORMATS() \
  if (!std::filesystem::exists(kFormats)) GTEST_SKIP() << "no shared data beside the checkout"

/// Largest distance of the pixels in which two lenses see the same rays, over the picture of the first.
double largestDifferencePx(const Intrinsics& a, const Intrinsics& b) {
  const Lens<double> from = lens(a), to = lens(b);
  double largest = 0;
  for (int x = 0; x < a.widthPx; x += 20)
    for (int y = 0; y < a.heightPx; y += 20) {
      const Vector2T<double> px(x, y), ray = undistortedFromPixel(from, px) / a.focalMm;
      const Vector2T<double> there = projectFromCamera(to, Vector3T<double>(ray.x(), ray.y(), 1));
      largest = std::max(largest, (there - px).norm());
    }
  return largest;
}

CalibratedIntrinsics polynomialSample() {
  CalibratedIntrinsics camera;
  camera.created = "2026-01-02T03:04:05Z";
  camera.rmsPx = 0.07;
  Intrinsics& in = camera.intrinsics;
  in.focalMm = 16.1 + 1.0 / 3;
  in.pixelHeightMm = 0.00741;
  in.model = DistortionModel::Polynomial;
  in.k1 = 4.1e-4;
  in.k2 = -3.2e-7;
  in.k3 = -2e-9;
  in.p1 = 5e-5;
  in.p2 = -6e-5;
  return camera;
}

CalibratedIntrinsics divisionSample() {
  CalibratedIntrinsics camera;
  camera.intrinsics.kappa = -4e-4;
  camera.intrinsics.cxPx = 690.25;
  return camera;
}

class LensFile : public testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        std::filesystem::temp_directory_path() / ("vignole_lens_" + std::to_string(::getpid()) + "_" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  [[nodiscard]] std::string errorOf(const std::string& file, const std::string& text) const {
    std::ofstream(directory_ / file) << text;
    const auto lens = importLens(directory_ / file, kPixelMm);
    EXPECT_FALSE(lens.has_value()) << file << "\n" << text;
    return lens ? std::string() : lens.error().message();
  }
  std::filesystem::path directory_;
};

TEST_F(LensFile, OursAndHalconsSurviveTheRoundTripExactly) {
  for (const CalibratedIntrinsics& camera : {polynomialSample(), divisionSample()})
    for (const char* name : {"a.toml", "a.dat"}) {
      const auto written = exportLens(camera, directory_ / name);
      ASSERT_TRUE(written.has_value()) << written.error().message();
      EXPECT_EQ(*written, 0) << "the same lens model";
      const auto read = importLens(directory_ / name, kPixelMm);
      ASSERT_TRUE(read.has_value()) << read.error().message();
      EXPECT_EQ(read->camera.intrinsics.model, camera.intrinsics.model);
      EXPECT_LT(largestDifferencePx(camera.intrinsics, read->camera.intrinsics), 1e-9) << name;
    }
}

TEST_F(LensFile, OpenCvAndMrcalComeBackWithinWhatTheySay) {
  for (const CalibratedIntrinsics& camera : {polynomialSample(), divisionSample()})
    for (const char* name : {"a.yaml", "a.yml", "a.cameramodel"}) {
      const auto written = exportLens(camera, directory_ / name);
      ASSERT_TRUE(written.has_value()) << written.error().message();
      EXPECT_LT(*written, 0.06) << "tangential terms are not quite the same the other way round";
      const auto read = importLens(directory_ / name, camera.intrinsics.pixelWidthMm);
      ASSERT_TRUE(read.has_value()) << read.error().message();
      EXPECT_LT(read->maxResidualPx, 0.06);
      EXPECT_LT(largestDifferencePx(camera.intrinsics, read->camera.intrinsics), *written + read->maxResidualPx + 1e-6)
          << name;
      EXPECT_NEAR(read->camera.intrinsics.focalMm, camera.intrinsics.focalMm, 1e-12);
      EXPECT_NEAR(read->camera.intrinsics.pixelHeightMm, camera.intrinsics.pixelHeightMm, 1e-15);
    }
}

TEST_F(LensFile, KeepsTheErrorThatOpenCvStates) {
  ASSERT_TRUE(exportLens(polynomialSample(), directory_ / "a.yaml").has_value());
  EXPECT_EQ(importLens(directory_ / "a.yaml", kPixelMm)->camera.rmsPx, polynomialSample().rmsPx);
}

TEST_F(LensFile, ReadsTheSameCameraFromAllSharedFormats) {
  SKIP_WITHOUT_FORMATS();
  const auto openCv = importLens(kFormats / "opencv.yaml", kPixelMm);
  const auto mrcal = importLens(kFormats / "mrcal.cameramodel", kPixelMm);
  const auto halcon = importLens(kFormats / "halcon_polynomial.dat", kPixelMm);
  const auto division = importLens(kFormats / "halcon_division.dat", kPixelMm);
  ASSERT_TRUE(openCv.has_value()) << openCv.error().message();
  ASSERT_TRUE(mrcal.has_value()) << mrcal.error().message();
  ASSERT_TRUE(halcon.has_value()) << halcon.error().message();
  ASSERT_TRUE(division.has_value()) << division.error().message();
  EXPECT_LT(openCv->maxResidualPx, 0.1) << "a strong lens leaves about 0.04 px";
  EXPECT_LT(largestDifferencePx(openCv->camera.intrinsics, mrcal->camera.intrinsics), 1e-6);
  EXPECT_LT(largestDifferencePx(openCv->camera.intrinsics, halcon->camera.intrinsics), 0.06)
      << "their polynomial was fitted in undistorted pixels and is written with few digits";
  // Division says the radial part of it to first order: the file is what it is.
  EXPECT_EQ(division->camera.intrinsics.model, DistortionModel::Division);
  EXPECT_NEAR(division->camera.intrinsics.kappa, -390.6e-6, 1e-12);
  EXPECT_NEAR(division->camera.intrinsics.focalMm, 16, 1e-12);
  EXPECT_NEAR(halcon->camera.intrinsics.p1, 0.052317e-3, 1e-12);
}

TEST_F(LensFile, WritesWhatTheSharedFilesHave) {
  SKIP_WITHOUT_FORMATS();
  const auto keysOf = [](const std::string& text) {
    std::vector<std::string> keys;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const auto colon = line.find(':');
      if (line.starts_with(" ") && !line.starts_with("    '")) continue;
      if (line.starts_with("#") || line.empty() || colon == std::string::npos) continue;
      keys.push_back(line.substr(0, colon));
    }
    return keys;
  };
  for (const char* name : {"halcon_polynomial.dat", "halcon_division.dat", "mrcal.cameramodel", "opencv.yaml"}) {
    CalibratedIntrinsics camera = std::string(name) == "halcon_division.dat" ? divisionSample() : polynomialSample();
    const std::filesystem::path file = directory_ / name;
    ASSERT_TRUE(exportLens(camera, file).has_value());
    EXPECT_EQ(keysOf(*readFile(file)), keysOf(*readFile(kFormats / name))) << name;
  }
}

TEST_F(LensFile, ConvertsTheSharedOpenCvCameraBackToItself) {
  SKIP_WITHOUT_FORMATS();
  const auto camera = importLens(kFormats / "opencv.yaml", kPixelMm);
  ASSERT_TRUE(camera.has_value());
  const ToOpenCv back = toOpenCv(camera->camera.intrinsics);
  EXPECT_NEAR(back.lens.k1, -0.1, 1e-3);
  EXPECT_NEAR(back.lens.p1, 0.001, 2e-5);
  EXPECT_NEAR(back.lens.p2, -0.0008, 2e-5);
  EXPECT_NEAR(back.lens.fxPx, 2162.162162, 1e-9);
  EXPECT_LT(back.maxResidualPx, 0.1);
}

TEST_F(LensFile, FirstOrderOfTheConversionIsThatOfTheDesign) {
  Intrinsics in = divisionSample().intrinsics;
  const double small = -1e-5;
  in.kappa = small;
  const double inFocalLengths = small * in.focalMm * in.focalMm;
  EXPECT_NEAR(toOpenCv(in).lens.k1, inFocalLengths, 1e-3 * std::abs(inFocalLengths));
  Intrinsics tangential = in;
  tangential.kappa = 0;
  tangential.model = DistortionModel::Polynomial;
  tangential.p1 = 1e-6;
  tangential.p2 = 2e-6;
  EXPECT_NEAR(toOpenCv(tangential).lens.p1, -2e-6 * in.focalMm, 1e-8);
  EXPECT_NEAR(toOpenCv(tangential).lens.p2, -1e-6 * in.focalMm, 1e-8);
}

TEST_F(LensFile, DivisionAndPolynomialStartFromEachOther) {
  const Intrinsics division = divisionSample().intrinsics;
  const Intrinsics polynomial = asVariant(division, {DistortionModel::Polynomial, 3, false, false});
  EXPECT_LT(largestDifferencePx(division, polynomial), 0.05);
  EXPECT_NEAR(asVariant(polynomial, {DistortionModel::Division, 0, false, false}).kappa, division.kappa, 1e-15);
}

TEST_F(LensFile, RefusesBadFilesByNameAndKey) {
  const std::string halcon = toHalcon(polynomialSample().intrinsics);
  const auto without = [](std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_NE(errorOf("a.dat", "nothing of the kind").find("foc"), std::string::npos);
  EXPECT_NE(errorOf("a.dat", without(halcon, ":sx:", ":st:")).find("sx"), std::string::npos);
  EXPECT_NE(errorOf("a.dat", without(halcon, "imgw: 1400", "imgw: many")).find("many"), std::string::npos);
  EXPECT_NE(errorOf("a.dat", without(halcon, "foc: 0.01", "foc: 16.01")).find("metres"), std::string::npos);

  const std::string mrcal = toMrcal(polynomialSample().intrinsics);
  EXPECT_NE(errorOf("a.cameramodel", "{}").find("lensmodel"), std::string::npos);
  EXPECT_NE(errorOf("a.cameramodel", without(mrcal, "OPENCV5", "SPLINED_STEREOGRAPHIC")).find("convert"),
            std::string::npos);
  EXPECT_NE(errorOf("a.cameramodel", without(mrcal, "OPENCV5", "OPENCV8")).find("intrinsics"), std::string::npos);
  EXPECT_NE(errorOf("a.cameramodel", without(mrcal, "imagersize", "size")).find("imagersize"), std::string::npos);

  const std::string openCv = toOpenCvYaml(polynomialSample());
  EXPECT_NE(errorOf("a.yaml", "model: pinhole\n").find("%YAML"), std::string::npos);
  EXPECT_NE(errorOf("a.yaml", "%YAML:1.0\n---\n").find("camera_matrix"), std::string::npos);
  EXPECT_NE(errorOf("a.yaml", "%YAML:1.0\n---\ncamera_matrix: [ 1, 2\n").find("a.yaml"), std::string::npos);
  EXPECT_NE(errorOf("a.yaml", without(openCv, "image_width: 1400", "image_width: 0")).find("size"), std::string::npos);
  EXPECT_NE(errorOf("a.yaml", without(openCv, "distortion_coefficients", "distortion")).find("distortion_coefficients"),
            std::string::npos);
  EXPECT_NE(errorOf("a.txt", "").find(".cameramodel"), std::string::npos);
  EXPECT_NE(importLens(directory_ / "none.dat", kPixelMm).error().message().find("none.dat"), std::string::npos);
}

TEST_F(LensFile, RefusesADistortionThatFoldsThePictureOver) {
  OpenCvLens lens;
  lens.fxPx = lens.fyPx = 1000;
  lens.widthPx = 1400;
  lens.heightPx = 1024;
  lens.cxPx = 700;
  lens.cyPx = 500;
  lens.k1 = -2;
  const auto here = fromOpenCv(lens, DistortionModel::Polynomial, kPixelMm);
  ASSERT_FALSE(here.has_value());
  EXPECT_NE(here.error().what.find("folds"), std::string::npos);
}

}  // namespace
}  // namespace vignole
