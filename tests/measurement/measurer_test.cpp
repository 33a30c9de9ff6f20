#include <cmath>
#include <gtest/gtest.h>

#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"
#include "tests/registration/synthetic_profile.h"

namespace vignole {
namespace {

using synthetic::pose;
using synthetic::ProfileRequest;

Section section(const char* name = "60E1") {
  auto s = findSection(name);
  EXPECT_TRUE(s) << s.error().message();
  return *s;
}

/// Section, registrar and measurer in one.
struct Bench {
  explicit Bench(Section s) : rail(std::move(s)), parameters(defaultParameters(rail)), registrar(rail, {}) {
    auto l = toleranceLimits(rail, "X", "A");
    if (l) limits = *l;
    measurer = std::make_unique<Measurer>(rail, parameters, limits, MeasurementSettings{});
    auto n = nominalDimensions(rail, parameters);
    EXPECT_TRUE(n);
    nominal = *n;
  }
  const Measurement& measure(const Profile& profile, const RailTemperature& t = {}) {
    registrar.registerProfile(profile.points, registration, {}, profile.correlatedPoints);
    measurer->measure(profile, registration, t, result);
    return result;
  }
  const DimensionResult& operator[](Dimension d) const { return result.dimensions[index(d)]; }

  Section rail;
  DimensionParameters parameters;
  PerDimension<ToleranceLimits> limits;
  Registrar registrar;
  std::unique_ptr<Measurer> measurer;
  PerDimension<std::optional<double>> nominal;
  Registration registration;
  Measurement result;
};

ProfileRequest exact(int points = 5000) {
  ProfileRequest request;
  request.points = points;
  request.noiseMm = 0;
  request.worldFromSection = pose(3, -4, 1.5);
  return request;
}

TEST(Measurer, ReturnsTheNominalsOfEverySectionFromPointsOnIt) {
  for (const std::string& name : catalogueNames()) {
    Bench bench(section(name.c_str()));
    bench.measure(synthetic::sample(bench.rail, exact()));
    for (const Dimension d : kDimensions) {
      ASSERT_TRUE(bench[d].valueMm) << name << " " << vignole::name(d) << ": " << bench[d].reason;
      const double limit = d == Dimension::HR ? 0.05 : 5e-4;
      EXPECT_NEAR(*bench[d].valueMm, *bench.nominal[index(d)], limit) << name << " " << vignole::name(d);
      EXPECT_GT(bench[d].uMm, 0) << name << " " << vignole::name(d);
      EXPECT_GT(bench[d].points, 10) << name << " " << vignole::name(d);
    }
  }
}

TEST(Measurer, TheCalibrationsUncertaintyJoinsThatOfTheProfileAndWidensTheGuardBand) {
  Bench bench(section());
  const Profile profile = synthetic::sample(bench.rail, exact());
  const Measurement without = bench.measure(profile);
  PerDimension<double> calibration;
  calibration.fill(0.02);
  calibration[index(Dimension::HW)] = 0;
  calibration[index(Dimension::RH)] = 0.4;  // of limits at 0.6
  bench.measurer =
      std::make_unique<Measurer>(bench.rail, bench.parameters, bench.limits, MeasurementSettings{}, calibration);
  const Measurement with = bench.measure(profile);
  for (const Dimension d : kDimensions) {
    const DimensionResult &a = without.dimensions[index(d)], &b = with.dimensions[index(d)];
    EXPECT_EQ(a.valueMm, b.valueMm) << vignole::name(d);
    EXPECT_EQ(a.uCalibrationMm, 0) << vignole::name(d);
    EXPECT_EQ(b.uCalibrationMm, calibration[index(d)]) << vignole::name(d);
    EXPECT_NEAR(b.uMm, std::hypot(a.uMm, calibration[index(d)]), 1e-12 * b.uMm) << vignole::name(d);
  }
  EXPECT_EQ(without.dimensions[index(Dimension::HW)].uMm, with.dimensions[index(Dimension::HW)].uMm);
  const DimensionResult &hf = without.dimensions[index(Dimension::HF)], &joined = with.dimensions[index(Dimension::HF)];
  EXPECT_NEAR(joined.secondUMm, std::hypot(hf.secondUMm, 0.02), 1e-12);
  EXPECT_EQ(without.dimensions[index(Dimension::RH)].verdict, Verdict::Pass);
  EXPECT_EQ(with.dimensions[index(Dimension::RH)].verdict, Verdict::Near);
}

/// 60E1 with some primitives moved: the outline that is sampled need not close.
class Deformed : public testing::Test {
 protected:
  Primitive& shape(const char* name) { return outline[*bench.rail.find(name)]; }
  void shift(std::initializer_list<const char*> names, double x, double y) {
    for (const char* name : names) shape(name) = transformed({x, y, 0}, shape(name));
  }
  void measure() { bench.measure(synthetic::sample(outline, exact())); }
  void expect(std::map<Dimension, double> changes) {
    for (const Dimension d : kDimensions) {
      ASSERT_TRUE(bench[d].valueMm) << vignole::name(d) << ": " << bench[d].reason;
      const double limit = d == Dimension::HR ? 3 : 0.005;  // HR: sagitta of AHT within 2 micrometres
      EXPECT_NEAR(*bench[d].valueMm - *bench.nominal[index(d)], changes[d], limit) << vignole::name(d);
    }
  }
  Bench bench{section()};
  std::vector<Primitive> outline = synthetic::outlineOf(bench.rail);
};

TEST_F(Deformed, ARail1MmTooHighChangesItsHeights) {
  for (const auto& p : bench.rail.primitives) {
    Primitive& s = shape(p.name.c_str());
    if (startPoint(s).y() > 80 && endPoint(s).y() > 80) s = transformed({0, 1, 0}, s);
  }
  std::get<Segment>(shape("SWR")).end.y() += 1;
  std::get<Segment>(shape("SWL")).start.y() += 1;
  measure();
  expect({{Dimension::RH, 1}, {Dimension::RFH, 1}});
}

TEST_F(Deformed, AFoot1MmTooWideChangesItsWidthAndTheOffsetsToTheHead) {
  const double drop = 0.5 * 1.114491 / 15.602922;  // the foot top goes on sloping
  shift({"ABTR1"}, 0.5, -drop);
  shift({"ABTL1"}, -0.5, -drop);
  shift({"SBR", "ABBR"}, 0.5, 0);
  shift({"SBL", "ABBL"}, -0.5, 0);
  std::get<Segment>(shape("SBTR")).start += Point2(0.5, -drop);
  std::get<Segment>(shape("SBTL")).end += Point2(-0.5, -drop);
  std::get<Segment>(shape("SBB")).start.x() -= 0.5;
  std::get<Segment>(shape("SBB")).end.x() += 0.5;
  measure();
  expect({{Dimension::FW, 1},
          {Dimension::RASl, 0.5},
          {Dimension::RASr, 0.5},
          {Dimension::FTl, -drop},
          {Dimension::FTr, -drop}});
}

TEST_F(Deformed, AHeadSideMovedChangesTheHeadsWidthAndThatSide) {
  shift({"SHR", "AHTR1", "AHBR"}, 0.6, 0);
  measure();
  expect({{Dimension::HW, 0.6}, {Dimension::HWA, 0.6}, {Dimension::RASr, -0.6}});
}

TEST_F(Deformed, AHeadWornBy2MmChangesWhatIsTakenFromTheCrown) {
  shift({"AHTL2", "AHT", "AHTR2"}, 0, -2);
  measure();
  const double halfWidth = 36 + 0.05 * (157.7 - 156);  // the sides stay, they are read 2 mm lower
  const double halfAtArema = 36 + 0.05 * (157.7 - (170 - 15.875));
  const double wider = 2 * halfWidth - *bench.nominal[index(Dimension::HW)];
  expect({{Dimension::RH, -2},
          {Dimension::HW, wider},
          {Dimension::HWA, 2 * halfAtArema - *bench.nominal[index(Dimension::HWA)]},
          {Dimension::RASl, -wider / 2},
          {Dimension::RASr, -wider / 2}});
}

TEST_F(Deformed, AConvexFootIsSignedAndMovesTheBaseLineOnly) {
  // R 5000 through both ends of the flat: sagitta at 70 mm from the middle 0.49.
  Arc arc;
  const double r = 5000, half = 73;
  arc.centre = {0, std::sqrt(r * r - half * half)};
  arc.radiusMm = r;
  arc.startAngleRad = std::atan2(-arc.centre.y(), -half);
  arc.sweepRad = 2 * std::asin(half / r);
  shape("SBB") = arc;
  measure();
  const double sagitta = r - std::sqrt(r * r - 70.0 * 70.0);
  EXPECT_NEAR(*bench[Dimension::FC].valueMm, -sagitta, 0.002);
  // The base line lies where the arc is at 70 mm, a little below the flat's ends.
  const double lift = (73.0 * 73.0 - 70.0 * 70.0) / (2 * r);
  EXPECT_NEAR(*bench[Dimension::RH].valueMm, 172 + lift, 0.003);
}

TEST(Measurer, AMissingCameraIsNamedAndNothingIsInvented) {
  for (int camera = 0; camera < 4; ++camera) {
    Bench bench(section());
    ProfileRequest request;
    request.points = 5000;
    request.missingCamera = camera;
    bench.measure(synthetic::sample(bench.rail, request));
    int missing = 0;
    for (const Dimension d : kDimensions) {
      const DimensionResult& r = bench[d];
      if (r.valueMm) {
        EXPECT_NEAR(*r.valueMm, r.nominalMm, 6 * r.uMm + 1e-3) << vignole::name(d) << " camera " << camera + 1;
        continue;
      }
      ++missing;
      EXPECT_EQ(r.verdict, Verdict::NotMeasured == r.verdict ? Verdict::NotMeasured : r.verdict);
      EXPECT_NE(r.reason.find("camera " + std::to_string(camera + 1) + ": frame lost"), std::string::npos) << r.reason;
    }
    EXPECT_GE(missing, 4) << "camera " << camera + 1;
    EXPECT_NE(bench.result.verdict, Verdict::Pass);
  }
}

TEST(Measurer, AHeadAloneGivesItsWidthAndSaysWhyNotTheRest) {
  Bench bench(section());
  Profile profile = synthetic::sample(bench.rail, exact());
  const Transform2 back = exact().worldFromSection.inverse();
  std::erase_if(profile.points, [&](const ProfilePoint& p) { return (back * Point2(p.x, p.y)).y() < 138; });
  bench.measure(profile);
  for (const Dimension d : {Dimension::HW, Dimension::HWA}) {
    ASSERT_TRUE(bench[d].valueMm) << bench[d].reason;
    EXPECT_NEAR(*bench[d].valueMm, bench[d].nominalMm, 1e-3);
  }
  for (const Dimension d : {Dimension::RH, Dimension::RFH, Dimension::FW, Dimension::FTl, Dimension::RASr,
                            Dimension::WT, Dimension::FC, Dimension::HF}) {
    EXPECT_FALSE(bench[d].valueMm) << vignole::name(d);
    EXPECT_EQ(bench[d].reason, "no base line: no points on SBB") << vignole::name(d);
  }
}

TEST(Measurer, PointsThatDoNotReachTheDepthGiveNoWidth) {
  Bench bench(section());
  Profile profile = synthetic::sample(bench.rail, exact());
  const Transform2 back = exact().worldFromSection.inverse();
  std::erase_if(profile.points, [&](const ProfilePoint& p) {
    const Point2 q = back * Point2(p.x, p.y);
    return q.x() > 30 && q.y() > 130 && q.y() < 163;
  });
  bench.measure(profile);
  EXPECT_FALSE(bench[Dimension::HW].valueMm);
  EXPECT_EQ(bench[Dimension::HW].reason, "no points on SHR");
  EXPECT_FALSE(bench[Dimension::RASr].valueMm);
  EXPECT_TRUE(bench[Dimension::RASl].valueMm);
  EXPECT_TRUE(bench[Dimension::RH].valueMm);
}

TEST(Measurer, ValuesAreGivenAt15DegreesAndHotRailsAreRefused) {
  Bench bench(section());
  const Profile profile = synthetic::sample(bench.rail, exact());
  const double cold = *bench.measure(profile).dimensions[index(Dimension::RH)].valueMm;
  const double u = bench[Dimension::RH].uMm;
  bench.measure(profile, {35, 5});
  EXPECT_NEAR(*bench[Dimension::RH].valueMm, cold / (1 + 11.5e-6 * 20), 5e-5);
  EXPECT_NEAR(bench[Dimension::RH].uMm, std::hypot(u, 172 * 11.5e-6 * 5), 1e-5);
  bench.measure(profile, {300, 5});
  EXPECT_FALSE(bench[Dimension::RH].valueMm);
  EXPECT_EQ(bench[Dimension::RH].reason, "rail at 300 C: above 150 C no cold size is given");
  bench.measure(profile, {std::nan(""), 0});
  EXPECT_FALSE(bench[Dimension::RH].valueMm);
}

TEST(Measurer, DimensionsOfAHotRailAreTakenWhereTheyAreOnTheColdOne) {
  Bench bench(section());
  const Profile cold = synthetic::sample(bench.rail, exact());
  const PerDimension<DimensionResult> expected = bench.measure(cold).dimensions;
  Profile hot = cold;
  constexpr double kHotter = 100;
  for (ProfilePoint& p : hot.points) {
    p.x *= 1 + 11.5e-6 * kHotter;
    p.y *= 1 + 11.5e-6 * kHotter;
  }
  bench.measure(hot, {15 + kHotter, 0});
  // Taken at the same millimetres of the hot rail, RFH would be 0.021 mm too small.
  for (const Dimension d : kDimensions)
    EXPECT_NEAR(*bench[d].valueMm, *expected[index(d)].valueMm, d == Dimension::HR ? 0.1 : 5e-4) << vignole::name(d);
}

TEST(Measurer, AnUnregisteredProfileIsNotMeasuredForThatReason) {
  Bench bench(section());
  bench.measure({});
  for (const Dimension d : kDimensions) {
    EXPECT_FALSE(bench[d].valueMm);
    EXPECT_EQ(bench[d].reason, "only 0 points, at least 20 are needed");
  }
  EXPECT_EQ(bench.result.verdict, Verdict::NotMeasured);
}

/// Mean of (error / u)^2 over many noisy profiles: 1 if u is right.
void monteCarlo(const char* rail, double correlated, double understated, double low, double high) {
  Bench bench(section(rail));
  PerDimension<double> sum{};
  double sumMin = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    ProfileRequest request;
    request.points = 5000;
    request.noiseMm = 0.02;
    request.correlated = correlated;
    request.worldFromSection = pose(0.01 * trial, 1 - 0.01 * trial, 0.005 * trial - 1);
    request.seed = static_cast<std::uint64_t>(trial) + 9000;
    Profile profile = synthetic::sample(bench.rail, request);
    for (auto& p : profile.points) p.sigmaMm *= static_cast<float>(understated);
    bench.measure(profile);
    for (const Dimension d : kDimensions) {
      ASSERT_TRUE(bench[d].valueMm) << vignole::name(d) << bench[d].reason;
      // HR is judged on the curvature, which is what the points tell linearly.
      const double error = *bench[d].valueMm - bench[d].nominalMm, u = bench[d].uMm;
      const double z = d == Dimension::HR ? (1 / *bench[d].valueMm - 1 / bench[d].nominalMm) * *bench[d].valueMm *
                                                *bench[d].valueMm / u
                                          : error / u;
      sum[index(d)] += z * z;
    }
    sumMin += std::pow((*bench[Dimension::HF].secondMm) / bench[Dimension::HF].secondUMm, 2);
  }
  for (const Dimension d : kDimensions) {
    const double mean = sum[index(d)] / kTrials;
    EXPECT_GT(mean, low) << vignole::name(d);
    EXPECT_LT(mean, high) << vignole::name(d);
    std::printf("%s %.3f  ", std::string(vignole::name(d)).c_str(), mean);
  }
  EXPECT_NEAR(sumMin / kTrials, 1, 0.25) << "HF_min";
  std::printf("HF_min %.3f\n", sumMin / kTrials);
}

TEST(Uncertainty, AgreesWithMonteCarloForIndependentPoints) { monteCarlo("60E1", 1, 1, 0.8, 1.25); }
TEST(Uncertainty, AgreesWithMonteCarloForPointsThatShareTheirError) { monteCarlo("60E1", 9, 1, 0.8, 1.25); }
TEST(Uncertainty, AgreesOnA54E1WithItsWebOfOneArc) { monteCarlo("54E1", 9, 1, 0.8, 1.25); }
TEST(Uncertainty, AgreesOnA60E2WithFourRadii) { monteCarlo("60E2", 1, 1, 0.8, 1.25); }
TEST(Uncertainty, AgreesOnA49E5WithItsTightCrown) { monteCarlo("49E5", 9, 1, 0.8, 1.25); }
TEST(Uncertainty, AgreesOnTheShortFishingSurfacesOfAnAsymmetricRail) { monteCarlo("ASYM54", 9, 1, 0.8, 1.25); }
TEST(Uncertainty, TheScatterCorrectsSigmasThatWereTooSmall) { monteCarlo("60E1", 1, 0.5, 0.8, 1.25); }

}  // namespace
}  // namespace vignole
