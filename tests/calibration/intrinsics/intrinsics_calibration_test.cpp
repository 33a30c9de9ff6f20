#include "calibration/intrinsics/intrinsics_calibration.h"

#include <gtest/gtest.h>

#include "calibration/intrinsics/reprojection.h"
#include "tests/calibration/synthetic_target/synthetic_views.h"

namespace vignole {
namespace {

SyntheticSettings usual() {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
  settings.camera.kappa = -4e-4;
  settings.views = 10;
  return settings;
}

Intrinsics tiltedLens() {
  Intrinsics in = usualCamera();
  in.model = DistortionModel::Polynomial;
  in.k1 = 4e-4;
  in.k2 = -4e-6;
  in.p1 = 0.008 / in.focalMm;  // 0.008 in units of the focal length, as OpenCV has it
  return in;
}

std::vector<TargetView> viewsOf(const SyntheticSettings& settings, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  return syntheticViews(settings, random).views;
}

IntrinsicsCalibration calibrated(const std::vector<TargetView>& views, const PlanarTarget& target,
                                 const IntrinsicsSettings& settings = {}) {
  const auto result = calibrateIntrinsics(views, target, settings);
  EXPECT_TRUE(result.has_value());
  return result ? *result : IntrinsicsCalibration{};
}

double error(const IntrinsicsCalibration& c, CameraParameter p, double truth) {
  const auto i = static_cast<int>(p);
  return (toVector(c.camera.intrinsics)[i] - truth) / std::sqrt(c.camera.covariance(i, i));
}

std::string all(const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& t : texts) text += t + "\n";
  return text;
}

TEST(IntrinsicsCalibration, FindsTheCameraAndSaysHowWell) {
  const SyntheticSettings s = usual();
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_TRUE(c.accepted()) << all(c.refusals);
  EXPECT_EQ(c.variant, (LensVariant{DistortionModel::Division, 0, false, false}));
  EXPECT_LT(std::abs(error(c, CameraParameter::F, s.camera.focalMm)), 4);
  EXPECT_LT(std::abs(error(c, CameraParameter::U0, s.camera.cxPx)), 4);
  EXPECT_LT(std::abs(error(c, CameraParameter::V0, s.camera.cyPx)), 4);
  EXPECT_LT(std::abs(error(c, CameraParameter::Kappa, s.camera.kappa)), 4);
  EXPECT_NEAR(c.camera.rmsPx, 0.05 * std::sqrt(2), 0.005);
  EXPECT_NEAR(c.camera.meanPx / c.camera.rmsPx, 0.886, 0.02) << "of noise that is alike in all directions";
  EXPECT_NEAR(c.chi2PerDof, 1, 0.15);
  EXPECT_LT(c.unexplainedPx, 0.02);
  EXPECT_EQ(c.targetErrorMm, 0);
  EXPECT_EQ(c.targetBendMm, 0);
  for (const ViewResult& v : c.views) EXPECT_TRUE(v.used) << v.file << ": " << v.reason;
  ASSERT_TRUE(c.division && c.polynomial);
  EXPECT_EQ(c.division->rmsPx, c.camera.rmsPx) << "Table III and the camera are one adjustment";
  EXPECT_NEAR(c.polynomial->intrinsics.focalMm, c.division->intrinsics.focalMm, 0.01);
  EXPECT_EQ(c.variants.size(), 8U);
  EXPECT_NEAR(c.correlation(0, 0), 1, 1e-12);
  ASSERT_TRUE(c.openCv);
  EXPECT_NEAR(c.openCv->rmsPx, c.camera.rmsPx, 0.01);
  EXPECT_NEAR(c.openCv->fxPx, c.camera.intrinsics.focalMm / 0.0074, 3);
  int points = 0;
  for (const CoverageCell& cell : c.coverage.cells) points += cell.points;
  EXPECT_EQ(points, static_cast<int>(10 * 54)) << "all were in the picture and used";
}

TEST(IntrinsicsCalibration, TheSamePicturesGiveTheSameNumbers) {
  SyntheticSettings s = usual();
  s.targetErrorMm = 0.05;
  const auto views = viewsOf(s);
  const IntrinsicsCalibration a = calibrated(views, s.target), b = calibrated(views, s.target);
  EXPECT_EQ(toVector(a.camera.intrinsics), toVector(b.camera.intrinsics));
  EXPECT_EQ(a.camera.covariance, b.camera.covariance);
  EXPECT_EQ(a.variant, b.variant);
}

TEST(IntrinsicsCalibration, NoticesATiltedLens) {
  SyntheticSettings s = usual();
  s.camera = tiltedLens();
  const auto views = viewsOf(s);
  const IntrinsicsCalibration c = calibrated(views, s.target);
  EXPECT_EQ(c.variant, (LensVariant{DistortionModel::Polynomial, 2, true, false})) << name(c.variant);
  EXPECT_LT(std::abs(error(c, CameraParameter::P1, s.camera.p1)), 4);
  ASSERT_TRUE(c.division);
  EXPECT_GT(c.division->heldOutRmsPx, 1.5 * c.polynomial->heldOutRmsPx) << "division cannot say it";

  IntrinsicsSettings division;
  division.model = DistortionModel::Division;
  const IntrinsicsCalibration forced = calibrated(views, s.target, division);
  EXPECT_EQ(forced.variant.model, DistortionModel::Division) << "what is asked for is done";
  EXPECT_GT(forced.camera.rmsPx, 1.2 * c.camera.rmsPx);
}

TEST(IntrinsicsCalibration, FindsPixelsThatAreNotSquareAndOnlyThose) {
  SyntheticSettings s = usual();
  s.camera.pixelHeightMm = 0.00743;
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_TRUE(c.variant.aspect);
  EXPECT_LT(std::abs(error(c, CameraParameter::PixelHeight, s.camera.pixelHeightMm)), 4);
}

TEST(IntrinsicsCalibration, KeepsToTheFamilyThatIsAskedFor) {
  const SyntheticSettings s = usual();
  IntrinsicsSettings polynomial;
  polynomial.model = DistortionModel::Polynomial;
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target, polynomial);
  EXPECT_EQ(c.variant.model, DistortionModel::Polynomial);
  EXPECT_TRUE(c.division) << "both are told all the same";
}

