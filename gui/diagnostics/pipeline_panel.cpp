#include "gui/diagnostics/pipeline_panel.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "gui/theme/inscription.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr double kPad = 16;

QString milliseconds(double ms) { return QString::number(ms, 'f', ms < 0.995 ? 3 : ms < 99.5 ? 2 : 0); }

void text(QPainter& painter, double x, double baseline, const QFont& font, const QColor& ink, const QString& words) {
  painter.setFont(font);
  painter.setPen(ink);
  painter.drawText(QPointF(x, baseline), words);
}

void textRight(QPainter& painter, double right, double baseline, const QFont& font, const QColor& ink,
               const QString& words) {
  text(painter, right - QFontMetricsF(font).horizontalAdvance(words), baseline, font, ink, words);
}

}  // namespace

PipelinePanel::PipelinePanel(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PipelinePanel::show(const LineSnapshot& line, const WindowHealth& window) {
  stages_ = line.stages;
  triggers_ = line.triggers;
  profilesPerS_ = line.profilesPerS;
  expectedPerS_ = line.expectedPerS;
  window_ = window;
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
  const bool small = box.height() < 68;
  const int figurePixels = small ? 17 : 22, line = small ? 15 : 18;
  const double left = box.left() + (small ? 7 : 10);
  const double y = box.top() + (box.height() - figurePixels - 2 * line) / 2 + figurePixels - 3;
  if (!s || s->count == 0) {
    text(painter, left, box.center().y() + 5, uiFont(16), p.t3, tr("no data"));
    return;
  }
  const QString mean = milliseconds(s->meanMs);
  const QFont figure = uiFont(figurePixels, 500);
  text(painter, left, y, figure, p.t1, mean);
  text(painter, left + QFontMetricsF(figure).horizontalAdvance(mean) + 4, y, uiFont(14), p.t2, tr("ms"));
  if (behind) paintSymbol(painter, QRectF(box.right() - 24, box.top() + 4, 20, 20), StateSymbol::Near, p);
  text(painter, left, y + line, uiFont(14), p.t2, tr("UCL %1").arg(milliseconds(s->ucl99Ms)));
  text(painter, left, y + 2 * line, uiFont(14), p.t2, tr("max %1").arg(milliseconds(s->maxMs)));
}

void PipelinePanel::paintQueue(QPainter& painter, const QRectF& box, const std::string& stageBehind,
                               bool upright) const {
  const Palette& p = theme_.palette();
  const StageStatistics* s = stage(stageBehind);
  const double y = box.center().y();
  painter.setPen(QPen(p.t3, 1.5));
  if (!upright) painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
  const QRectF queue(box.left() + 5, y - 9, box.width() - 10, 18);
  if (!s || s->queueCapacity == 0) return;
  const double share = std::min(1.0, static_cast<double>(s->queueHighWater) / static_cast<double>(s->queueCapacity));
  const bool dropped = s->overflows > 0;
  painter.setBrush(p.panel2);
  painter.setPen(QPen(dropped ? p.out : p.t3, dropped ? 2 : 1));
  painter.drawRect(queue);
  painter.fillRect(QRectF(queue.left() + 2, queue.top() + 2, (queue.width() - 4) * share, queue.height() - 4),
                   dropped ? p.out : p.t3);
  const QString fill = QStringLiteral("%1/%2").arg(s->queueHighWater).arg(s->queueCapacity);
  const QFont font = uiFont(14);
  // Beside the queue where the flow runs through it from above, else below it.
  if (upright)
    text(painter, queue.right() + 6, y + 5, font, p.t2, fill);
  else
    text(painter, box.center().x() - QFontMetricsF(font).horizontalAdvance(fill) / 2, y + 26, font, p.t2, fill);
  if (!dropped) return;
  paintSymbol(painter, QRectF(box.center().x() - 9, y - 31, 18, 18), StateSymbol::Out, p);
}

void PipelinePanel::paintStages(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  const bool narrow = area.width() < 640;
  const double number = narrow ? 20 : 26, queue = narrow ? 46 : 62;
  const double box = (area.width() - number - 3 * queue - 14) / 4.15;
  const double x[3] = {area.left() + number, area.left() + number + box + queue,
                       area.left() + number + 2 * (box + queue)};
  const double lastX = x[2] + box + queue + 14, lastWidth = area.right() - lastX;
  const QFont heads = uiFont(15, 500);
  const QStringList columns = {tr("Acquisition"), tr("Extraction"), tr("2D to 3D")};
  for (int column = 0; column < 3; ++column) text(painter, x[column], area.top() + 14, heads, p.t1, columns[column]);
  text(painter, lastX, area.top() + 24 + 0.5 * (area.height() - 24) / kCameraCount - 9, heads, p.t1, tr("Profile"));

  const double top = area.top() + 24, pitch = (area.bottom() - top) / kCameraCount, height = std::min(pitch - 8, 84.0);
  const double joinX = x[2] + box + 14;
  for (int c = 0; c < kCameraCount; ++c) {
    const double y = top + c * pitch;
    const std::string n = std::to_string(c + 1);
    text(painter, area.left(), y + height / 2 + 7, uiFont(20, 500), p.t1, QString::fromStdString(n));
    paintStage(painter, QRectF(x[0], y, box, height), "acquire." + n);
    paintQueue(painter, QRectF(x[0] + box, y, queue, height), "extract." + n);
    paintStage(painter, QRectF(x[1], y, box, height), "extract." + n);
    paintQueue(painter, QRectF(x[1] + box, y, queue, height), "translate." + n);
    paintStage(painter, QRectF(x[2], y, box, height), "translate." + n);
    painter.setPen(QPen(p.t3, 1.5));
    painter.drawLine(QPointF(x[2] + box, y + height / 2), QPointF(joinX, y + height / 2));
  }
  painter.drawLine(QPointF(joinX, top + height / 2), QPointF(joinX, top + 3 * pitch + height / 2));
  const double profileY = top + 0.5 * pitch, measureY = top + 2.5 * pitch;
  paintQueue(painter, QRectF(joinX, profileY, lastX - joinX, height), "profile");
  paintStage(painter, QRectF(lastX, profileY, lastWidth, height), "profile");
  paintStage(painter, QRectF(lastX, measureY, lastWidth, height), "measure");
  painter.setPen(QPen(p.t3, 1.5));
  const double middle = lastX + lastWidth / 2;
  painter.drawLine(QPointF(middle, profileY + height), QPointF(middle, measureY));
  const double between = (profileY + height + measureY) / 2;
  paintQueue(painter, QRectF(middle - queue / 2, between - 9, queue, 18), "measure", true);
  text(painter, lastX, measureY + height + 20, heads, p.t1, tr("Measurement"));
}

void PipelinePanel::paintLedger(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  const std::uint64_t accounted = triggers_.measured + triggers_.incomplete + triggers_.lost;
  const std::uint64_t under = triggers_.seen > accounted ? triggers_.seen - accounted : 0;
  struct Row {
    QString words;
    std::uint64_t n;
    StateSymbol symbol;
    bool strong;
  };
  const Row rows[] = {{tr("Triggers"), triggers_.seen, StateSymbol::NoLimit, true},
                      {tr("Measured"), triggers_.measured, StateSymbol::Good, false},
                      {tr("Incomplete"), triggers_.incomplete,
                       triggers_.incomplete > 0 ? StateSymbol::Near : StateSymbol::NoLimit, false},
                      {tr("Lost"), triggers_.lost, triggers_.lost > 0 ? StateSymbol::Out : StateSymbol::NoLimit, false},
                      {tr("Under way"), under, StateSymbol::NoLimit, true}};
  text(painter, area.left(), area.top() + 16, uiFont(18, 500), p.t1, tr("Every trigger accounted for"));
  const double pitch = std::min(34.0, (area.height() - 26) / 5);
  double y = area.top() + 26;
  for (const Row& row : rows) {
    painter.fillRect(QRectF(area.left(), y, area.width(), 1), p.line2);
    const double baseline = y + pitch / 2 + 6;
    if (!row.strong) paintSymbol(painter, QRectF(area.left(), y + pitch / 2 - 10, 20, 20), row.symbol, p);
    text(painter, area.left() + (row.strong ? 0 : 30), baseline, uiFont(16, row.strong ? 500 : 400), p.t1, row.words);
    textRight(painter, area.right(), baseline, uiFont(18, 500), p.t1, count(row.n));
    y += pitch;
  }
}

void PipelinePanel::paintReasons(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  text(painter, area.left(), area.top() + 16, uiFont(18, 500), p.t1, tr("Why not measured"));
  std::vector<std::pair<std::uint64_t, std::string>> reasons;
  for (const auto& [words, n] : triggers_.reasons) reasons.emplace_back(n, words);
  std::sort(reasons.rbegin(), reasons.rend());
  const double pitch = std::min(34.0, (area.height() - 26) / 5);
  const auto places = static_cast<std::size_t>(3);
  double y = area.top() + 26;
  const QFont font = uiFont(16);
  if (reasons.empty()) {
    painter.fillRect(QRectF(area.left(), y, area.width(), 1), p.line2);
    text(painter, area.left(), y + pitch / 2 + 6, font, p.t3, tr("nothing was missing"));
  }
  for (std::size_t i = 0; i < std::min(places, reasons.size()); ++i, y += pitch) {
    painter.fillRect(QRectF(area.left(), y, area.width(), 1), p.line2);
    const QString n = count(reasons[i].first);
    const double room = area.width() - QFontMetricsF(font).horizontalAdvance(n) - 16;
    text(painter, area.left(), y + pitch / 2 + 6, font, p.t1,
         QFontMetricsF(font).elidedText(QString::fromStdString(reasons[i].second), Qt::ElideRight, room));
    textRight(painter, area.right(), y + pitch / 2 + 6, uiFont(18, 500), p.t1, n);
  }
  y = area.top() + 26 + 3 * pitch;
  painter.fillRect(QRectF(area.left(), y, area.width(), 1), p.line2);
  const bool slow = window_.turnP99Ms > 50;
  text(painter, area.left(), y + pitch / 2 + 6, font, p.t2, tr("Window turn p99"));
  textRight(painter, area.right(), y + pitch / 2 + 6, font, slow ? p.out : p.t2,
            tr("%1 of 50 ms").arg(window_.turnP99Ms, 0, 'f', 1));
  y += pitch;
  painter.fillRect(QRectF(area.left(), y, area.width(), 1), p.line2);
  text(painter, area.left(), y + pitch / 2 + 6, font, p.t2, tr("Profiles"));
  textRight(painter, area.right(), y + pitch / 2 + 6, font, p.t2,
            tr("%1 of %2 per second").arg(profilesPerS_, 0, 'f', 1).arg(expectedPerS_, 0, 'f', 1));
}

void PipelinePanel::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(p.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  text(painter, kPad, 32, uiFont(20, 500), p.t1, tr("Pipeline"));
  const QString note =
      tr("mean time of a stage; UCL: upper limit of the 99 % confidence interval; queues: highest fill");
  const QFont small = uiFont(14);
  text(painter, kPad + 90, 31, small, p.t2,
       QFontMetricsF(small).elidedText(note, Qt::ElideRight, width() - 90 - 2 * kPad));
  const double ledgerHeight = std::min(200.0, height() * 0.34);
  const double split = height() - ledgerHeight - kPad;
  paintStages(painter, QRectF(kPad, 48, width() - 2 * kPad, split - 48 - 12));
  const double half = (width() - 3 * kPad) / 2;
  paintLedger(painter, QRectF(kPad, split, half, ledgerHeight));
  paintReasons(painter, QRectF(2 * kPad + half, split, half, ledgerHeight));
}

}  // namespace vignole
