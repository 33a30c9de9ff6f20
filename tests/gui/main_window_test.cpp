#include "gui/main_window/main_window.h"

#include <QAbstractButton>
#include <QImage>
#include <QMessageBox>
#include <QTest>
#include <gtest/gtest.h>
#include <set>

#include "gui/languages/languages.h"
#include "gui/main_window/alarm_line.h"
#include "gui/main_window/header_bar.h"
#include "gui/main_window/tour.h"
#include "gui/monitor/dimension_model.h"
#include "gui/monitor/dimension_table.h"
#include "gui/monitor/monitor_page.h"
#include "gui/monitor/profile_canvas.h"
#include "gui/monitor/verdict_panel.h"
#include "gui/plots/strip_chart.h"
#include "tests/gui/least_size.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

QDateTime stillClock() { return QDateTime(QDate(2026, 11, 22), QTime(14, 32, 7)); }

class MainWindowTest : public ::testing::Test {
 protected:
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Languages languages;  // English has plurals too
  Workplace place{theme, line, session, units};
  std::unique_ptr<MainWindow> window;

  void SetUp() override {
    place.languages = &languages;
    line.snapshot = makeSnapshot();
    window = std::make_unique<MainWindow>(place, stillClock);
    window->resize(1920, 1080);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  void show(const LineSnapshot& snapshot) {
    line.snapshot = snapshot;
    window->tick(PullDetail::Everything);
  }
  void key(int code, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window.get(), static_cast<Qt::Key>(code), modifiers);
  }
  const ProfileDrawing& drawing() { return window->monitor().canvas().drawing(); }
};

TEST_F(MainWindowTest, ShowsEachState) {
  show(emptySnapshot(LineState::Idle));
  EXPECT_EQ(window->header().stateWord(), QStringLiteral("Idle"));
  EXPECT_EQ(window->monitor().verdict().verdict().word, QStringLiteral("Waiting for a rail"));
  EXPECT_EQ(drawing().profile, nullptr);

  show(makeSnapshot());
  EXPECT_EQ(window->header().stateWord(), QStringLiteral("Measuring"));
  EXPECT_EQ(window->monitor().verdict().verdict().word, QStringLiteral("Good"));
  EXPECT_FALSE(window->alarmLine().alarm());
  EXPECT_EQ(drawing().profile, &line.snapshot.latest->profile);
  EXPECT_FALSE(drawing().selected) << "a good rail needs no pointing at";

  show(makeSnapshot({.deviationMm = {{Dimension::WT, 1.032}}}));
  EXPECT_EQ(window->monitor().verdict().verdict().word, QStringLiteral("Out of tolerance"));
  ASSERT_TRUE(window->alarmLine().alarm());
  EXPECT_EQ(drawing().selected, Dimension::WT);

  show(heldSnapshot(134));
  EXPECT_EQ(window->header().stateWord(), QStringLiteral("Stopped"));
  EXPECT_TRUE(drawing().held);
  EXPECT_TRUE(window->monitor().verdict().verdict().held);
}

TEST_F(MainWindowTest, KeysOneToFourChooseTheView) {
  const ProfileView views[] = {ProfileView::Whole, ProfileView::Head, ProfileView::Web, ProfileView::Foot};
  for (int i = 3; i >= 0; --i) {
    key(Qt::Key_1 + i);
    EXPECT_EQ(drawing().view, views[i]);
  }
}

TEST_F(MainWindowTest, PlusMinusZeroMagnify) {
  EXPECT_EQ(drawing().magnification, 20);
  key(Qt::Key_Plus);
  EXPECT_EQ(drawing().magnification, 50);
  for (int i = 0; i < 5; ++i) key(Qt::Key_Plus);
  EXPECT_EQ(drawing().magnification, 100);
  for (int i = 0; i < 10; ++i) key(Qt::Key_Minus);
  EXPECT_EQ(drawing().magnification, 1);
  key(Qt::Key_0);
  EXPECT_EQ(drawing().magnification, 20);
}

TEST_F(MainWindowTest, CColoursByCamera) {
  key(Qt::Key_C);
  EXPECT_TRUE(drawing().byCamera);
  key(Qt::Key_C);
  EXPECT_FALSE(drawing().byCamera);
}

TEST_F(MainWindowTest, FullViewAndTheWayBack) {
  key(Qt::Key_F11);
  EXPECT_TRUE(window->monitor().fullView());
  EXPECT_FALSE(window->monitor().table().isVisible());
  EXPECT_TRUE(window->monitor().canvas().isVisible());
  EXPECT_GT(window->monitor().canvas().width(), 1800);
  key(Qt::Key_Escape);
  EXPECT_FALSE(window->monitor().fullView());
  EXPECT_TRUE(window->monitor().table().isVisible());
}

