// Alarms, from what the line says to what a person does with them; time stands in the test's hand.

#include "gui/alarms/alarms_page.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>

#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;
using namespace std::chrono_literals;

class AlarmsTest : public ::testing::Test {
 protected:
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  AlarmTime now{std::chrono::hours(500000)};
  AlarmWatch watch{place, [this] { return now; }};

  void follow(const LineSnapshot& snapshot, int seconds = 10) {
    for (int i = 0; i < seconds; ++i) {
      now += 1s;
      watch.follow(snapshot);
    }
  }
  static void press(QWidget& page, const QString& name) {
    for (QPushButton* button : page.findChildren<QPushButton*>())
      if (button->accessibleName().startsWith(name)) {
        ASSERT_TRUE(button->isEnabled()) << name.toStdString();
        QTest::mouseClick(button, Qt::LeftButton);
        return;
      }
    FAIL() << "no button " << name.toStdString();
  }
};

TEST_F(AlarmsTest, ABadRailIsOneAlarmHoweverManyDimensions) {
  const LineSnapshot bad = makeSnapshot({.deviationMm = {{Dimension::WT, 1.4}, {Dimension::HW, 0.8}}});
  follow(bad);
  ASSERT_EQ(watch.book().active().size(), 1U);
  const Alarm alarm = watch.book().active().front();
  EXPECT_EQ(alarm.key.rule, "rail.out-of-tolerance");
  EXPECT_EQ(alarm.details.size(), 2U) << "told once, however long the stretch grows";
  EXPECT_EQ(watch.rates().tenMinutes, 1U);
  // The next rail is good; the alarm waits for somebody to have seen it.
  LineSnapshot good = makeSnapshot();
  auto summary = std::make_shared<RailSummary>(*good.rail);
  summary->rail.id = "the next one";
  good.rail = summary;
  follow(good);
  ASSERT_EQ(watch.book().active().size(), 1U);
  watch.acknowledgeAll();
  EXPECT_TRUE(watch.book().active().empty());
}

TEST_F(AlarmsTest, ALostCameraIsAlarmingAfterItsDelayAndGoesWhenItIsBack) {
  const LineSnapshot without = makeSnapshot({.lostCamera = 2});
  LineSnapshot lost = without;
  lost.lostCameras = {{2, 1.0, "no frames"}};
  follow(lost, 1);
  const auto isLost = [&] {
    for (const Alarm& alarm : watch.book().active())
      if (alarm.key == AlarmKey{"camera.lost", "camera 3"} && alarm.state != AlarmState::ReturnedUnacknowledged)
        return true;
    return false;
  };
  EXPECT_FALSE(isLost()) << "one that comes back within a second is none";
  follow(lost, 5);
  EXPECT_TRUE(isLost());
  follow(makeSnapshot(), 20);
  EXPECT_FALSE(isLost());
}

TEST_F(AlarmsTest, ThePageAcknowledgesAndShelvesWithAReasonUntilTheTimeIsUp) {
  AlarmsPage page(place, watch);
  page.resize(1888, 880);
  page.show();
  follow(heldSnapshot(100), 1);
  LineSnapshot fault = heldSnapshot(100);
  fault.state = LineState::Fault;
  fault.error = "the source is gone";
  follow(fault);
  ASSERT_EQ(watch.book().active().size(), 1U);
  press(page, QStringLiteral("Acknowledge: "));
  ASSERT_EQ(watch.book().active().size(), 1U);
  EXPECT_EQ(watch.book().active().front().state, AlarmState::Acknowledged);

  press(page, QStringLiteral("Shelve"));
  EXPECT_TRUE(watch.book().shelved().empty()) << "without a reason nothing is hidden";
  page.findChild<QLineEdit*>()->setText(QStringLiteral("exchange planned"));
  press(page, QStringLiteral("Shelve"));
  ASSERT_EQ(watch.book().shelved().size(), 1U);
  EXPECT_TRUE(watch.book().active().empty());
  now += 16min;
  follow(fault, 2);
  EXPECT_TRUE(watch.book().shelved().empty());
  EXPECT_EQ(watch.book().active().size(), 1U) << "what is still wrong comes back";
}

TEST_F(AlarmsTest, AnOperatorMayNotShelveForLongerThanAnHour) {
  AlarmsPage page(place, watch);
  page.show();
  const auto longest = [&] {
    for (QComboBox* box : page.findChildren<QComboBox*>())
      if (box->accessibleName() == QStringLiteral("For how long")) return box->itemData(box->count() - 1).toInt();
    return 0;
  };
  EXPECT_EQ(longest(), 60);
  session.enter(QStringLiteral("Ana"), Role::Technician);
  page.hide();
  page.show();
  EXPECT_EQ(longest(), 240);
}

}  // namespace
}  // namespace vignole
