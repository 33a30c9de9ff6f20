#include "gui/theme/inscription.h"

#include <QFontMetricsF>
#include <cmath>

#include "report/dimension_text.h"

namespace vignole {

namespace {

QFont subscriptFont(const QFont& font) {
  QFont small = font;
  small.setPixelSize(qMax(11, qRound(font.pixelSize() * 0.76)));
  return small;
}

QString elided(const QFont& font, const QString& text, double maxWidth) {
  QString rest = text;
  while (rest.contains(' ') && inscriptionWidth(font, rest + QChar(0x2026)) > maxWidth)
    rest = rest.left(rest.lastIndexOf(' ')).trimmed();
  return rest + QChar(0x2026);
}

/// Calls piece(text, lowered) for each run.
template <typename Piece>
void forEachPiece(const QString& text, Piece&& piece) {
  qsizetype from = 0;
  while (from < text.size()) {
    const qsizetype mark = text.indexOf('_', from);
    if (mark < 0 || mark + 1 >= text.size()) {
      piece(text.mid(from), false);
      return;
    }
    if (mark > from) piece(text.mid(from, mark - from), false);
    piece(text.mid(mark + 1, 1), true);
    from = mark + 2;
  }
}

}  // namespace

double inscriptionWidth(const QFont& font, const QString& text) {
  const QFontMetricsF normal(font), low(subscriptFont(font));
  double width = 0;
  forEachPiece(text,
               [&](const QString& piece, bool lowered) { width += (lowered ? low : normal).horizontalAdvance(piece); });
  return width;
}

double paintInscription(QPainter& painter, double left, double baseline, const QFont& font, const QString& text,
                        double maxWidth) {
  if (maxWidth > 0 && inscriptionWidth(font, text) > maxWidth)
    return paintInscription(painter, left, baseline, font, elided(font, text, maxWidth));
  const QFont low = subscriptFont(font);
  double x = left;
  forEachPiece(text, [&](const QString& piece, bool lowered) {
    painter.setFont(lowered ? low : font);
    painter.drawText(QPointF(x, baseline + (lowered ? 0.2 * font.pixelSize() : 0)), piece);
    x += QFontMetricsF(painter.font()).horizontalAdvance(piece);
  });
  return x - left;
}

QString shortSigned(double value, int decimals) {
  const double steps = std::pow(10, decimals);
  const double rounded = std::round(value * steps) / steps;
  const QString text = QString::number(std::abs(rounded), 'g', 6).replace('.', decimalMark());
  if (rounded == 0) return QStringLiteral("0");
  return (rounded < 0 ? QChar(0x2212) : QChar('+')) + text;
}

QString count(std::uint64_t value) {
  QString digits = QString::number(value);
  for (qsizetype at = digits.size() - 3; at > 0; at -= 3) digits.insert(at, QChar(0x2009));
  return digits;
}

QString age(double seconds) {
  const auto whole = static_cast<qint64>(seconds);
  if (seconds < 10) return numberText(seconds, 1) + " s";
  if (whole < 60) return QStringLiteral("%1 s").arg(whole);
  if (whole < 3600) return QStringLiteral("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  return QStringLiteral("%1 h %2 min").arg(whole / 3600).arg(whole / 60 % 60);
}

QString inscribed(Dimension dimension) {
  const std::string_view text = name(dimension);
  return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

QString spoken(Dimension dimension) { return inscribed(dimension).replace('_', ' '); }

}  // namespace vignole
