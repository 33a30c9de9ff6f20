#include "calibration/assessment/dimension_uncertainty.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "engine/measurement/measurement.h"
#include "engine/optics/nominal_rig.h"
#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

Section rail() { return *findSection("60E1"); }

/// Each camera's focal length, place and principal point, and a plate that makes everything too large together.
std::vector<ErrorSource> sources() {
  std::vector<ErrorSource> all;
  const auto source = [&](const std::string& name) -> ErrorSource& {
    all.push_back({name, {}});
    all.back().effects = Eigen::Matrix<double, kRigParameters, Eigen::Dynamic>::Zero(kRigParameters, 1);
    return all.back();
  };
  for (int c = 0; c < kCameraCount; ++c) {
    const std::string camera = "camera " + std::to_string(c + 1);
    source(camera + " focal length").effects(c * kCameraParameters + static_cast<int>(CameraParameter::F), 0) = 2e-4;
    ErrorSource& lines = source(camera + " lines");
    lines.effects.setZero(kRigParameters, 3);
    for (int k = 0; k < 3; ++k)
      lines.effects(c * kCameraParameters + static_cast<int>(CameraParameter::T1) + k, k) = 0.003;
  }
  ErrorSource& plate = source("plate's scale");
  for (int c = 0; c < kCameraCount; ++c)
    plate.effects.block<3, 1>(c * kCameraParameters + static_cast<int>(CameraParameter::T1), 0) =
        5e-5 * nominalRig().rangeFinders[static_cast<std::size_t>(c)].cameraFromWorld.translationMm;
  return all;
}

TEST(DimensionUncertainty, ContributionsSumUpAndTheWorstComesFirst) {
  const auto jacobian = dimensionJacobian(rail(), defaultParameters(rail()), nominalRig());
  ASSERT_TRUE(jacobian) << jacobian.error().message();
  const auto of = sources();
  const auto all = dimensionUncertainty(*jacobian, of);
  ASSERT_EQ(all.size(), kDimensionCount);
  for (const DimensionUncertainty& one : all) {
    ASSERT_EQ(one.contributions.size(), of.size());
    double sum = 0;
    for (std::size_t k = 0; k < one.contributions.size(); ++k) {
      sum += one.contributions[k].uMm * one.contributions[k].uMm;
      if (k > 0) {
        EXPECT_LE(one.contributions[k].uMm, one.contributions[k - 1].uMm);
      }
    }
    EXPECT_NEAR(std::sqrt(sum), one.uMm, 1e-12);
  }
  // 5e-5 of 172 mm.
  for (const Contribution& c : all[index(Dimension::RH)].contributions)
    if (c.source == "plate's scale") {
      EXPECT_NEAR(c.uMm, 0.0086, 2e-4);
    }
}

TEST(DimensionUncertainty, LeavesOutWhatTheSectionDoesNotHave) {
  DimensionJacobian jacobian = DimensionJacobian::Ones();
  jacobian.row(static_cast<int>(index(Dimension::FC))).setConstant(std::nan(""));
  const auto all = dimensionUncertainty(jacobian, sources());
  EXPECT_EQ(all.size(), kDimensionCount - 1);
  for (const DimensionUncertainty& one : all) EXPECT_NE(one.dimension, Dimension::FC);
}

TEST(DimensionUncertainty, OfNoErrorsIsZero) {
  const auto all = dimensionUncertainty(DimensionJacobian::Ones(), {});
  ASSERT_EQ(all.size(), kDimensionCount);
  EXPECT_EQ(all.front().uMm, 0);
  const std::vector<ErrorSource> exact = {errorSource(RigCalibration{})};
  EXPECT_EQ(dimensionUncertainty(DimensionJacobian::Ones(), exact).front().uMm, 0);
}

TEST(MonteCarlo, AgreesWithThePropagation) {
  const auto checked = monteCarlo(rail(), defaultParameters(rail()), nominalRig(), sources(), 1500, 11);
  ASSERT_TRUE(checked) << checked.error().message();
  ASSERT_EQ(checked->size(), kDimensionCount);
  for (const MonteCarloDimension& d : *checked) {
    EXPECT_NEAR(d.relativeU, 1 / std::sqrt(2.0 * 1499), 1e-9);
    // The extreme of a crown that both ends move by themselves is larger than one end moves, by up to sqrt(2).
    const double limit = d.dimension == Dimension::HF ? 0.45 : 4 * d.relativeU + 0.01;
    EXPECT_NEAR(d.drawnMm / d.uMm, 1, limit) << name(d.dimension);
    if (d.dimension != Dimension::HF) {
      EXPECT_LT(std::abs(d.biasMm), 4 * d.uMm / std::sqrt(1500.0) + 0.02 * d.uMm) << name(d.dimension);
    }
  }
}

TEST(MonteCarlo, SameSeedSameNumbersAndCanBeCancelled) {
  const auto once = monteCarlo(rail(), defaultParameters(rail()), nominalRig(), sources(), 50, 3);
  const auto twice = monteCarlo(rail(), defaultParameters(rail()), nominalRig(), sources(), 50, 3);
  ASSERT_TRUE(once && twice);
  for (std::size_t k = 0; k < once->size(); ++k) EXPECT_EQ((*once)[k].drawnMm, (*twice)[k].drawnMm);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(monteCarlo(rail(), defaultParameters(rail()), nominalRig(), sources(), 50, 3, {{}, stop.get_token()}));
}

}  // namespace
}  // namespace vignole
