#include "calibration/parameter_study/study_factors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/parameter_study/calibration_trial.h"

namespace vignole {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Expected<StudyPlan> plan(const std::string& text) { return parseStudyPlan("format = 1\n" + text, "study.toml"); }
std::string errorOf(const Expected<StudyPlan>& plan) { return plan ? "" : plan.error().message(); }

TEST(StudyPlan, ReadsNumbersAndNames) {
  const auto p = plan(
      "[fixed]\nmethod = 'paper'\nlow_dn = 5\n[design]\nmax_runs = 50\n[analysis]\nresponse = 'pd_mm'\n"
      "interactions = false\n"
      "[[factor]]\nname = 'sigma_px'\nlevels = [1.5, 3]\n[[factor]]\nname = 'fit'\nlevels = ['stable', 'direct']\n");
  ASSERT_TRUE(p) << errorOf(p);
  EXPECT_EQ(p->design.maxRuns, 50);
  EXPECT_EQ(p->analysis.primary, Response::Pd);
  EXPECT_EQ(p->analysis.order, 1);
  const auto settings = trialSettings(*p, {1, 1});
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->lines.stripe.sigma, 3);
  EXPECT_EQ(settings->lines.stripe.low, 5);
  EXPECT_EQ(settings->adjustment.method, RigMethod::Paper);
  EXPECT_EQ(settings->adjustment.paper.fit, EllipseFitVariant::Fitzgibbon);
  EXPECT_EQ(settings->exposureMs, std::nullopt);
}

TEST(StudyPlan, RefusesWithLineAndRemedy) {
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'sigma'\nlevels = [1, 2]\n")),
              AllOf(HasSubstr("study.toml:3:"), HasSubstr("names no factor: sigma; known are exposure_ms, sigma_px")));
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'sigma_px'\nlevels = [1, 20]\n")), HasSubstr("study.toml:4:"));
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'sigma_px'\nlevels = ['x', 'y']\n")), HasSubstr("a number from 1 to 8"));
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'fit'\nlevels = ['stable', 'best']\n")),
              HasSubstr("\"direct\", \"stable\", \"normalised\"") /* in any order the table has */);
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'max_ellipses'\nlevels = [6, 7.5]\n")), HasSubstr("whole number"));
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'sigma_px'\nlevels = [2]\n")), HasSubstr("two or more"));
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'sigma_px'\n")), HasSubstr("levels"));
  EXPECT_THAT(errorOf(plan("")), HasSubstr("[[factor]]"));
  EXPECT_THAT(errorOf(plan("[fixed]\nsigma_px = 2\n[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n")),
              HasSubstr("is a factor too"));
  EXPECT_THAT(errorOf(plan("[fixed]\nspeed = 2\n[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n")),
              HasSubstr("names no factor: speed"));
  EXPECT_THAT(errorOf(plan("[analysis]\nresponse = 'cd'\n[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n")),
              HasSubstr("cd_mm"));
  EXPECT_THAT(errorOf(plan("[design]\nmax_runs = 3\n[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n"
                           "[[factor]]\nname = 't_ec'\nlevels = [0.2, 0.3]\n")),
              AllOf(HasSubstr("4 runs"), HasSubstr("limit of 3")));
  EXPECT_THAT(errorOf(plan("[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\nsteps = 3\n")), HasSubstr("steps"));
}

TEST(StudyPlan, FactorsOfThePaperMeanItsMethod) {
  const std::string tEc = "[[factor]]\nname = 't_ec'\nlevels = [0.2, 0.3]\n";
  EXPECT_EQ(trialSettings(*plan(tEc), {0})->adjustment.method, RigMethod::Paper);
  EXPECT_EQ(trialSettings(*plan("[fixed]\nmethod = 'joint'\n" + tEc), {0})->adjustment.method, RigMethod::Joint);
  EXPECT_EQ(trialSettings(*plan("[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n"), {0})->adjustment.method,
            RigMethod::Joint);
}

TEST(CalibrationStudy, RefusesWhenNoFactorDoesAnything) {
  const auto p = plan("[fixed]\nmethod = 'joint'\n[[factor]]\nname = 't_ec'\nlevels = [0.2, 0.3]\n");
  ASSERT_TRUE(p) << errorOf(p);
  TrialMaterial material;
  material.placements.push_back({"nowhere", "nowhere", {}});
  const auto study = runCalibrationStudy(*p, material, {});
  ASSERT_FALSE(study);
  EXPECT_THAT(study.error().message(), HasSubstr("t_ec does nothing under the method"));
}

TEST(CalibrationStudy, ExposuresMustBeThoseOfThePlacements) {
  TrialMaterial material;
  EXPECT_THAT(checkMaterial(material, {}).error().message(), HasSubstr("no placement"));
  material.placements = {{"exposure5ms/a", "a", 5.0}, {"exposure15ms/a", "a", 15.0}};
  const auto twenty = plan("[[factor]]\nname = 'exposure_ms'\nlevels = [5, 20]\n");
  EXPECT_THAT(checkMaterial(material, *twenty).error().message(), AllOf(HasSubstr("exposure20ms"), HasSubstr("5, 15")));
  const auto sigma = plan("[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n");
  EXPECT_THAT(checkMaterial(material, *sigma).error().message(), HasSubstr("several exposures"));
  EXPECT_TRUE(checkMaterial(material, *plan("[fixed]\nexposure_ms = 15\n[[factor]]\nname = 'sigma_px'\n"
                                            "levels = [2, 3]\n")));
}

TEST(StudyPlan, ThresholdsThatContradictEachOtherAreRefusedWithTheirRun) {
  const auto p =
      plan("[[factor]]\nname = 'low_dn'\nlevels = [5, 30]\n[[factor]]\nname = 'high_dn'\nlevels = [10, 40]\n");
  ASSERT_TRUE(p) << errorOf(p);
  const auto settings = trialSettings(*p, {1, 0});
  ASSERT_FALSE(settings);
  EXPECT_THAT(settings.error().message(), HasSubstr("low_dn 30, high_dn 10"));
}

TEST(StudyPlan, TheFilesThatComeWithTheProgramAreGood) {
  for (const char* file : {"calibration.toml", "methods.toml", "association.toml"}) {
    const auto p = loadStudyPlan(std::filesystem::path(VIGNOLE_SOURCE_DIR) / "resources/studies" / file);
    ASSERT_TRUE(p) << errorOf(p);
    const auto design = factorialDesign(p->factors, p->design);
    ASSERT_TRUE(design);
    for (const Combination& run : design->runs) EXPECT_TRUE(trialSettings(*p, run));
  }
}

TEST(StudyFactors, OfThePaperDoNothingElsewhere) {
  TrialSettings settings;
  ASSERT_TRUE(applyFactor(settings, "method", "joint"));
  EXPECT_TRUE(isInert("t_ec", settings));
  EXPECT_TRUE(isInert("fit", settings));
  EXPECT_FALSE(isInert("end_margin_sigmas", settings));
  EXPECT_FALSE(isInert("sigma_px", settings));
  ASSERT_TRUE(applyFactor(settings, "method", "paper"));
  EXPECT_FALSE(isInert("t_ec", settings));
  EXPECT_TRUE(isInert("end_margin_sigmas", settings));
  ASSERT_TRUE(applyFactor(settings, "association", "robust"));
  EXPECT_TRUE(isInert("t_ec", settings)) << "a limit of the four steps";
  EXPECT_FALSE(isInert("fit", settings));
  EXPECT_FALSE(applyFactor(settings, "method", 3.0));
  EXPECT_GT(studyFactorWords().size(), 10U);
}

}  // namespace
}  // namespace vignole
