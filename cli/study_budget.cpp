// Uncertainty budgets and conformity with a tolerance.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/study.h"
#include "engine/quality/model_expression.h"
#include "engine/quality/uncertainty_budget.h"

namespace vignole::cli {

namespace {

/// "sensitivity_nm_per_unit" or "sensitivity": the column, and the unit of the measurand that it tells.
struct SensitivityColumn {
  std::optional<std::size_t> column;
  std::string unit;
};

SensitivityColumn sensitivityColumn(const CsvTable& table) {
  const std::string head = "sensitivity", tail = "_per_unit";
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    std::string column = table.columns()[c];
    if (!column.starts_with(head)) continue;
    column.erase(0, head.size());
    if (column.ends_with(tail)) column.erase(column.size() - tail.size());
    if (column.starts_with('_')) column.erase(0, 1);
    return {c, column};
  }
  return {};
}

Expected<UncertaintyBudget> readBudget(const CsvTable& table, const StudyOptions& o) {
  const auto symbol = table.column("symbol"), estimate = table.column("estimate"), u = table.column("u");
  for (const auto* column : {&symbol, &estimate, &u})
    if (!*column) return tl::unexpected(column->error());
  const auto description = table.find("description"), unit = table.find("unit"), dof = table.find("dof"),
             distribution = table.find("distribution");
  const SensitivityColumn sensitivity = sensitivityColumn(table);
  if (!sensitivity.column && o.model.empty())
    return inputError(table.file() + ":1",
                      "has no column sensitivity_<unit>_per_unit; add it, or give the model with --model");
  UncertaintyBudget budget;
  budget.measurand = o.measurand;
  budget.unit = sensitivity.unit;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    BudgetInput input;
    input.symbol = table.text(r, *symbol);
    if (description) input.description = table.text(r, *description);
    if (unit) input.unit = table.text(r, *unit);
    const auto x = table.number(r, *estimate), ux = table.number(r, *u);
    if (!x) return tl::unexpected(x.error());
    if (!ux) return tl::unexpected(ux.error());
    if (*ux < 0) return inputError(table.where(r), "u is negative; a standard uncertainty is 0 or more");
    input.estimate = *x;
    input.u = *ux;
    if (dof && table.text(r, *dof) != "inf") {
      const auto nu = table.optionalNumber(r, *dof);
      if (!nu) return tl::unexpected(nu.error());
      if (*nu && !(**nu > 0)) return inputError(table.where(r), "dof must be above 0; empty is infinite");
      if (*nu) input.degrees = **nu;
    }
    if (sensitivity.column) {
      const auto c = table.optionalNumber(r, *sensitivity.column);
      if (!c) return tl::unexpected(c.error());
      if (!*c && o.model.empty())
        return inputError(table.where(r), "its sensitivity is empty; a number is needed, 0 included");
      input.sensitivity = c->value_or(1);
    }
    if (distribution) {
      const auto known = inputDistributionNamed(table.text(r, *distribution));
      if (!known)
        return inputError(table.where(r), "distribution '" + table.text(r, *distribution).substr(0, 40) +
                                              "' is none of auto, t, normal, rectangular, triangular, arcsine");
      input.distribution = *known;
    }
    budget.inputs.push_back(std::move(input));
  }
  return budget;
}

Json monteCarloJson(const std::optional<MonteCarlo>& m) {
  if (!m) return nullptr;
  return {{"trials", m->trials},       {"mean", numberOrNull(m->mean)},
          {"u", numberOrNull(m->u)},   {"interval_95", rangeJson(m->interval95)},
          {"tolerance", m->tolerance}, {"first_order_agrees", m->agrees}};
}

Chart contributionsChart(const UncertaintyBudget& budget, const UncertaintyResult& r) {
  Chart chart{"contributions to the uncertainty",
              "",
              budget.unit,
              {{"", {}, ChartColour::Value, ChartSeries::Look::Bars}},
              {{r.uc, "u = " + shortNumber(r.uc), ChartColour::Centre}},
              {}};
  for (std::size_t i = 0; i < r.lines.size(); ++i) {
    chart.series[0].points.emplace_back(static_cast<double>(i), r.lines[i].contribution);
    chart.categories.push_back(budget.inputs[i].symbol);
  }
  return chart;
}

Json risksJson(const ConformityRisks& risks) {
  return {{"consumer_risk", risks.consumer}, {"producer_risk", risks.producer}, {"share_bad", risks.bad}};
}

}  // namespace