TEST(IntrinsicsCalibration, CorrectsTheCentresOfCirclesUnderAStrongLens) {
  SyntheticSettings s = usual();
  s.target = circles(9, 6, 20, 14);
  s.camera.kappa = -3e-3;
  s.noisePx = 0.003;
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_LT(c.camera.rmsPx, 0.006) << "perspective shifts these centres by up to a pixel, distortion by 0.1 px";
  EXPECT_LT(std::abs(error(c, CameraParameter::F, s.camera.focalMm)), 4);
  ASSERT_TRUE(c.openCv);
  EXPECT_GT(c.openCv->rmsPx, 0.05) << "or the test proves nothing";
}

TEST(IntrinsicsCalibration, LeavesOutPointsThatDoNotFit) {
  const SyntheticSettings s = usual();
  auto views = viewsOf(s);
  views[2].points[10].px += Point2(3, -1);
  views[2].points[30].px += Point2(0, 40);
  views[7].points[5].px += Point2(-0.8, 0.8);
  const IntrinsicsCalibration c = calibrated(views, s.target);
  EXPECT_TRUE(c.accepted()) << all(c.refusals);
  EXPECT_EQ(c.views[2].rejected, 2);
  EXPECT_EQ(c.views[7].rejected, 1);
  EXPECT_FALSE(c.views[2].pointResults[10].used);
  EXPECT_NEAR(c.views[2].pointResults[30].errorPx.y(), -40, 0.5);
  EXPECT_NEAR(c.camera.rmsPx, 0.05 * std::sqrt(2), 0.005);
  EXPECT_LT(std::abs(error(c, CameraParameter::F, s.camera.focalMm)), 4);
}

