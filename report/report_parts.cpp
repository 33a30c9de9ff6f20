#include "report/report_parts.h"

#include <QDateTime>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QPen>
#include <QTextOption>
#include <QTimeZone>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "report/dimension_text.h"
#include "report/drawing_words.h"
#include "report/engine_words.h"
#include "report/state_symbol.h"
#include "report/typeface.h"

namespace vignole {

namespace {

double scaleOf(const QPainter& painter) { return std::clamp(QFontInfo(painter.font()).pixelSize() / 16.0, 0.4, 4.0); }

QString text(const std::string& s) { return s.empty() ? QStringLiteral("\u2013") : QString::fromStdString(s); }

QColor softOf(Verdict verdict, const Palette& palette) {
  switch (verdict) {
    case Verdict::Fail:
      return palette.outSoft;
    case Verdict::Near:
      return palette.nearSoft;
    case Verdict::NotMeasured:
      return palette.invalidSoft;
    case Verdict::Pass:
    case Verdict::NoLimit:
      break;
  }
  return palette.panel;
}

QColor barOf(Verdict verdict, const Palette& palette) {
  switch (verdict) {
    case Verdict::Fail:
      return palette.out;
    case Verdict::Near:
      return palette.near;
    case Verdict::NotMeasured:
      return palette.invalid;
    case Verdict::Pass:
    case Verdict::NoLimit:
      break;
  }
  return palette.t3;
}

bool abnormal(Verdict v) { return v == Verdict::Fail || v == Verdict::Near || v == Verdict::NotMeasured; }

/// How much of its half tolerance a dimension uses at its worst, 0 .. 1 within the limits.
double toleranceUsed(const DimensionSummary& s) {
  if (s.values.count() == 0) return 0;
  double used = 0;
  if (s.upperMm && *s.upperMm > s.nominalMm)
    used = std::max(used, (s.values.max() - s.nominalMm) / (*s.upperMm - s.nominalMm));
  if (s.lowerMm && *s.lowerMm < s.nominalMm)
    used = std::max(used, (s.nominalMm - s.values.min()) / (s.nominalMm - *s.lowerMm));
  return used;
}

double rankOf(const DimensionSummary& s) {
  switch (s.verdict) {
    case Verdict::Fail:
      return 300 + std::min(99.0, toleranceUsed(s));
    case Verdict::NotMeasured:
      return 200;
    case Verdict::Near:
      return 100 + std::min(99.0, toleranceUsed(s));
    case Verdict::Pass:
      return 10 + std::min(80.0, toleranceUsed(s));
    case Verdict::NoLimit:
      break;
  }
  return 0;
}

void addNames(TextRuns& runs, const std::vector<Dimension>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) runs.emplace_back(i + 1 == names.size() ? Drawing::tr(" and ") : QStringLiteral(", "));
    runs.emplace_back(names[i]);
  }
}

// --- the table of dimensions ---------------------------------------------------------------------------------------

enum class Column { State, Name, Nominal, Mean, Min, Max, S, U, Expanded, Limits, Exceptions };
struct ColumnLayout {
  Column column;
  const char* head;
  double weight;
};
constexpr ColumnLayout kColumns[] = {{Column::State, QT_TRANSLATE_NOOP("Drawing", "State"), 128},
                                     {Column::Name, QT_TRANSLATE_NOOP("Drawing", "Dimension"), 84},
                                     {Column::Nominal, QT_TRANSLATE_NOOP("Drawing", "Nominal"), 80},
                                     {Column::Mean, QT_TRANSLATE_NOOP("Drawing", "Mean"), 80},
                                     {Column::Min, QT_TRANSLATE_NOOP("Drawing", "Min"), 80},
                                     {Column::Max, QT_TRANSLATE_NOOP("Drawing", "Max"), 80},
                                     {Column::S, "s", 62},
                                     {Column::U, "u", 62},
                                     {Column::Expanded, "U (k=2)", 70},
                                     {Column::Limits, QT_TRANSLATE_NOOP("Drawing", "Limits"), 124},
                                     {Column::Exceptions, QT_TRANSLATE_NOOP("Drawing", "Exc."), 46}};
constexpr double kTableHeadPx = 28, kTableRowPx = 27, kTableTextPx = 16, kTableHeadTextPx = 14;

QString limitsText(const DimensionSummary& s) {
  const auto limit = [&](double mm) { return limitText(mm - s.nominalMm); };
  if (s.lowerMm && s.upperMm) return limit(*s.lowerMm) + QStringLiteral(" / ") + limit(*s.upperMm);
  if (s.upperMm) return Drawing::tr("max %1").arg(limit(*s.upperMm));
  if (s.lowerMm) return Drawing::tr("min %1").arg(limit(*s.lowerMm));
  return QStringLiteral("\u2013");
}

