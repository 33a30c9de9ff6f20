#include "gui/monitor/dimension_cells.h"

#include <QAbstractItemView>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/theme/inscription.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

constexpr double kEdge = 16;       // padding of the panel
constexpr double kLimitText = 60;  // room beside a bar for the limit's number, pushed aside by a mark

bool rightAligned(int column) {
  return column == DimensionModel::Value || column == DimensionModel::Deviation ||
         column == DimensionModel::Uncertainty;
}

void drawRight(QPainter& painter, const QRectF& box, const QFont& font, const QString& text) {
  painter.setFont(font);
  painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter, text);
}

/// Type of a row: 32 px values where the row is as high as in the mock-ups, smaller ones on small screens.
struct RowType {
  int value, name, deviation, uncertainty, word;
  explicit RowType(double height)
      : value(std::clamp(static_cast<int>(height * 0.7), 20, 32)),
        name(std::clamp(static_cast<int>(height * 0.52), 17, 24)),
        deviation(std::clamp(static_cast<int>(height * 0.48), 16, 22)),
        uncertainty(std::clamp(static_cast<int>(height * 0.4), 15, 18)),
        word(std::clamp(static_cast<int>(height * 0.36), 14, 16)) {}
};

/// Where deviations lie on a bar: the limits at 20 and 80 % of its width, on narrow ones as far in as their numbers
/// need.
class BarScale {
 public:
  BarScale(const QRectF& box, const DimensionRow& row)
      : left_(box.left() + std::max(0.2 * box.width(), kLimitText)),
        right_(box.right() - std::max(0.2 * box.width(), kLimitText)),
        low_(row.lowerMm.value_or(std::min(row.nominalMm, row.upperMm.value_or(row.nominalMm)))),
        high_(row.upperMm.value_or(std::max(row.nominalMm, low_))) {
    if (high_ - low_ < 1e-9) high_ = low_ + 1;
  }
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double at(double valueMm) const { return left_ + (valueMm - low_) / (high_ - low_) * (right_ - left_); }
  [[nodiscard]] double width(double mm) const { return mm / (high_ - low_) * (right_ - left_); }

 private:
  double left_, right_, low_, high_;
};

}  // namespace

DimensionCells::DimensionCells(const Theme& theme, QObject* parent) : QStyledItemDelegate(parent), theme_(theme) {}

void DimensionCells::paintGround(QPainter& painter, const QRectF& box, const DimensionRow& row,
                                 const QModelIndex& index, const QStyleOptionViewItem& option) const {
  const Palette& p = theme_.palette();
  QColor soft = p.panel, strong;
  if (row.symbol == StateSymbol::Out) soft = p.outSoft, strong = p.out;
  if (row.symbol == StateSymbol::Near) soft = p.nearSoft, strong = p.near;
  if (row.symbol == StateSymbol::NotMeasured) soft = p.invalidSoft, strong = p.invalid;
  painter.fillRect(box, soft);
  painter.fillRect(QRectF(box.left(), box.bottom() - 1, box.width(), 1), p.line2);
  const bool first = index.column() == 0;
  if (first && strong.isValid()) painter.fillRect(QRectF(box.left(), box.top(), 6, box.height() - 1), strong);
  const auto* table = qobject_cast<const QAbstractItemView*>(option.widget);
  const bool selected = (option.state & QStyle::State_Selected) != 0;
  const bool focused = table && table->hasFocus() && table->currentIndex().row() == index.row();
  if (!selected && !focused) return;
  const double line = selected ? 2 : 1;
  const bool last = box.right() >= table->viewport()->width() - 1;
  painter.fillRect(QRectF(box.left(), box.top(), box.width(), line), p.accent);
  painter.fillRect(QRectF(box.left(), box.bottom() - line, box.width(), line), p.accent);
  if (first) painter.fillRect(QRectF(box.left(), box.top(), line, box.height()), p.accent);
  if (last) painter.fillRect(QRectF(box.right() - line, box.top(), line, box.height()), p.accent);
}

