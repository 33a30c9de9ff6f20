// Studies of a process over time: control charts and capability.

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/study.h"
#include "engine/quality/capability.h"
#include "engine/quality/control_chart.h"

namespace vignole::cli {

namespace {

/// Column x, in subgroups of consecutive or scattered rows where there is a column `subgroup`.
Expected<std::vector<Subgroup>> readSubgroups(const CsvTable& table) {
  const auto x = table.numbers("x");
  if (!x) return tl::unexpected(x.error());
  const auto column = table.find("subgroup");
  std::vector<Subgroup> groups;
  std::map<std::string, std::size_t> places;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const std::string groupName = column ? table.text(r, *column) : std::to_string(r + 1);
    const auto [place, isNew] = places.emplace(groupName, groups.size());
    if (isNew) groups.push_back({groupName, {}});
    groups[place->second].values.push_back((*x)[r]);
  }
  return groups;
}

constexpr std::size_t kLargestForRange = 10;  // above, ranges waste what the subgroup knows

std::string usualMethod(const std::vector<Subgroup>& groups) {
  std::size_t largest = 1;
  for (const Subgroup& g : groups) largest = std::max(largest, g.values.size());
  return largest == 1 ? "i-mr" : largest <= kLargestForRange ? "xbar-r" : "xbar-s";
}

ChartKind kindNamed(const std::string& method) {
  if (method == "xbar-r") return ChartKind::XbarR;
  if (method == "xbar-s") return ChartKind::XbarS;
  if (method == "ewma") return ChartKind::Ewma;
  if (method == "cusum") return ChartKind::Cusum;
  return ChartKind::IndividualsMovingRange;
}

ControlChartSettings chartSettings(const StudyOptions& o, const std::string& method) {
  ControlChartSettings s;
  s.kind = kindNamed(method);
  s.sigmas = o.sigmas.value_or(s.sigmas);
  s.rules = ruleSetNamed(o.rules).value_or(s.rules);
  s.constants = o.constants == "exact" ? ConstantPrecision::Exact : ConstantPrecision::Tabulated;
  s.target = o.reference;
  s.sigma = o.sigma;
  s.lambda = o.lambda;
  s.exactLimits = o.limits == "exact";
  s.cusumK = o.k.value_or(s.cusumK);
  s.cusumH = o.h.value_or(s.cusumH);
  return s;
}

Json violationsJson(const ControlChart& chart, const std::vector<Subgroup>& groups) {
  Json list = Json::array();
  for (const ChartPanel& panel : chart.panels)
    for (const RuleSignal& s : panel.signals) {
      const bool location = &panel == &chart.panels.front();
      list.push_back({{"panel", panel.name},
                      {"point", s.index + panel.first + 1},
                      {"subgroup", groups[s.index + panel.first].name},
                      {"rule", s.rule},
                      {"value", panel.values[s.index]},
                      {"meaning", describe(location ? chart.rules : RuleSet::Limits, s.rule)}});
    }
  return list;
}

Json pointsJson(const ControlChart& chart, const std::vector<Subgroup>& groups) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Json row = {{"subgroup", groups[i].name}, {"n", groups[i].values.size()}};
    for (const ChartPanel& p : chart.panels) {
      if (i < p.first) continue;
      row[p.name] = p.values[i - p.first];
      row["LCL_" + p.name] = p.lower[i - p.first];
      row["UCL_" + p.name] = p.upper[i - p.first];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Chart> chartsOf(const ControlChart& chart) {
  std::vector<Chart> charts;
  for (const ChartPanel& p : chart.panels) {
    Chart c{p.name + " chart", "subgroup", "", {{"", {}, ChartColour::Value, ChartSeries::Look::LineAndDots}}, {}, {}};
    c.title = p.name + " chart, " + std::to_string(p.signals.size()) + (p.signals.size() == 1 ? " signal" : " signals");
    ChartSeries lower{"", {}, ChartColour::Limit, ChartSeries::Look::Line}, upper = lower;
    ChartSeries out{"", {}, ChartColour::Out, ChartSeries::Look::Dots};
    for (std::size_t i = 0; i < p.values.size(); ++i) {
      const auto x = static_cast<double>(i + p.first + 1);
      c.series[0].points.emplace_back(x, p.values[i]);
      lower.points.emplace_back(x, p.lower[i]);
      upper.points.emplace_back(x, p.upper[i]);
    }
    for (const RuleSignal& s : p.signals)
      out.points.emplace_back(static_cast<double>(s.index + p.first + 1), p.values[s.index]);
    c.series.insert(c.series.end(), {lower, upper, out});
    c.levels = {{p.centre, "CL " + shortNumber(p.centre), ChartColour::Centre}};
    charts.push_back(std::move(c));
  }
  return charts;
}

/// The keys of the published examples, beside those that every chart has.
Json chartJson(const ControlChart& chart, const std::vector<Subgroup>& groups) {
  const ChartPanel& location = chart.panels.front();
  const bool individuals = chart.kind == ChartKind::IndividualsMovingRange;
  Json j = {{"n", chart.n}, {"subgroups", chart.subgroups}};
  j[individuals ? "xbar" : "xbarbar"] = chart.centre;
  if (chart.meanMovingRange) j["MRbar"] = *chart.meanMovingRange;
  if (chart.meanRange) j["Rbar"] = *chart.meanRange;
  if (chart.meanSd) j["sbar"] = *chart.meanSd;
  j["sigma"] = chart.sigma;
  j["UCL"] = location.ucl;
  j["LCL"] = location.lcl;
  for (std::size_t i = 1; i < chart.panels.size(); ++i) {
    j["centre_" + chart.panels[i].name] = chart.panels[i].centre;
    j["UCL_" + chart.panels[i].name] = chart.panels[i].ucl;
    j["LCL_" + chart.panels[i].name] = chart.panels[i].lcl;
  }
  j["signals"] = chart.signalCount();
  j["stable"] = chart.stable();
  j["autocorrelation"] = chart.autocorrelation;
  j["autocorrelation_limit"] = 2 / std::sqrt(static_cast<double>(chart.subgroups));
  j["violations"] = violationsJson(chart, groups);
  j["points"] = pointsJson(chart, groups);
  return j;
}

Json indexJson(const std::optional<CapabilityIndex>& index) { return index ? numberOrNull(index->value) : Json(); }
Json intervalJson(const std::optional<CapabilityIndex>& index) { return index ? rangeJson(index->interval) : Json(); }

/// Shares per class, with the limits of the tolerance as far as they lie in the picture.
Chart histogram(const std::vector<double>& values, const ToleranceZone& tolerance) {
  const Sample s = describe(values);
  const auto classes = static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(static_cast<double>(s.n))), 5.0, 40.0));
  const double width = s.range() > 0 ? s.range() / static_cast<double>(classes) : 1;
  std::vector<double> counts(classes, 0);
  for (const double v : values) ++counts[std::min(classes - 1, static_cast<std::size_t>((v - s.min) / width))];
  Chart chart{"histogram, tolerance " + (tolerance.lower ? shortNumber(*tolerance.lower) : std::string("-")) + " to " +
                  (tolerance.upper ? shortNumber(*tolerance.upper) : std::string("-")),
              "middle of the class",
              "count",
              {{"", {}, ChartColour::Value, ChartSeries::Look::Bars}},
              {},
              {}};
  for (std::size_t i = 0; i < classes; ++i) {
    chart.series[0].points.emplace_back(static_cast<double>(i), counts[i]);
    chart.categories.push_back(shortNumber(s.min + (static_cast<double>(i) + 0.5) * width));
  }
  return chart;
}

}  // namespace