QString cellText(Column column, const DimensionSummary& s) {
  const int decimals = decimalsOf(s.dimension);
  const bool measured = s.values.count() > 0;
  const auto value = [&](double mm) { return measured ? numberText(mm, decimals) : QStringLiteral("\u2013"); };
  switch (column) {
    case Column::Nominal:
      return numberText(s.nominalMm, decimals);
    case Column::Mean:
      return value(s.meanMm());
    case Column::Min:
      return value(s.values.min());
    case Column::Max:
      return value(s.values.max());
    case Column::S:
      return value(s.values.sd());
    case Column::U:
      return value(s.uMm);
    case Column::Expanded:
      return value(2 * s.uMm);
    case Column::Limits:
      return limitsText(s);
    case Column::Exceptions:
      return s.exceptions.empty() ? QStringLiteral("\u2013") : QString::number(s.exceptions.size());
    case Column::State:
    case Column::Name:
      break;
  }
  return {};
}

class TablePainter {
 public:
  TablePainter(QPainter& painter, const QRectF& area, const RailSummary& summary, const Palette& palette)
      : painter_(painter), area_(area), summary_(summary), palette_(palette), scale_(scaleOf(painter)) {
    double weights = 0;
    for (const ColumnLayout& c : kColumns) weights += c.weight;
    unit_ = (area.width() - 24 * scale_) / weights;
    rowHeight_ = (area.height() - kTableHeadPx * scale_) / static_cast<double>(kDimensionCount);
  }

  void paint() {
    painter_.setPen(palette_.t2);
    painter_.setFont(typeface(kTableHeadTextPx * scale_));
    eachColumn(area_.top(), kTableHeadPx * scale_, [&](const ColumnLayout& c, const QRectF& cell) {
      painter_.drawText(cell, Drawing::tr(c.head), inCell(c.column));
    });
    double y = area_.top() + kTableHeadPx * scale_;
    for (const Dimension d : kDimensions) {
      paintRow(y, summary_.dimensions[index(d)]);
      y += rowHeight_;
    }
    painter_.setPen(QPen(palette_.line, 1));
    painter_.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
  }

 private:
  static QTextOption inCell(Column c) {
    const bool left = c == Column::State || c == Column::Name;
    QTextOption option(left ? Qt::AlignVCenter | Qt::AlignLeft : Qt::AlignVCenter | Qt::AlignRight);
    option.setWrapMode(QTextOption::NoWrap);
    return option;
  }
  template <typename Use>
  void eachColumn(double y, double height, Use use) const {
    double x = area_.left() + 12 * scale_;
    for (const ColumnLayout& c : kColumns) {
      use(c, QRectF(x, y, c.weight * unit_, height));
      x += c.weight * unit_;
    }
  }
  void paintRow(double y, const DimensionSummary& s) {
    const QRectF row(area_.left(), y, area_.width(), rowHeight_);
    if (abnormal(s.verdict)) {
      painter_.fillRect(row, softOf(s.verdict, palette_));
      painter_.fillRect(QRectF(row.topLeft(), QSizeF(5 * scale_, row.height())), barOf(s.verdict, palette_));
    }
    painter_.setPen(QPen(palette_.line2, 1));
    painter_.drawLine(row.topLeft(), row.topRight());
    eachColumn(y, row.height(), [&](const ColumnLayout& c, const QRectF& cell) { paintCell(c.column, cell, s); });
  }
  void paintCell(Column column, const QRectF& cell, const DimensionSummary& s) {
    const double baseLine = cell.center().y() + 0.36 * kTableTextPx * scale_;
    if (column == Column::State) {
      const double side = 19 * scale_;
      paintSymbol(painter_, QRectF(cell.left(), cell.center().y() - side / 2, side, side), symbolOf(s.verdict),
                  palette_);
      painter_.setFont(typeface(kTableHeadTextPx * scale_, abnormal(s.verdict) ? QFont::Medium : QFont::Normal));
      painter_.setPen(abnormal(s.verdict) ? palette_.t1 : palette_.t2);
      painter_.drawText(QPointF(cell.left() + side + 8 * scale_, baseLine), wordOf(s.verdict));
      return;
    }
    const bool strong = column == Column::Name || column == Column::Mean;
    painter_.setFont(typeface(kTableTextPx * scale_, strong ? QFont::Medium : QFont::Normal));
    painter_.setPen(strong ? palette_.t1 : palette_.t2);
    if (column == Column::Name)
      drawDimensionName(painter_, QPointF(cell.left(), baseLine), s.dimension);
    else
      painter_.drawText(cell, cellText(column, s), inCell(column));
  }

