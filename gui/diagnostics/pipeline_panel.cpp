#include "gui/diagnostics/pipeline_panel.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>

#include "gui/theme/inscription.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

QString milliseconds(double ms) { return QString::number(ms, 'f', ms < 0.995 ? 3 : ms < 99.5 ? 2 : 0); }

void text(QPainter& painter, double x, double baseline, const QFont& font, const QColor& ink, const QString& words) {
  painter.setFont(font);
  painter.setPen(ink);
  painter.drawText(QPointF(x, baseline), words);
}

}  // namespace

PipelinePanel::PipelinePanel(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PipelinePanel::show(const LineSnapshot& line) {
  stages_ = line.stages;
  triggers_ = line.triggers;
  expectedPerS_ = line.expectedPerS;
  setAccessibleName(tr("Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost")
                        .arg(triggers_.seen)
                        .arg(triggers_.measured)
                        .arg(triggers_.incomplete)
                        .arg(triggers_.lost));
  update();
}

const StageStatistics* PipelinePanel::stage(const std::string& name) const {
  const auto at = std::find_if(stages_.begin(), stages_.end(), [&](const auto& s) { return s.name == name; });
  return at == stages_.end() ? nullptr : &*at;
}

void PipelinePanel::paintStage(QPainter& painter, const QRectF& box, const std::string& name) const {
  const Palette& p = theme_.palette();
  const StageStatistics* s = stage(name);
  // Acquisition of a paced source waits for its trigger: its time is no work and cannot be behind.
  const bool waits = name.starts_with("acquire");
  const double budgetMs = expectedPerS_ > 0 ? 1000 / expectedPerS_ : 0;
  const bool behind = s && !waits && budgetMs > 0 && s->meanMs > 0.8 * budgetMs;
  painter.setPen(QPen(behind ? p.nearInk : p.line, behind ? 2 : 1));
  painter.setBrush(behind ? p.nearSoft : p.panel2);
  painter.drawRoundedRect(box, 3, 3);
  const bool small = box.height() < 56;
  const double left = box.left() + 10, y = box.center().y() - (small ? 1 : 4);
  if (!s || s->count == 0) {
    text(painter, left, box.center().y() + 5, uiFont(16), p.t3, tr("no data"));
    return;
  }
  const QString mean = milliseconds(s->meanMs);
  const QFont figure = uiFont(small ? 18 : 22, 500);
  text(painter, left, y, figure, p.t1, mean);
  text(painter, left + QFontMetricsF(figure).horizontalAdvance(mean) + 4, y, uiFont(14), p.t2, tr("ms"));
  if (behind) paintSymbol(painter, QRectF(box.right() - 26, box.top() + 5, 20, 20), StateSymbol::Near, p);
  const QFont note = uiFont(14);
  text(painter, left, y + 20, note, p.t2,
       QFontMetricsF(note).elidedText(tr("SD %1   UCL %2").arg(milliseconds(s->sdMs), milliseconds(s->ucl99Ms)),
                                      Qt::ElideRight, box.width() - 14));
}

void PipelinePanel::paintQueue(QPainter& painter, const QRectF& box, const std::string& stageBehind) const {
  const Palette& p = theme_.palette();
  const StageStatistics* s = stage(stageBehind);
  const double y = box.center().y();
  painter.setPen(QPen(p.t3, 1.5));
  painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
  if (!s || s->queueCapacity == 0) return;
  const double wide = std::min(box.width() - 16, 92.0);
  const QRectF queue(box.center().x() - wide / 2, y - 10, wide, 20);
  const auto share = [&](std::size_t n) {
    return std::min(1.0, static_cast<double>(n) / static_cast<double>(s->queueCapacity));
  };
  const bool dropped = s->overflows > 0;
  painter.setBrush(p.panel2);
  painter.setPen(QPen(dropped ? p.out : p.t3, dropped ? 2 : 1));
  painter.drawRect(queue);
  const double inner = queue.width() - 4;
  painter.fillRect(QRectF(queue.left() + 2, queue.top() + 2, inner * share(s->queueDepth), queue.height() - 4), p.t3);
  const double mark = queue.left() + 2 + inner * share(s->queueHighWater);
  painter.fillRect(QRectF(mark - 1, queue.top() - 4, 2, queue.height() + 8), dropped ? p.out : p.t1);
  const QFont font = uiFont(14);
  const QString fill = tr("%1 of %2").arg(s->queueHighWater).arg(s->queueCapacity);
  text(painter, box.center().x() - QFontMetricsF(font).horizontalAdvance(fill) / 2, y + 28, font, p.t2, fill);
  if (dropped) paintSymbol(painter, QRectF(box.center().x() - 9, y - 33, 18, 18), StateSymbol::Out, p);
}

void PipelinePanel::paintStages(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  const double camera = 96, queue = area.width() < 1400 ? 64 : 92, bend = 18;
  const double box = std::min(230.0, (area.width() - camera - 4 * queue - 2 * bend) / 5);
  // What is left is spread over the queues: boxes need no more room than their figures.
  const double gap = (area.width() - camera - 2 * bend - 5 * box) / 4;
  std::array<double, 5> x{};
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = area.left() + camera + static_cast<double>(i) * (box + gap) + (i > 2 ? 2 * bend : 0);
  const QFont heads = uiFont(15, 500);
  const QStringList columns = {tr("Acquisition"), tr("Line extraction"), tr("2D to 3D"), tr("Profile"),
                               tr("Measurement")};
  for (int column = 0; column < 5; ++column)
    text(painter, x[static_cast<std::size_t>(column)], area.top() + 14, heads, p.t1, columns[column]);

  const double top = area.top() + 26, pitch = (area.bottom() - top) / kCameraCount, height = std::min(pitch - 26, 66.0);
  const double joinX = x[2] + box + bend, middleY = top + 1.5 * pitch;
  const auto line = [&](double fromX, double fromY, double toX, double toY) {
    painter.setPen(QPen(p.t3, 1.5));
    painter.drawLine(QPointF(fromX, fromY), QPointF(toX, toY));
  };
  for (int c = 0; c < kCameraCount; ++c) {
    const double y = top + c * pitch;
    const std::string n = std::to_string(c + 1);
    text(painter, area.left(), y + height / 2 + 6, uiFont(17, 500), p.t1, tr("Camera %1").arg(c + 1));
    paintStage(painter, QRectF(x[0], y, box, height), "acquire." + n);
    paintQueue(painter, QRectF(x[0] + box, y, gap, height), "extract." + n);
    paintStage(painter, QRectF(x[1], y, box, height), "extract." + n);
    paintQueue(painter, QRectF(x[1] + box, y, gap, height), "translate." + n);
    paintStage(painter, QRectF(x[2], y, box, height), "translate." + n);
    line(x[2] + box, y + height / 2, joinX, y + height / 2);
  }
  line(joinX, top + height / 2, joinX, top + 3 * pitch + height / 2);
  paintQueue(painter, QRectF(joinX, middleY, x[3] - joinX, height), "profile");
  paintStage(painter, QRectF(x[3], middleY, box, height), "profile");
  paintQueue(painter, QRectF(x[3] + box, middleY, gap, height), "measure");
  paintStage(painter, QRectF(x[4], middleY, box, height), "measure");
}

void PipelinePanel::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QFont small = uiFont(14);
  paintStages(painter, QRectF(0, 0, width(), height() - 26));
  text(
      painter, 0, height() - 6, small, p.t2,
      QFontMetricsF(small).elidedText(
          tr("mean time of a stage, SD standard deviation, UCL upper limit of the 99 % confidence interval; of a queue "
             "now (dark), highest fill (mark) and size"),
          Qt::ElideRight, width()));
}

}  // namespace vignole
