// The checks on adjustments made by hand: what is noise passes, what is more does not.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>

#include "calibration/assessment/comparison.h"
#include "calibration/assessment/existing_calibration.h"
#include "calibration/assessment/plane_motion.h"
#include "calibration/assessment/radius_check.h"
#include "calibration/assessment/residual_checks.h"
#include "calibration/assessment/seam_check.h"
#include "engine/rail/catalogue.h"
#include "tests/calibration/assessment/synthetic_adjustment.h"

namespace vignole {
namespace {

using testing::adjustmentOf;

constexpr double kSigmaPx = 0.1, kFilter = 1.8;
const std::vector<Transform2> kPlacements = {{0, 0, 0}, {2, 168, 3.1}};

RigAdjustment adjustment(std::uint64_t seed = 1) {
  return adjustmentOf(nominalRig(), plate13(), kPlacements, kSigmaPx, kFilter, seed);
}

/// A camera of the calibration somewhere else by this, in its own axes.
RigCalibration movedCamera(RigCalibration rig, std::size_t camera, const Eigen::Vector3d& shiftMm) {
  rig.rangeFinders[camera].cameraFromWorld.translationMm += shiftMm;
  return rig;
}

const Check& named(const std::vector<Check>& checks, const std::string& name) {
  for (const Check& check : checks)
    if (check.name == name) return check;
  ADD_FAILURE() << "no check " << name;
  return checks.front();
}

TEST(PlaneMotion, LaysPointsOntoEachOther) {
  const Transform2 motion{12, -30, 2.5};
  std::vector<Point2> from, to;
  for (int i = 0; i < 9; ++i) {
    from.emplace_back(10.0 * (i % 3), 25.0 * std::floor(i / 3.0));
    to.push_back(motion * from.back());
  }
  const Transform2 found = laidOnto(from, to);
  EXPECT_NEAR(found.xMm, 12, 1e-9);
  EXPECT_NEAR(found.yMm, -30, 1e-9);
  EXPECT_NEAR(found.angleRad, 2.5, 1e-12);
}

TEST(PinCentres, ErrByTheirCovariance) {
  const RigCalibration& rig = nominalRig();
  const PinPlate plate = plate13();
  double chi2 = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const PinPixels& arc : pinPixels(adjustment(seed))) {
      const Pin& pin = plate.pins[static_cast<std::size_t>(arc.pin - 1)];
      const PinCentre centre = centreOf(arc, rig.rangeFinders[static_cast<std::size_t>(arc.camera)], pin.radiusMm);
      ASSERT_TRUE(centre.valid);
      const Point2 error = centre.mm - kPlacements[static_cast<std::size_t>(arc.placement)] * pin.centreMm;
      EXPECT_LT(error.norm(), 0.2);
      chi2 += error.dot(centre.covariance.inverse() * error);
      count += 2;
    }
  EXPECT_NEAR(chi2 / count, 1, 0.12);
}

TEST(PinCentres, APlaceMovesWithTheCamerasParametersAsItsJacobianSays) {
  const RangeFinderCalibration& finder = nominalRig().rangeFinders[2];
  const Point2 px(650, 420);
  const auto jacobian = placeJacobian(finder, px);
  CameraChange change = CameraChange::Zero();
  change[static_cast<int>(CameraParameter::F)] = 0.002;
  change[static_cast<int>(CameraParameter::TurnY)] = 1e-5;
  change[static_cast<int>(CameraParameter::T3)] = 0.01;
  RangeFinderCalibration moved = finder;
  apply(change, moved);
  const PlanePoint a = PlaneMap(finder)(px.x(), px.y()), b = PlaneMap(moved)(px.x(), px.y());
  const Eigen::Vector2d predicted = jacobian * change;
  EXPECT_NEAR(b.x - a.x, predicted.x(), 1e-3 * predicted.norm());
  EXPECT_NEAR(b.y - a.y, predicted.y(), 1e-3 * predicted.norm());
  EXPECT_NEAR((pixelOf(finder, {a.x, a.y}) - px).norm(), 0, 1e-9);
}

TEST(PinMisfit, IsWhatIsExpectedForNoise) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  PinMisfit misfit;
  for (int k = 0; k < 4000; ++k) {
    const double along = 0.005, across = k % 2 == 0 ? 0.05 : 0.3;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    covariance.diagonal() << along * along, across * across;
    misfit.add({along * normal(random), across * normal(random)}, covariance);
  }
  EXPECT_EQ(misfit.count(), 4000);
  EXPECT_NEAR(misfit.rmsMm() / misfit.expectedMm(), 1, 0.03);
  EXPECT_NEAR(misfit.expectedMm(), 0.00705, 5e-4) << "the certain direction counts";
}

TEST(ResidualChecks, NoiseThatTheFilterMadePasses) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const Check& check : residualChecks(adjustment(seed)))
      EXPECT_TRUE(check.done && check.pass()) << check.name << ": " << check.words;
}