  QPainter& painter_;
  QRectF area_;
  const RailSummary& summary_;
  const Palette& palette_;
  double scale_, unit_, rowHeight_;
};

QString timeText(std::chrono::system_clock::time_point time, bool utc) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const QDateTime moment = QDateTime::fromMSecsSinceEpoch(ms, utc ? QTimeZone::utc() : QTimeZone::systemTimeZone());
  return moment.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

/// Its id, and what is wrong with its age.
std::string calibrationOf(const RailSummary& s) {
  return s.calibrationWarning.empty() ? s.calibrationId : s.calibrationId + " (overdue)";
}

}  // namespace

double drawRuns(QPainter& painter, const QPointF& baseLine, const TextRuns& runs, double widthPx) {
  const QFontMetricsF metrics(painter.font());
  double advance = 0;
  for (const auto& run : runs) {
    const double left = widthPx - advance;
    if (const Dimension* d = std::get_if<Dimension>(&run)) {
      if (dimensionNameWidth(painter.font(), *d) > left) break;
      advance += drawDimensionName(painter, baseLine + QPointF(advance, 0), *d);
      continue;
    }
    const QString& whole = std::get<QString>(run);
    const QString shown = metrics.elidedText(whole, Qt::ElideRight, std::max(0.0, left));
    painter.drawText(baseLine + QPointF(advance, 0), shown);
    advance += metrics.horizontalAdvance(shown);
    if (shown != whole) break;
  }
  return advance;
}

std::vector<Fact> factsOf(const RailReport& report) {
  const RailSummary& s = *report.summary;
  const auto time = report.measuredAt.value_or(std::chrono::system_clock::now());
  const bool measured = report.measuredAt.has_value();
  return {{Drawing::tr("Rail"), text(s.rail.id)},
          {Drawing::tr("Heat"), text(s.rail.heat)},
          {Drawing::tr("Section"), text(report.recipe->section.name)},
          {Drawing::tr("Recipe"), text(s.recipe)},
          {Drawing::tr("Length"), numberText(s.lengthM, 2) + QStringLiteral(" m")},
          {Drawing::tr("Profiles"), QString::number(s.profiles)},
          {Drawing::tr("Rail temperature"),
           QStringLiteral("%1 \u00b1 %2 °C")
               .arg(numberText(s.rail.temperatureC, 1), numberText(s.rail.temperatureUncertaintyC, 1))},
          {Drawing::tr("Calibration"), text(calibrationOf(s))},
          {measured ? Drawing::tr("Measured (UTC)") : Drawing::tr("Written (UTC)"), timeText(time, true)},
          {measured ? Drawing::tr("Measured (local)") : Drawing::tr("Written (local)"), timeText(time, false)},
          {Drawing::tr("Program"), QStringLiteral("Vignole ") + QString::fromStdString(report.programVersion)},
          {Drawing::tr("Values"), Drawing::tr("mm at 15 °C")}};
}

void paintFacts(QPainter& painter, const QRectF& area, const std::vector<Fact>& facts, int columns,
                const Palette& palette) {
  const double scale = scaleOf(painter);
  const auto perRow = static_cast<std::size_t>(std::max(1, columns));
  const std::size_t rows = (facts.size() + perRow - 1) / perRow;
  const double width = area.width() / static_cast<double>(perRow);
  const double height = area.height() / static_cast<double>(std::max<std::size_t>(1, rows));
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const std::size_t row = i / perRow, column = i % perRow;
    const QPointF at(area.left() + static_cast<double>(column) * width, area.top() + static_cast<double>(row) * height);
    painter.setFont(typeface(14 * scale));
    painter.setPen(palette.t2);
    painter.drawText(at + QPointF(0, 14 * scale), facts[i].label);
    painter.setFont(typeface(18 * scale, QFont::Medium));
    painter.setPen(palette.t1);
    const QString value = QFontMetricsF(painter.font()).elidedText(facts[i].value, Qt::ElideRight, width - 12 * scale);
    painter.drawText(at + QPointF(0, 35 * scale), value);
  }
}

QString verdictHeadline(Verdict verdict) {
  switch (verdict) {
    case Verdict::Fail:
      return Drawing::tr("Out of tolerance");
    case Verdict::NoLimit:
      return Drawing::tr("No limits to judge by");
    case Verdict::NotMeasured:
      return Drawing::tr("Not valid");
    default:
      return wordOf(verdict);
  }
}

