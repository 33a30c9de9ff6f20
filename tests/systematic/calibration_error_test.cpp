#include "engine/systematic/calibration_error.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

#include "engine/measurement/measurement.h"
#include "engine/optics/nominal_rig.h"
#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

Section section(const char* name = "60E1") {
  auto found = findSection(name);
  EXPECT_TRUE(found) << found.error().message();
  return *found;
}

/// The drawing with lenses that distort, of both models.
RigCalibration rig() {
  RigCalibration r = nominalRig();
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    Intrinsics& in = r.rangeFinders[c].intrinsics;
    in.focalMm = 16.1 + 0.05 * static_cast<double>(c);
    in.cxPx += 2;
    if (c % 2 == 0) {
      in.model = DistortionModel::Division;
      in.kappa = -2e-4;
    } else {
      in.model = DistortionModel::Polynomial;
      in.k1 = 1.5e-4;
      in.p1 = 2e-5;
    }
  }
  return r;
}

constexpr double kFloorMm = 2e-5;  // single precision of what the measurement works in

/// A rig whose parameters are off by a little, all at once; the outline moves by some micrometres to some hundredths.
RigChange smallChange(std::uint64_t seed, double scale) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  CameraChange sd;
  sd << 2e-4, 0, 0.05, 0.05, 2e-7, 2e-7, 5e-9, 1e-10, 5e-7, 5e-7, 2e-5, 2e-5, 2e-5, 3e-3, 3e-3, 3e-3;
  RigChange change;
  for (int i = 0; i < kRigParameters; ++i) change[i] = scale * sd[i % kCameraParameters] * normal(random);
  return change;
}

RigCalibration changed(RigCalibration r, const RigChange& change) {
  apply(change, r);
  return r;
}

bool isExtreme(Dimension d) { return d == Dimension::HF; }

/// mm per mm of the outline that a dimension's own rounding and curvature ask for: HR multiplies everything.
double floorOf(Dimension d) { return d == Dimension::HR ? 0.02 : kFloorMm; }

TEST(SeenSection, EveryCameraSeesWhatTheDesignSays) {
  const Section s = section();
  const RigCalibration r = rig();
  const Profile profile = profileOf(seenLines(s, {}, r, 1), r);
  Registrar registrar(s, {});
  Registration registration;
  registrar.registerProfile(profile.points, registration);
  ASSERT_TRUE(registration.valid);
  EXPECT_LT(registration.rmsMm, 1e-4);
  std::map<std::string, std::array<int, kCameraCount>> seen;
  for (std::size_t i = 0; i < profile.points.size(); ++i)
    if (registration.primitiveOfPoint[i] >= 0)
      ++seen[s.primitives[static_cast<std::size_t>(registration.primitiveOfPoint[i])].name][profile.points[i].camera];
  const auto seers = [&](const char* primitive) {
    std::set<int> who;
    for (int c = 0; c < kCameraCount; ++c)
      if (seen[primitive][static_cast<std::size_t>(c)] > 3) who.insert(c + 1);
    return who;
  };
  // Optics design, section 2.
  EXPECT_EQ(seers("AHT"), (std::set{1, 2}));
  EXPECT_EQ(seers("SHR"), (std::set{2, 3}));
  EXPECT_EQ(seers("SHL"), (std::set{1, 4}));
  EXPECT_EQ(seers("SHBR"), (std::set{3}));
  EXPECT_EQ(seers("SWR"), (std::set{2, 3}));
  EXPECT_EQ(seers("SWBL"), (std::set{1}));
  EXPECT_EQ(seers("SBTR"), (std::set{2}));
  EXPECT_EQ(seers("SBL"), (std::set{1, 4}));
  EXPECT_EQ(seers("SBB"), (std::set{3, 4}));
  EXPECT_GT(profile.points.size(), 3000U);
}

TEST(MeasuredDimensions, AreTheNominalOnesByAnExactRig) {
  for (const std::string& name : catalogueNames()) {
    const Section s = section(name.c_str());
    const auto error = measuredDimensions(s, defaultParameters(s), rig(), rig());
    ASSERT_TRUE(error) << error.error().message();
    for (const Dimension d : kDimensions)
      EXPECT_NEAR((*error)[index(d)], 0, floorOf(d)) << name << ' ' << vignole::name(d);
  }
}

TEST(MeasuredDimensions, DoNotDependOnWhereTheWorldIs) {
  const Section s = section();
  RigCalibration moved = rig();
  const Transform2 worldFromOther{3, -2, 0.02};
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(worldFromOther.angleRad), -std::sin(worldFromOther.angleRad),
      std::sin(worldFromOther.angleRad), std::cos(worldFromOther.angleRad);
  for (RangeFinderCalibration& f : moved.rangeFinders) {
    f.cameraFromWorld.translationMm +=
        f.cameraFromWorld.rotation * Eigen::Vector3d(worldFromOther.xMm, worldFromOther.yMm, 0);
    f.cameraFromWorld.rotation = f.cameraFromWorld.rotation * turn;
  }
  const auto error = measuredDimensions(s, defaultParameters(s), rig(), moved);
  ASSERT_TRUE(error) << error.error().message();
  for (const Dimension d : kDimensions) EXPECT_NEAR((*error)[index(d)], 0, 2 * floorOf(d)) << name(d);
}