Expected<StudyOutcome> studyControlChart(const StudyOptions& o) {
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  const auto groups = readSubgroups(*table);
  if (!groups) return tl::unexpected(groups.error());
  const std::string method = o.method.empty() ? usualMethod(*groups) : o.method;
  const ControlChartSettings settings = chartSettings(o, method);
  const auto chart = controlChart(*groups, settings);
  if (!chart) return inFile(o.files.front(), chart.error());
  StudyOutcome out;
  out.options = {{"file", o.files.front()},
                 {"method", method},
                 {"rules", name(settings.rules)},
                 {"sigmas", settings.sigmas},
                 {"constants", o.constants},
                 {"reference", numberOrNull(settings.target)},
                 {"sigma", numberOrNull(settings.sigma)}};
  if (chart->kind == ChartKind::Ewma) {
    out.options["lambda"] = settings.lambda;
    out.options["limits"] = o.limits;
  }
  if (chart->kind == ChartKind::Cusum) {
    out.options["k"] = settings.cusumK;
    out.options["h"] = settings.cusumH;
  }
  out.results = chartJson(*chart, *groups);
  if (const auto published = table->find("ewma_published");
      published && chart->kind == ChartKind::Ewma && chart->subgroups == table->rows()) {
    double furthest = 0;
    for (std::size_t r = 0; r < table->rows(); ++r) {
      const auto value = table->number(r, *published);
      if (!value) return tl::unexpected(value.error());
      furthest = std::max(furthest, std::abs(*value - chart->panels[0].values[r]));
    }
    out.results["max_abs_dev_from_published_series"] = furthest;
  }
  out.notes = chart->notes;
  for (int rule = 1; rule <= (settings.rules == RuleSet::Nelson            ? 8
                              : settings.rules == RuleSet::WesternElectric ? 4
                                                                           : 1);
       ++rule)
    out.notes.formulas.push_back("rule " + std::to_string(rule) + ": " + std::string(describe(settings.rules, rule)));
  out.charts = chartsOf(*chart);
  return out;
}