TextRuns verdictReason(const RailSummary& summary) {
  std::vector<Dimension> out, near, missing;
  std::size_t judged = 0;
  for (const Dimension d : worstFirst(summary)) {
    const DimensionSummary& s = summary.dimensions[index(d)];
    if (s.lowerMm || s.upperMm) ++judged;
    if (s.verdict == Verdict::Fail) out.push_back(d);
    if (s.verdict == Verdict::Near) near.push_back(d);
    if (s.verdict == Verdict::NotMeasured && (s.lowerMm || s.upperMm)) missing.push_back(d);
  }
  TextRuns runs;
  const auto next = [&] {
    if (!runs.empty()) runs.emplace_back(QStringLiteral(";  "));
  };
  if (!out.empty()) {
    addNames(runs, out);
    runs.emplace_back(Drawing::tr(" out of tolerance"));
    const auto& exceptions = summary.dimensions[index(out.front())].exceptions;
    if (out.size() == 1 && exceptions.size() == 1)
      runs.emplace_back(Drawing::tr(" from %1 to %2 m")
                            .arg(numberText(exceptions.front().fromM, 2), numberText(exceptions.front().toM, 2)));
    else if (out.size() == 1 && !exceptions.empty())
      runs.emplace_back(Drawing::tr(" in %1 stretches, the first at %2 m")
                            .arg(exceptions.size())
                            .arg(numberText(exceptions.front().fromM, 2)));
  }
  if (!missing.empty()) {
    next();
    addNames(runs, missing);
    const std::string& reason = summary.dimensions[index(missing.front())].reason;
    runs.emplace_back(reason.empty() ? Drawing::tr(" not measured")
                                     : Drawing::tr(" not measured, because %1").arg(inWords(reason)));
  }
  if (!near.empty()) {
    next();
    addNames(runs, near);
    runs.emplace_back(Drawing::tr(" near limit"));
  }
  if (runs.empty() && judged > 0)
    runs.emplace_back(Drawing::tr("%1 toleranced dimensions within their limits over %2 m")
                          .arg(judged)
                          .arg(numberText(summary.lengthM, 2)));
  return runs;
}

void paintVerdict(QPainter& painter, const QRectF& area, const RailReport& report, const Palette& palette) {
  const double scale = scaleOf(painter);
  const Verdict verdict = report.summary->verdict;
  painter.fillRect(area, softOf(verdict, palette));
  painter.fillRect(QRectF(area.topLeft(), QSizeF(10 * scale, area.height())), barOf(verdict, palette));
  const double side = 0.62 * area.height();
  paintSymbol(painter, QRectF(area.left() + 28 * scale, area.center().y() - side / 2, side, side), symbolOf(verdict),
              palette);
  const double left = area.left() + 48 * scale + side, width = area.right() - left - 16 * scale;
  painter.setPen(palette.t1);
  painter.setFont(typeface(0.44 * area.height(), QFont::Bold));
  painter.drawText(QPointF(left, area.top() + 0.52 * area.height()), verdictHeadline(verdict));
  painter.setFont(typeface(20 * scale));
  drawRuns(painter, QPointF(left + 2 * scale, area.top() + 0.83 * area.height()), verdictReason(*report.summary),
           width);
  if (report.simulation) {
    painter.setFont(typeface(16 * scale));
    paintSimulationMark(painter, QPointF(area.right() - 16 * scale, area.top() + 0.34 * area.height()), palette);
  }
}

double paintSimulationMark(QPainter& painter, const QPointF& rightMiddle, const Palette& palette) {
  const double scale = scaleOf(painter);
  const QString word = Drawing::tr("SIMULATION");
  painter.setFont(typeface(18 * scale, QFont::Bold));
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(word) + 24 * scale;
  const QRectF frame(rightMiddle.x() - width, rightMiddle.y() - 16 * scale, width, 32 * scale);
  painter.setPen(QPen(palette.t1, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame);
  painter.drawText(frame, Qt::AlignCenter, word);
  return width;
}

double dimensionTableHeight(double scale) {
  return (kTableHeadPx + static_cast<double>(kDimensionCount) * kTableRowPx) * scale;
}

void paintDimensionTable(QPainter& painter, const QRectF& area, const RailSummary& summary, const Palette& palette) {
  painter.save();
  TablePainter(painter, area, summary, palette).paint();
  painter.restore();
}

std::vector<Dimension> worstFirst(const RailSummary& summary) {
  std::vector<Dimension> order(kDimensions.begin(), kDimensions.end());
  std::stable_sort(order.begin(), order.end(), [&](Dimension a, Dimension b) {
    return rankOf(summary.dimensions[index(a)]) > rankOf(summary.dimensions[index(b)]);
  });
  return order;
}

}  // namespace vignole
