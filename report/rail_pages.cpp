#include "report/rail_pages.h"

#include <QPainter>
#include <QPen>
#include <algorithm>
#include <functional>
#include <iterator>

#include "report/dimension_text.h"
#include "report/drawing_words.h"
#include "report/engine_words.h"
#include "report/hatch.h"
#include "report/page_frame.h"
#include "report/profile_drawing.h"
#include "report/report_parts.h"
#include "report/state_symbol.h"
#include "report/tolerance_chart.h"
#include "report/typeface.h"

namespace vignole {

namespace {

constexpr double kBodyPx = 16;
constexpr double kListRow = 26;
constexpr std::size_t kMostExceptions = 400;  // a certificate, not a database: the rest is counted and told

struct ListedException {
  Dimension dimension;
  DimensionException exception;
};

std::vector<ListedException> exceptionsAlongTheRail(const RailSummary& summary) {
  std::vector<ListedException> list;
  for (const Dimension d : kDimensions)
    for (const DimensionException& e : summary.dimensions[index(d)].exceptions) list.push_back({d, e});
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.exception.fromM < b.exception.fromM; });
  return list;
}

class RailPages {
 public:
  explicit RailPages(const RailReport& report)
      : report_(report), palette_(lightPalette()), exceptions_(exceptionsAlongTheRail(*report.summary)) {
    shownExceptions_ = std::min(exceptions_.size(), kMostExceptions);
    pages_.emplace_back([this](const QRectF& body) { overview(body); });
    pages_.emplace_back([this](const QRectF& body) { charts(body); });
    planLists();
  }

  [[nodiscard]] QByteArray pdf() {
    const RailSummary& s = *report_.summary;
    const QString rail = Drawing::tr("Rail %1").arg(QString::fromStdString(s.rail.id));
    const QString program = QStringLiteral("Vignole ") + QString::fromStdString(report_.programVersion);
    PageFrame frame;
    frame.title = Drawing::tr("Rail profile report");
    frame.subject = rail;
    frame.foot =
        Drawing::tr("%1   recipe %2   calibration %3")
            .arg(program, QString::fromStdString(s.recipe),
                 QString::fromStdString(s.calibrationWarning.empty() ? s.calibrationId
                                                                     : s.calibrationId + ", " + s.calibrationWarning));
    frame.simulation = report_.simulation;
    frame.markOnFirstPage = false;  // the verdict there carries it
    std::vector<std::function<void(QPainter&, const QRectF&)>> pages;
    for (const auto& page : pages_)
      pages.emplace_back([this, &page](QPainter& painter, const QRectF& body) {
        painter_ = &painter;
        page(body);
      });
    return pdfOfPages(frame, rail, program, pages);
  }

 private:
  void body() { painter_->setFont(typeface(kBodyPx)); }
  void write(double x, double y, const QString& what, const QColor& ink, double px = kBodyPx,
             QFont::Weight weight = QFont::Normal) {
    writeText(*painter_, x, y, what, ink, px, weight);
  }
  void writeRight(double right, double y, const QString& what, const QColor& ink, double px = kBodyPx) {
    writeTextRight(*painter_, right, y, what, ink, px);
  }

  void overview(const QRectF& area) {
    double y = area.top();
    paintFacts(*painter_, QRectF(area.left(), y, area.width(), 150), factsOf(report_), 4, palette_);
    y += 158;
    body();
    paintVerdict(*painter_, QRectF(area.left(), y, area.width(), 108), report_, palette_);
    y += 120;
    const double table = dimensionTableHeight(1.0);
    drawing(QRectF(area.left(), y, area.width(), area.bottom() - table - 52 - y));
    y = area.bottom() - table - 30;
    body();
    paintDimensionTable(*painter_, QRectF(area.left(), y, area.width(), table), *report_.summary, palette_);
    write(area.left(), area.bottom() + 2,
          Drawing::tr("mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one "
                      "profile; Exc.: stretches out of tolerance."),
          palette_.t3, 14);
  }

  void drawing(const QRectF& area) {
    ProfileDrawing d;
    d.section = &report_.recipe->section;
    d.limits = &report_.recipe->limits;
    d.parameters = &report_.recipe->parameters;
    if (report_.example != nullptr) {
      d.profile = &report_.example->profile;
      d.registration = &report_.example->registration;
      d.measurement = &report_.example->measurement;
      write(area.left(), area.top() + 16,
            Drawing::tr("Profile at %1 m").arg(numberText(report_.example->profile.positionMm / 1000, 2)), palette_.t2,
            16);
    }
    body();
    paintProfile(*painter_, area, d, palette_);
  }

