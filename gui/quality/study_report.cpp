#include "gui/quality/study_report.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/theme/inscription.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

/// Whose words these are, for translators.
struct StudyReport {
  Q_DECLARE_TR_FUNCTIONS(StudyReport)
};
QString shown(const std::string& text) { return QString::fromStdString(text); }
std::string plain(const QString& text) { return text.toStdString(); }

QString percent(double value) { return numberText(value, 1) + QStringLiteral(" %"); }

QString findingOf(const OutlierTest& test) {
  switch (test.standout) {
    case Standout::None:
      return StudyReport::tr("no outlier");
    case Standout::Straggler:
      return StudyReport::tr("straggler (5 %)");
    case Standout::Outlier:
      return StudyReport::tr("outlier (1 %)");
  }
  return {};
}

void addTest(std::vector<std::pair<QString, QString>>& rows, const QString& name,
             const std::optional<OutlierTest>& test) {
  if (!test) return;
  rows.emplace_back(name, StudyReport::tr("%1: %2, critical %3 at 1 %")
                              .arg(findingOf(*test), numberText(test->statistic, 3), numberText(test->critical1, 3)));
}

void addNotes(std::vector<std::pair<QString, QString>>& rows, const StudyNotes& notes) {
  for (const auto& [name, value] : notes.constants) rows.emplace_back(shown(name), QString::number(value, 'g', 5));
  for (const std::string& formula : notes.formulas) rows.emplace_back(shown(formula), QString());
}

TableBlock repeatabilityTable(const RunsStudy& study) {
  TableBlock table;
  table.title = plain(StudyReport::tr("Mean range of the runs, mm, per %1 m (Table VI)").arg(study.sectionM));
  table.heads = {"<" + plain(StudyReport::tr("Dimension"))};
  const RepeatabilityResult* any = nullptr;
  for (const DimensionStudy& d : study.dimensions)
    if (d.repeatability && (any == nullptr || d.repeatability->sections.size() > any->sections.size()))
      any = &*d.repeatability;
  const std::size_t sections = any == nullptr ? 0 : any->sections.size();
  for (std::size_t s = 0; s < sections; ++s)
    table.heads.push_back(plain(QStringLiteral("%1 m").arg(any->sections[s].toM)));
  for (const QString& head :
       {StudyReport::tr("mean"), QStringLiteral("s r"), QStringLiteral("r"), StudyReport::tr("share of T, %")})
    table.heads.push_back(plain(head));
  for (const Dimension d : kDimensions) {
    const DimensionStudy& is = study.dimensions[index(d)];
    std::vector<std::string> row = {plain(spoken(d))};
    for (std::size_t s = 0; s < sections; ++s)
      row.push_back(is.repeatability && s < is.repeatability->sections.size()
                        ? plain(numberText(is.repeatability->sections[s].meanRangeMm, 4))
                        : "-");
    if (is.repeatability)
      for (const double v : {is.repeatability->meanRangeMm, is.repeatability->srMm, is.repeatability->rMm})
        row.push_back(plain(numberText(v, 4)));
    else
      row.insert(row.end(), 3, "-");
    row.push_back(is.sharePercent ? plain(numberText(*is.sharePercent, 1)) : "-");
    table.rows.push_back(std::move(row));
    table.standings.push_back(!is.sharePercent                           ? Standing::None
                              : *is.sharePercent <= kAllowedSharePercent ? Standing::Good
                                                                         : Standing::Bad);
  }
  return table;
}

