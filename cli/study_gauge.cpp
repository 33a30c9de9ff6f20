// Studies of the gauge itself: type 1, linearity, repeatability and reproducibility, agreement.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/study.h"
#include "engine/quality/agreement.h"
#include "engine/quality/gauge.h"
#include "engine/quality/gauge_rr.h"

namespace vignole::cli {

namespace {

std::string indexName(const std::string& index, double k, double sigmas) {
  return index + "_K" + shortNumber(k) + "_" + shortNumber(sigmas) + "s";
}

void addIndices(Json& results, const Type1Result& r, double k, double sigmas) {
  results[indexName("Cg", k, sigmas)] = numberOrNull(r.cg);
  results[indexName("Cgk", k, sigmas)] = numberOrNull(r.cgk);
  results[indexName("pctVar_repeat", k, sigmas)] = numberOrNull(r.percentRepeatability);
  results[indexName("pctVar_repeat_bias", k, sigmas)] = numberOrNull(r.percentRepeatabilityAndBias);
}

Chart grrBars(const GrrResult& r) {
  Chart chart{"share of the total standard deviation",
              "",
              "%",
              {{"", {}, ChartColour::Value, ChartSeries::Look::Bars}},
              {},
              {}};
  for (const auto& [name, c] : {std::pair{"GRR", &r.grr}, std::pair{"repeat.", &r.repeatability},
                                std::pair{"reprod.", &r.reproducibility}, std::pair{"part", &r.part}}) {
    chart.series[0].points.emplace_back(static_cast<double>(chart.categories.size()), c->percentStudyVariation);
    chart.categories.emplace_back(name);
  }
  chart.levels = {{10, "10 %", ChartColour::Centre}, {30, "30 %", ChartColour::Limit}};
  return chart;
}

Chart readingsChart(const std::vector<GaugeReading>& readings) {
  Chart chart{"readings by part and operator", "part", "", {}, {}, {}};
  std::vector<std::string> operators;
  const auto placeOf = [](std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    names.push_back(name);
    return names.size() - 1;
  };
  constexpr std::array<ChartColour, 3> kTurn = {ChartColour::Value, ChartColour::Second, ChartColour::Third};
  for (const GaugeReading& g : readings) {
    const std::size_t o = placeOf(operators, g.operatorName);
    if (o >= chart.series.size())
      chart.series.push_back({g.operatorName, {}, kTurn.at(o % kTurn.size()), ChartSeries::Look::Dots});
    const auto x = static_cast<double>(placeOf(chart.categories, g.part));
    chart.series[o].points.emplace_back(x + 0.12 * (static_cast<double>(o % 5) - 1), g.value);
  }
  return chart;
}

Json anovaJson(const std::vector<AnovaRow>& rows) {
  Json table = Json::array();
  for (const AnovaRow& row : rows)
    table.push_back({{"source", row.source},
                     {"df", row.degrees},
                     {"SS", row.ss},
                     {"MS", row.ms},
                     {"F", numberOrNull(row.f)},
                     {"p", numberOrNull(row.p)}});
  return table;
}

void addComponent(Json& results, const std::string& name, const GrrComponent& c) {
  results["sd_" + name] = c.sd;
  results["var_" + name] = c.variance();
  results["pct_contribution_" + name] = c.percentContribution;
  results["pct_studyvar_" + name] = c.percentStudyVariation;
  results["pct_tolerance_" + name] = numberOrNull(c.percentTolerance);
}

Json anovaResults(const GrrResult& r) {
  Json j = Json::object();
  for (const AnovaRow& row : r.anova) {
    if (row.source == "total") continue;
    const std::string name = row.source == "part(operator)" ? "part" : row.source;
    j["ms_" + name] = row.ms;
    if (name == "repeatability") continue;
    j["F_" + name] = numberOrNull(row.f);
    j["p_" + name] = numberOrNull(row.p);
  }
  j["interaction_pooled"] = r.pooledMs.has_value();
  j["ms_repeatability_pooled"] = numberOrNull(r.pooledMs);
  addComponent(j, "repeatability", r.repeatability);
  addComponent(j, "reproducibility", r.reproducibility);
  addComponent(j, "operator", r.operatorAlone);
  addComponent(j, "interaction", r.interaction);
  addComponent(j, "grr", r.grr);
  addComponent(j, "part", r.part);
  addComponent(j, "total", r.total);
  j["anova"] = anovaJson(r.anova);
  return j;
}

Json rangeResults(const GrrResult& r) {
  Json j = {{"Rbarbar", r.ranges->meanRange},
            {"Xdiff", r.ranges->meanDifference},
            {"Rp", r.ranges->partRange},
            {"EV", r.repeatability.sd},
            {"AV", r.reproducibility.sd},
            {"GRR", r.grr.sd},
            {"PV", r.part.sd},
            {"TV", r.total.sd}};
  for (const auto& [name, c] : {std::pair{"EV", &r.repeatability}, std::pair{"AV", &r.reproducibility},
                                std::pair{"GRR", &r.grr}, std::pair{"PV", &r.part}}) {
    j[std::string("pct_") + name] = c->percentStudyVariation;
    j[std::string("pct_contribution_") + name] = c->percentContribution;
    j[std::string("pct_tolerance_") + name] = numberOrNull(c->percentTolerance);
  }
  j["UCL_R"] = r.ranges->rangeLimit;
  j["ranges_beyond_UCL"] = r.ranges->beyond;
  return j;
}

Expected<std::vector<GaugeReading>> readReadings(const CsvTable& table) {
  const auto part = table.column("part"), oper = table.column("operator"), trial = table.column("trial");
  for (const auto* column : {&part, &oper, &trial})
    if (!*column) return tl::unexpected(column->error());
  const auto values = table.numbers("value");
  if (!values) return tl::unexpected(values.error());
  std::vector<GaugeReading> readings;
  for (std::size_t r = 0; r < table.rows(); ++r)
    readings.push_back({table.text(r, *part), table.text(r, *oper), (*values)[r]});
  return readings;
}

bool allNumbers(const CsvTable& table, std::size_t column) {
  for (std::size_t r = 0; r < table.rows(); ++r)
    if (!table.number(r, column)) return false;
  return true;
}

Expected<StudyOutcome> studyKappa(const StudyOptions& o, const CsvTable& table, std::size_t a, std::size_t b) {
  std::vector<std::string> first, second;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    first.push_back(table.text(r, a));
    second.push_back(table.text(r, b));
  }
  const KappaWeights weights = o.method == "kappa-linear"      ? KappaWeights::Linear
                               : o.method == "kappa-quadratic" ? KappaWeights::Quadratic
                                                               : KappaWeights::None;
  const auto k = kappaStudy(first, second, weights, o.alpha);
  if (!k) return inFile(o.files.front(), k.error());
  StudyOutcome out;
  out.options = {{"file", o.files.front()}, {"method", o.method.empty() ? "kappa" : o.method}, {"alpha", o.alpha}};
  out.results = {{"n", k->n},
                 {"p_observed", k->observed},
                 {"p_expected", k->expected},
                 {"kappa", k->kappa},
                 {"se", k->se},
                 {"se_0", k->se0},
                 {"kappa_interval", rangeJson(k->interval)},
                 {"z", k->z},
                 {"p", k->p}};
  Json counts = Json::array();
  for (std::size_t i = 0; i < k->categories.size(); ++i) {
    Json row = {{"a \\ b", k->categories[i]}};
    for (std::size_t j = 0; j < k->categories.size(); ++j) row[k->categories[j]] = k->counts[i][j];
    counts.push_back(row);
  }
  out.results["counts"] = counts;
  out.notes = k->notes;
  Chart chart{"agreement by category",
              "",
              "share that agrees",
              {{"", {}, ChartColour::Value, ChartSeries::Look::Bars}},
              {},
              k->categories};
  for (std::size_t i = 0; i < k->categories.size(); ++i) {
    double row = 0;
    for (const std::size_t n : k->counts[i]) row += static_cast<double>(n);
    chart.series[0].points.emplace_back(static_cast<double>(i),
                                        row > 0 ? static_cast<double>(k->counts[i][i]) / row : 0);
  }
  out.charts.push_back(std::move(chart));
  return out;
}

}  // namespace

