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
  profileNotes_.clear();
  measureNotes_.clear();
  if (line.latest) {
    const ProfileResult& result = *line.latest;
    profileNotes_ << tr("%1 points").arg(count(result.profile.points.size()));
    measureNotes_ << (result.registration.valid ? tr("registered") : tr("not registered"));
    int measured = 0;
    for (const Dimension d : kDimensions) measured += result.measurement.dimensions[index(d)].valueMm ? 1 : 0;
    measureNotes_ << tr("%n dimension(s)", nullptr, measured);
  }
  setAccessibleName(tr("Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost")
                        .arg(triggers_.seen)
                        .arg(triggers_.measured)
                        .arg(triggers_.incomplete)
                        .arg(triggers_.lost));
  update();
}

void PipelinePanel::setConsumers(std::vector<Consumer> consumers) {
  consumers_ = std::move(consumers);
  update();
}

bool PipelinePanel::behind(const std::string& name) const {
  // Acquisition of a paced source waits for its trigger: its time is no work and cannot be behind.
  const StageStatistics* s = stage(name);
  const double budgetMs = expectedPerS_ > 0 ? 1000 / expectedPerS_ : 0;
  return s != nullptr && !name.starts_with("acquire") && budgetMs > 0 && s->meanMs > 0.8 * budgetMs;
}

void PipelinePanel::paintBox(QPainter& painter, const QRectF& box, bool near, bool out) const {
  const Palette& p = theme_.palette();
  painter.setPen(QPen(out ? p.out : near ? p.nearInk : p.line, out || near ? 2 : 1));
  painter.setBrush(out ? p.outSoft : near ? p.nearSoft : p.panel2);
  painter.drawRoundedRect(box, 3, 3);
  if (out || near)
    paintSymbol(painter, QRectF(box.right() - 26, box.top() + 5, 20, 20), out ? StateSymbol::Out : StateSymbol::Near,
                p);
}

const StageStatistics* PipelinePanel::stage(const std::string& name) const {
  const auto at = std::find_if(stages_.begin(), stages_.end(), [&](const auto& s) { return s.name == name; });
  return at == stages_.end() ? nullptr : &*at;
}

void PipelinePanel::paintStage(QPainter& painter, const QRectF& box, const std::string& name) const {
  const Palette& p = theme_.palette();
  const StageStatistics* s = stage(name);
  paintBox(painter, box, behind(name), false);
  const bool small = box.height() < 56;
  const double left = box.left() + 10, y = box.center().y() - (small ? 3 : 4);
  if (!s || s->count == 0) {
    text(painter, left, box.center().y() + 5, uiFont(16), p.t3, tr("no data"));
    return;
  }
  const QString mean = milliseconds(s->meanMs);
  const QFont figure = uiFont(small ? 18 : 22, 500);
  text(painter, left, y, figure, p.t1, mean);
  text(painter, left + QFontMetricsF(figure).horizontalAdvance(mean) + 4, y, uiFont(14), p.t2, tr("ms"));
  const QFont note = uiFont(14);
  text(painter, left, y + (small ? 18 : 20), note, p.t2,
       QFontMetricsF(note).elidedText(tr("SD %1   UCL %2").arg(milliseconds(s->sdMs), milliseconds(s->ucl99Ms)),
                                      Qt::ElideRight, box.width() - 14));
}

void PipelinePanel::paintTallStage(QPainter& painter, const QRectF& box, const std::string& name,
                                   const QStringList& notes) const {
  const Palette& p = theme_.palette();
  const StageStatistics* s = stage(name);
  paintBox(painter, box, behind(name), false);
  const double left = box.left() + 10, room = box.width() - 16;
  if (!s || s->count == 0) {
    text(painter, left, box.center().y() + 5, uiFont(16), p.t3, tr("no data"));
    return;
  }
  const QFont figure = uiFont(28, 500), note = uiFont(14);
  const QString mean = milliseconds(s->meanMs);
  double y = box.top() + 36;
  text(painter, left, y, figure, p.t1, mean);
  text(painter, left + QFontMetricsF(figure).horizontalAdvance(mean) + 4, y, uiFont(15), p.t2, tr("ms"));
  QStringList lines = {tr("SD %1").arg(milliseconds(s->sdMs)), tr("99 % UCL %1").arg(milliseconds(s->ucl99Ms))};
  lines << notes;
  for (const QString& line : lines) {
    y += 21;
    if (y > box.bottom() - 6) return;
    text(painter, left, y, note, p.t2, QFontMetricsF(note).elidedText(line, Qt::ElideRight, room));
  }
}

void PipelinePanel::paintQueue(QPainter& painter, const QRectF& box, const std::string& stageBehind) const {
  const StageStatistics* s = stage(stageBehind);
  paintQueue(painter, box, s ? s->queueDepth : 0, s ? s->queueHighWater : 0, s ? s->queueCapacity : 0,
             s && s->overflows > 0);
}