TEST_F(MainWindowTest, AChosenRowIsDrawnAndChartedAndEscapeLetsGo) {
  window->monitor().table().choose(Dimension::HW);
  window->tick(PullDetail::Everything);
  EXPECT_EQ(drawing().selected, Dimension::HW);
  const auto strips = window->monitor().findChildren<StripChart*>();
  ASSERT_EQ(strips.size(), 2);
  EXPECT_EQ(strips[0]->series().name, QStringLiteral("HW"));
  EXPECT_NE(strips[1]->series().name, QStringLiteral("HW"));
  key(Qt::Key_Escape);
  EXPECT_FALSE(drawing().selected);
}

TEST_F(MainWindowTest, CtrlDChangesEveryColourAndNothingElse) {
  const QImage light = window->grab().toImage();
  key(Qt::Key_D, Qt::ControlModifier);
  EXPECT_TRUE(theme.dark());
  const QImage dark = window->grab().toImage();
  ASSERT_EQ(light.size(), dark.size());
  EXPECT_EQ(light.pixelColor(4, 200), lightPalette().bg);
  EXPECT_EQ(dark.pixelColor(4, 200), darkPalette().bg);
  key(Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(window->grab().toImage(), light);
}

TEST_F(MainWindowTest, CtrlRStopsAndStartsTheLine) {
  key(Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(line.stops, 1);
  key(Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(line.starts, 1);
}

TEST_F(MainWindowTest, ClosingStopsTheLine) {
  show(emptySnapshot());
  EXPECT_TRUE(window->close());
  EXPECT_EQ(line.stops, 1);
}

TEST_F(MainWindowTest, ClosingWhileARailIsMeasuredAsksAndFinishesIt) {
  EXPECT_FALSE(window->close());
  ASSERT_NE(window->question(), nullptr);
  EXPECT_EQ(line.stops, 0);
  const auto press = [this](const char* name) {
    for (QAbstractButton* button : window->question()->buttons())
      if (button->accessibleName() == QLatin1String(name)) return QTest::mouseClick(button, Qt::LeftButton);
    ADD_FAILURE() << name;
  };
  press("Stay");
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->question() == nullptr; }));
  EXPECT_FALSE(window->close());
  press("Close after this rail");
  EXPECT_TRUE(window->isVisible());
  EXPECT_EQ(line.stops, 0) << "the rail is finished first";
  show(emptySnapshot());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window->isVisible(); }));
  EXPECT_EQ(line.stops, 1);
}

TEST_F(MainWindowTest, CtrlAAcknowledgesWhatTheAlarmLineShows) {
  show(makeSnapshot({.deviationMm = {{Dimension::WT, 1.4}, {Dimension::HW, 0.9}}}));
  ASSERT_TRUE(window->alarmLine().alarm());
  EXPECT_EQ(window->alarmLine().cause(), QStringLiteral("Rail V1-0007 out of tolerance: HW and WT"));
  key(Qt::Key_A, Qt::ControlModifier);
  window->tick(PullDetail::Everything);
  EXPECT_FALSE(window->alarmLine().alarm()) << window->alarmLine().cause().toStdString();
  EXPECT_EQ(window->alarmLine().quiet(), QStringLiteral("1 alarm acknowledged, still on"));
}

TEST_F(MainWindowTest, InchesAreShownAtOnceAndStoredMillimetresStay) {
  const auto value = [this] {
    const auto* model = window->monitor().table().model();
    return model->index(static_cast<int>(index(Dimension::FW)), DimensionModel::Value).data().toString();
  };
  const QString millimetres = value();
  EXPECT_TRUE(millimetres.startsWith(QStringLiteral("150."))) << millimetres.toStdString();
  units.setLength(Units::Length::Inch);
  window->tick(PullDetail::Everything);
  EXPECT_TRUE(value().startsWith(QStringLiteral("5.9"))) << value().toStdString();
  EXPECT_EQ(window->monitor().table().model()->headerData(DimensionModel::Value, Qt::Horizontal).toString(),
            QStringLiteral("in"));
  EXPECT_EQ(drawing().unit, LengthUnit::Inch);
  units.setLength(Units::Length::Millimetre);
  window->tick(PullDetail::Everything);
  EXPECT_EQ(value(), millimetres);
}

