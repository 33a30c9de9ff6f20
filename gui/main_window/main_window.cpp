#include "gui/main_window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/alarms/alarms_page.h"
#include "gui/calibration/calibration_page.h"
#include "gui/charts/charts_page.h"
#include "gui/diagnostics/diagnostics_page.h"
#include "gui/main_window/alarm_line.h"
#include "gui/main_window/header_bar.h"
#include "gui/main_window/page_bar.h"
#include "gui/monitor/dimension_table.h"
#include "gui/monitor/monitor_page.h"
#include "gui/monitor/profile_canvas.h"
#include "gui/monitor/verdict_panel.h"
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
  setWindowTitle(QStringLiteral("Vignole"));
  auto* content = new QWidget(this);
  content->setObjectName(QStringLiteral("page"));
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  header_ = new HeaderBar(theme_, place.session, place.languages, clock, content);
  stack_ = new QStackedWidget(content);
  alarm_ = new AlarmLine(theme_, content);
  pages_ = new PageBar(theme_, content);
  column->addWidget(header_);
  column->addWidget(stack_, 1);
  column->addWidget(alarm_);
  column->addWidget(pages_);
  setCentralWidget(content);
  alarms_ = new AlarmWatch(
      place, [clock] { return AlarmTime(std::chrono::milliseconds(clock().toMSecsSinceEpoch())); }, this);
  connect(alarm_, &AlarmLine::acknowledged, alarms_, qOverload<std::uint64_t>(&AlarmWatch::acknowledge));
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
  monitor_ = new MonitorPage(theme_, place_.units, *line_.pull(PullDetail::Profile).recipe, stack_);
  add(PageId::Monitor, monitor_);
  add(PageId::Stripes, new StripesPage(place_, stack_));
  add(PageId::Charts, new ChartsPage(place_, stack_));
  auto* rails = new RailsPage(place_, stack_);
  connect(rails, &RailsPage::liveAsked, this, [this] { showPage(PageId::Monitor); });
  add(PageId::Rails, rails);
  add(PageId::Calibration, new CalibrationPage(place_, stack_));
  add(PageId::Recipes, new RecipesPage(place_, stack_));
  add(PageId::Quality, new QualityPage(place_, stack_));
  add(PageId::Alarms, new AlarmsPage(place_, *alarms_, stack_));
  add(PageId::Diagnostics, new DiagnosticsPage(place_, watchdog_, stack_));
  settings_ = new SettingsPage(place_, stack_);
  add(PageId::Settings, settings_);
  connect(settings_, &SettingsPage::tourAsked, this, &MainWindow::startTour);
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

void MainWindow::startTour() {
  if (tour_) return;
  showPage(PageId::Monitor);
  const std::vector<Tour::Step> steps = {
      {&monitor_->verdict(), [] { return tr("Is this rail good?"); },
       [] {
         return tr(
             "The large word is the verdict of the rail so far; beside it stands whether the gauge can be "
             "trusted. Both are made for two metres' distance.");
       }},
      {&monitor_->canvas(), [] { return tr("The measured profile"); },
       [] {
         return tr(
             "The rail as it is measured, over its section; deviations are drawn twenty times larger. Keys 1 to "
             "4 show whole, head, web and foot, + and − change the magnification, C colours by camera.");
       }},
      {&monitor_->table(), [] { return tr("Every dimension"); },
       [] {
         return tr(
             "Value, deviation, uncertainty and where it lies in its tolerance; the hatched ends are closer to "
             "a limit than the uncertainty. Choose a row to see the dimension in the drawing.");
       }},
      {header_, [] { return tr("What runs"); },
       [] {
         return tr(
             "The line, the rail and who is here. SIMULATION: without a site the rails come from a virtual rig, "
             "measured by the real engine.");
       }},
      {pages_, [] { return tr("Ten pages"); },
       [] {
         return tr(
             "F1 to F10, in this order: rails that passed are on F4, alarms on F8, language, units and people on "
             "F10. Ctrl+R stops and starts the line.");
       }}};
  tour_ = new Tour(theme_, steps, centralWidget());
  connect(tour_, &Tour::left, this, [this] {
    monitor_->setFocus();
    emit tourLeft();
  });
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
  if (closing_ == Closing::AfterRail && line.state != LineState::Measuring) {
    closing_ = Closing::Now;
    QTimer::singleShot(0, this, &QWidget::close);
  }
  alarms_->follow(line);
  alarms_->observeWindow(watchdog_.takeWorstMs());
  alarm_->show(line, alarms_->book());
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
    if (alarm_->alarm()) alarms_->acknowledge(alarm_->alarm()->id);
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

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  // What is told by the line is told anew, in the other language.
  if (event->type() == QEvent::LanguageChange) tick(PullDetail::Everything);
}

void MainWindow::askBeforeClosing() {
  if (question_) {
    question_->raise();
    return;
  }
  question_ = new QMessageBox(QMessageBox::NoIcon, tr("Close Vignole"), tr("A rail is being measured."),
                              QMessageBox::NoButton, this);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setInformativeText(tr("What has been measured of it is kept; the rest would pass unmeasured."));
  QPushButton* after = question_->addButton(tr("Close after this rail"), QMessageBox::AcceptRole);
  QPushButton* now = question_->addButton(tr("Close now"), QMessageBox::DestructiveRole);
  QPushButton* stay = question_->addButton(tr("Stay"), QMessageBox::RejectRole);
  question_->setDefaultButton(after);
  question_->setEscapeButton(stay);
  for (QPushButton* button : {after, now, stay}) {
    button->setFont(uiFont(16, 500));
    button->setAccessibleName(button->text());
  }
  connect(after, &QPushButton::clicked, this, [this] {
    closing_ = Closing::AfterRail;
    tick(PullDetail::Everything);
  });
  connect(now, &QPushButton::clicked, this, [this] {
    closing_ = Closing::Now;
    close();
  });
  question_->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (closing_ != Closing::Now && line_.pull(PullDetail::Everything).state == LineState::Measuring) {
    event->ignore();
    askBeforeClosing();
    return;
  }
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
