#include "gui/monitor/monitor_page.h"

#include <QButtonGroup>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <algorithm>

#include "gui/monitor/dimension_table.h"
#include "gui/monitor/judgement.h"
#include "gui/monitor/last_rails.h"
#include "gui/monitor/profile_canvas.h"
#include "gui/monitor/verdict_panel.h"
#include "gui/plots/strip_chart.h"
#include "gui/theme/inscription.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

constexpr std::array<double, 7> kMagnifications = {1, 2, 5, 10, 20, 50, 100};
constexpr double kStartMagnification = 20;
// The second strip leaves windows narrower or lower than this.
constexpr int kWidthForTwoStrips = 1500, kHeightForTwoStrips = 700;

StripSeries seriesOf(const LineSnapshot& line, Dimension dimension, LengthUnit unit) {
  const auto shown = [unit](std::optional<double> mm) { return mm ? std::optional(inUnit(*mm, unit)) : std::nullopt; };
  StripSeries series;
  series.name = inscribed(dimension);
  series.value = QStringLiteral("–");
  series.held = line.held();
  if (line.latest) {
    const DimensionResult& r = line.latest->measurement.dimensions[index(dimension)];
    series.symbol = symbolOf(r.verdict);
    series.nominal = inUnit(r.nominalMm, unit);
    series.lower = shown(r.lowerMm);
    series.upper = shown(r.upperMm);
    series.least = inUnit(0.02, unit);
    series.decimals = decimalsIn(unit, 3);
    series.positionM = line.latest->profile.positionMm / 1000;
    series.value = r.valueMm ? lengthText(*r.valueMm, decimalsOf(dimension), unit) : MonitorPage::tr("no value");
  }
  if (line.rail) {
    const DimensionSummary& summary = line.rail->dimensions[index(dimension)];
    series.lengthM = line.rail->rail.lengthMm / 1000;
    for (const TrackBin& bin : summary.track)
      if (bin.count > 0) series.points.append({bin.positionM, inUnit(bin.meanMm, unit)});
    for (const DimensionException& e : summary.exceptions) series.outside.append({e.fromM, e.toM});
  }
  if (series.held) series.note = lineState(line.state).word;
  return series;
}

}  // namespace

MonitorPage::MonitorPage(const Theme& theme, const Units& units, const Recipe& recipe, QWidget* parent)
    : Page(parent), theme_(theme), units_(units), drawingPanel_(new QFrame(this)), tablePanel_(new QFrame(this)) {
  setObjectName(QStringLiteral("page"));
  drawingPanel_->setObjectName(QStringLiteral("plotPanel"));
  tablePanel_->setObjectName(QStringLiteral("panel"));

  toolbar_ = makeToolbar();
  canvas_ = new ProfileCanvas(theme, recipe, drawingPanel_);
  auto* drawing = new QVBoxLayout(drawingPanel_);
  drawing->setContentsMargins(16, 12, 16, 8);
  drawing->setSpacing(8);
  drawing->addWidget(toolbar_);
  drawing->addWidget(canvas_, 1);

  for (StripChart*& strip : strips_) strip = new StripChart(theme, this);
  verdict_ = new VerdictPanel(theme, this);
  table_ = new DimensionTable(theme, tablePanel_);
  auto* frame = new QVBoxLayout(tablePanel_);
  frame->setContentsMargins(1, 1, 1, 1);
  frame->addWidget(table_);
  lastRails_ = new LastRails(theme, this);
  QWidget::setTabOrder(byCamera_, before_);
  QWidget::setTabOrder(before_, full_);
  QWidget::setTabOrder(full_, run_);
  QWidget::setTabOrder(run_, table_);
  setFocusPolicy(Qt::ClickFocus);  // a press on no control takes the focus ring off the last one

  connect(table_, &DimensionTable::chosenChanged, this, [this] { pointAtDimension(nullptr); });
  connect(&theme_, &Theme::changed, this, &MonitorPage::relabel);
  connect(&units_, &Units::changed, this, &MonitorPage::showUnit);
  bindKeys();
  retranslate();
  showUnit();
  setMagnification(kStartMagnification);
}

