#include "calibration/parameter_study/parameter_study.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace vignole {
namespace {

std::vector<Factor> threeFactors() {
  return {{"exposure_ms", {5.0, 10.0, 15.0}}, {"sigma_px", {1.0, 2.0, 3.0}}, {"t_ec", {0.3, 0.4}}};
}

/// Centre distance in mm by a law of factors: exposure and sigma act, t_ec does nothing; chance of 5 % on each camera.
class LawfulTrial {
 public:
  explicit LawfulTrial(unsigned seed) : random_(seed) {}
  Expected<StudyRun> operator()(const Combination& c, const Job&) {
    StudyRun run;
    for (int camera = 0; camera < 4; ++camera) {
      StudyUnit unit;
      unit.camera = camera;
      unit.placement = 0;
      if (fails && fails(c, camera)) {
        unit.failure = "too few pins";
        at(unit, Response::Success) = 0;
        at(unit, Response::Association) = 0.2;
      } else {
        at(unit, Response::Success) = 1;
        at(unit, Response::Association) = 1;
        at(unit, Response::Cd) = meanCd(c) * (1 + 0.1 * camera) * std::exp(gauss_(random_));
      }
      run.units.push_back(unit);
    }
    ++runs;
    return run;
  }
  static double meanCd(const Combination& c) {
    return 0.2 * (c[0] == 0 ? 2 : c[0] == 1 ? 1 : 1.4) * (c[1] == 0 ? 1.5 : c[1] == 1 ? 1 : 1.1);
  }
  static double& at(StudyUnit& unit, Response response) { return unit.values[static_cast<std::size_t>(response)]; }

  std::function<bool(const Combination&, int camera)> fails;
  int runs = 0;

 private:
  std::mt19937 random_;
  std::normal_distribution<double> gauss_{0, 0.05};
};

ParameterStudy study(LawfulTrial& trial, const std::vector<Factor>& factors = threeFactors(),
                     const DesignSettings& design = {}) {
  auto result = runParameterStudy(*factorialDesign(factors, design), std::ref(trial), {}, {});
  EXPECT_TRUE(result) << result.error().message();
  return *std::move(result);
}

TEST(ParameterStudy, RanksTheFactorsThatActAndFindsTheBestSetting) {
  LawfulTrial trial(1);
  const ParameterStudy result = study(trial);
  EXPECT_EQ(trial.runs, 18);
  const ResponseStudy* cd = result.of(Response::Cd);
  ASSERT_NE(cd, nullptr);
  ASSERT_TRUE(cd->analysis);
  const VarianceAnalysis& a = *cd->analysis;
  EXPECT_EQ(a.terms[static_cast<std::size_t>(a.ranking[0])].name, "exposure_ms");
  EXPECT_EQ(a.terms[static_cast<std::size_t>(a.ranking[1])].name, "sigma_px");
  EXPECT_LT(a.terms[0].p, 1e-6);
  EXPECT_LT(a.terms[1].p, 1e-6);
  EXPECT_GT(a.terms[2].p, 1e-3) << "t_ec does nothing";
  // Geometric means: the ratios of the law.
  const Effect& exposure = a.effects[0];
  EXPECT_NEAR(std::exp(exposure.means[0].mean - exposure.means[1].mean), 2, 4 * 2 * exposure.means[0].standardError);
  EXPECT_NEAR(exposure.means[0].standardError, 0.05 / std::sqrt(24.0), 0.003);

  ASSERT_TRUE(cd->best);
  EXPECT_EQ(cd->best->combination[0], 1);
  EXPECT_EQ(cd->best->combination[1], 1);
  EXPECT_TRUE(cd->best->confirmed) << cd->best->remark;
  EXPECT_EQ(cd->best->observations, 4);
  EXPECT_NEAR(cd->best->observed / cd->best->foretold.mean, 1, 0.15);
  EXPECT_EQ(result.unitsFailed, 0);
  EXPECT_EQ(result.unitsTried, 72);
}

TEST(ParameterStudy, OfEqualSettingsThePreferredIsTaken) {
  int preferred = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    LawfulTrial trial(seed);
    const ParameterStudy result = study(trial);
    const BestSetting& best = *result.of(Response::Cd)->best;
    EXPECT_EQ(best.ties.front(), best.combination);
    preferred += best.combination[2] == 0 ? 1 : 0;
  }
  EXPECT_GT(preferred, 14) << "t_ec does nothing: its first level is taken unless chance is beyond one standard error";
}