Expected<StudyOutcome> studyType1(const StudyOptions& o) {
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  const auto values = table->numbers("x");
  if (!values) return tl::unexpected(values.error());
  Type1Settings settings;
  settings.reference = *o.reference;
  settings.tolerance = toleranceWidth(o.tolerance);
  settings.kPercent = o.k.value_or(settings.kPercent);
  settings.sigmas = o.sigmas.value_or(settings.sigmas);
  settings.alpha = o.alpha;
  const auto r = type1Study(*values, settings);
  if (!r) return inFile(o.files.front(), r.error());
  StudyOutcome out;
  out.options = {
      {"file", o.files.front()}, {"reference", settings.reference}, {"tolerance", toleranceJson(o.tolerance)},
      {"k", settings.kPercent},  {"sigmas", settings.sigmas},       {"alpha", o.alpha}};
  out.results = {{"n", r->sample.n},    {"mean", r->sample.mean},    {"bias", r->bias},
                 {"s", r->sample.sd()}, {"Cg", numberOrNull(r->cg)}, {"Cgk", numberOrNull(r->cgk)}};
  addIndices(out.results, *r, settings.kPercent, settings.sigmas);
  // Both usual conventions stand beside the chosen one: figures of different customers compare only under one of them.
  for (const auto& [k, sigmas] : {std::pair{20.0, 6.0}, std::pair{15.0, 4.0}}) {
    settings.kPercent = k;
    settings.sigmas = sigmas;
    if (const auto other = type1Study(*values, settings)) addIndices(out.results, *other, k, sigmas);
  }
  out.results["t"] = numberOrNull(r->t);
  out.results["p"] = numberOrNull(r->p);
  out.results["ci_lo"] = numberOrNull(r->biasInterval.low);
  out.results["ci_hi"] = numberOrNull(r->biasInterval.high);
  out.notes = r->notes;
  Chart chart{"type 1 study", "sample", "", {{"", {}, ChartColour::Value, ChartSeries::Look::LineAndDots}}, {}, {}};
  for (std::size_t i = 0; i < values->size(); ++i)
    chart.series[0].points.emplace_back(static_cast<double>(i + 1), (*values)[i]);
  chart.levels.push_back({*o.reference, "reference", ChartColour::Centre});
  if (const auto t = toleranceWidth(o.tolerance)) {
    const double half = o.k.value_or(20) / 200 * *t;
    chart.levels.push_back({*o.reference + half, "+ K/2 of T", ChartColour::Limit});
    chart.levels.push_back({*o.reference - half, "- K/2 of T", ChartColour::Limit});
  }
  out.charts.push_back(std::move(chart));
  return out;
}

