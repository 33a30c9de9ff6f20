#include "gui/main_window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/alarms/alarms_page.h"
#include "gui/charts/charts_page.h"
#include "gui/diagnostics/diagnostics_page.h"
#include "gui/main_window/alarm_line.h"
#include "gui/main_window/header_bar.h"
#include "gui/main_window/page_bar.h"
#include "gui/monitor/dimension_table.h"
#include "gui/monitor/monitor_page.h"
#include "gui/quality/quality_page.h"
#include "gui/rails/rails_page.h"
#include "gui/recipes/recipes_page.h"
#include "gui/settings/settings_page.h"
#include "gui/stripes/stripes_page.h"

namespace vignole {

namespace {
constexpr int kIdleMs = 15 * 60 * 1000;
constexpr int kTickMs = 33;          // 30 pictures a second at most
constexpr int kTicksPerFigures = 6;  // five times a second: faster digits cannot be read
}  // namespace

MainWindow::MainWindow(Workplace& place, const Clock& clock) : place_(place), line_(place.line), theme_(place.theme) {
  setWindowTitle(tr("Vignole"));
  auto* content = new QWidget(this);
  content->setObjectName(QStringLiteral("page"));
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  header_ = new HeaderBar(theme_, place.session, clock, content);
  stack_ = new QStackedWidget(content);
  alarm_ = new AlarmLine(theme_, clock, content);
  pages_ = new PageBar(theme_, content);
  column->addWidget(header_);
  column->addWidget(stack_, 1);
  column->addWidget(alarm_);
  column->addWidget(pages_);
  setCentralWidget(content);
  alarms_ = new AlarmWatch(place, {}, this);
  addPages();
  setMinimumSize(1280, 720);

  const auto restyle = [this] { setStyleSheet(theme_.styleSheet()); };
  restyle();
  connect(&theme_, &Theme::changed, this, restyle);
  connect(&header_->themeButton(), &QPushButton::clicked, this, [this] { theme_.setDark(!theme_.dark()); });
  connect(&header_->userButton(), &QPushButton::clicked, this, &MainWindow::signInOrOut);
  connect(pages_, &PageBar::pageAsked, this, &MainWindow::showPage);
  connect(monitor_, &MonitorPage::runAsked, this, &MainWindow::toggleRun);
  bindKeys();
  monitor_->setFocus();  // no control looks pressed before a key has been

  ticks_.setInterval(kTickMs);
  ticks_.setTimerType(Qt::PreciseTimer);
  connect(&ticks_, &QTimer::timeout, this,
          [this] { tick(tickNumber_++ % kTicksPerFigures == 0 ? PullDetail::Everything : PullDetail::Profile); });
  seconds_.setInterval(1000);
  connect(&seconds_, &QTimer::timeout, header_, &HeaderBar::beat);
  idle_.setSingleShot(true);
  idle_.setInterval(kIdleMs);
  connect(&idle_, &QTimer::timeout, &place_.session, &Session::leave);
  connect(&place_.session, &Session::changed, this, [this] {
    if (place_.session.user().isEmpty())
      idle_.stop();
    else
      idle_.start();
  });
  qApp->installEventFilter(this);
  tick(PullDetail::Everything);
}

void MainWindow::addPages() {
  monitor_ = new MonitorPage(theme_, *line_.pull(PullDetail::Profile).recipe, stack_);
  add(PageId::Monitor, monitor_);
  add(PageId::Stripes, new StripesPage(place_, stack_));
  add(PageId::Charts, new ChartsPage(place_, stack_));
  auto* rails = new RailsPage(place_, stack_);
  connect(rails, &RailsPage::liveAsked, this, [this] { showPage(PageId::Monitor); });
  add(PageId::Rails, rails);
  add(PageId::Recipes, new RecipesPage(place_, stack_));
  add(PageId::Quality, new QualityPage(place_, stack_));
  add(PageId::Alarms, new AlarmsPage(place_, *alarms_, stack_));
  add(PageId::Diagnostics, new DiagnosticsPage(place_, watchdog_, stack_));
  settings_ = new SettingsPage(place_, stack_);
  add(PageId::Settings, settings_);
}

void MainWindow::add(PageId page, Page* widget) {
  all_[static_cast<std::size_t>(page)] = widget;
  stack_->addWidget(widget);
  pages_->addPage(page);
  bindKey(Qt::Key_F1 + static_cast<int>(page), [this, page] { showPage(page); });
}

void MainWindow::showPage(PageId page) {
  Page* widget = this->page(page);
  if (widget == nullptr) return;
  shown_ = page;
  stack_->setCurrentWidget(widget);
  pages_->setShown(page);
  widget->setFocus();
  tick(PullDetail::Everything);
}

void MainWindow::startTicking() {
  watchdog_.start();
  ticks_.start();
  seconds_.start();
}

void MainWindow::tick(PullDetail detail) {
  const LineSnapshot& line = line_.pull(detail);
  page(shown_)->showLine(line, detail);
  if (detail == PullDetail::Profile) return;
  header_->show(line);
  alarm_->show(line);
  alarms_->follow(line);
  pages_->setAlarms(alarms_->book().active().size());
}

void MainWindow::bindKey(const QKeySequence& key, std::function<void()> action) {
  auto* shortcut = new QShortcut(key, this);
  connect(shortcut, &QShortcut::activated, this, std::move(action));
}

void MainWindow::bindKeys() {
  bindKey(Qt::CTRL | Qt::Key_L, [this] { signInOrOut(); });
  bindKey(Qt::CTRL | Qt::Key_D, [this] { theme_.setDark(!theme_.dark()); });
  bindKey(Qt::CTRL | Qt::Key_A, [this] {
    // What the alarm line shows: the most urgent that nobody has seen.
    const std::vector<Alarm> active = alarms_->book().active();
    if (!active.empty()) alarms_->acknowledge(active.front().id);
  });
  bindKey(Qt::CTRL | Qt::SHIFT | Qt::Key_A, [this] { alarms_->acknowledgeAll(); });
  bindKey(Qt::CTRL | Qt::Key_R, [this] { toggleRun(); });
}

void MainWindow::signInOrOut() {
  if (!place_.session.user().isEmpty()) {
    place_.session.leave();
    return;
  }
  showPage(PageId::Settings);
  settings_->askForName();
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  // Whoever has gone away leaves the operator's screen; what it shows stays.
  const QEvent::Type type = event->type();
  if (type == QEvent::KeyPress || type == QEvent::MouseButtonPress || type == QEvent::Wheel ||
      type == QEvent::TouchBegin)
    if (idle_.isActive()) idle_.start();
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::toggleRun() {
  if (line_.running())
    line_.stop();
  else
    line_.start();
  tick(PullDetail::Everything);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  ticks_.stop();
  seconds_.stop();
  line_.stop();  // asks; the line's owner joins its threads
  event->accept();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  const bool low = height() < 900;
  header_->setFixedHeight(low ? 56 : 64);
  alarm_->setFixedHeight(low ? 40 : 48);
  pages_->setFixedHeight(low ? 48 : 56);
}

}  // namespace vignole