Expected<StudyOutcome> studyCapability(const StudyOptions& o) {
  const std::string& file = o.files.front();
  if (!o.tolerance.lower && !o.tolerance.upper)
    return inputError("--tolerance", "is needed: LO,HI (one of them may be left out: ,HI)");
  const auto table = CsvTable::load(file);
  if (!table) return tl::unexpected(table.error());
  const auto groups = readSubgroups(*table);
  if (!groups) return tl::unexpected(groups.error());
  const std::string method = o.method.empty() ? usualMethod(*groups) : o.method;
  CapabilitySettings settings;
  settings.lower = o.tolerance.lower;
  settings.upper = o.tolerance.upper;
  settings.alpha = o.alpha;
  settings.sigmas = o.sigmas.value_or(settings.sigmas);
  settings.evenIfUnstable = o.evenIfUnstable;
  settings.chart.kind = kindNamed(method);
  settings.chart.rules = ruleSetNamed(o.rules).value_or(RuleSet::Limits);
  settings.chart.constants = o.constants == "exact" ? ConstantPrecision::Exact : ConstantPrecision::Tabulated;
  settings.chart.sigma = o.sigma;
  const auto r = capabilityStudy(*groups, settings);
  if (!r) return inFile(file, r.error());
  StudyOutcome out;
  out.options = {{"file", file},
                 {"method", method},
                 {"tolerance", toleranceJson(o.tolerance)},
                 {"sigmas", settings.sigmas},
                 {"alpha", o.alpha},
                 {"rules", name(settings.chart.rules)},
                 {"constants", o.constants}};
  out.results = {{"n", r->all.n},
                 {"subgroups", r->chart.subgroups},
                 {"stable", r->stable},
                 {"mean", r->all.mean},
                 {"s", r->all.sd()},
                 {"sigma_within", r->sigmaWithin},
                 {"Cp", indexJson(r->cp)},
                 {"Cpk", indexJson(r->cpk)},
                 {"Pp", indexJson(r->pp)},
                 {"Ppk", indexJson(r->ppk)},
                 {"Cp_interval", intervalJson(r->cp)},
                 {"Cpk_interval", intervalJson(r->cpk)},
                 {"Pp_interval", intervalJson(r->pp)},
                 {"Ppk_interval", intervalJson(r->ppk)},
                 {"expected_beyond_ppm", numberOrNull(r->beyondPpm)},
                 {"observed_beyond", r->beyond},
                 {"signals", r->chart.signalCount()},
                 {"autocorrelation", r->chart.autocorrelation},
                 {"violations", violationsJson(r->chart, *groups)}};
  if (!r->stable && !o.evenIfUnstable)
    out.refused =
        "the process is not stable (see violations): an index would predict nothing; --even-if-unstable gives it "
        "all the same";
  out.notes = r->notes;
  out.charts = chartsOf(r->chart);
  std::vector<double> all;
  for (const Subgroup& g : *groups) all.insert(all.end(), g.values.begin(), g.values.end());
  out.charts.push_back(histogram(all, o.tolerance));
  return out;
}

}  // namespace vignole::cli