Expected<StudyOutcome> studyLinearity(const StudyOptions& o) {
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  const auto reference = table->numbers("reference"), value = table->numbers("value");
  if (!reference) return tl::unexpected(reference.error());
  if (!value) return tl::unexpected(value.error());
  LinearitySettings settings;
  settings.alpha = o.alpha;
  settings.processVariation = o.variation ? o.variation : toleranceWidth(o.tolerance);
  const auto r = linearityStudy(*reference, *value, settings);
  if (!r) return inFile(o.files.front(), r.error());
  StudyOutcome out;
  out.options = {
      {"file", o.files.front()}, {"alpha", o.alpha}, {"process_variation", numberOrNull(settings.processVariation)}};
  out.results = {{"n", r->line.n},
                 {"slope", r->line.slope},
                 {"intercept", r->line.intercept},
                 {"s", r->line.sdResidual},
                 {"R2", r->line.r2},
                 {"se_slope", r->line.sdSlope},
                 {"se_intercept", r->line.sdIntercept},
                 {"t_slope", numberOrNull(r->line.tSlope)},
                 {"p_slope", numberOrNull(r->line.pSlope)},
                 {"t_intercept", numberOrNull(r->line.tIntercept)},
                 {"p_intercept", numberOrNull(r->line.pIntercept)},
                 {"repeatability", r->repeatability},
                 {"bias_mean", r->bias.mean},
                 {"pct_linearity", r->percentLinearity},
                 {"linearity", numberOrNull(r->linearity)},
                 {"pct_bias", numberOrNull(r->percentBias)},
                 {"zero_in_band", r->zeroInBand}};
  Json levels = Json::array();
  Chart chart{"bias over the reference",
              "reference",
              "bias",
              {{"values", {}, ChartColour::Value, ChartSeries::Look::Dots},
               {"line", {}, ChartColour::Centre},
               {"band", {}, ChartColour::Limit},
               {"", {}, ChartColour::Limit}},
              {},
              {}};
  for (const LinearityLevel& level : r->levels)
    levels.push_back({{"reference", level.reference},
                      {"n", level.bias.n},
                      {"bias", level.bias.mean},
                      {"s", level.bias.sd()},
                      {"t", numberOrNull(level.t)},
                      {"p", numberOrNull(level.p)},
                      {"band", rangeJson(level.band)}});
  out.results["levels"] = levels;
  for (std::size_t i = 0; i < value->size(); ++i)
    chart.series[0].points.emplace_back((*reference)[i], (*value)[i] - (*reference)[i]);
  const double low = r->levels.front().reference, high = r->levels.back().reference;
  for (int i = 0; i <= 50; ++i) {
    const double x = low + (high - low) * i / 50;
    const ValueRange band = r->line.band(x, o.alpha);
    chart.series[1].points.emplace_back(x, r->line.at(x));
    chart.series[2].points.emplace_back(x, band.low);
    chart.series[3].points.emplace_back(x, band.high);
  }
  chart.levels.push_back({0, "no bias", ChartColour::Centre});
  out.charts.push_back(std::move(chart));
  out.notes = r->notes;
  return out;
}