  void charts(const QRectF& area) {
    write(area.left(), area.top() + 16, Drawing::tr("Dimensions along the rail, mm over m"), palette_.t1, 18,
          QFont::Medium);
    const double top = area.top() + 34, gap = 40;
    const std::size_t rows = (kDimensionCount + 2) / 2;
    const double height = (area.bottom() - top) / static_cast<double>(rows), width = (area.width() - gap) / 2;
    for (std::size_t i = 0; i < kDimensionCount; ++i) {
      const std::size_t row = i / 2;
      const double x = area.left() + (i % 2 == 0 ? 0 : width + gap);
      const QRectF cell(x, top + static_cast<double>(row) * height, width, height - 14);
      body();
      paintToleranceChart(*painter_, cell, report_.summary->dimensions[i], report_.summary->lengthM, palette_);
    }
    chartKey(QRectF(area.left() + width + gap, top + static_cast<double>(rows - 1) * height, width, height - 14));
  }

  void chartKey(const QRectF& area) {
    const double x = area.left(), text = x + 56;
    double y = area.top() + 34;
    const auto item = [&](const QString& what, const QPen& pen) {
      painter_->setPen(pen);
      painter_->drawLine(QPointF(x, y - 5), QPointF(x + 40, y - 5));
      write(text, y, what, palette_.t2, 14);
      y += 24;
    };
    QPen dashed(QBrush(palette_.t3), 1.25, Qt::CustomDashLine, Qt::FlatCap);
    dashed.setDashPattern({8, 4});
    QColor soft = palette_.t3;
    soft.setAlphaF(0.35F);
    item(Drawing::tr("mean of a stretch"), QPen(palette_.t1, 1.6));
    item(Drawing::tr("smallest to largest value of the stretch"), QPen(QBrush(soft), 8, Qt::SolidLine, Qt::FlatCap));
    item(Drawing::tr("expected value"), dashed);
    item(Drawing::tr("limits; the ground outside is grey"), QPen(palette_.t2, 1.75));
    item(Drawing::tr("exception, with its square"), QPen(QBrush(palette_.out), 4, Qt::SolidLine, Qt::FlatCap));
    paintHatch(*painter_, QRectF(x, y - 13, 40, 14), palette_.invalid, 8, 1.5);
    write(text, y, Drawing::tr("not measured"), palette_.t2, 14);
  }

  // --- exceptions, triggers, notes ----------------------------------------------------------------------------------

  [[nodiscard]] double ledgerHeight() const {
    return 34 + kListRow * (4 + static_cast<double>(report_.summary->triggers.reasons.size())) + 140;
  }
  void planLists() {
    const double room = pageBody().height() - 80;
    const auto perPage = static_cast<std::size_t>(room / kListRow);
    std::size_t first = 0;
    do {
      const std::size_t count = std::min(perPage, shownExceptions_ - first);
      const bool last = first + count == shownExceptions_;
      const bool ledgerFits = static_cast<double>(count) * kListRow + 60 + ledgerHeight() < pageBody().height();
      pages_.emplace_back([this, first, count, withLedger = last && ledgerFits](const QRectF& body) {
        const double y = exceptionList(body, first, count);
        if (withLedger) ledger(body, y + 40);
      });
      if (last && !ledgerFits) pages_.emplace_back([this](const QRectF& body) { ledger(body, body.top() + 16); });
      first += count;
    } while (first < shownExceptions_);
  }

  double exceptionList(const QRectF& area, std::size_t first, std::size_t count) {
    double y = area.top() + 16;
    QString title = Drawing::tr("Exceptions");
    if (exceptions_.empty()) title = Drawing::tr("Exceptions: none");
    if (first > 0) title += Drawing::tr(" (continued)");
    write(area.left(), y, title, palette_.t1, 18, QFont::Medium);
    if (exceptions_.size() > shownExceptions_ && first == 0)
      writeRight(area.right(), y, Drawing::tr("the first %1 of %2").arg(shownExceptions_).arg(exceptions_.size()),
                 palette_.t2, 14);
    if (exceptions_.empty()) return y;
    y += 30;
    const double columns[] = {290, 430, 570, 730, 880, 1040};
    const QString heads[] = {Drawing::tr("from m"),   Drawing::tr("to m"),      Drawing::tr("length m"),
                             Drawing::tr("worst mm"), Drawing::tr("deviation"), Drawing::tr("beyond limit")};
    for (std::size_t c = 0; c < std::size(heads); ++c)
      writeRight(area.left() + columns[c], y, heads[c], palette_.t2, 14);
    for (std::size_t i = first; i < first + count; ++i) {
      y += kListRow;
      exceptionRow(area, y, exceptions_[i], columns);
    }
    return y;
  }