TEST(IntrinsicsCalibration, LeavesOutPicturesThatDoNotFitWithAReason) {
  const SyntheticSettings s = usual();
  auto views = viewsOf(s);
  std::mt19937_64 random(9);
  std::normal_distribution<double> shake(0, 1);
  for (FoundPoint& p : views[4].points) p.px += Point2(shake(random), shake(random));
  for (std::size_t i = 0; i + 1 < views[6].points.size(); i += 2)
    std::swap(views[6].points[i].px, views[6].points[i + 1].px);  // counted wrongly
  const IntrinsicsCalibration c = calibrated(views, s.target);
  EXPECT_TRUE(c.accepted()) << all(c.refusals);
  EXPECT_FALSE(c.views[4].used);
  EXPECT_NE(c.views[4].reason.find("take it again"), std::string::npos) << c.views[4].reason;
  EXPECT_FALSE(c.views[6].used);
  for (const std::size_t v : {0U, 1U, 2U, 3U, 5U, 7U, 8U, 9U}) EXPECT_TRUE(c.views[v].used) << c.views[v].reason;
  EXPECT_NEAR(c.camera.rmsPx, 0.05 * std::sqrt(2), 0.005);
}

TEST(IntrinsicsCalibration, TellsWhyAPictureIsOfNoUse) {
  const SyntheticSettings s = usual();
  auto views = viewsOf(s);
  views[0].refusal = "blurred; focus";
  views[1].points.resize(5);
  views[2].widthPx = 700;
  for (FoundPoint& p : views[3].points) p.px.x() = 1399 - p.px.x();  // a picture that was flipped
  views[5] = views[4];
  views[5].file = "again.png";
  for (FoundPoint& p : views[5].points) p.px += Point2(0.5, -0.3);
  const IntrinsicsCalibration c = calibrated(views, s.target);
  EXPECT_EQ(c.views[0].reason, "blurred; focus");
  EXPECT_NE(c.views[1].reason.find("5 points"), std::string::npos) << c.views[1].reason;
  EXPECT_NE(c.views[2].reason.find("700"), std::string::npos) << c.views[2].reason;
  EXPECT_NE(c.views[3].reason.find("mirror"), std::string::npos) << c.views[3].reason;
  EXPECT_NE(c.views[5].reason.find(views[4].file), std::string::npos) << c.views[5].reason;
  EXPECT_TRUE(c.views[4].used);
  EXPECT_TRUE(c.accepted()) << all(c.refusals);
}

TEST(IntrinsicsCalibration, RefusesTooFewPictures) {
  const SyntheticSettings s = usual();
  auto views = viewsOf(s);
  EXPECT_NE(all(calibrated({}, s.target).refusals).find("no picture"), std::string::npos);
  const IntrinsicsCalibration one = calibrated({views[0]}, s.target);
  EXPECT_NE(all(one.refusals).find("only one picture"), std::string::npos) << all(one.refusals);
  EXPECT_NE(all(one.refusals).find("take 10 to 20"), std::string::npos);
  EXPECT_EQ(one.camera.covariance(0, 0), 0);

  const std::vector<TargetView> alike(6, views[0]);
  const IntrinsicsCalibration same = calibrated(alike, s.target);
  EXPECT_NE(all(same.refusals).find("only one picture"), std::string::npos) << all(same.refusals);
  EXPECT_NE(same.views[3].reason.find("move and tilt"), std::string::npos) << same.views[3].reason;
}

/// Moved over the picture and nearer, but never tilted otherwise: f and distance cannot be told apart.
TEST(IntrinsicsCalibration, RefusesPicturesThatAreTiltedAlike) {
  SyntheticSettings s = usual();
  s.minTiltDeg = 0;
  for (const double tilt : {0.0, 3.0}) {
    s.maxTiltDeg = tilt;
    const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
    EXPECT_FALSE(c.accepted());
    EXPECT_NE(all(c.refusals).find("tilted alike"), std::string::npos) << all(c.refusals);
    EXPECT_NE(all(c.refusals).find("20 to 40 degrees"), std::string::npos);
  }
}

TEST(IntrinsicsCalibration, RefusesWhatIsTooUncertain) {
  SyntheticSettings s = usual();
  s.views = 4;
  s.maxTiltDeg = 9;
  s.minTiltDeg = 8;
  s.noisePx = 1;
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_FALSE(c.accepted());
  EXPECT_NE(all(c.refusals).find("uncertain by"), std::string::npos) << all(c.refusals);
}