TableBlock accuracyTable(const RunsStudy& study) {
  TableBlock table;
  table.title = plain(StudyReport::tr("Errors against the reference, mm (Table V)"));
  table.heads = {"<" + plain(StudyReport::tr("Dimension")),
                 "n",
                 plain(StudyReport::tr("bias")),
                 "RMS",
                 plain(StudyReport::tr("largest")),
                 plain(StudyReport::tr("largest, %")),
                 plain(StudyReport::tr("E_n above 1"))};
  for (const Dimension d : kDimensions) {
    const auto& accuracy = study.dimensions[index(d)].accuracy;
    std::vector<std::string> row = {plain(spoken(d))};
    if (accuracy) {
      const AccuracyFigures& f = accuracy->whole;
      row.push_back(std::to_string(f.n));
      row.push_back(plain(deviationText(f.bias, 4)));
      row.push_back(plain(numberText(f.rms, 4)));
      row.push_back(plain(deviationText(f.max, 4)));
      row.push_back(f.maxPercent && percentMeans(d) ? plain(deviationText(*f.maxPercent, 3)) : "-");
      row.push_back(accuracy->en.empty()
                        ? "-"
                        : std::to_string(accuracy->enBeyond1) + " / " + std::to_string(accuracy->en.size()));
    } else {
      row.insert(row.end(), 6, "-");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Plot valuesPlot(const RepeatabilityResult& r, Dimension dimension) {
  Plot plot;
  plot.title = plain(StudyReport::tr("%1: values of the runs").arg(spoken(dimension)));
  plot.xLabel = plain(StudyReport::tr("length, m"));
  plot.yLabel = "mm";
  for (std::size_t run = 0; run < r.runs.size(); ++run) {
    Curve curve{r.runs[run], {}, static_cast<int>(run % 5), true, 1};
    for (std::size_t i = 0; i < r.positionM.size(); ++i) curve.points.emplace_back(r.positionM[i], r.valueMm[run][i]);
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Plot rangePlot(const RepeatabilityResult& r, Dimension dimension) {
  Plot plot;
  plot.title = plain(StudyReport::tr("%1: range of the runs").arg(spoken(dimension)));
  plot.xLabel = plain(StudyReport::tr("length, m"));
  plot.yLabel = "mm";
  Curve range{"", {}, 4, true, 1};
  for (std::size_t i = 0; i < r.positionM.size(); ++i) range.points.emplace_back(r.positionM[i], r.rangeMm[i]);
  plot.curves = {std::move(range)};
  for (const RepeatabilitySection& s : r.sections)
    plot.curves.push_back(
        {"", {{s.fromM, s.meanRangeMm}, {std::min(s.toM, r.positionM.back()), s.meanRangeMm}}, 5, true, 2});
  return plot;
}

Plot errorPlot(const AccuracyResult& r, Dimension dimension) {
  Plot plot;
  plot.title = plain(StudyReport::tr("%1: error at each position").arg(spoken(dimension)));
  plot.xLabel = plain(StudyReport::tr("length, m"));
  plot.yLabel = "mm";
  Curve bias{plain(StudyReport::tr("mean of the runs")), {}, 4, false, 3};
  for (std::size_t i = 0; i < r.positionM.size(); ++i) bias.points.emplace_back(r.positionM[i], r.perPosition[i].bias);
  plot.curves = {std::move(bias)};
  return plot;
}

}  // namespace

StudyVerdict verdictOf(const RunsStudy& study, RunsStudyKind kind) {
  if (kind == RunsStudyKind::Repeatability) {
    const auto worst = study.worstShare();
    if (!worst)
      return {Standing::None, StudyReport::tr("No verdict"),
              StudyReport::tr("no dimension has both a tolerance and figures")};
    const double share = *study.dimensions[index(*worst)].sharePercent;
    const bool good = share <= kAllowedSharePercent;
    return {good ? Standing::Good : Standing::Bad,
            good ? StudyReport::tr("Repeatable") : StudyReport::tr("Not repeatable"),
            StudyReport::tr("%1 uses the largest share of its tolerance, %2; allowed are %3 %")
                .arg(spoken(*worst), percent(share))
                .arg(kAllowedSharePercent)};
  }
  const auto worst = study.worstAgreement();
  if (!worst)
    return {Standing::None, StudyReport::tr("No verdict"),
            StudyReport::tr(
                "uncertainties of values and reference are both needed for E_n; the figures stand by themselves")
                .replace('_', ' ')};
  const AccuracyResult& r = *study.dimensions[index(*worst)].accuracy;
  const double share = static_cast<double>(r.enBeyond1) / static_cast<double>(r.en.size());
  const double allowed = allowedBeyond(r.en.size());
  const bool good = share <= allowed;
  return {good ? Standing::Good : Standing::Bad, good ? StudyReport::tr("Agrees") : StudyReport::tr("Does not agree"),
          StudyReport::tr("worst is %1: E n above 1 in %2 of its %3 values; chance allows %4")
              .arg(spoken(*worst), percent(100 * share), count(r.en.size()), percent(100 * allowed))};
}

std::vector<std::pair<QString, QString>> figuresOf(const RepeatabilityResult& r, Dimension dimension) {
  const int decimals = decimalsOf(dimension) + 1;
  const auto mm = [&](double value) { return numberText(value, decimals) + QStringLiteral(" mm"); };
  std::vector<std::pair<QString, QString>> rows = {
      {StudyReport::tr("Runs and positions"),
       QStringLiteral("%1 · %2").arg(r.runs.size()).arg(count(r.positionM.size()))},
      {StudyReport::tr("Repeatability s r"), mm(r.srMm)},
      {StudyReport::tr("its 95 % interval"),
       StudyReport::tr("%1 to %2").arg(numberText(r.srIntervalMm.low, decimals), mm(r.srIntervalMm.high))},
      {StudyReport::tr("Limit r = 2.8 s r"), mm(r.rMm)},
      {StudyReport::tr("Mean and largest range"),
       StudyReport::tr("%1 and %2").arg(numberText(r.meanRangeMm, decimals), mm(r.maxRangeMm))},
      {StudyReport::tr("s from the range"), mm(r.srFromRangeMm)},
      {StudyReport::tr("Autocorrelation"), numberText(r.autocorrelation, 2)}};
  if (r.dropped > 0) rows.emplace_back(StudyReport::tr("Left out: a run lacks them"), count(r.dropped));
  addTest(rows, StudyReport::tr("Grubbs, means of the runs"), r.grubbsRuns);
  addTest(rows, StudyReport::tr("Cochran, scatter of the runs"), r.cochranRuns);
  addNotes(rows, r.notes);
  return rows;
}

std::vector<std::pair<QString, QString>> figuresOf(const AccuracyResult& r, Dimension dimension) {
  const int decimals = decimalsOf(dimension) + 1;
  const auto mm = [&](double value) { return deviationText(value, decimals) + QStringLiteral(" mm"); };
  const auto range = [&](const ValueRange& v) {
    return StudyReport::tr("%1 to %2").arg(deviationText(v.low, decimals), mm(v.high));
  };
  std::vector<std::pair<QString, QString>> rows = {
      {StudyReport::tr("Runs and positions"), QStringLiteral("%1 · %2").arg(r.runs).arg(count(r.positions))},
      {StudyReport::tr("Bias"), mm(r.whole.bias)}};
  if (r.biasInterval) rows.emplace_back(StudyReport::tr("its 95 % interval"), range(*r.biasInterval));
  rows.emplace_back(StudyReport::tr("RMS error"), numberText(r.whole.rms, decimals) + QStringLiteral(" mm"));
  rows.emplace_back(StudyReport::tr("Largest error"), mm(r.whole.max));
  if (r.whole.maxPercent && percentMeans(dimension))
    rows.emplace_back(StudyReport::tr("in % of the reference"), deviationText(*r.whole.maxPercent, 3));
  if (r.agreement) {
    rows.emplace_back(StudyReport::tr("Limits of agreement"), range(r.agreement->limits));
    rows.emplace_back(StudyReport::tr("interval of the lower"), range(r.agreement->lowerInterval));
    rows.emplace_back(StudyReport::tr("interval of the upper"), range(r.agreement->upperInterval));
  }
  if (!r.en.empty()) {
    rows.emplace_back(StudyReport::tr("Largest E n"), numberText(r.enMax, 2));
    rows.emplace_back(StudyReport::tr("E n above 1"),
                      StudyReport::tr("%1 of %2").arg(count(r.enBeyond1), count(r.en.size())));
  }
  addNotes(rows, r.notes);
  return rows;
}

Document studyReport(const RunsStudy& study, RunsStudyKind kind, Dimension chosen, const Recipe& recipe,
                     const QString& conditions, bool simulation) {
  const bool repeatability = kind == RunsStudyKind::Repeatability;
  Document document;
  document.title = plain(repeatability ? StudyReport::tr("Repeatability study") : StudyReport::tr("Accuracy study"));
  document.subject = recipe.name + " v" + std::to_string(recipe.version);
  document.foot = "ISO 5725";
  document.simulation = simulation;
  std::string runs;
  for (const std::string& run : study.runs) runs += (runs.empty() ? "" : ", ") + run;
  FactList facts;
  facts.facts = {
      {plain(StudyReport::tr("Runs")), std::to_string(study.runs.size())},
      {plain(StudyReport::tr("Section")), recipe.section.name},
      {plain(StudyReport::tr("Tolerances")), recipe.name + " v" + std::to_string(recipe.version)},
      {plain(StudyReport::tr("Values")), plain(study.windowM > 0 ? StudyReport::tr("means over %1 m").arg(study.windowM)
                                                                 : StudyReport::tr("single profiles"))}};
  if (!repeatability) facts.facts.emplace_back(plain(StudyReport::tr("Reference")), study.reference);
  document.blocks.emplace_back(std::move(facts));
  // Whole sentences: a column of facts would cut them.
  document.blocks.emplace_back(Paragraph{plain(StudyReport::tr("Runs: %1.").arg(shown(runs))), true});
  document.blocks.emplace_back(Paragraph{plain(StudyReport::tr("Conditions: %1.").arg(conditions)), true});
  const StudyVerdict verdict = verdictOf(study, kind);
  document.blocks.emplace_back(VerdictLine{verdict.standing, plain(verdict.word), plain(verdict.reason)});
  document.blocks.emplace_back(repeatability ? repeatabilityTable(study) : accuracyTable(study));
  std::vector<std::pair<QString, QString>> figures;
  PlotBlock plots;
  const DimensionStudy& is = study.dimensions[index(chosen)];
  if (repeatability && is.repeatability) {
    plots.title = plain(StudyReport::tr("%1 over the length, as Fig. 9").arg(spoken(chosen)));
    plots.plots = {valuesPlot(*is.repeatability, chosen), rangePlot(*is.repeatability, chosen)};
    figures = figuresOf(*is.repeatability, chosen);
  } else if (!repeatability && is.accuracy) {
    plots.title = plain(StudyReport::tr("%1 against its reference").arg(spoken(chosen)));
    plots.plots = {errorPlot(*is.accuracy, chosen)};
    figures = figuresOf(*is.accuracy, chosen);
  }
  plots.aspect = 0.35;
  if (!plots.plots.empty()) document.blocks.emplace_back(std::move(plots));
  if (!figures.empty()) {
    document.blocks.emplace_back(Heading{plain(StudyReport::tr("Figures of %1").arg(spoken(chosen)))});
    FactList list;
    for (const auto& [label, value] : figures) {
      if (value.isEmpty()) continue;
      list.facts.emplace_back(plain(label), plain(value));
    }
    document.blocks.emplace_back(std::move(list));
    for (const auto& [label, value] : figures)
      if (value.isEmpty()) document.blocks.emplace_back(Paragraph{plain(label), true});
  }
  return document;
}

}  // namespace vignole
