// The worked examples of the AIAG, NIST, JCGM and others, to the printed digits.

#include "tests/quality/published.h"

#include <cmath>
#include <gtest/gtest.h>

#include "engine/quality/control_chart.h"
#include "engine/quality/gauge.h"
#include "engine/quality/gauge_rr.h"
#include "engine/quality/uncertainty_budget.h"

namespace vignole {
namespace {

using testing::Published;

std::vector<GaugeReading> readings(const CsvTable& table) {
  std::vector<GaugeReading> list;
  for (std::size_t i = 0; i < table.rows(); ++i)
    list.push_back({table.text(i, 0), table.text(i, 1), table.number(i, 3).value()});
  return list;
}

TEST(PublishedExamples, GaugeStudyByAnalysisOfVariance) {
  Published p("aiag_grr_anova");
  SKIP_WITHOUT(p);
  GrrSettings settings;
  settings.tolerance = 8;
  for (const double alpha : {0.25, 0.05}) {
    settings.alpha = alpha;
    EXPECT_TRUE(grrStudy(readings(p.table()), settings)->pooledMs) << alpha;
  }
  const auto r = grrStudy(readings(p.table()), settings);
  ASSERT_TRUE(r) << r.error().message();
  p.expect("ms_part", r->anova[0].ms);
  p.expect("ms_operator", r->anova[1].ms);
  p.expect("ms_interaction", r->anova[2].ms);
  p.expect("ms_repeatability", r->anova[3].ms);
  p.expect("ms_repeatability_pooled", *r->pooledMs);
  p.expect("F_interaction", *r->anova[2].f);
  p.expect("p_interaction", *r->anova[2].p);
  for (const auto& [name, c] :
       {std::pair{"repeatability", &r->repeatability}, std::pair{"reproducibility", &r->reproducibility},
        std::pair{"grr", &r->grr}, std::pair{"part", &r->part}, std::pair{"total", &r->total}}) {
    p.expect(std::string("sd_") + name, c->sd);
    p.expect(std::string("var_") + name, c->variance());
    if (std::string(name) != "total") p.expect(std::string("pct_studyvar_") + name, c->percentStudyVariation);
  }
  p.expect("pct_contribution_grr", r->grr.percentContribution);
  p.expect("pct_contribution_part", r->part.percentContribution);
  p.expect("ndc_raw_1.41", r->ndcRaw);
  p.expect("ndc", *r->ndc);
  p.expect("pct_tolerance_grr", *r->grr.percentTolerance);
  p.expect("pct_tolerance_part", *r->part.percentTolerance);
  p.expectNothingLeft();
}

TEST(PublishedExamples, GaugeStudyByAverageAndRange) {
  Published p("aiag_grr_average_range");
  SKIP_WITHOUT(p);
  GrrSettings settings;
  settings.method = GrrMethod::AverageRange;
  const auto r = grrStudy(readings(p.table()), settings);
  ASSERT_TRUE(r) << r.error().message();
  p.expect("Rbarbar", r->ranges->meanRange);
  p.expect("Xdiff", r->ranges->meanDifference);
  p.expect("Rp", r->ranges->partRange);
  p.expect("EV", r->repeatability.sd);
  p.expect("AV", r->reproducibility.sd);
  p.expect("GRR", r->grr.sd);
  p.expect("PV", r->part.sd);
  p.expect("TV", r->total.sd);
  p.expect("pct_EV", r->repeatability.percentStudyVariation);
  p.expect("pct_AV", r->reproducibility.percentStudyVariation);
  p.expect("pct_GRR", r->grr.percentStudyVariation);
  p.expect("pct_PV", r->part.percentStudyVariation);
  p.expect("ndc", *r->ndc);
  p.expectNothingLeft();
  EXPECT_EQ(r->ranges->beyond, 1U) << "the second appraiser's fourth part";
}

TEST(PublishedExamples, Type1) {
  Published p("type1_cg_cgk");
  SKIP_WITHOUT(p);
  Type1Settings settings;
  settings.reference = -4;
  settings.tolerance = 15;
  const auto values = p.table().numbers("x").value();
  const auto wide = type1Study(values, settings);
  settings.kPercent = 15;
  settings.sigmas = 4;
  const auto narrow = type1Study(values, settings);
  ASSERT_TRUE(wide && narrow);
  p.expect("mean", wide->sample.mean);
  p.expect("bias", wide->bias);
  p.expect("s", wide->sample.sd());
  p.expect("Cg_K20_6s", *wide->cg);
  p.expect("Cgk_K20_6s", *wide->cgk);
  p.expect("pctVar_repeat_K20_6s", *wide->percentRepeatability);
  p.expect("pctVar_repeat_bias_K20_6s", *wide->percentRepeatabilityAndBias);
  p.expect("Cg_K15_4s", *narrow->cg);
  p.expect("Cgk_K15_4s", *narrow->cgk);
  p.expect("t", wide->t);
  p.expect("p", wide->p);
  p.expect("ci_lo", wide->biasInterval.low);
  p.expect("ci_hi", wide->biasInterval.high);
  p.expectNothingLeft();
}

std::vector<Subgroup> individuals(const std::vector<double>& values) {
  std::vector<Subgroup> groups;
  for (const double v : values) groups.push_back({"", {v}});
  return groups;
}

TEST(PublishedExamples, IndividualsChart) {
  Published p("nist_individuals");
  SKIP_WITHOUT(p);
  const auto chart = controlChart(individuals(p.table().numbers("x").value()));
  ASSERT_TRUE(chart) << chart.error().message();
  p.expect("xbar", chart->centre);
  p.expect("MRbar", *chart->meanMovingRange);
  p.expect("UCL", chart->panels[0].ucl);
  p.expect("LCL", chart->panels[0].lcl);
  p.expectNothingLeft();
  EXPECT_TRUE(chart->stable());
}

TEST(PublishedExamples, EwmaChart) {
  Published p("nist_ewma");
  SKIP_WITHOUT(p);
  ControlChartSettings settings;
  settings.kind = ChartKind::Ewma;
  settings.target = 50;
  settings.sigma = 2.0539;
  const auto chart = controlChart(individuals(p.table().numbers("x").value()), settings);
  ASSERT_TRUE(chart) << chart.error().message();
  const auto published = p.table().numbers("ewma_published").value();
  double furthest = 0;
  for (std::size_t i = 0; i < published.size(); ++i)
    furthest = std::max(furthest, std::abs(chart->panels[0].values[i] - published[i]));
  p.expect("UCL", chart->panels[0].ucl);
  p.expect("LCL", chart->panels[0].lcl);
  p.expect("max_abs_dev_from_published_series", furthest);
  p.expect("signals", static_cast<double>(chart->signalCount()));
  p.expectNothingLeft();
}

UncertaintyBudget endGauge(const CsvTable& table) {
  UncertaintyBudget budget;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    BudgetInput input;
    input.symbol = table.text(i, 0);
    input.estimate = table.number(i, 2).value();
    input.u = table.number(i, 3).value();
    if (const auto nu = table.optionalNumber(i, 5).value()) input.degrees = *nu;
    input.sensitivity = table.number(i, 6).value();
    budget.inputs.push_back(input);
  }
  return budget;
}

TEST(PublishedExamples, EndGaugeBudget) {
  Published p("gum_h1");
  SKIP_WITHOUT(p);
  const auto table = p.table();
  UncertaintySettings settings;
  settings.trials = 0;
  const auto r = uncertaintyStudy(endGauge(table), settings);
  ASSERT_TRUE(r) << r.error().message();
  for (std::size_t i = 0; i < table.rows(); ++i)
    EXPECT_NEAR(r->lines[i].contribution, table.number(i, 7).value(), 0.08) << table.text(i, 0);
  p.expect("l_nm", r->value);
  p.expect("uc_nm", r->uc);
  p.expect("veff_truncated", static_cast<double>(*r->truncatedDegrees));
  p.expect("k_99", r->k99);
  p.expect("U99_nm", r->u99);
  p.expect("k_95", r->k95);
  p.expectNothingLeft();
}

}  // namespace
}  // namespace vignole