TEST(ParameterStudy, FailuresAreCountedAndNeverRecommended) {
  LawfulTrial trial(3);
  // The best setting of the law fails in one camera.
  trial.fails = [](const Combination& c, int camera) { return c[0] == 1 && c[1] == 1 && camera == 2; };
  const ParameterStudy result = study(trial);
  EXPECT_EQ(result.unitsFailed, 2);
  EXPECT_EQ(result.failures.at("too few pins"), 2);
  EXPECT_THAT(result.remarks, testing::Contains(testing::HasSubstr("2 of 72 cameras")));
  const ResponseStudy* cd = result.of(Response::Cd);
  EXPECT_EQ(cd->observations, 70);
  EXPECT_FALSE(cd->analysis->balanced);
  EXPECT_NE(std::pair(cd->best->combination[0], cd->best->combination[1]), std::pair(1, 1));
  EXPECT_EQ(result.of(Response::Success)->observations, 72);
  EXPECT_NEAR(result.of(Response::Success)->analysis->mean, 70.0 / 72, 1e-12);
}

TEST(ParameterStudy, EverythingFailingIsSaidNotHidden) {
  LawfulTrial trial(4);
  trial.fails = [](const Combination&, int) { return true; };
  const ParameterStudy result = study(trial);
  EXPECT_EQ(result.unitsFailed, 72);
  EXPECT_EQ(result.of(Response::Cd), nullptr);
  ASSERT_NE(result.of(Response::Success), nullptr);
  EXPECT_EQ(result.of(Response::Success)->analysis->mean, 0);
}

TEST(ParameterStudy, AFractionRunsItsBestSettingToConfirmIt) {
  std::vector<Factor> factors = threeFactors();
  factors.push_back({"max_ellipses", {4.0, 6.0, 8.0}});
  int confirmed = 0, unplanned = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    LawfulTrial trial(seed);
    const ParameterStudy result = study(trial, factors, {256, 27});
    EXPECT_EQ(result.design.runs.size(), 27U);
    const BestSetting& best = *result.of(Response::Cd)->best;
    EXPECT_EQ(best.combination[0], 1) << seed;
    EXPECT_GT(best.observations, 0);
    confirmed += best.confirmed ? 1 : 0;
    const bool extra = result.runs.size() == 28;
    unplanned += extra ? 1 : 0;
    EXPECT_EQ(result.runs.back().confirmation, extra);
  }
  EXPECT_GT(unplanned, 0);
  EXPECT_GE(confirmed, 10) << "95 % intervals";
}

TEST(ParameterStudy, AnErrorOfTheWorldEndsItAndCancellingToo) {
  const auto design = *factorialDesign(threeFactors());
  const StudyTrial broken = [](const Combination&, const Job&) -> Expected<StudyRun> {
    return worldError("disk", "is gone");
  };
  EXPECT_EQ(runParameterStudy(design, broken, {}, {}).error().message(), "disk: is gone");
  std::stop_source stop;
  LawfulTrial trial(1);
  double last = -1;
  Job job{[&](double share, std::string_view) {
            EXPECT_GE(share, last);
            last = share;
            if (share > 0.5) stop.request_stop();
          },
          stop.get_token()};
  const auto cancelled = runParameterStudy(design, std::ref(trial), {}, job);
  ASSERT_FALSE(cancelled);
  EXPECT_THAT(cancelled.error().message(), testing::HasSubstr("cancelled"));
  EXPECT_GT(trial.runs, 5);
  EXPECT_LT(trial.runs, 18);
}

TEST(ParameterStudy, TableHasARowForEveryUnit) {
  LawfulTrial trial(3);
  trial.fails = [](const Combination& c, int camera) { return c[0] == 0 && camera == 2; };
  const std::string csv = toCsv(study(trial));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 72);
  EXPECT_THAT(csv,
              testing::StartsWith("run,exposure_ms,sigma_px,t_ec,camera,placement,confirmation,same_as_run,refusal,"
                                  "failure,success,association,cd_mm,rd_mm,pd_mm,pd_nominal_mm,reprojection_px,"
                                  "dimension_u_mm,time_s\n1,5,1,0.3,1,1,no,,,,1,1,"));
  EXPECT_THAT(csv, testing::HasSubstr("\n1,5,1,0.3,3,1,no,,,too few pins,0,0.2,,,,,,,\n"));
}

TEST(ResponseNames, AreFoundAgain) {
  for (const Response response : kResponses) EXPECT_EQ(responseNamed(name(response)), response);
  EXPECT_EQ(responseNamed("cd"), std::nullopt);
}

}  // namespace
}  // namespace vignole
