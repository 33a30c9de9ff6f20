#include "gui/monitor/last_rails.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "gui/monitor/judgement.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {
constexpr double kTwoLines = 60;  // a tile lower than this has one line
}

LastRails::LastRails(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void LastRails::show(const LineSnapshot& line) {
  tiles_.clear();
  for (const PassedRail& rail : line.passed)
    tiles_.push_back({QString::fromStdString(rail.id), wordOf(rail.verdict), symbolOf(rail.verdict), false});
  const bool passedAlready = line.rail && !line.passed.empty() && line.passed.back().id == line.rail->rail.id &&
                             line.state != LineState::Measuring;
  if (line.rail && line.latest && !passedAlready) {
    const VerdictText now = railVerdict(line);
    QString word = now.symbol == StateSymbol::Out ? tr("Out") : now.word;
    tiles_.push_back(
        {QString::fromStdString(line.rail->rail.id), word + (now.held ? tr(", held") : tr(", now")), now.symbol, true});
  }
  summary_ = tr("good %1 of %2").arg(line.railsGood).arg(line.railsPassed);
  setAccessibleName(tr("Last rails: %1").arg(summary_));
  update();
}

void LastRails::paintTile(QPainter& painter, const QRectF& box, const Tile& tile) const {
  const Palette& p = theme_.palette();
  QColor fill = p.panel2, edge = p.t1;
  if (tile.symbol == StateSymbol::Out) fill = p.outSoft, edge = p.out;
  if (tile.symbol == StateSymbol::Near) fill = p.nearSoft, edge = p.nearInk;
  if (tile.symbol == StateSymbol::NotMeasured) fill = p.invalidSoft, edge = p.invalid;
  painter.setPen(tile.now ? QPen(edge, 2) : Qt::NoPen);
  painter.setBrush(fill);
  painter.drawRoundedRect(tile.now ? box.adjusted(1, 1, -1, -1) : box, 3, 3);
  // Low windows have one line: symbol, id and word side by side.
  const bool oneLine = box.height() < kTwoLines;
  const double middle = box.center().y();
  const double symbolY = oneLine ? middle - 12 : middle - 25, idBaseline = oneLine ? middle + 7 : middle - 5;
  paintSymbol(painter, QRectF(box.left() + 10, symbolY, 24, 24), tile.symbol, p);
  const QFont small = uiFont(15);
  // The rail's name stands whole where it can, the word gives way.
  const double name = std::min(QFontMetricsF(uiFont(15, 500)).horizontalAdvance(tile.id), 0.5 * box.width());
  const QString word =
      oneLine ? QFontMetricsF(small).elidedText(tile.word, Qt::ElideRight, box.width() - 42 - 20 - name) : tile.word;
  const double wordWidth = oneLine ? QFontMetricsF(small).horizontalAdvance(word) + 10 : 0;
  const double room = box.width() - 42 - 8 - wordWidth;
  QFont id = uiFont(20, 500);
  while (id.pixelSize() > 15 && QFontMetricsF(id).horizontalAdvance(tile.id) > room)
    id.setPixelSize(id.pixelSize() - 1);
  painter.setPen(p.t1);
  painter.setFont(id);
  painter.drawText(QPointF(box.left() + 42, idBaseline), QFontMetricsF(id).elidedText(tile.id, Qt::ElideLeft, room));
  painter.setPen(p.t2);
  painter.setFont(small);
  if (oneLine)
    painter.drawText(QPointF(box.right() - wordWidth, idBaseline), word);
  else
    painter.drawText(QPointF(box.left() + 12, middle + 25),
                     QFontMetricsF(small).elidedText(tile.word, Qt::ElideRight, box.width() - 18));
}

void LastRails::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(p.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  const double middle = height() / 2.0;
  painter.setPen(p.t1);
  painter.setFont(uiFont(16, 500));
  painter.drawText(QPointF(16, middle - 8), tr("Last rails"));
  painter.setPen(p.t2);
  painter.setFont(uiFont(14));
  painter.drawText(QPointF(16, middle + 16), summary_);

  const double margin = height() < 80 ? 7 : 10;
  const double left = 124, room = width() - left - 8, wanted = height() - 2 * margin < kTwoLines ? 176 : 124;
  const int places = std::max(1, static_cast<int>(room / wanted));
  const double tile = room / places;
  const int shown = std::min<int>(places, static_cast<int>(tiles_.size()));
  // The one under way has its fixed place at the right end: the eye need not look for it.
  for (int i = 0; i < shown; ++i) {
    const auto& t = tiles_[tiles_.size() - static_cast<std::size_t>(shown - i)];
    paintTile(painter, QRectF(left + (places - shown + i) * tile, margin, tile - 2, height() - 2 * margin), t);
  }
}

}  // namespace vignole