TEST(ResidualChecks, WhatBendsAlongTheArcsDoesNot) {
  RigAdjustment wrong = adjustment();
  for (PinView& view : wrong.pins)
    if (view.camera == 1)
      for (std::size_t i = 0; i < view.residualPx.size(); ++i)
        view.residualPx[i] += 0.2 * std::cos(3.0 * static_cast<double>(i) / static_cast<double>(view.points));
  const std::vector<Check> checks = residualChecks(wrong);
  EXPECT_FALSE(named(checks, "residual whiteness").pass());
  EXPECT_NE(named(checks, "residual whiteness").words.find("camera 2"), std::string::npos);
  const auto refusals = refusalsOf(checks);
  ASSERT_FALSE(refusals.empty());
  EXPECT_EQ(refusals.front().rfind("refused, because ", 0), 0U) << refusals.front();
}

TEST(ResidualChecks, StraysAndScatterDoNot) {
  RigAdjustment wrong = adjustment();
  int k = 0;
  for (PinView& view : wrong.pins)
    if (view.camera == 0)
      for (double& r : view.residualPx)
        if (++k % 12 == 0) r = 1.5;
  EXPECT_FALSE(named(residualChecks(wrong), "residual distribution").pass());
  wrong.finders[3].noisePx = 0.25;
  EXPECT_FALSE(named(residualChecks(wrong), "residual noise").pass());
  EXPECT_FALSE(residualChecks(RigAdjustment{}).front().done) << "nothing to look at is no pass";
}

TEST(Seam, PinsSeenByTwoCamerasStandInOnePlace) {
  const RigAdjustment a = adjustment();
  const auto seams = pairSeams(pinPixels(a), a.calibration, a.calibration.pins);
  ASSERT_EQ(seams.size(), 6U);
  for (const PairSeam& seam : seams) {
    EXPECT_EQ(seam.pins, 26);
    EXPECT_NEAR(seam.rmsMm / seam.expectedMm, 1, 0.35);
    EXPECT_LT(seam.meanMm.norm(), 4 * seam.uMeanMm);
  }
  EXPECT_TRUE(seamCheck(seams).pass()) << seamCheck(seams).words;
  EXPECT_TRUE(seamShiftCheck(seams).pass()) << seamShiftCheck(seams).words;
  EXPECT_FALSE(seamCheck({}).done);
}

TEST(Seam, ACameraThatMovedIsSeen) {
  const RigAdjustment a = adjustment();
  const RigCalibration moved = movedCamera(a.calibration, 2, {0.03, 0, 0});
  const auto seams = pairSeams(pinPixels(a), moved, a.calibration.pins);
  const Check check = seamShiftCheck(seams);
  EXPECT_FALSE(check.pass());
  EXPECT_NEAR(check.value, 0.03, 0.004);
  EXPECT_NE(check.words.find('3'), std::string::npos) << check.words;
  // Not if the calibration is that uncertain.
  RigCalibration uncertain = moved;
  uncertain.covariance = Eigen::MatrixXd::Zero(kRigParameters, kRigParameters);
  const int t1 = 2 * kCameraParameters + static_cast<int>(CameraParameter::T1);
  uncertain.covariance(t1, t1) = 0.02 * 0.02;
  const auto wide = pairSeams(pinPixels(a), uncertain, a.calibration.pins);
  EXPECT_TRUE(seamShiftCheck(wide).pass()) << seamShiftCheck(wide).words;
}

TEST(PinRadii, AreThoseOfThePlateOrNot) {
  const RigAdjustment a = adjustment();
  PinPlate plate = plate13();
  const auto right = radiusMisfits(pinPixels(a), a.calibration, plate);
  for (const RadiusMisfit& m : right) {
    EXPECT_EQ(m.arcs, 26);
    EXPECT_LT(std::abs(m.meanMm), 4 * m.uMm);
  }
  EXPECT_TRUE(radiusCheck(right).pass()) << radiusCheck(right).words;
  for (Pin& pin : plate.pins) pin.radiusMm += 0.1;
  const Check wrong = radiusCheck(radiusMisfits(pinPixels(a), a.calibration, plate));
  EXPECT_FALSE(wrong.pass());
  EXPECT_NEAR(wrong.value, 0.1, 0.04);
  EXPECT_FALSE(radiusCheck({}).done);
}

TEST(Comparison, TwoOfTheSameAreTheSameWhereverTheirWorldsLie) {
  const Section section = *findSection("60E1");
  const RigCalibration turned = inWorld(nominalRig(), {3, 165, 3.05});
  const auto same = compare(turned, nominalRig(), section, section.parameters);
  ASSERT_TRUE(same) << same.error().message();
  for (const Dimension d : kDimensions)
    EXPECT_NEAR(same->differenceMm[index(d)], 0, d == Dimension::HR ? 0.05 : 1e-4) << name(d);
  for (const CameraMovement& m : same->cameras) {
    EXPECT_LT(std::hypot(m.xMm, m.yMm), 1e-6);
    EXPECT_LT(m.centreMm, 1e-6);
    EXPECT_LT(m.poseDeg, 1e-6);
  }
}