Expected<StudyOutcome> studyUncertainty(const StudyOptions& o) {
  const std::string& file = o.files.front();
  const auto table = CsvTable::load(file);
  if (!table) return tl::unexpected(table.error());
  auto budget = readBudget(*table, o);
  if (!budget) return tl::unexpected(budget.error());
  if (!o.model.empty()) {
    std::vector<std::string> symbols;
    for (const BudgetInput& i : budget->inputs) symbols.push_back(i.symbol);
    auto model = ModelExpression::parse(o.model, symbols);
    if (!model) return inFile("--model", model.error());
    budget->model = std::move(*model);
  }
  UncertaintySettings settings;
  settings.k = o.k.value_or(settings.k);
  settings.trials = o.trials;
  settings.seed = o.seed;
  const auto r = uncertaintyStudy(*budget, settings);
  if (!r) return inFile(file, r.error());
  const std::string unit = budget->unit.empty() ? "" : "_" + budget->unit;
  StudyOutcome out;
  out.options = {{"file", file},
                 {"k", settings.k},
                 {"trials", settings.trials},
                 {"seed", settings.seed},
                 {"measurand", o.measurand},
                 {"model", o.model.empty() ? Json("sum of sensitivity x estimate") : Json(o.model)}};
  out.results[o.measurand + unit] = r->value;
  out.results["uc" + unit] = r->uc;
  out.results["veff"] = numberOrNull(r->degrees);
  out.results["veff_truncated"] = r->truncatedDegrees ? Json(*r->truncatedDegrees) : Json();
  out.results["k_95"] = r->refused ? Json() : numberOrNull(r->k95);
  out.results["k_99"] = r->refused ? Json() : numberOrNull(r->k99);
  out.results["U95" + unit] = r->refused ? Json() : numberOrNull(r->u95);
  out.results["U99" + unit] = r->refused ? Json() : numberOrNull(r->u99);
  out.results["U" + unit] = r->refused ? Json() : numberOrNull(r->expanded);
  if (const auto t = toleranceWidth(o.tolerance); t && !r->refused) {
    out.options["tolerance"] = toleranceJson(o.tolerance);
    out.results["Q_MS_pct"] = 100 * 2 * r->expanded / *t;
    out.notes.formulas.emplace_back("Q_MS = 2 U / T (VDA 5), at most 15 %");
  }
  out.results["monte_carlo"] = monteCarloJson(r->monteCarlo);
  Json lines = Json::array();
  for (std::size_t i = 0; i < r->lines.size(); ++i)
    lines.push_back({{"symbol", budget->inputs[i].symbol},
                     {"estimate", budget->inputs[i].estimate},
                     {"u", budget->inputs[i].u},
                     {"dof", numberOrNull(budget->inputs[i].degrees)},
                     {"sensitivity", r->lines[i].sensitivity},
                     {"contribution", r->lines[i].contribution},
                     {"pct", r->lines[i].percent}});
  out.results["contributions"] = lines;
  if (r->refused)
    out.refused =
        "first order gives u = 0 (every sensitivity vanishes, or nothing is uncertain); take the Monte Carlo of the "
        "model (--model)";
  const auto own = out.notes.formulas;
  out.notes = r->notes;
  out.notes.formulas.insert(out.notes.formulas.end(), own.begin(), own.end());
  out.charts.push_back(contributionsChart(*budget, *r));
  return out;
}

Expected<StudyOutcome> studyConformity(const StudyOptions& o) {
  if (!o.tolerance.lower && !o.tolerance.upper)
    return inputError("--tolerance", "is needed: LO,HI (one of them may be left out: ,HI)");
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  const auto values = table->numbers("value"), u = table->numbers("u");
  if (!values) return tl::unexpected(values.error());
  if (!u) return tl::unexpected(u.error());
  const double guard = o.sigmas.value_or(kGuardSigmas);
  StudyOutcome out;
  out.options = {{"file", o.files.front()}, {"tolerance", toleranceJson(o.tolerance)}, {"sigmas", guard}};
  Json rows = Json::array();
  std::array<std::size_t, 3> counts{};
  Chart chart{"measured values with their guard bands",
              "value",
              "",
              {{"value", {}, ChartColour::Value, ChartSeries::Look::Dots}},
              {},
              {}};
  for (std::size_t i = 0; i < values->size(); ++i) {
    if ((*u)[i] < 0) return inputError(table->where(i), "u is negative; a standard uncertainty is 0 or more");
    const Conformity verdict = conformity((*values)[i], (*u)[i], o.tolerance, guard);
    const ToleranceZone zone = acceptanceZone((*u)[i], o.tolerance, guard);
    ++counts.at(static_cast<std::size_t>(verdict));
    rows.push_back({{"value", (*values)[i]},
                    {"u", (*u)[i]},
                    {"verdict", name(verdict)},
                    {"p_conforms", conformanceProbability((*values)[i], (*u)[i], o.tolerance)},
                    {"accept_from", numberOrNull(zone.lower)},
                    {"accept_to", numberOrNull(zone.upper)}});
    chart.series[0].points.emplace_back(static_cast<double>(i + 1), (*values)[i]);
  }
  out.results = {{"n", values->size()},
                 {"conforms", counts[0]},
                 {"does_not_conform", counts[1]},
                 {"cannot_be_decided", counts[2]}};
  const double meanU = meanOf(*u);
  // The spread of the process: given, or that of the values without what measuring adds.
  const Sample s = describe(*values);
  const ProcessSpread process{o.processMean.value_or(s.mean),
                              o.processSd.value_or(std::sqrt(std::max(0.0, s.variance() - meanU * meanU)))};
  if (process.sd > 0 && meanU > 0) {
    out.results["risks_without_guard"] = risksJson(conformityRisks(process, meanU, o.tolerance, o.tolerance));
    out.results["risks_with_guard"] =
        risksJson(conformityRisks(process, meanU, o.tolerance, acceptanceZone(meanU, o.tolerance, guard)));
    out.options["process_mean"] = process.mean;
    out.options["process_sd"] = process.sd;
  }
  out.results["values"] = rows;
  out.notes.formulas = {
      "conforms: LO + g u <= value <= HI - g u; does not: value < LO - g u or value > HI + g u; else it cannot "
      "be decided (ISO 14253-1)",
      "p_conforms = P(LO <= N(value, u) <= HI) (JCGM 106, 7)",
      "consumer risk = P(bad and accepted), producer risk = P(good and rejected): normal process, u = mean of "
      "the column (JCGM 106, 9.5)"};
  out.notes.constants = {{"g", guard}};
  for (const auto& [limit, words] : {std::pair{o.tolerance.lower, "LO"}, std::pair{o.tolerance.upper, "HI"}})
    if (limit) chart.levels.push_back({*limit, words, ChartColour::Limit});
  out.charts.push_back(std::move(chart));
  return out;
}

}  // namespace vignole::cli