QWidget* MonitorPage::makeToolbar() {
  auto* bar = new QWidget(drawingPanel_);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  views_ = new QButtonGroup(this);
  views_->setExclusive(true);
  for (const ProfileView view : {ProfileView::Whole, ProfileView::Head, ProfileView::Web, ProfileView::Foot}) {
    auto* button = new QPushButton(bar);
    button->setCheckable(true);
    button->setObjectName(QStringLiteral("segment"));
    button->setFont(uiFont(16, 500));
    views_->addButton(button, static_cast<int>(view));
    row->addWidget(button);
  }
  views_->button(0)->setChecked(true);
  connect(views_, &QButtonGroup::idClicked, this, [this](int id) { setView(static_cast<ProfileView>(id)); });

  row->addSpacing(4);
  less_ = new QPushButton(bar);
  magnificationLabel_ = new QLabel(bar);
  magnificationLabel_->setObjectName(QStringLiteral("magnification"));
  magnificationLabel_->setFixedHeight(44);
  magnificationLabel_->setFont(uiFont(18, 500));
  magnificationLabel_->setAlignment(Qt::AlignCenter);
  magnificationLabel_->setFixedWidth(64);
  more_ = new QPushButton(bar);
  for (QWidget* w : std::initializer_list<QWidget*>{less_, magnificationLabel_, more_}) row->addWidget(w);
  for (QPushButton* b : {less_, more_}) {
    b->setObjectName(QStringLiteral("segment"));
    b->setFixedWidth(44);
    b->setIconSize({20, 20});
  }
  connect(less_, &QPushButton::clicked, this, &MonitorPage::magnifyLess);
  connect(more_, &QPushButton::clicked, this, &MonitorPage::magnifyMore);

  row->addSpacing(4);
  byCamera_ = new QPushButton(bar);
  byCamera_->setCheckable(true);
  byCamera_->setFont(uiFont(16, 500));
  connect(byCamera_, &QPushButton::toggled, this, [this](bool on) { canvas_->setByCamera(on); });
  row->addWidget(byCamera_);
  before_ = new QPushButton(bar);
  before_->setCheckable(true);
  before_->setFixedWidth(52);
  before_->setIconSize({20, 20});
  connect(before_, &QPushButton::toggled, this, [this](bool on) { canvas_->setBeforeRegistration(on); });
  row->addWidget(before_);
  row->addStretch(1);
  full_ = new QPushButton(bar);
  full_->setCheckable(true);
  full_->setFixedWidth(52);
  full_->setIconSize({20, 20});
  connect(full_, &QPushButton::clicked, this, [this] { setFullView(!fullView_); });
  run_ = new QPushButton(bar);
  run_->setMinimumWidth(132);
  run_->setFont(uiFont(16, 500));
  run_->setIconSize({20, 20});
  connect(run_, &QPushButton::clicked, this, &MonitorPage::runAsked);
  row->addWidget(full_);
  row->addWidget(run_);
  return bar;
}

void MonitorPage::showProfile(const LineSnapshot& line) {
  if (canvas_->isVisible()) canvas_->show(line);
}

void MonitorPage::showLine(const LineSnapshot& line, PullDetail detail) {
  showProfile(line);
  if (detail == PullDetail::Everything) showFigures(line);
}

void MonitorPage::showFigures(const LineSnapshot& line) {
  verdict_->show(line, units_.length());
  table_->show(line);
  lastRails_->show(line);
  showStrips(line);
  pointAtDimension(&line);
  setRunning(line.state != LineState::Idle && line.state != LineState::Stopped && line.state != LineState::Fault);
}

void MonitorPage::showStrips(const LineSnapshot& line) {
  std::vector<Dimension> wanted = nearestToLimits(line, strips_.size(), stripDimensions_);
  // A chosen dimension has the first strip; the nearest other one the second.
  if (const auto chosen = table_->chosen(); chosen && !wanted.empty()) {
    const auto at = std::find(wanted.begin(), wanted.end(), *chosen);
    if (at == wanted.end())
      wanted.front() = *chosen;
    else
      std::iter_swap(wanted.begin(), at);
  }
  stripDimensions_ = wanted;
  for (std::size_t i = 0; i < strips_.size(); ++i)
    strips_[i]->show(i < wanted.size() ? seriesOf(line, wanted[i], units_.length()) : StripSeries{});
}