TEST(IntrinsicsCalibration, EstimatesATargetThatIsNotAsStated) {
  SyntheticSettings s = usual();
  s.targetErrorMm = 0.05;
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_NEAR(c.targetErrorMm, 0.05 / std::sqrt(3.0), 0.008);
  EXPECT_EQ(c.targetBendMm, 0);
  EXPECT_EQ(c.targetCorrectionsMm.size(), 54U);
  EXPECT_NEAR(c.camera.rmsPx, 0.05 * std::sqrt(2), 0.008);
  EXPECT_LT(std::abs(error(c, CameraParameter::F, s.camera.focalMm)), 4);
  ASSERT_TRUE(c.openCv && c.openCvTargetAsStated);
  EXPECT_NEAR(c.openCv->rmsPx, c.camera.rmsPx, 0.01) << "the same target";
  EXPECT_GT(c.openCvTargetAsStated->rmsPx, 1.5 * c.camera.rmsPx);
  EXPECT_NE(all(c.warnings).find("um"), std::string::npos);
}

TEST(IntrinsicsCalibration, TakesAStatedUncertaintyOfTheTargetAtItsWord) {
  SyntheticSettings s = usual();
  s.targetErrorMm = 0.05;
  s.target.uMm = 0.05 / std::sqrt(3.0);
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_EQ(c.targetErrorMm, s.target.uMm);
  EXPECT_NEAR(c.camera.rmsPx, 0.05 * std::sqrt(2), 0.008);
}

/// Printed on paper: a saddle of some tenths of a millimetre.
TEST(IntrinsicsCalibration, EstimatesATargetThatIsBent) {
  SyntheticSettings s = usual();
  s.bendMm = 0.5;
  const IntrinsicsCalibration c = calibrated(viewsOf(s), s.target);
  EXPECT_GT(c.targetBendMm, 0.05);
  EXPECT_EQ(c.targetHeightsMm.size(), 54U);
  EXPECT_NEAR(c.camera.rmsPx, 0.05 * std::sqrt(2), 0.01);
  EXPECT_LT(std::abs(error(c, CameraParameter::F, s.camera.focalMm)), 4);
  EXPECT_NE(all(c.warnings).find("not flat"), std::string::npos) << all(c.warnings);
}

/// The finder of a grid without a mark starts at one end in some pictures, at the other in the rest.
TEST(IntrinsicsCalibration, CountsAGridFromTheSameEnd) {
  SyntheticSettings s = usual();
  s.targetErrorMm = 0.05;
  auto views = viewsOf(s);
  for (const std::size_t v : {1U, 4U, 5U})
    for (FoundPoint& p : views[v].points) p.index = 53 - p.index;
  const IntrinsicsCalibration c = calibrated(views, s.target), asIs = calibrated(viewsOf(s), s.target);
  for (const ViewResult& v : c.views) EXPECT_TRUE(v.used) << v.reason;
  EXPECT_NEAR(c.camera.rmsPx, asIs.camera.rmsPx, 1e-5);
  EXPECT_NEAR(c.camera.intrinsics.focalMm, asIs.camera.intrinsics.focalMm, 1e-5);
}

TEST(IntrinsicsCalibration, StopsWhenAsked) {
  const SyntheticSettings s = usual();
  std::stop_source stop;
  stop.request_stop();
  const auto result = calibrateIntrinsics(viewsOf(s), s.target, {}, Job{{}, stop.get_token()});
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(result.error().message().find("cancelled"), std::string::npos);
}

TEST(IntrinsicsCalibration, TellsHowFarItIs) {
  const SyntheticSettings s = usual();
  double last = 0;
  int told = 0;
  const Job job{[&](double share, std::string_view) {
                  EXPECT_GE(share, last);
                  last = share;
                  ++told;
                },
                {}};
  ASSERT_TRUE(calibrateIntrinsics(viewsOf(s), s.target, {}, job).has_value());
  EXPECT_GE(told, 4);
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace vignole
