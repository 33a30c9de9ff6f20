#include "report/page_frame.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPageSize>
#include <QPdfWriter>
#include <QPen>

#include "report/drawing_words.h"
#include "report/report_parts.h"
#include "report/typeface.h"

namespace vignole {

namespace {

constexpr double kUnitsPerInch = 144;
constexpr int kResolution = 1200;
const QSizeF kPage(210.0 / 25.4 * kUnitsPerInch, 297.0 / 25.4 * kUnitsPerInch);
constexpr double kMargin = 72, kHeadHeight = 56, kFootHeight = 44;
constexpr double kBodyPx = 16;

void paintFrame(QPainter& painter, const PageFrame& frame, std::size_t page, std::size_t pages) {
  const Palette& palette = lightPalette();
  const double right = kPage.width() - kMargin, base = kMargin + 28;
  const auto line = [&](double y) {
    painter.setPen(QPen(palette.line, 1));
    painter.drawLine(QPointF(kMargin, y), QPointF(right, y));
  };
  writeText(painter, kMargin, base, QStringLiteral("Vignole"), palette.t1, 26, QFont::Bold);
  writeText(painter, kMargin + 112, base, frame.title, palette.t2, 20);
  writeTextRight(painter, right, base, frame.subject, palette.t1, 20);
  if (frame.simulation && (page > 1 || frame.markOnFirstPage)) {
    const double wide = QFontMetricsF(typeface(20)).horizontalAdvance(frame.subject);
    painter.setFont(typeface(kBodyPx));
    paintSimulationMark(painter, QPointF(right - wide - 24, base - 7), palette);
  }
  line(kMargin + kHeadHeight - 14);
  const double foot = kPage.height() - kMargin;
  line(foot - 26);
  writeText(painter, kMargin, foot, frame.foot, palette.t2, 14);
  writeTextRight(painter, right, foot, Drawing::tr("Page %1 of %2").arg(page).arg(pages), palette.t2, 14);
}

}  // namespace

QRectF pageBody() {
  const double top = kMargin + kHeadHeight, bottom = kPage.height() - kMargin - kFootHeight;
  return {kMargin, top, kPage.width() - 2 * kMargin, bottom - top};
}

void writeText(QPainter& painter, double x, double y, const QString& what, const QColor& ink, double px, int weight) {
  painter.setFont(typeface(px, static_cast<QFont::Weight>(weight)));
  painter.setPen(ink);
  painter.drawText(QPointF(x, y), what);
}

void writeTextRight(QPainter& painter, double right, double y, const QString& what, const QColor& ink, double px) {
  painter.setFont(typeface(px));
  painter.setPen(ink);
  painter.drawText(QPointF(right - QFontMetricsF(painter.font()).horizontalAdvance(what), y), what);
}

QByteArray pdfOfPages(const PageFrame& frame, const QString& title, const QString& creator,
                      const std::vector<std::function<void(QPainter&, const QRectF&)>>& pages) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly)) return {};
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(title);
    writer.setCreator(creator);
    QPainter painter;
    if (!painter.begin(&writer)) return {};
    for (std::size_t page = 0; page < pages.size(); ++page) {
      if (page > 0) writer.newPage();
      painter.save();
      painter.scale(kResolution / kUnitsPerInch, kResolution / kUnitsPerInch);
      painter.setRenderHint(QPainter::Antialiasing);
      paintFrame(painter, frame, page + 1, pages.size());
      painter.setFont(typeface(kBodyPx));
      pages[page](painter, pageBody());
      painter.restore();
    }
    if (!painter.end()) return {};
  }
  return bytes;
}

}  // namespace vignole
