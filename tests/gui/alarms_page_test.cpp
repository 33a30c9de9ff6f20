// Alarms, from what the line says to what a person does with them; time stands in the test's hand.

#include "gui/alarms/alarms_page.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "engine/archive/alarm_history.h"
#include "gui/alarms/alarm_card.h"
#include "gui/alarms/alarm_history_panel.h"
#include "gui/alarms/alarm_words.h"
#include "gui/languages/languages.h"
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

TEST_F(AlarmsTest, AFloodIsShownGroupedAndAcknowledgedAtOnce) {
  AlarmsPage page(place, watch);
  page.resize(1888, 880);
  page.show();
  LineSnapshot bad = makeSnapshot({.deviationMm = {{Dimension::WT, 1.4}}});
  for (int i = 0; i < 12; ++i) {
    auto summary = std::make_shared<RailSummary>(*bad.rail);
    summary->rail.id = "R" + std::to_string(i);
    bad.rail = summary;
    follow(bad, 2);
  }
  EXPECT_TRUE(watch.rates().flood);
  EXPECT_EQ(watch.book().active().size(), 12U);
  QCoreApplication::processEvents();
  int cards = 0;
  for (const AlarmCard* card : page.findChildren<AlarmCard*>()) cards += card->isHidden() ? 0 : 1;
  EXPECT_EQ(cards, 1) << "all of one rule";
  press(page, QStringLiteral("Acknowledge all"));
  for (const Alarm& alarm : watch.book().active()) EXPECT_EQ(alarm.state, AlarmState::Acknowledged);
}

TEST_F(AlarmsTest, WhatHappenedIsOneRowAnAlarmAndIsExported) {
  const QTemporaryDir folder;
  AlarmHistoryPanel panel(theme, watch);
  panel.retranslate();
  LineSnapshot fault = heldSnapshot(100);
  fault.state = LineState::Fault;
  fault.error = "the source is gone";
  follow(fault);
  watch.acknowledgeAll();
  follow(makeSnapshot(), 20);
  const auto history = watch.log().history();
  ASSERT_EQ(history.size(), 1U);
  EXPECT_TRUE(history.front().clearedUs);
  EXPECT_EQ(history.front().acknowledgedBy, "operator");
  EXPECT_EQ(history.front().details, "the source is gone");
  const QString file = folder.filePath(QStringLiteral("alarms.csv"));
  ASSERT_TRUE(panel.exportTo(file));
  QFile csv(file);
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  const QByteArray text = csv.readAll();
  EXPECT_EQ(text.count('\n'), 2);
  EXPECT_TRUE(text.contains("measurement.stopped")) << text.constData();
}

TEST_F(AlarmsTest, TheArchiveKeepsTheLivesOfAlarmsForTheNextStart) {
  const QTemporaryDir folder;
  place.archiveUrl = folder.filePath(QStringLiteral("alarms.db")).toStdString();
  auto archive = Archive::open(place.archiveUrl, Archive::Missing::Create);
  ASSERT_TRUE(archive);
  place.archive = &*archive;
  const auto stored = [&] {
    const auto all = AlarmHistory(*archive).alarms();
    return all && all->size() == 1 && all->front().acknowledgedUs && all->front().clearedUs;
  };
  {
    AlarmWatch kept(place, [this] { return now; });
    LineSnapshot fault = heldSnapshot(100);
    fault.state = LineState::Fault;
    for (int i = 0; i < 10; ++i) now += 1s, kept.follow(fault);
    kept.acknowledgeAll();
    for (int i = 0; i < 20; ++i) now += 1s, kept.follow(makeSnapshot());
    EXPECT_TRUE(QTest::qWaitFor(stored, 10000));
  }
  AlarmWatch next(place, [this] { return now; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return next.log().history().size() == 1; }, 10000));
}

TEST_F(AlarmsTest, ADimensionThatIsNotMeasuredIsAnAlarmUnlessACameraExplainsIt) {
  LineSnapshot missing = makeSnapshot({.missing = {{Dimension::RFH, "SHBR has 0 points"}}});
  ASSERT_FALSE(missing.unmeasured.empty());
  follow(missing);
  ASSERT_EQ(watch.book().active().size(), 1U);
  EXPECT_EQ(watch.book().active().front().key.rule, "dimension.not-measured");
}

TEST_F(AlarmsTest, EveryTextOfEveryRuleIsThereForTheTranslators) {
  Languages languages;
  ASSERT_TRUE(languages.use(QStringLiteral("de")));
  for (const AlarmRule& rule : standardAlarmRules())
    for (const std::string& text : {rule.cause, rule.consequence, rule.action})
      EXPECT_NE(ruleWords(text), QString::fromStdString(text)) << rule.id;
}

}  // namespace
}  // namespace vignole