void MonitorPage::pointAtDimension(const LineSnapshot* line) {
  if (line) worst_ = worstOutside(*line);
  const auto chosen = table_->chosen();
  canvas_->setSelected(chosen ? chosen : worst_);
}

void MonitorPage::setView(ProfileView view) {
  views_->button(static_cast<int>(view))->setChecked(true);
  canvas_->setView(view);
}

void MonitorPage::setMagnification(double magnification) {
  magnification_ = std::clamp(magnification, kMagnifications.front(), kMagnifications.back());
  magnificationLabel_->setText(QStringLiteral("×%1").arg(magnification_));
  less_->setEnabled(magnification_ > kMagnifications.front());
  more_->setEnabled(magnification_ < kMagnifications.back());
  canvas_->setMagnification(magnification_);
}

void MonitorPage::magnifyMore() {
  const auto* next = std::upper_bound(kMagnifications.begin(), kMagnifications.end(), magnification_);
  if (next != kMagnifications.end()) setMagnification(*next);
}

void MonitorPage::magnifyLess() {
  const auto* at = std::lower_bound(kMagnifications.begin(), kMagnifications.end(), magnification_);
  if (at != kMagnifications.begin()) setMagnification(*(at - 1));
}

void MonitorPage::resetMagnification() { setMagnification(kStartMagnification); }
void MonitorPage::setByCamera(bool byCamera) { byCamera_->setChecked(byCamera); }
bool MonitorPage::byCamera() const { return byCamera_->isChecked(); }

void MonitorPage::setFullView(bool full) {
  if (full == fullView_) return;
  fullView_ = full;
  full_->setChecked(full);
  layOut();
}

void MonitorPage::setRunning(bool running) {
  if (running == running_) return;
  running_ = running;
  relabel();
}

void MonitorPage::showUnit() {
  table_->setUnit(units_.length());
  canvas_->setUnit(units_.length());
}

void MonitorPage::retranslate() {
  const QString views[] = {tr("Whole"), tr("Head"), tr("Web"), tr("Foot")};
  for (int i = 0; i < 4; ++i) {
    QAbstractButton* button = views_->button(i);
    button->setText(views[i]);
    button->setAccessibleName(tr("View: %1").arg(views[i].toLower()));
    button->setToolTip(tr("%1 of the section (%2)").arg(views[i]).arg(i + 1));
  }
  less_->setAccessibleName(tr("Magnify deviations less"));
  less_->setToolTip(tr("Magnify deviations less (−)"));
  magnificationLabel_->setToolTip(tr("Deviations are drawn so many times larger (0: back to 20)"));
  more_->setAccessibleName(tr("Magnify deviations more"));
  more_->setToolTip(tr("Magnify deviations more (+)"));
  byCamera_->setAccessibleName(tr("Colour points by camera"));
  byCamera_->setToolTip(tr("Colour points by camera (C)"));
  before_->setAccessibleName(tr("Show the points before registration"));
  before_->setToolTip(tr("Show the points before registration (B)"));
  full_->setAccessibleName(tr("Drawing in full view"));
  full_->setToolTip(tr("Drawing in full view (F11)"));
  table_->retranslate();
  canvas_->retranslate();
  relabel();
  layOut();
}

void MonitorPage::relabel() {
  const QString run = running_ ? tr("Stop line") : tr("Start line");
  run_->setText(compact_ ? QString() : run);
  byCamera_->setText(compact_ ? QString() : tr("By camera"));
  run_->setAccessibleName(run);
  run_->setToolTip(tr("%1 (Ctrl+R)").arg(run));
  const QColor ink = theme_.palette().t1;
  run_->setIcon(theme_.icon(running_ ? QStringLiteral("pause") : QStringLiteral("play"), 20, ink, devicePixelRatioF()));
  byCamera_->setIcon(compact_ ? QIcon(theme_.icon(QStringLiteral("camera"), 20, ink, devicePixelRatioF())) : QIcon());
  before_->setIcon(theme_.icon(QStringLiteral("compare"), 20, ink, devicePixelRatioF()));
  full_->setIcon(theme_.icon(QStringLiteral("fit"), 20, ink, devicePixelRatioF()));
  less_->setIcon(theme_.icon(QStringLiteral("minus"), 20, ink, devicePixelRatioF()));
  more_->setIcon(theme_.icon(QStringLiteral("add"), 20, ink, devicePixelRatioF()));
}

