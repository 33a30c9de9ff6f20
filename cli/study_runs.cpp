// Studies of a rail measured several times: repeatability, accuracy; and precision of groups after ISO 5725.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "cli/study.h"
#include "engine/quality/accuracy.h"
#include "engine/quality/precision.h"
#include "engine/quality/repeatability.h"

namespace vignole::cli {

namespace {

Json testJson(const std::optional<OutlierTest>& test, const std::vector<std::string>& names) {
  if (!test) return nullptr;
  Json suspects = Json::array();
  for (const std::size_t i : test->where) suspects.push_back(i < names.size() ? Json(names[i]) : Json(i));
  Json j = {{"statistic", numberOrNull(test->statistic)},
            {"critical_5pct", numberOrNull(test->critical5)},
            {"critical_1pct", numberOrNull(test->critical1)},
            {"finding", name(test->standout)}};
  j["suspect"] = suspects.size() == 1 ? suspects[0] : suspects;
  return j;
}

Json mandelJson(const std::optional<Mandel>& mandel, const std::vector<std::string>& names) {
  if (!mandel) return nullptr;
  Json rows = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i)
    rows.push_back({{"name", names[i]}, {"h", mandel->h[i]}, {"k", mandel->k[i]}});
  return {
      {"h_5pct", mandel->h5}, {"h_1pct", mandel->h1}, {"k_5pct", mandel->k5}, {"k_1pct", mandel->k1}, {"values", rows}};
}

/// Columns of a profile table that are no dimensions.
bool isDimension(const std::string& column) {
  static const std::set<std::string> kOthers = {"run",     "position_m", "rail",    "profile",
                                                "trigger", "rms_mm",     "inliers", "flags"};
  return !kOthers.contains(column) && !column.starts_with("u_");
}

using RunsOfDimension = std::map<std::string, std::vector<RepeatabilityRun>>;

/// Adds one file; without a column `run`, the file is a run of its own.
Expected<void> readRuns(const std::string& file, RunsOfDimension& runs, std::vector<std::string>& order) {
  const auto table = CsvTable::load(file);
  if (!table) return tl::unexpected(table.error());
  const auto position = table->column("position_m");
  if (!position) return tl::unexpected(position.error());
  const auto run = table->find("run");
  const std::string ownName = std::filesystem::path(file).stem().string();
  bool any = false;
  for (std::size_t c = 0; c < table->columns().size(); ++c) {
    const std::string& dimension = table->columns()[c];
    if (!isDimension(dimension)) continue;
    any = true;
    if (std::find(order.begin(), order.end(), dimension) == order.end()) order.push_back(dimension);
    std::vector<RepeatabilityRun>& list = runs[dimension];
    std::map<std::string, std::size_t> places;
    for (std::size_t r = 0; r < table->rows(); ++r) {
      const auto at = table->number(r, *position);
      if (!at) return tl::unexpected(at.error());
      const auto value = table->optionalNumber(r, c);
      if (!value) return tl::unexpected(value.error());
      const std::string runName = run ? table->text(r, *run) : ownName;
      auto place = places.find(runName);
      if (place == places.end()) {
        place = places.emplace(runName, list.size()).first;
        list.push_back({runName, {}, {}});
      }
      list[place->second].positionM.push_back(*at);
      list[place->second].valueMm.push_back(value->value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  }
  if (!any) return inputError(file + ":1", "has no column of a dimension beside run and position_m");
  return {};
}

Json repeatabilityJson(const std::string& dimension, const RepeatabilityResult& r) {
  Json sections = Json::array(), consistency = Json::array();
  for (const RepeatabilitySection& s : r.sections) {
    sections.push_back(
        {{"from_m", s.fromM}, {"to_m", s.toM}, {"positions", s.positions}, {"mean_range", s.meanRangeMm}});
    if (!s.consistency) continue;
    const Mandel& m = *s.consistency;
    for (std::size_t i = 0; i < r.runs.size(); ++i)
      consistency.push_back({{"from_m", s.fromM},
                             {"to_m", s.toM},
                             {"run", r.runs[i]},
                             {"h", m.h[i]},
                             {"h_5pct", m.h5},
                             {"h_1pct", m.h1},
                             {"k", m.k[i]},
                             {"k_5pct", m.k5},
                             {"k_1pct", m.k1}});
  }
  Json runs = Json::array();
  for (std::size_t i = 0; i < r.runs.size(); ++i)
    runs.push_back({{"run", r.runs[i]}, {"n", r.perRun[i].n}, {"mean", r.perRun[i].mean}, {"s", r.perRun[i].sd()}});
  Json positions = Json::array();
  for (const double at : r.positionM) positions.push_back(at);
  std::vector<std::string> places;
  for (const double at : r.positionM) places.push_back(shortNumber(at) + " m");
  return {{"name", dimension},
          {"runs", r.runs.size()},
          {"positions", r.positionM.size()},
          {"positions_dropped", r.dropped},
          {"n", r.runs.size() * r.positionM.size()},
          {"mean", r.meanMm},
          {"mean_range", r.meanRangeMm},
          {"max_range", r.maxRangeMm},
          {"s_r", r.srMm},
          {"s_r_interval", rangeJson(r.srIntervalMm)},
          {"degrees_of_freedom", r.degrees},
          {"s_r_from_range", r.srFromRangeMm},
          {"r", r.rMm},
          {"autocorrelation", r.autocorrelation},
          {"sections", sections},
          {"per_run", runs},
          {"mandel", consistency},
          {"grubbs_runs", testJson(r.grubbsRuns, r.runs)},
          {"double_grubbs_runs", testJson(r.doubleGrubbsRuns, r.runs)},
          {"cochran_runs", testJson(r.cochranRuns, r.runs)},
          {"cochran_positions", testJson(r.cochranPositions, places)},
          {"position_m", positions},
          {"range", r.rangeMm}};
}

/// The paper's Table VI: a row a section, a column a dimension.
void addToTable(Json& table, const std::string& dimension, const RepeatabilityResult& r) {
  for (const RepeatabilitySection& s : r.sections) {
    const auto row = std::find_if(table.begin(), table.end(), [&](const Json& t) { return t["to_m"] == s.toM; });
    Json& target = row != table.end() ? *row : table.emplace_back(Json{{"to_m", s.toM}});
    target[dimension] = s.meanRangeMm;
  }
}

/// The paper's Fig. 9: values over the length with the limits, ranges over the length.
void addCharts(std::vector<Chart>& charts, const std::string& dimension, const RepeatabilityResult& r,
               const ToleranceZone& tolerance) {
  Chart values{dimension + ": values of " + std::to_string(r.runs.size()) + " runs", "length, m", "mm", {}, {}, {}};
  constexpr std::array<ChartColour, 3> kTurn = {ChartColour::Value, ChartColour::Second, ChartColour::Third};
  for (std::size_t i = 0; i < r.runs.size(); ++i) {
    ChartSeries s{r.runs[i], {}, kTurn.at(i % kTurn.size()), ChartSeries::Look::Line};
    for (std::size_t p = 0; p < r.positionM.size(); ++p) s.points.emplace_back(r.positionM[p], r.valueMm[i][p]);
    values.series.push_back(std::move(s));
  }
  if (tolerance.lower) values.levels.push_back({*tolerance.lower, "lower limit", ChartColour::Limit});
  if (tolerance.upper) values.levels.push_back({*tolerance.upper, "upper limit", ChartColour::Limit});
  charts.push_back(std::move(values));
  Chart ranges{dimension + ": range of the runs", "length, m", "mm", {{"", {}}}, {}, {}};
  for (std::size_t p = 0; p < r.positionM.size(); ++p)
    ranges.series[0].points.emplace_back(r.positionM[p], r.rangeMm[p]);
  ranges.levels.push_back({r.meanRangeMm, "mean " + shortNumber(r.meanRangeMm), ChartColour::Centre});
  charts.push_back(std::move(ranges));
}

Json figuresJson(const AccuracyFigures& f) {
  return {{"n", f.n},
          {"bias", f.bias},
          {"rms", f.rms},
          {"max", f.max},
          {"s", f.sd},
          {"bias_pct", numberOrNull(f.biasPercent)},
          {"rms_pct", numberOrNull(f.rmsPercent)},
          {"max_pct", numberOrNull(f.maxPercent)}};
}

Json agreementJson(const BlandAltman& a) {
  return {{"limits", rangeJson(a.limits)},
          {"bias_interval", rangeJson(a.biasInterval)},
          {"lower_limit_interval", rangeJson(a.lowerInterval)},
          {"upper_limit_interval", rangeJson(a.upperInterval)}};
}

Json accuracyJson(const std::string& dimension, const AccuracyResult& r) {
  Json j = {{"name", dimension}};
  j.update(figuresJson(r.whole));
  j["positions"] = r.positions;
  j["runs"] = r.runs;
  j["bias_interval"] = r.biasInterval ? rangeJson(*r.biasInterval) : Json();
  if (!r.en.empty()) {
    j["en_max"] = r.enMax;
    j["en_beyond_1"] = r.enBeyond1;
    j["en_points"] = r.en.size();
  }
  if (r.agreement) j["bland_altman"] = agreementJson(*r.agreement);
  j["per_position"] = Json::array();
  for (std::size_t i = 0; i < r.positionM.size(); ++i) {
    Json row = {{"position_m", r.positionM[i]}};
    row.update(figuresJson(r.perPosition[i]));
    j["per_position"].push_back(row);
  }
  return j;
}

using PointsOfDimension = std::map<std::string, std::vector<AccuracyPoint>>;

Expected<PointsOfDimension> readPoints(const CsvTable& table, std::vector<std::string>& order) {
  std::map<std::string, std::size_t> at;
  for (const char* column : {"dimension", "position_m", "run", "value", "reference"}) {
    const auto found = table.column(column);
    if (!found) return tl::unexpected(found.error());
    at[column] = *found;
  }
  const auto u = table.find("u_value"), uReference = table.find("u_reference");
  PointsOfDimension points;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    AccuracyPoint p;
    p.run = table.text(r, at["run"]);
    for (const auto& [column, target] :
         {std::pair{"position_m", &p.positionM}, std::pair{"value", &p.value}, std::pair{"reference", &p.reference}}) {
      const auto value = table.number(r, at[column]);
      if (!value) return tl::unexpected(value.error());
      *target = *value;
    }
    for (const auto& [column, target] : {std::pair{u, &p.u}, std::pair{uReference, &p.uReference}}) {
      if (!column) continue;
      const auto value = table.optionalNumber(r, *column);
      if (!value) return tl::unexpected(value.error());
      *target = value->value_or(0);
    }
    const std::string& dimension = table.text(r, at["dimension"]);
    if (std::find(order.begin(), order.end(), dimension) == order.end()) order.push_back(dimension);
    points[dimension].push_back(std::move(p));
  }
  if (points.empty()) return inputError(table.file(), "has a header but no rows");
  return points;
}

/// The dimensions asked for, or all; an unknown one is an error.
Expected<std::vector<std::string>> chosen(const std::vector<std::string>& all, const std::vector<std::string>& wanted) {
  if (wanted.empty()) return all;
  for (const std::string& w : wanted)
    if (std::find(all.begin(), all.end(), w) == all.end()) {
      std::string known;
      for (const std::string& a : all) known += (known.empty() ? "" : ", ") + a;
      return inputError("--dimension", "'" + w + "' is not in the file; there are " + known);
    }
  return wanted;
}

}  // namespace

Expected<StudyOutcome> studyRepeatability(const StudyOptions& o) {
  RunsOfDimension runs;
  std::vector<std::string> order;
  for (const std::string& file : o.files)
    if (auto read = readRuns(file, runs, order); !read) return tl::unexpected(read.error());
  const auto dimensions = chosen(order, o.dimensions);
  if (!dimensions) return tl::unexpected(dimensions.error());
  StudyOutcome out;
  out.options = {{"files", o.files}, {"section_m", o.sectionM}, {"window_m", o.windowM}, {"alpha", o.alpha}};
  out.results["mean_range_per_section"] = Json::array();
  out.results["dimensions"] = Json::array();
  RepeatabilitySettings settings;
  settings.sectionM = o.sectionM;
  settings.alpha = o.alpha;
  for (const std::string& dimension : *dimensions) {
    settings.windowM = 0;
    const auto single = repeatabilityStudy(runs[dimension], settings);
    if (!single) return inFile(o.files.front() + ", " + dimension, single.error());
    Json j = repeatabilityJson(dimension, *single);
    addToTable(out.results["mean_range_per_section"], dimension, *single);
    addCharts(out.charts, dimension, *single, o.tolerance);
    if (o.windowM > 0) {
      settings.windowM = o.windowM;
      const auto windows = repeatabilityStudy(runs[dimension], settings);
      if (!windows) return inFile(o.files.front() + ", " + dimension, windows.error());
      j["windows"] = repeatabilityJson(dimension, *windows);
      j["windows"].erase("name");
    }
    out.results["dimensions"].push_back(std::move(j));
    out.notes = single->notes;
  }
  // The window is an option of the study, not of the figures over single profiles.
  std::erase_if(out.notes.constants, [](const auto& c) { return c.first == "window_m"; });
  return out;
}

Expected<StudyOutcome> studyAccuracy(const StudyOptions& o) {
  const auto table = CsvTable::load(o.files.front());
  if (!table) return tl::unexpected(table.error());
  std::vector<std::string> order;
  auto points = readPoints(*table, order);
  if (!points) return tl::unexpected(points.error());
  const auto dimensions = chosen(order, o.dimensions);
  if (!dimensions) return tl::unexpected(dimensions.error());
  BlandAltmanSettings settings;
  settings.alpha = o.alpha;
  settings.sigmas = o.sigmas.value_or(settings.sigmas);
  StudyOutcome out;
  out.options = {{"file", o.files.front()}, {"alpha", o.alpha}, {"sigmas", settings.sigmas}};
  out.results["dimensions"] = Json::array();
  for (const std::string& dimension : *dimensions) {
    const auto r = accuracyStudy((*points)[dimension], settings);
    if (!r) return inFile(o.files.front() + ", " + dimension, r.error());
    out.results["dimensions"].push_back(accuracyJson(dimension, *r));
    out.notes = r->notes;
    Chart chart{dimension + ": value - reference",
                "length, m",
                "mm",
                {{"", {}, ChartColour::Value, ChartSeries::Look::Dots}},
                {},
                {}};
    for (const AccuracyPoint& p : (*points)[dimension])
      chart.series[0].points.emplace_back(p.positionM, p.value - p.reference);
    chart.levels.push_back({r->whole.bias, "bias " + shortNumber(r->whole.bias), ChartColour::Centre});
    if (r->agreement) {
      chart.levels.push_back({r->agreement->limits.low, "lower limit", ChartColour::Limit});
      chart.levels.push_back({r->agreement->limits.high, "upper limit", ChartColour::Limit});
    }
    out.charts.push_back(std::move(chart));
  }
  return out;
}

Expected<StudyOutcome> studyPrecision(const StudyOptions& o) {
  const std::string& file = o.files.front();
  const auto table = CsvTable::load(file);
  if (!table) return tl::unexpected(table.error());
  const auto group = table->column("group");
  if (!group) return tl::unexpected(group.error());
  const auto values = table->numbers("value");
  if (!values) return tl::unexpected(values.error());
  const auto level = table->find("level");
  std::map<std::string, std::vector<PrecisionGroup>> levels;
  std::vector<std::string> order;
  for (std::size_t r = 0; r < table->rows(); ++r) {
    const std::string levelName = level ? table->text(r, *level) : "";
    if (std::find(order.begin(), order.end(), levelName) == order.end()) order.push_back(levelName);
    std::vector<PrecisionGroup>& groups = levels[levelName];
    const std::string& groupName = table->text(r, *group);
    auto found =
        std::find_if(groups.begin(), groups.end(), [&](const PrecisionGroup& g) { return g.name == groupName; });
    if (found == groups.end()) found = groups.insert(groups.end(), {groupName, {}});
    found->values.push_back((*values)[r]);
  }
  StudyOutcome out;
  out.options = {{"file", file}, {"alpha", o.alpha}};
  out.results["levels"] = Json::array();
  for (const std::string& levelName : order) {
    const auto r = precisionStudy(levels[levelName], o.alpha);
    if (!r) return inFile(levelName.empty() ? file : file + ", level " + levelName, r.error());
    std::vector<std::string> names;
    Json groups = Json::array();
    Chart chart{levelName + " means of the groups",
                "group",
                "",
                {{"", {}, ChartColour::Value, ChartSeries::Look::Dots}},
                {},
                {}};
    for (std::size_t i = 0; i < r->groups.size(); ++i) {
      names.push_back(levels[levelName][i].name);
      groups.push_back(
          {{"group", names.back()}, {"n", r->groups[i].n}, {"mean", r->groups[i].mean}, {"s", r->groups[i].sd()}});
      chart.series[0].points.emplace_back(static_cast<double>(i), r->groups[i].mean);
    }
    chart.categories = names;
    chart.levels.push_back({r->mean, "mean", ChartColour::Centre});
    out.charts.push_back(std::move(chart));
    out.results["levels"].push_back({{"level", levelName},
                                     {"n", r->n},
                                     {"mean", r->mean},
                                     {"s_r", r->sr},
                                     {"s_r_interval", rangeJson(r->srInterval)},
                                     {"s_L", r->sL},
                                     {"s_R", r->sR},
                                     {"r", r->r},
                                     {"R", r->R},
                                     {"ms_between", r->msBetween},
                                     {"ms_within", r->msWithin},
                                     {"F", numberOrNull(r->f)},
                                     {"p", numberOrNull(r->p)},
                                     {"groups", groups},
                                     {"cochran", testJson(r->cochranTest, names)},
                                     {"grubbs", testJson(r->grubbsTest, names)},
                                     {"double_grubbs", testJson(r->doubleGrubbsTest, names)},
                                     {"mandel", mandelJson(r->consistency, names)}});
    out.notes = r->notes;
  }
  return out;
}

}  // namespace vignole::cli