/// Cameras that stand farther away than they are said to make everything larger: no place but in proportion.
TEST(MeasuredDimensions, GrowWithTheScaleOfTheWorld) {
  const Section s = section();
  const auto nominal = *nominalDimensions(s, defaultParameters(s));
  RigCalibration larger = rig();
  constexpr double kGrowth = 1e-3;
  for (RangeFinderCalibration& f : larger.rangeFinders) f.cameraFromWorld.translationMm *= 1 + kGrowth;
  const auto error = measuredDimensions(s, defaultParameters(s), rig(), larger);
  ASSERT_TRUE(error) << error.error().message();
  // WT at a given height and the places on slopes do not grow in proportion; these do.
  for (const Dimension d : {Dimension::RH, Dimension::FW})
    EXPECT_NEAR((*error)[index(d)], kGrowth * *nominal[index(d)], 0.002) << name(d);
}

TEST(MeasuredDimensions, RefuseARigThatSeesNoRail) {
  RigCalibration blind = rig();
  for (RangeFinderCalibration& f : blind.rangeFinders) f.cameraFromWorld.translationMm.x() += 2000;
  EXPECT_FALSE(measuredDimensions(section(), defaultParameters(section()), blind, rig()));
  EXPECT_FALSE(dimensionJacobian(section(), defaultParameters(section()), blind));
  DimensionParameters off;
  off.rasDepthMm.left = 500;
  EXPECT_FALSE(measuredDimensions(section(), off, rig(), rig()));
}

class JacobianOf : public testing::TestWithParam<const char*> {};

TEST_P(JacobianOf, PredictsWhatIsMeasured) {
  const Section s = section(GetParam());
  const DimensionParameters p = defaultParameters(s);
  const auto jacobian = dimensionJacobian(s, p, rig());
  ASSERT_TRUE(jacobian) << jacobian.error().message();
  PerDimension<double> differences{}, sizes{};
  constexpr int kDraws = 12;
  for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
    const RigChange change = smallChange(seed, 1);
    const auto direct = measuredDimensions(s, p, rig(), changed(rig(), change));
    ASSERT_TRUE(direct) << direct.error().message();
    const Eigen::VectorXd linear = *jacobian * change;
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      const double predicted = linear[static_cast<int>(d)];
      sizes[d] += predicted * predicted / kDraws;
      differences[d] += ((*direct)[d] - predicted) * ((*direct)[d] - predicted) / kDraws;
    }
  }
  for (const Dimension d : kDimensions) {
    if (isExtreme(d) || d == Dimension::HR) continue;
    const double size = std::sqrt(sizes[index(d)]);
    EXPECT_GT(size, 1e-4) << name(d);
    EXPECT_LT(std::sqrt(differences[index(d)]), 0.01 * size + kFloorMm) << name(d);
  }
  const double hr = std::sqrt(sizes[index(Dimension::HR)]);
  EXPECT_LT(std::sqrt(differences[index(Dimension::HR)]), 0.15 * hr + floorOf(Dimension::HR));
}
INSTANTIATE_TEST_SUITE_P(Sections, JacobianOf, testing::Values("60E1", "ASYM54"),
                         [](const auto& one) { return std::string(one.param); });

TEST(Jacobian, IsNothingForWhatALensModelDoesNotHave) {
  const auto jacobian = dimensionJacobian(section(), defaultParameters(section()), rig());
  ASSERT_TRUE(jacobian);
  const auto column = [&](int camera, CameraParameter p) {
    return jacobian->col(camera * kCameraParameters + static_cast<int>(p)).norm();
  };
  EXPECT_EQ(column(0, CameraParameter::K1), 0);  // camera 1 has the division model
  EXPECT_GT(column(0, CameraParameter::Kappa), 0);
  EXPECT_EQ(column(1, CameraParameter::Kappa), 0);
  EXPECT_GT(column(1, CameraParameter::K1), 0);
}

TEST(CalibrationUncertainty, IsTheCovariancePropagated) {
  RigCalibration r = rig();
  const auto exact = calibrationUncertainty(section(), defaultParameters(section()), r);
  ASSERT_TRUE(exact);
  for (const double u : *exact) EXPECT_EQ(u, 0);
  // All cameras farther away together by one part in 10,000: a scale, 17 um of the height.
  RigChange together = RigChange::Zero();
  for (int c = 0; c < kCameraCount; ++c)
    together.segment<3>(c * kCameraParameters + static_cast<int>(CameraParameter::T1)) =
        1e-4 * r.rangeFinders[static_cast<std::size_t>(c)].cameraFromWorld.translationMm;
  r.covariance = together * together.transpose();
  const auto u = calibrationUncertainty(section(), defaultParameters(section()), r);
  ASSERT_TRUE(u);
  EXPECT_NEAR((*u)[index(Dimension::RH)], 0.0172, 2e-4);
  EXPECT_NEAR((*u)[index(Dimension::FW)], 0.0150, 2e-4);
}

}  // namespace
}  // namespace vignole