void MonitorPage::back() {
  if (fullView_)
    setFullView(false);
  else
    table_->choose({});
}

void MonitorPage::bindKeys() {
  const auto bind = [this](const QKeySequence& key, auto action) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  const ProfileView views[] = {ProfileView::Whole, ProfileView::Head, ProfileView::Web, ProfileView::Foot};
  for (int i = 0; i < 4; ++i) bind(QKeySequence(Qt::Key_1 + i), [this, view = views[i]] { setView(view); });
  bind(Qt::Key_Plus, [this] { magnifyMore(); });
  bind(Qt::Key_Equal, [this] { magnifyMore(); });  // + without Shift on many keyboards
  bind(Qt::Key_Minus, [this] { magnifyLess(); });
  bind(Qt::Key_0, [this] { resetMagnification(); });
  bind(Qt::Key_C, [this] { setByCamera(!byCamera()); });
  bind(Qt::Key_B, [this] { before_->toggle(); });
  bind(Qt::Key_F11, [this] { setFullView(!fullView_); });
  bind(Qt::Key_Escape, [this] { back(); });
}

void MonitorPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void MonitorPage::resizeEvent(QResizeEvent* /*event*/) { layOut(); }

// The grid of the mock-ups: sixteen columns, gutter and margin 16 (8 on small screens); seven columns for the drawing,
// nine for the figures. Wider windows stretch plots and the drawing.
void MonitorPage::layOut() {
  const bool low = height() < 760;
  const int gap = low || width() < 1600 ? 8 : 16;
  const QRect area = rect().adjusted(gap, gap, -gap, -gap);
  for (QWidget* w : std::initializer_list<QWidget*>{verdict_, tablePanel_, lastRails_, strips_[0], strips_[1]})
    w->setVisible(!fullView_);
  if (fullView_) {
    drawingPanel_->setGeometry(area);
    return;
  }
  const bool twoStrips = width() >= kWidthForTwoStrips && height() >= kHeightForTwoStrips;
  const int leftWidth = qRound((area.width() + gap) * 7.0 / 16) - gap;
  const int strip = low ? 80 : 88, stripGap = 8;
  strips_[1]->setVisible(twoStrips);
  const int stripsHeight = twoStrips ? 2 * strip + stripGap : strip;
  const QRect hero(area.left(), area.top(), leftWidth, area.height() - stripsHeight - gap);
  for (QAbstractButton* view : views_->buttons()) {
    view->setFont(uiFont(leftWidth < 640 ? 14 : 16, 500));
    const int word = view->fontMetrics().horizontalAdvance(view->text()) + 14;
    view->setFixedWidth(std::max(leftWidth < 640 ? 57 : leftWidth < 900 ? 64 : 84, word));
  }
  before_->setVisible(leftWidth >= 760);  // its key remains
  if (const bool compact = leftWidth < 900; compact != compact_) {
    compact_ = compact;
    for (QPushButton* b : {byCamera_, run_}) {
      b->setMinimumWidth(compact ? 52 : 132);  // its word changes
      b->setMaximumWidth(compact ? 52 : QWIDGETSIZE_MAX);
    }
    relabel();
  }
  drawingPanel_->setGeometry(hero);
  int y = hero.bottom() + 1 + gap;
  for (StripChart* s : strips_) {
    s->setGeometry(area.left(), y, leftWidth, strip);
    y += strip + stripGap;
  }

  const int right = area.left() + leftWidth + gap, rightWidth = area.right() + 1 - right;
  const int verdictHeight = low ? 92 : 120, lastHeight = low ? 60 : 96;
  verdict_->setGeometry(right, area.top(), rightWidth, verdictHeight);
  lastRails_->setGeometry(right, area.bottom() + 1 - lastHeight, rightWidth, lastHeight);
  const int tableTop = area.top() + verdictHeight + gap;
  tablePanel_->setGeometry(right, tableTop, rightWidth, area.bottom() + 1 - lastHeight - gap - tableTop);
}

}  // namespace vignole