TEST(Comparison, TellsWhichCameraMovedAndWhatItDoesToTheDimensions) {
  const Section section = *findSection("60E1");
  RigCalibration newer = movedCamera(nominalRig(), 1, {0.08, 0, 0});
  newer.covariance = Eigen::MatrixXd::Identity(kRigParameters, kRigParameters) * 1e-12;
  const auto compared = compare(nominalRig(), newer, section, section.parameters);
  ASSERT_TRUE(compared) << compared.error().message();
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const CameraMovement& m = compared->cameras[c];
    if (c == 1) {
      EXPECT_NEAR(std::hypot(m.xMm, m.yMm), 0.06, 0.015) << "less what laying the worlds onto each other takes";
    } else {
      EXPECT_LT(std::hypot(m.xMm, m.yMm), 0.035);
    }
  }
  const auto direct = measuredDimensions(section, section.parameters, newer, nominalRig());
  ASSERT_TRUE(direct);
  EXPECT_NEAR(compared->differenceMm[index(Dimension::WT)], (*direct)[index(Dimension::WT)], 1e-4);
  const Check check = comparisonCheck(*compared);
  EXPECT_FALSE(check.pass());
  EXPECT_FALSE(check.refuses);
  EXPECT_NE(check.words.find("camera 2"), std::string::npos) << check.words;
}

class Existing : public ::testing::Test {
 protected:
  Existing() {
    PinPlate plate = plate13();
    for (Pin& pin : plate.pins) pin.uCentreMm = pin.uRadiusMm = 0.003;
    fresh_ = adjustmentOf(nominalRig(), plate, kPlacements, kSigmaPx, kFilter, 5);
    calibration_ = fresh_.calibration;
    calibration_.created = "2026-01-01T00:00:00Z";
    RigChange sd = RigChange::Zero();
    for (int c = 0; c < kCameraCount; ++c)
      sd.segment<3>(c * kCameraParameters + static_cast<int>(CameraParameter::T1)).setConstant(0.002);
    calibration_.covariance = sd.cwiseAbs2().asDiagonal();
    fresh_.calibration.covariance = calibration_.covariance;
  }
  Expected<ExistingCalibration> judge(const RigCalibration& calibration, int daysLater = 10) {
    auto inputs = inputsFor(calibration);
    EXPECT_TRUE(inputs);
    inputs->placements.resize(kPlacements.size());
    const auto now = *secondsSinceEpoch("2026-01-01T00:00:00Z") + std::chrono::hours(24 * daysLater);
    const Section section = *findSection("60E1");
    return judgeExisting(calibration, *inputs, fresh_, section, section.parameters, now);
  }
  RigAdjustment fresh_;
  RigCalibration calibration_;
};

TEST_F(Existing, StillRight) {
  const auto judged = judge(calibration_);
  ASSERT_TRUE(judged) << judged.error().message();
  EXPECT_TRUE(refusalsOf(judged->checks).empty()) << refusalsOf(judged->checks).front();
  ASSERT_EQ(judged->placements.size(), 2U);
  for (const Fold& f : judged->placements) EXPECT_NEAR(f.misfit.rmsMm() / f.misfit.expectedMm(), 1, 0.3);
  for (const SpreadMm& cd : judged->cd) EXPECT_LT(cd.mean, 0.1);
  EXPECT_EQ(judged->dimensions.size(), kDimensionCount);
  for (const DimensionUncertainty& d : judged->dimensions) EXPECT_EQ(d.contributions.size(), 4U);
}

TEST_F(Existing, ACameraThatMovedSinceIsRefused) {
  const auto judged = judge(movedCamera(calibration_, 2, {0.05, 0, 0}));
  ASSERT_TRUE(judged) << judged.error().message();
  const auto refusals = refusalsOf(judged->checks);
  ASSERT_FALSE(refusals.empty());
  EXPECT_FALSE(named(judged->checks, "seam shift").pass());
  EXPECT_FALSE(named(judged->checks, "dimensions").pass()) << named(judged->checks, "dimensions").words;
}

TEST_F(Existing, OlderThanItsIntervalIsRefused) {
  RigCalibration old = calibration_;
  old.intervalDays = 30;
  EXPECT_TRUE(refusalsOf(judge(old, 29)->checks).empty());
  const auto refusals = refusalsOf(judge(old, 31)->checks);
  ASSERT_EQ(refusals.size(), 1U);
  EXPECT_NE(refusals.front().find("31 days old"), std::string::npos) << refusals.front();
  EXPECT_FALSE(refusalsOf(judge(old, -20)->checks).empty()) << "made in the future";
}

TEST_F(Existing, WithoutPinsNeedsAPlate) {
  calibration_.pins.clear();
  const auto inputs = inputsFor(calibration_);
  ASSERT_FALSE(inputs);
  EXPECT_NE(inputs.error().message().find("--plate"), std::string::npos);
}

}  // namespace
}  // namespace vignole
