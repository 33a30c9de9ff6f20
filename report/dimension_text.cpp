#include "report/dimension_text.h"

#include <QFontMetricsF>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "report/drawing_words.h"
#include "report/engine_words.h"

namespace vignole {

namespace {

constexpr QChar kMinus(0x2212);
std::atomic<char16_t> theDecimalMark{u'.'};
constexpr double kIndexSize = 0.74;    // of the name's type size
constexpr double kIndexLowered = 0.2;  // of the name's type size

struct NameParts {
  QString stem, index;
};

NameParts partsOf(Dimension dimension) {
  const std::string_view whole = name(dimension);
  const std::size_t split = whole.find('_');
  const auto text = [](std::string_view s) { return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size())); };
  if (split == std::string_view::npos) return {text(whole), {}};
  return {text(whole.substr(0, split)), text(whole.substr(split + 1))};
}

QFont indexFont(const QFont& font) {
  QFont small = font;
  small.setPixelSize(std::max(1, static_cast<int>(std::lround(font.pixelSize() * kIndexSize))));
  return small;
}

}  // namespace

void setDecimalMark(QChar mark) { theDecimalMark = mark.unicode(); }
QChar decimalMark() { return theDecimalMark.load(); }

int decimalsOf(Dimension dimension) { return dimension == Dimension::HR ? 1 : 3; }

QString numberText(double value, int decimals) {
  const double half = 0.5 * std::pow(10.0, -decimals);
  QString digits = QString::number(std::abs(value), 'f', decimals);
  digits.replace('.', decimalMark());
  return value <= -half ? kMinus + digits : digits;
}

QString deviationText(double value, int decimals) {
  const double half = 0.5 * std::pow(10.0, -decimals);
  const QString text = numberText(value, decimals);
  return value >= half ? u'+' + text : text;
}

QString limitText(double deviationMm) {
  const double hundredths = 100 * deviationMm;
  return deviationText(deviationMm, std::abs(hundredths - std::round(hundredths)) < 0.05 ? 2 : 3);
}

QString titleOf(Dimension dimension) {
  [[maybe_unused]] static constexpr const char* kForTranslators[] = {
      QT_TRANSLATE_NOOP("Dimension", "Rail height"),         QT_TRANSLATE_NOOP("Dimension", "Rail flange height"),
      QT_TRANSLATE_NOOP("Dimension", "Foot width"),          QT_TRANSLATE_NOOP("Dimension", "Head form"),
      QT_TRANSLATE_NOOP("Dimension", "Head width"),          QT_TRANSLATE_NOOP("Dimension", "Head width (AREMA)"),
      QT_TRANSLATE_NOOP("Dimension", "Foot thickness left"), QT_TRANSLATE_NOOP("Dimension", "Foot thickness right"),
      QT_TRANSLATE_NOOP("Dimension", "Rail asymmetry left"), QT_TRANSLATE_NOOP("Dimension", "Rail asymmetry right"),
      QT_TRANSLATE_NOOP("Dimension", "Web thickness"),       QT_TRANSLATE_NOOP("Dimension", "Head radius"),
      QT_TRANSLATE_NOOP("Dimension", "Foot concavity")};
  return QCoreApplication::translate("Dimension", std::string(title(dimension)).c_str());
}

QString wordOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return Drawing::tr("Good");
    case Verdict::Near:
      return Drawing::tr("Near limit");
    case Verdict::Fail:
      return Drawing::tr("Out");
    case Verdict::NoLimit:
      return Drawing::tr("No limit");
    case Verdict::NotMeasured:
      break;
  }
  return Drawing::tr("Not measured");
}

QString lengthText(double mm, int decimals, LengthUnit unit) {
  return numberText(inUnit(mm, unit), decimalsIn(unit, decimals));
}

QString verdictSentence(Dimension dimension, const DimensionResult& result, LengthUnit unit) {
  if (!result.valueMm)
    return Drawing::tr("not measured, because %1").arg(inWords(result.reason.empty() ? "no points" : result.reason));
  if (result.verdict != Verdict::Fail) return wordOf(result.verdict);
  // rails.md: the lower limit of HF judges HF_min; FC is judged on what is concave only.
  const double high = dimension == Dimension::FC ? std::max(0.0, *result.valueMm) : *result.valueMm;
  const double low = dimension == Dimension::HF && result.secondMm ? *result.secondMm : high;
  const double above = result.upperMm ? high - *result.upperMm : -1;
  const double below = result.lowerMm ? *result.lowerMm - low : -1;
  const int decimals = decimalsOf(dimension);
  if (above >= below && above > 0) return Drawing::tr("%1 above the limit").arg(lengthText(above, decimals, unit));
  if (below > 0) return Drawing::tr("%1 below the limit").arg(lengthText(below, decimals, unit));
  return Drawing::tr("Out of tolerance");
}

double drawDimensionName(QPainter& painter, const QPointF& baseLine, Dimension dimension) {
  const NameParts parts = partsOf(dimension);
  const QFont font = painter.font();
  painter.drawText(baseLine, parts.stem);
  if (parts.index.isEmpty()) return QFontMetricsF(font).horizontalAdvance(parts.stem);
  const double stem = QFontMetricsF(font).horizontalAdvance(parts.stem) + 0.03 * font.pixelSize();
  const QFont small = indexFont(font);
  painter.setFont(small);
  painter.drawText(baseLine + QPointF(stem, kIndexLowered * font.pixelSize()), parts.index);
  painter.setFont(font);
  return stem + QFontMetricsF(small).horizontalAdvance(parts.index);
}

double dimensionNameWidth(const QFont& font, Dimension dimension) {
  const NameParts parts = partsOf(dimension);
  const double stem = QFontMetricsF(font).horizontalAdvance(parts.stem);
  if (parts.index.isEmpty()) return stem;
  return stem + 0.03 * font.pixelSize() + QFontMetricsF(indexFont(font)).horizontalAdvance(parts.index);
}

}  // namespace vignole