Expected<StudyOutcome> studyGrr(const StudyOptions& o) {
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  const auto readings = readReadings(*table);
  if (!readings) return tl::unexpected(readings.error());
  GrrSettings settings;
  settings.method = o.method == "average-range" ? GrrMethod::AverageRange
                    : o.method == "nested"      ? GrrMethod::Nested
                                                : GrrMethod::Anova;
  settings.alpha = o.alpha;
  settings.sigmas = o.sigmas.value_or(settings.sigmas);
  settings.tolerance = toleranceWidth(o.tolerance);
  const auto r = grrStudy(*readings, settings);
  if (!r) return inFile(o.files.front(), r.error());
  StudyOutcome out;
  out.options = {{"file", o.files.front()},
                 {"method", o.method},
                 {"alpha", o.alpha},
                 {"sigmas", settings.sigmas},
                 {"tolerance", toleranceJson(o.tolerance)}};
  out.results = r->ranges ? rangeResults(*r) : anovaResults(*r);
  out.results["ndc_raw_1.41"] = numberOrNull(r->ndcRaw);
  out.results["ndc"] = r->ndc ? Json(*r->ndc) : Json();
  out.results["parts"] = r->parts;
  out.results["operators"] = r->operators;
  out.results["trials"] = r->trials;
  out.notes = r->notes;
  out.charts = {grrBars(*r), readingsChart(*readings)};
  return out;
}

Expected<StudyOutcome> studyAgreement(const StudyOptions& o) {
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  const auto a = table->column("a"), b = table->column("b");
  if (!a) return tl::unexpected(a.error());
  if (!b) return tl::unexpected(b.error());
  const bool words = o.method.empty() && !allNumbers(*table, *a) && !allNumbers(*table, *b);
  if (words || o.method.starts_with("kappa")) return studyKappa(o, *table, *a, *b);
  const auto first = table->numbers("a"), second = table->numbers("b");
  if (!first) return tl::unexpected(first.error());
  if (!second) return tl::unexpected(second.error());
  BlandAltmanSettings settings;
  settings.alpha = o.alpha;
  settings.method = o.method == "bland-altman-1986" ? LimitsMethod::BlandAltman1986
                    : o.method == "exact"           ? LimitsMethod::Exact
                                                    : LimitsMethod::BlandAltman1999;
  settings.sigmas = o.sigmas.value_or(settings.method == LimitsMethod::BlandAltman1986 ? 2 : settings.sigmas);
  const auto r = agreementStudy(*first, *second, settings);
  if (!r) return inFile(o.files.front(), r.error());
  const BlandAltman& d = r->differences;
  StudyOutcome out;
  out.options = {{"file", o.files.front()},
                 {"method", o.method.empty() ? "bland-altman" : o.method},
                 {"sigmas", settings.sigmas},
                 {"alpha", o.alpha}};
  out.results = {{"n", d.n},
                 {"bias", d.bias},
                 {"s", d.sd},
                 {"lower_limit", d.limits.low},
                 {"upper_limit", d.limits.high},
                 {"bias_interval", rangeJson(d.biasInterval)},
                 {"lower_limit_interval", rangeJson(d.lowerInterval)},
                 {"upper_limit_interval", rangeJson(d.upperInterval)},
                 {"t", numberOrNull(d.t)},
                 {"p", numberOrNull(d.p)},
                 {"proportional_slope", r->proportional.slope},
                 {"proportional_p", numberOrNull(r->proportional.pSlope)},
                 {"correlation", r->correlation},
                 {"concordance", r->concordance}};
  out.notes = d.notes;
  Chart chart{"difference over mean (Bland, Altman)",
              "mean of a and b",
              "a - b",
              {{"", {}, ChartColour::Value, ChartSeries::Look::Dots}},
              {{d.bias, "bias", ChartColour::Centre},
               {d.limits.low, "lower limit", ChartColour::Limit},
               {d.limits.high, "upper limit", ChartColour::Limit}},
              {}};
  for (std::size_t i = 0; i < r->means.size(); ++i) chart.series[0].points.emplace_back(r->means[i], r->difference[i]);
  out.charts.push_back(std::move(chart));
  return out;
}

}  // namespace vignole::cli
