#include "report/rail_picture.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPen>

#include "report/dimension_text.h"
#include "report/drawing_words.h"
#include "report/profile_drawing.h"
#include "report/report_parts.h"
#include "report/tolerance_chart.h"
#include "report/typeface.h"

namespace vignole {

namespace {

constexpr QSize kPicture(1600, 1024);
constexpr double kMargin = 16, kHeader = 64;

void panel(QPainter& painter, const QRectF& area, const QColor& ground, const Palette& palette) {
  painter.setPen(QPen(palette.line, 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

void header(QPainter& painter, const RailReport& report, const Palette& palette) {
  painter.fillRect(QRectF(0, 0, kPicture.width(), kHeader), palette.head);
  painter.setPen(palette.t1);
  painter.setFont(typeface(26, QFont::Bold));
  painter.drawText(QPointF(kMargin, 42), QStringLiteral("Vignole"));
  double right = kPicture.width() - kMargin;
  if (report.simulation) {
    painter.setFont(typeface(16));
    right -= paintSimulationMark(painter, QPointF(right, kHeader / 2), palette) + 24;
  }
  std::vector<Fact> facts = factsOf(report);
  facts.resize(7);  // rail, heat, section, recipe, length, profiles, temperature; the rest stands at the foot
  painter.setFont(typeface(16));
  paintFacts(painter, QRectF(148, 10, right - 148, kHeader - 16), facts, static_cast<int>(facts.size()), palette);
}

void drawing(QPainter& painter, const QRectF& area, const RailReport& report, const Palette& palette) {
  panel(painter, area, palette.panel2, palette);
  ProfileDrawing d;
  d.section = &report.recipe->section;
  d.limits = &report.recipe->limits;
  d.parameters = &report.recipe->parameters;
  if (report.example != nullptr) {
    d.profile = &report.example->profile;
    d.registration = &report.example->registration;
    d.measurement = &report.example->measurement;
    painter.setFont(typeface(14));
    painter.setPen(palette.t2);
    const QString where = Drawing::tr("profile at %1 m").arg(numberText(report.example->profile.positionMm / 1000, 2));
    painter.drawText(
        QPointF(area.right() - 16 - QFontMetricsF(painter.font()).horizontalAdvance(where), area.top() + 24), where);
  }
  painter.setFont(typeface(16));
  paintProfile(painter, area.adjusted(1, 12, -1, -2), d, palette);
}

void chart(QPainter& painter, const QRectF& area, const RailReport& report, Dimension dimension,
           const Palette& palette) {
  panel(painter, area, palette.panel, palette);
  painter.setFont(typeface(16));
  paintToleranceChart(painter, area.adjusted(16, 6, -8, -6), report.summary->dimensions[index(dimension)],
                      report.summary->lengthM, palette);
}

void footer(QPainter& painter, const RailReport& report, const Palette& palette) {
  QString line;
  const std::vector<Fact> facts = factsOf(report);
  for (std::size_t i = 7; i < facts.size(); ++i) {
    if (!line.isEmpty()) line += QStringLiteral("     ");
    line += facts[i].label + u' ' + facts[i].value;
  }
  painter.setFont(typeface(14));
  painter.setPen(palette.t2);
  painter.drawText(QPointF(kMargin, kPicture.height() - 12), line);
}

}  // namespace

QImage railPicture(const RailReport& report, const Palette& palette) {
  QImage image(kPicture, QImage::Format_RGB32);
  image.fill(palette.bg);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  header(painter, report, palette);

  drawing(painter, QRectF(kMargin, 80, 640, 672), report, palette);
  painter.setFont(typeface(16));
  const QRectF right(kMargin + 656, 80, kPicture.width() - 2 * kMargin - 656, 672);
  paintVerdict(painter, QRectF(right.left(), right.top(), right.width(), 116), report, palette);
  const QRectF table(right.left(), right.top() + 132, right.width(), right.height() - 132);
  panel(painter, table, palette.panel, palette);
  painter.setFont(typeface(16));
  paintDimensionTable(painter, table.adjusted(1, 4, -1, -1), *report.summary, palette);

  const std::vector<Dimension> worst = worstFirst(*report.summary);
  const double half = (kPicture.width() - 3 * kMargin) / 2;
  chart(painter, QRectF(kMargin, 768, half, 212), report, worst[0], palette);
  chart(painter, QRectF(2 * kMargin + half, 768, half, 212), report, worst[1], palette);
  footer(painter, report, palette);
  return image;
}

}  // namespace vignole