void PipelinePanel::paintQueue(QPainter& painter, const QRectF& box, std::size_t depth, std::size_t highWater,
                               std::size_t capacity, bool dropped) const {
  const Palette& p = theme_.palette();
  const double y = box.center().y();
  painter.setPen(QPen(p.t3, 1.5));
  painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
  if (capacity == 0) return;
  const double wide = std::min(box.width() - 16, 92.0);
  const QRectF queue(box.center().x() - wide / 2, y - 10, wide, 20);
  const auto share = [&](std::size_t n) {
    return std::min(1.0, static_cast<double>(n) / static_cast<double>(capacity));
  };
  painter.setBrush(p.panel2);
  painter.setPen(QPen(dropped ? p.out : p.t3, dropped ? 2 : 1));
  painter.drawRect(queue);
  const double inner = queue.width() - 4;
  painter.fillRect(QRectF(queue.left() + 2, queue.top() + 2, inner * share(depth), queue.height() - 4), p.t3);
  const double mark = queue.left() + 2 + inner * share(highWater);
  painter.fillRect(QRectF(mark - 1, queue.top() - 4, 2, queue.height() + 8), dropped ? p.out : p.t1);
  const QFont font = uiFont(14);
  const QString fill = tr("%1 of %2").arg(highWater).arg(capacity);
  text(painter, box.center().x() - QFontMetricsF(font).horizontalAdvance(fill) / 2, y + 28, font, p.t2, fill);
  if (dropped) paintSymbol(painter, QRectF(box.center().x() - 9, y - 33, 18, 18), StateSymbol::Out, p);
}

void PipelinePanel::paintStages(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  const bool narrow = area.width() < 1400;
  const double camera = narrow ? 84 : 96, queue = narrow ? 54 : 92, bend = narrow ? 12 : 18;
  const double box = std::min(206.0, (area.width() - camera - 5 * queue - 3 * bend) / 6);
  // What is left is spread over the queues: boxes need no more room than their figures.
  const double gap = (area.width() - camera - 3 * bend - 6 * box) / 5;
  std::array<double, 6> x{};
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = area.left() + camera + static_cast<double>(i) * (box + gap) + (i > 2 ? 2 * bend : 0) + (i > 4 ? bend : 0);
  const QFont heads = uiFont(15, 500);
  const QStringList columns = {tr("Acquisition"), tr("Line extraction"), tr("2D to 3D"),
                               tr("Profile"),     tr("Measurement"),     tr("Consumers")};
  for (int column = 0; column < 6; ++column)
    text(painter, x[static_cast<std::size_t>(column)], area.top() + 14, heads, p.t1,
         QFontMetricsF(heads).elidedText(columns[column], Qt::ElideRight, box + gap - 6));

  const double top = area.top() + 26, pitch = (area.bottom() - top) / kCameraCount, height = std::min(pitch - 10, 66.0);
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
  const double centre = middleY + height / 2, tall = std::min(2.8 * pitch, 170.0);
  paintQueue(painter, QRectF(joinX, middleY, x[3] - joinX, height), "profile");
  paintTallStage(painter, QRectF(x[3], centre - tall / 2, box, tall), "profile", profileNotes_);
  paintQueue(painter, QRectF(x[3] + box, middleY, gap, height), "measure");
  paintTallStage(painter, QRectF(x[4], centre - tall / 2, box, tall), "measure", measureNotes_);
  paintConsumers(painter, x[4] + box, centre, QRectF(x[5], top, box, 4 * pitch));
}

void PipelinePanel::paintConsumers(QPainter& painter, double fromX, double middleY, const QRectF& area) const {
  const Palette& p = theme_.palette();
  if (consumers_.empty()) return;
  const double pitch = area.height() / static_cast<double>(consumers_.size()), height = std::min(pitch - 26, 66.0);
  const double bendX = fromX + 10;
  double y = area.top() + (pitch - height) / 2;
  const double firstY = y + height / 2, lastY = firstY + pitch * static_cast<double>(consumers_.size() - 1);
  painter.setPen(QPen(p.t3, 1.5));
  painter.drawLine(QPointF(fromX, middleY), QPointF(bendX, middleY));
  painter.drawLine(QPointF(bendX, firstY), QPointF(bendX, lastY));
  for (const Consumer& c : consumers_) {
    const QRectF box(area.left(), y, area.width(), height);
    paintQueue(painter, QRectF(bendX, y, area.left() - bendX, height), c.queued, c.highWater, c.capacity, c.out);
    paintBox(painter, box, c.near, c.out);
    const QFont name = uiFont(17, 500), note = uiFont(14);
    text(painter, box.left() + 10, box.center().y() - 4, name, p.t1,
         QFontMetricsF(name).elidedText(c.name, Qt::ElideRight, box.width() - (c.near || c.out ? 40 : 16)));
    text(painter, box.left() + 10, box.center().y() + 17, note, p.t2,
         QFontMetricsF(note).elidedText(c.note, Qt::ElideRight, box.width() - 16));
    y += pitch;
  }
}

void PipelinePanel::paintLegend(QPainter& painter) const {
  const Palette& p = theme_.palette();
  const QFont small = uiFont(14);
  const QFontMetricsF metrics(small);
  const double base = height() - 6;
  double x = 0;
  const auto words = [&](const QString& what) {
    text(painter, x, base, small, p.t2, metrics.elidedText(what, Qt::ElideRight, width() - x));
    x += metrics.horizontalAdvance(what) + 28;
  };
  painter.fillRect(QRectF(x, base - 12, 14, 14), p.t3);
  x += 20;
  words(tr("in the queue now"));
  painter.fillRect(QRectF(x + 4, base - 14, 2, 18), p.t1);
  x += 14;
  words(tr("highest fill, of how many places"));
  words(tr("mean time, SD standard deviation, UCL upper limit of its 99 % confidence interval"));
}

void PipelinePanel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintStages(painter, QRectF(0, 0, width(), height() - 26));
  paintLegend(painter);
}

}  // namespace vignole