void DimensionCells::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* model = qobject_cast<const DimensionModel*>(index.model());
  if (!model) return;
  const Palette& p = theme_.palette();
  const DimensionRow& row = model->row(index.row());
  const QRectF box(option.rect);
  const RowType type(box.height());
  painter->save();
  paintGround(*painter, box, row, index, option);
  painter->setRenderHint(QPainter::Antialiasing);
  const bool abnormal = row.symbol == StateSymbol::Out || row.symbol == StateSymbol::Near || row.notMeasured();
  const QString text = index.data(Qt::DisplayRole).toString();
  painter->setPen(row.held || row.waiting ? p.t3 : p.t1);
  switch (index.column()) {
    case DimensionModel::State: {
      // Good is small and quiet, what is abnormal has the full size.
      const bool calm = row.symbol == StateSymbol::Good || row.symbol == StateSymbol::NoLimit;
      const double side = std::min(calm ? 19.0 : 28.0, box.height() * 0.68);
      if (!row.waiting)
        paintSymbol(*painter, QRectF(box.left() + kEdge + (28 - side) / 2, box.center().y() - side / 2, side, side),
                    row.symbol, p);
      painter->setPen(abnormal ? p.t1 : p.t3);
      painter->setFont(uiFont(type.word, abnormal ? 500 : 400));
      painter->drawText(box.adjusted(kEdge + (row.waiting ? 9 : 34), 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
      break;
    }
    case DimensionModel::Name: {
      painter->setPen(p.t1);
      const QFont font = uiFont(type.name, 500);
      painter->setFont(font);
      drawDimensionName(*painter, {box.left(), box.center().y() + font.pixelSize() * 0.36}, row.dimension);
      break;
    }
    case DimensionModel::Value:
      if (row.notMeasured()) {
        painter->setPen(p.t1);
        painter->setFont(uiFont(type.deviation, 500));
        const QRectF wide = box.adjusted(8, 0, -kEdge, 0);
        painter->drawText(wide, Qt::AlignLeft | Qt::AlignVCenter,
                          QFontMetricsF(painter->font()).elidedText(text, Qt::ElideRight, wide.width()));
      } else {
        drawRight(*painter, box, uiFont(type.value, 500), text);
      }
      break;
    case DimensionModel::Deviation:
      drawRight(*painter, box, uiFont(type.deviation), text);
      break;
    case DimensionModel::Uncertainty:
      if (!row.held && !row.waiting) painter->setPen(p.t2);
      drawRight(*painter, box, uiFont(type.uncertainty), text);
      break;
    case DimensionModel::Bar:
      paintBar(*painter, box.adjusted(10, 0, -2, 0), row);
      break;
    case DimensionModel::Track:
      paintTrack(*painter, box.adjusted(6, 7, -kEdge, -8), row);
      break;
    default:
      break;
  }
  painter->restore();
}

void DimensionCells::paintBar(QPainter& painter, const QRectF& box, const DimensionRow& row) const {
  const Palette& p = theme_.palette();
  const BarScale scale(box, row);
  const double y = std::round(box.center().y());
  if (row.waiting) return;
  if (!row.lowerMm && !row.upperMm) {
    painter.setPen(QPen(p.line, 2));
    painter.drawLine(QPointF(scale.left(), y), QPointF(scale.right(), y));
    return;
  }
  painter.fillRect(QRectF(scale.left(), y - 6, scale.right() - scale.left(), 12), p.chan);
  const double guard = std::min(scale.width(row.expandedUMm), (scale.right() - scale.left()) / 2);
  const QBrush hatch(p.t3, Qt::BDiagPattern);
  if (row.lowerMm) painter.fillRect(QRectF(scale.left(), y - 6, guard, 12), hatch);
  if (row.upperMm) painter.fillRect(QRectF(scale.right() - guard, y - 6, guard, 12), hatch);
  painter.setPen(QPen(p.t2, 2));
  painter.drawLine(QPointF(scale.left(), y - 9), QPointF(scale.left(), y + 9));
  painter.drawLine(QPointF(scale.right(), y - 9), QPointF(scale.right(), y + 9));
  painter.setPen(QPen(p.model, 1.5));
  const double nominal = scale.at(row.nominalMm);
  if (nominal - scale.left() > 2 && scale.right() - nominal > 2)
    painter.drawLine(QPointF(nominal, y - 8), QPointF(nominal, y + 8));

  const bool marked = row.symbol == StateSymbol::Out || row.symbol == StateSymbol::Near;
  const double overshoot = 12;
  const double x =
      row.valueMm ? std::clamp(scale.at(*row.valueMm), scale.left() - overshoot, scale.right() + overshoot) : nominal;
  // A mark at a limit pushes the limit's number aside.
  const double reach = marked ? 12 : 5;
  const double leftText = std::min(scale.left() - 8, x - reach - 4),
               rightText = std::max(scale.right() + 8, x + reach + 4);
  painter.setPen(p.t3);
  painter.setFont(uiFont(14));
  painter.drawText(QRectF(leftText - 60, y - 10, 60, 20), Qt::AlignRight | Qt::AlignVCenter,
                   limitBesideBar(scale.low(), row));
  painter.drawText(QRectF(rightText, y - 10, 60, 20), Qt::AlignLeft | Qt::AlignVCenter,
                   limitBesideBar(scale.high(), row));
  if (!row.valueMm) return;
  const double u = scale.width(row.expandedUMm);
  const QColor ink = row.held ? p.t3 : p.t1;
  painter.setPen(QPen(ink, 2));
  const double from = std::max(x - u, box.left()), to = std::min(x + u, box.right());
  painter.drawLine(QPointF(from, y), QPointF(to, y));
  if (marked)
    paintSymbol(painter, QRectF(x - 11, y - 11, 22, 22), row.symbol, p);
  else
    painter.fillRect(QRectF(x - 3, y - 10, 6, 20), ink);
}

void DimensionCells::paintTrack(QPainter& painter, const QRectF& box, const DimensionRow& row) const {
  const Palette& p = theme_.palette();
  painter.fillRect(box, p.panel2);
  if (row.track.isEmpty() || row.lengthM <= 0) return;
  const bool limits = row.lowerMm || row.upperMm;
  double low = row.lowerMm.value_or(row.nominalMm), high = row.upperMm.value_or(row.nominalMm);
  if (!limits) {
    low = high = row.track.front().y();
    for (const QPointF& point : row.track) {
      low = std::min(low, point.y());
      high = std::max(high, point.y());
    }
    const double least = 4 * row.expandedUMm;  // noise is not blown up to a mountain range
    const double widen = std::max(0.0, (least - (high - low)) / 2);
    low -= widen;
    high += widen;
  }
  const double span = std::max(high - low, 1e-6);
  const QRectF inner = box.adjusted(0, 4, 0, -4);
  const auto at = [&](const QPointF& point) {
    const double share = std::clamp((point.y() - low) / span, -0.12, 1.12);
    return QPointF(inner.left() + std::min(point.x() / row.lengthM, 1.0) * inner.width(),
                   inner.bottom() - share * inner.height());
  };
  if (limits) {
    QPen dashed(p.t3, 1);
    dashed.setDashPattern({4, 3});
    painter.setPen(dashed);
    if (row.upperMm) painter.drawLine(inner.topLeft(), inner.topRight());
    if (row.lowerMm) painter.drawLine(inner.bottomLeft(), inner.bottomRight());
  }
  // One point a pixel: what is drawn finer than that only costs time.
  QPolygonF course;
  QVector<QPolygonF> beyond;
  bool outsideBefore = false;
  double lastX = -10;
  for (const QPointF& point : row.track) {
    const QPointF on = at(point);
    if (on.x() - lastX < 1) continue;
    lastX = on.x();
    course << on;
    const bool outside = std::any_of(row.outside.begin(), row.outside.end(),
                                     [&](const auto& s) { return point.x() >= s.first && point.x() <= s.second; });
    if (outside && !outsideBefore) beyond.append(QPolygonF());
    if (outside) beyond.last() << on;
    outsideBefore = outside;
  }
  painter.setPen(QPen(row.held ? p.t3 : p.t1, 1.25));
  painter.drawPolyline(course);
  painter.setPen(QPen(p.out, 3.5));
  for (const QPolygonF& part : beyond)
    if (part.size() == 1)
      painter.drawPoint(part.front());
    else
      painter.drawPolyline(part);
  painter.setPen(QPen(p.line, 1));
  const double now = at({row.positionM, low}).x();
  painter.drawLine(QPointF(now, box.top()), QPointF(now, box.bottom()));
}

DimensionHeads::DimensionHeads(const Theme& theme, QWidget* parent)
    : QHeaderView(Qt::Horizontal, parent), theme_(theme) {
  setSectionsClickable(false);
  setHighlightSections(false);
  setFixedHeight(30);
}

void DimensionHeads::paintSection(QPainter* painter, const QRect& rect, int logicalIndex) const {
  const Palette& p = theme_.palette();
  painter->save();
  painter->fillRect(rect, p.panel);
  painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1), p.line2);
  painter->setPen(p.t3);
  painter->setFont(uiFont(14));
  const double left = logicalIndex == DimensionModel::State  ? kEdge
                      : logicalIndex == DimensionModel::Name ? 0
                      : logicalIndex == DimensionModel::Bar  ? 18
                                                             : 6;
  const QString text = model()->headerData(logicalIndex, Qt::Horizontal).toString();
  if (rightAligned(logicalIndex))
    painter->drawText(QRectF(rect), Qt::AlignRight | Qt::AlignVCenter, text);
  else
    painter->drawText(QRectF(rect).adjusted(left, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetricsF(painter->font()).elidedText(text, Qt::ElideRight, rect.width() - left));
  painter->restore();
}

}  // namespace vignole
