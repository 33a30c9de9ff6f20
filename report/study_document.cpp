#include "report/study_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace vignole {
namespace {

constexpr std::size_t kBarsShown = 8, kInteractionsShown = 4;

[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...) {
  std::array<char, 256> buffer{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  va_end(arguments);
  return buffer.data();
}

std::string valueText(double value) { return std::isfinite(value) ? printed("%.4g", value) : std::string("-"); }

std::string pText(double p) {
  if (!std::isfinite(p)) return "-";
  return p < 1e-4 ? "< 0.0001" : printed("%.4f", p);
}

std::string intervalText(const ScaledMean& m) {
  return valueText(m.mean) + (std::isfinite(m.low) ? " (" + valueText(m.low) + " to " + valueText(m.high) + ")" : "");
}

std::vector<std::string> levelWords(const ParameterStudy& study, int factor) {
  std::vector<std::string> all;
  for (const FactorLevel& level : study.design.factors[static_cast<std::size_t>(factor)].levels)
    all.push_back(words(level));
  return all;
}

/// A mean and the bar of one standard error, at x.
void addMean(const ScaledMean& m, double x, int colour, Curve& line, std::vector<Curve>& bars) {
  if (!std::isfinite(m.mean)) return;
  line.points.emplace_back(x, m.mean);
  if (std::isfinite(m.low)) bars.push_back({"", {{x, m.low}, {x, m.high}}, colour, true, 1.5});
}

Plot mainEffectPlot(const ParameterStudy& study, const ResponseStudy& response, const Effect& effect) {
  Plot plot;
  plot.title = effect.name;
  plot.yLabel = std::string(name(response.response));
  plot.categories = levelWords(study, effect.factors[0]);
  Curve line{"", {}, 5, true, 2};
  std::vector<Curve> bars;
  for (const EffectMean& mean : effect.means)
    addMean(response.scaled(mean.mean, mean.standardError), mean.levels[0], 5, line, bars);
  Curve dots = line;
  dots.line = false;
  dots.dotPx = 6;
  plot.curves = {line, dots};
  plot.curves.insert(plot.curves.end(), bars.begin(), bars.end());
  return plot;
}

/// One line for every level of the second factor, over the levels of the first.
Plot interactionPlot(const ParameterStudy& study, const ResponseStudy& response, const Effect& effect) {
  Plot plot;
  plot.title = effect.name;
  plot.yLabel = std::string(name(response.response));
  plot.categories = levelWords(study, effect.factors[0]);
  const std::vector<std::string> second = levelWords(study, effect.factors[1]);
  const std::string& factor = study.design.factors[static_cast<std::size_t>(effect.factors[1])].name;
  for (std::size_t level = 0; level < second.size(); ++level) {
    Curve line{factor + " " + second[level], {}, static_cast<int>(level % 4), true, 2};
    std::vector<Curve> bars;
    for (const EffectMean& mean : effect.means)
      if (mean.levels[1] == static_cast<int>(level))
        addMean(response.scaled(mean.mean, mean.standardError), mean.levels[0], line.colour, line, bars);
    plot.curves.push_back(line);
    plot.curves.insert(plot.curves.end(), bars.begin(), bars.end());
  }
  return plot;
}

/// Pareto: influence in per cent, largest first.
Plot influencePlot(const VarianceAnalysis& analysis) {
  Plot plot;
  plot.title = "Influence";
  plot.yLabel = "eta squared, %";
  plot.bars = true;
  Curve bars{"", {}, 5, true, 2};
  for (std::size_t i = 0; i < std::min(kBarsShown, analysis.ranking.size()); ++i) {
    const VarianceLine& line = analysis.terms[static_cast<std::size_t>(analysis.ranking[i])];
    bars.points.emplace_back(static_cast<double>(i), 100 * line.share);
    plot.categories.push_back(line.name);
  }
  plot.curves = {bars};
  return plot;
}

TableBlock varianceTable(const VarianceAnalysis& a) {
  TableBlock table;
  table.title = "Analysis of variance";
  table.heads = {"<source", "sum of squares", "dof", "mean square", "F", "p", "eta squared"};
  const auto add = [&](const VarianceLine& line, bool tested) {
    table.rows.push_back({line.name, valueText(line.squares), std::to_string(line.dof), valueText(line.meanSquare),
                          tested ? printed("%.2f", line.f) : "", tested ? pText(line.p) : "",
                          tested ? printed("%.1f %%", 100 * line.share) : ""});
  };
  for (const int i : a.ranking) add(a.terms[static_cast<std::size_t>(i)], true);
  if (a.blocks.dof > 0) add(a.blocks, false);
  add(a.error, false);
  add(a.total, false);
  for (const std::string& remark : a.remarks) table.note += (table.note.empty() ? "" : "; ") + remark;
  return table;
}

std::vector<Plot> interactionPlots(const ParameterStudy& study, const ResponseStudy& response) {
  std::vector<Plot> plots;
  for (const int i : response.analysis->ranking) {
    const Effect& effect = response.analysis->effects[static_cast<std::size_t>(i)];
    if (effect.factors.size() == 2 && plots.size() < kInteractionsShown)
      plots.push_back(interactionPlot(study, response, effect));
  }
  return plots;
}

void addResponse(const ParameterStudy& study, const ResponseStudy& response, bool plots, Document& document) {
  document.blocks.push_back(Heading{std::string(longName(response.response))});
  if (!response.analysis) {
    document.blocks.push_back(Paragraph{"not analysed: " + response.whyNot, true});
    return;
  }
  const VarianceAnalysis& a = *response.analysis;
  document.blocks.push_back(
      FactList{{{"Observations", std::to_string(response.observations)},
                {response.logarithmic ? "Geometric mean" : "Mean", valueText(response.scaled(a.mean, 0).mean)},
                {"Error, degrees of freedom", std::to_string(a.error.dof)}}});
  if (response.best)
    document.blocks.push_back(Paragraph{"Best setting: " + words(study.design.factors, response.best->combination) +
                                            "; predicted " + intervalText(response.best->predicted) + ", its own run " +
                                            valueText(response.best->observed),
                                        false});
  if (plots) {
    PlotBlock main{"Main effects", 3, 0.8, {}, "means over all other factors; bars: one standard error"};
    for (const Effect& effect : a.effects)
      if (effect.factors.size() == 1) main.plots.push_back(mainEffectPlot(study, response, effect));
    document.blocks.push_back(PlotBlock{"", 1, 0.4, {influencePlot(a)}, "share of what the runs differ by"});
    document.blocks.push_back(main);
    if (auto crossed = interactionPlots(study, response); !crossed.empty())
      document.blocks.push_back(
          PlotBlock{"Interactions", 2, 0.7, crossed, "lines that do not run in parallel: the factors act together"});
  }
  document.blocks.push_back(varianceTable(a));
}

VerdictLine verdictOf(const ParameterStudy& study) {
  const ResponseStudy* primary = study.of(study.primary);
  if (primary == nullptr || !primary->best)
    return {Standing::Bad, "No setting can be recommended", "no run yields " + std::string(longName(study.primary))};
  const BestSetting& best = *primary->best;
  return {best.confirmed ? Standing::Good : Standing::Near, words(study.design.factors, best.combination),
          std::string(longName(study.primary)) + ": " + intervalText(best.predicted) + " predicted, " +
              valueText(best.observed) + " in its own run; " + (best.confirmed ? "confirmed" : best.remark)};
}

Plot exposurePlot(const ExposureAdvice& advice, const char* title, const char* unit, double ExposureRow::*value) {
  Plot plot;
  plot.title = title;
  plot.xLabel = "exposure, ms";
  plot.yLabel = unit;
  Curve line{"", {}, 5, true, 2}, dots{"", {}, 5, false, 6}, chosen{"recommended", {}, 2, false, 9};
  for (const ExposureRow& row : advice.rows) {
    line.points.emplace_back(row.exposureMs, row.*value);
    if (advice.exposureMs == row.exposureMs) chosen.points.emplace_back(row.exposureMs, row.*value);
  }
  dots.points = line.points;
  plot.curves = {line, dots};
  if (!chosen.points.empty()) plot.curves.push_back(chosen);
  return plot;
}

}  // namespace

Document studyDocument(const ParameterStudy& study, const std::string& subject) {
  Document document;
  document.title = "Parameter study";
  document.subject = subject;
  document.blocks.push_back(verdictOf(study));
  document.blocks.push_back(
      FactList{{{"Runs", std::to_string(study.design.runs.size()) + " of " + std::to_string(study.design.fullRuns)},
                {"Cameras in placements", std::to_string(study.unitsTried)},
                {"of these failed", std::to_string(study.unitsFailed)},
                {"Runs refused", std::to_string(study.runsRefused)}}});
  for (const std::string& remark : study.remarks) document.blocks.push_back(Paragraph{remark, true});
  if (!study.failures.empty()) {
    TableBlock table{"Failures", {"<reason", "times"}, {}, {}, ""};
    for (const auto& [reason, times] : study.failures) table.rows.push_back({reason, std::to_string(times)});
    document.blocks.push_back(table);
  }
  if (const ResponseStudy* primary = study.of(study.primary)) addResponse(study, *primary, true, document);
  for (const ResponseStudy& response : study.responses)
    if (response.response != study.primary) addResponse(study, response, false, document);
  return document;
}

Document exposureDocument(const ExposureAdvice& advice, const std::string& subject) {
  Document document;
  document.title = "Exposure for rails";
  document.subject = subject;
  std::string why;
  for (std::size_t i = 0; i < advice.reasons.size() && i < 2; ++i) why += (i == 0 ? "" : "; ") + advice.reasons[i];
  document.blocks.push_back(advice.exposureMs ? VerdictLine{Standing::Good, printed("%g ms", *advice.exposureMs), why}
                                              : VerdictLine{Standing::Bad, "No exposure can be recommended", why});
  for (std::size_t i = 2; i < advice.reasons.size(); ++i) document.blocks.push_back(Paragraph{advice.reasons[i], true});
  const bool known = std::any_of(advice.rows.begin(), advice.rows.end(), [](const auto& r) { return r.sigmaMm > 0; });
  TableBlock table{"Over exposure",
                   {"exposure ms", "clipped", "S/N", "weak S/N", "found", known ? "u mm" : "u px", "blur mm",
                    "highest Hz", "mm a profile"},
                   {},
                   {},
                   "u: standard uncertainty of a point across the line; blur: by motion"};
  for (const ExposureRow& r : advice.rows) {
    table.rows.push_back({printed("%g", r.exposureMs), printed("%.2f %%", 100 * r.saturatedMax), printed("%.1f", r.snr),
                          printed("%.1f", r.weakSnr), printed("%.1f %%", 100 * r.coverage),
                          printed("%.4f", known ? r.sigmaMm : r.sigmaPx), printed("%.4f", r.blurMm),
                          printed("%.1f", r.highestRateHz), printed("%.1f", r.spacingMm)});
    table.standings.push_back(r.limits.empty() ? Standing::Good : Standing::Bad);
  }
  document.blocks.push_back(table);
  document.blocks.push_back(
      PlotBlock{"",
                2,
                0.62,
                {exposurePlot(advice, "Uncertainty of the line", known ? "mm" : "px",
                              known ? &ExposureRow::sigmaMm : &ExposureRow::sigmaPx),
                 exposurePlot(advice, "Contrast over noise at the weakest 5 %", "", &ExposureRow::weakSnr),
                 exposurePlot(advice, "Smear by motion", "mm", &ExposureRow::blurMm),
                 exposurePlot(advice, "Highest trigger rate", "Hz", &ExposureRow::highestRateHz)},
                ""});
  return document;
}

}  // namespace vignole