TEST_F(MainWindowTest, WhoeverHasGoneLeavesTheOperatorsScreenAndThePageStays) {
  window->setIdleReturn(std::chrono::milliseconds(50));
  window->showPage(PageId::Charts);
  session.enter(QStringLiteral("Ana"), Role::Technician);
  EXPECT_TRUE(QTest::qWaitFor([&] { return session.role() == Role::Operator; }));
  EXPECT_EQ(window->page(), PageId::Charts);
  EXPECT_TRUE(window->isVisible());
}

TEST_F(MainWindowTest, TheTourPointsAndIsLeftWithEsc) {
  window->startTour();
  ASSERT_NE(window->tour(), nullptr);
  key(Qt::Key_Right);
  QTest::keyClick(window->tour(), Qt::Key_Right);
  EXPECT_GE(window->tour()->step(), 1U);
  for (const QSize& size : {QSize(1366, 768), QSize(1920, 1080)}) {
    window->resize(size);
    EXPECT_EQ(window->tour()->size(), size);
  }
  QTest::keyClick(window->tour(), Qt::Key_Escape);
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->tour() == nullptr; }));
}

TEST_F(MainWindowTest, PullsOnATickAndStopsWhenClosed) {
  window->startTicking();
  show(makeSnapshot({.deviationMm = {{Dimension::WT, 1.4}}}));
  line.snapshot = makeSnapshot();
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->monitor().verdict().verdict().word == QStringLiteral("Good"); }));
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->watchdog().turns() > 5; }));
}

TEST_F(MainWindowTest, EveryControlHasANameAndIsReachedByTab) {
  std::set<const QWidget*> reached;
  const QWidget* at = window.get();
  do {
    if ((at->focusPolicy() & Qt::TabFocus) != 0) reached.insert(at);
    at = at->nextInFocusChain();
  } while (at != window.get());
  int controls = 0;
  for (const QWidget* w : window->findChildren<QWidget*>()) {
    const bool control = qobject_cast<const QAbstractButton*>(w) || qobject_cast<const DimensionTable*>(w);
    if (!control || !w->isVisible()) continue;
    ++controls;
    EXPECT_FALSE(w->accessibleName().isEmpty()) << w->metaObject()->className();
    EXPECT_TRUE(reached.count(w)) << w->accessibleName().toStdString();
  }
  EXPECT_GE(controls, 13);
}

TEST_F(MainWindowTest, FocusIsVisible) {
  auto* button = window->findChildren<QAbstractButton*>().front();
  const QImage before = button->grab().toImage();
  button->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(button->hasFocus());
  EXPECT_NE(button->grab().toImage(), before);
}

class WindowSize : public MainWindowTest, public ::testing::WithParamInterface<QSize> {};

/// A widget has at least its minimum, and lies within its parent.
void expectUnclipped(const QWidget& root) {
  for (const QWidget* w : root.findChildren<QWidget*>()) {
    if (!w->isVisible() || w->parentWidget() == nullptr || w->inherits("QCustomPlot") ||
        w->parentWidget()->inherits("QAbstractScrollArea"))
      continue;
    const QSize least = leastSize(*w);
    const std::string who =
        std::string(w->metaObject()->className()) + " \"" + w->accessibleName().toStdString() + "\"";
    EXPECT_GE(w->width(), least.width()) << who;
    EXPECT_GE(w->height(), least.height()) << who;
    EXPECT_TRUE(w->parentWidget()->rect().contains(w->geometry()))
        << who << " at " << w->x() << "," << w->y() << " " << w->width() << "x" << w->height();
  }
}

TEST_P(WindowSize, NothingIsClipped) {
  window->resize(GetParam());
  ASSERT_EQ(window->size(), GetParam());
  for (const LineSnapshot& snapshot :
       {emptySnapshot(), makeSnapshot({.deviationMm = {{Dimension::WT, 1.4}}}), heldSnapshot(100),
        makeSnapshot({.missing = {{Dimension::RFH, "SHBR has 0 points"}}, .lostCamera = 2})}) {
    show(snapshot);
    expectUnclipped(*window);
  }
  for (int i = 0; i < kPageCount; ++i) {
    window->showPage(static_cast<PageId>(i));
    expectUnclipped(*window);
  }
  window->showPage(PageId::Monitor);
  key(Qt::Key_F11);
  expectUnclipped(*window);
}

INSTANTIATE_TEST_SUITE_P(Sizes, WindowSize,
                         ::testing::Values(QSize(1366, 768), QSize(1600, 900), QSize(1920, 1080), QSize(3840, 2160)),
                         [](const auto& size) { return "W" + std::to_string(size.param.width()); });

}  // namespace
}  // namespace vignole