  void exceptionRow(const QRectF& area, double y, const ListedException& listed, const double* columns) {
    const DimensionSummary& s = report_.summary->dimensions[index(listed.dimension)];
    const DimensionException& e = listed.exception;
    const int decimals = decimalsOf(listed.dimension);
    double beyond = 0;
    if (s.upperMm) beyond = std::max(beyond, e.worstMm - *s.upperMm);
    if (s.lowerMm) beyond = std::max(beyond, *s.lowerMm - e.worstMm);
    painter_->setPen(QPen(palette_.line2, 1));
    painter_->drawLine(QPointF(area.left(), y - 19), QPointF(area.right(), y - 19));
    paintSymbol(*painter_, QRectF(area.left(), y - 14, 17, 17), StateSymbol::Out, palette_);
    painter_->setFont(typeface(kBodyPx, QFont::Medium));
    painter_->setPen(palette_.t1);
    drawDimensionName(*painter_, QPointF(area.left() + 28, y), listed.dimension);
    const QString cells[] = {numberText(e.fromM, 3),
                             numberText(e.toM, 3),
                             numberText(e.toM - e.fromM, 3),
                             numberText(e.worstMm, decimals),
                             deviationText(e.worstMm - s.nominalMm, decimals),
                             numberText(beyond, decimals)};
    for (std::size_t c = 0; c < std::size(cells); ++c) writeRight(area.left() + columns[c], y, cells[c], palette_.t1);
  }

  void ledger(const QRectF& area, double y) {
    const TriggerLedger& t = report_.summary->triggers;
    write(area.left(), y, Drawing::tr("Triggers"), palette_.t1, 18, QFont::Medium);
    const auto row = [&](const QString& what, std::uint64_t count, double indent) {
      y += kListRow;
      painter_->setPen(QPen(palette_.line2, 1));
      painter_->drawLine(QPointF(area.left(), y - 19), QPointF(area.left() + 520, y - 19));
      write(area.left() + indent, y, what, indent > 0 ? palette_.t2 : palette_.t1);
      writeRight(area.left() + 520, y, QString::number(count), indent > 0 ? palette_.t2 : palette_.t1);
    };
    y += 6;
    row(Drawing::tr("seen"), t.seen, 0);
    row(Drawing::tr("measured: complete, four contours"), t.measured, 0);
    row(Drawing::tr("incomplete: a camera or the registration was missing"), t.incomplete, 0);
    row(Drawing::tr("lost: no profile"), t.lost, 0);
    for (const auto& [reason, count] : t.reasons) row(inWords(reason), count, 24);
    notes(area, y + 46);
  }

  void notes(const QRectF& area, double y) {
    write(area.left(), y, Drawing::tr("Notes"), palette_.t1, 18, QFont::Medium);
    QStringList notes = {
        Drawing::tr("Lengths refer to 15 °C. U is the expanded uncertainty with k = 2; a value "
                    "nearer to a limit than U is near limit: it cannot be decided.")};
    if (report_.recipe->section.standing != SectionStanding::Standard)
      notes << (report_.recipe->section.standing == SectionStanding::Invented
                    ? Drawing::tr("This section is invented: not for acceptance.")
                    : Drawing::tr("This section is approximate: not for acceptance."));
    for (const std::string& note : {report_.recipe->note, report_.recipe->section.note})
      if (!note.empty()) notes << QString::fromStdString(note);
    painter_->setFont(typeface(14));
    painter_->setPen(palette_.t2);
    painter_->drawText(QRectF(area.left(), y + 12, area.width(), 200), Qt::TextWordWrap,
                       notes.join(QStringLiteral("\n")));
  }

  const RailReport& report_;
  const Palette& palette_;
  QPainter* painter_ = nullptr;
  std::vector<ListedException> exceptions_;
  std::size_t shownExceptions_ = 0;
  std::vector<std::function<void(const QRectF&)>> pages_;
};

}  // namespace

QByteArray railPdf(const RailReport& report) { return RailPages(report).pdf(); }

}  // namespace vignole
