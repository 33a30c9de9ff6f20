// Settings: who may what, theme and units at once.

#include "gui/settings/settings_page.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "engine/archive/audit_trail.h"
#include "engine/archive/user_register.h"
#include "engine/optics/nominal_rig.h"
#include "gui/settings/audit_panel.h"
#include "gui/settings/people_panel.h"
#include "gui/settings/rig_drawing.h"
#include "gui/settings/sign_in_panel.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

class SettingsPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  std::optional<Archive> archive;
  std::unique_ptr<SettingsPage> page;

  void SetUp() override {
    place.archiveUrl = folder.filePath(QStringLiteral("people.db")).toStdString();
    auto opened = Archive::open(place.archiveUrl, Archive::Missing::Create);
    ASSERT_TRUE(opened);
    archive = std::move(*opened);
    place.archive = &*archive;
    page = std::make_unique<SettingsPage>(place);
    page->resize(1888, 880);
    page->show();
    page->askForName();
  }
  template <typename W>
  W* named(const char* accessibleName) {
    for (W* w : page->findChildren<W*>())
      if (w->accessibleName() == QLatin1String(accessibleName)) return w;
    ADD_FAILURE() << accessibleName;
    return nullptr;
  }
  void signIn(const char* name, const char* password, const char* button = "Sign in", bool clear = true) {
    auto* panel = page->findChild<SignInPanel*>();
    QSignalSpy answered(panel, &SignInPanel::answered);
    ASSERT_TRUE(QTest::qWaitFor([&] { return named<QLineEdit>("Name")->isVisible(); }, 10000));
    QTest::keyClicks(named<QLineEdit>("Name"), QLatin1String(name));
    QTest::keyClicks(named<QLineEdit>("Password"), QLatin1String(password));
    QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 20000));
    if (clear) named<QLineEdit>("Name")->clear();
  }
};

TEST_F(SettingsPageTest, TheFirstOneIsTheAdministratorWhoEntersOthers) {
  signIn("Ana", "short", "Enter as the first administrator");
  EXPECT_TRUE(session.user().isEmpty()) << "too short a password";
  signIn("Ana", "long enough", "Enter as the first administrator");
  EXPECT_EQ(session.user(), QStringLiteral("Ana"));
  EXPECT_EQ(session.role(), Role::Administrator);

  page->showGroup(SettingsPage::Group::People);
  QTest::keyClicks(named<QLineEdit>("Name of the new person"), QStringLiteral("Ben"));
  QTest::keyClicks(named<QLineEdit>("First password of the new person"), QStringLiteral("another one"));
  QTest::keyClicks(named<QLineEdit>("Reason for entering the person"), QStringLiteral("new technician"));
  named<QComboBox>("Role of the new person")->setCurrentIndex(1);
  QTest::mouseClick(named<QPushButton>("Enter a person"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return UserRegister(*archive).accounts()->size() == 2; }, 20000));

  page->askForName();
  QTest::mouseClick(named<QPushButton>("Sign out"), Qt::LeftButton);
  EXPECT_EQ(session.role(), Role::Operator);
  signIn("Ben", "wrong one");
  EXPECT_TRUE(session.user().isEmpty());
  signIn("Ben", "another one", "Sign in", false);
  EXPECT_TRUE(session.user().isEmpty()) << "a password that somebody else has given lets nobody in";
  auto* panel = page->findChild<SignInPanel*>();
  QSignalSpy answered(panel, &SignInPanel::answered);
  QTest::keyClicks(named<QLineEdit>("Present password"), QStringLiteral("another one"));
  QTest::keyClicks(named<QLineEdit>("New password"), QStringLiteral("one of my own"));
  QTest::mouseClick(named<QPushButton>("Change the password"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 20000));
  EXPECT_EQ(session.role(), Role::Technician);
  page->showGroup(SettingsPage::Group::People);
  EXPECT_FALSE(named<QPushButton>("Enter a person")->isVisible()) << "people are the administrator's";
}

TEST_F(SettingsPageTest, AnAccountIsClosedWithAReasonThatStandsInTheAuditTrail) {
  signIn("Ana", "long enough", "Enter as the first administrator");
  ASSERT_TRUE(UserRegister(*archive).add("Ben", Role::QA, "another one", "Ana", "new"));
  page->showGroup(SettingsPage::Group::People);
  auto* people = page->findChild<PeoplePanel*>();
  people->load();
  auto* table = named<QTableWidget>("People who may sign in");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->rowCount() == 2; }, 20000));
  const int ben = table->item(0, 0)->text() == QStringLiteral("Ben") ? 0 : 1;
  table->selectRow(ben);
  auto* close = named<QPushButton>("Close the account of the chosen person");
  QTest::mouseClick(close, Qt::LeftButton);
  QTest::keyClicks(named<QLineEdit>("Reason for entering the person"), QStringLiteral("left the mill"));
  // The first press had no reason: the second alone may close.
  QTest::mouseClick(close, Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return UserRegister(*archive).accounts()->at(static_cast<std::size_t>(ben)).disabled; }, 20000));
  const auto trail = AuditTrail(*archive).entries();
  ASSERT_TRUE(trail);
  EXPECT_EQ(trail->front().reason, "left the mill");
  EXPECT_EQ(trail->front().user, "Ana");
  page->showGroup(SettingsPage::Group::Audit);
  page->findChild<AuditPanel*>()->load();
  auto* rows = named<QTableWidget>("Audit trail, newest first");
  ASSERT_TRUE(QTest::qWaitFor([&] { return rows->rowCount() == static_cast<int>(trail->size()); }, 20000));
  EXPECT_EQ(rows->item(0, 4)->text(), QStringLiteral("left the mill"));
}

TEST_F(SettingsPageTest, TheAuditTrailIsNotTheOperators) {
  page->showGroup(SettingsPage::Group::Audit);
  EXPECT_FALSE(named<QTableWidget>("Audit trail, newest first")->isVisible());
}

TEST_F(SettingsPageTest, ThemeAndUnitChangeAtOnce) {
  page->showGroup(SettingsPage::Group::Screen);
  auto* box = named<QComboBox>("Unit of lengths");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(units.length(), Units::Length::Inch);
  auto* look = named<QComboBox>("Theme");
  QTest::keyClick(look, Qt::Key_Down);
  EXPECT_TRUE(theme.dark());
}

TEST_F(SettingsPageTest, TheRigIsDrawnFromTheCalibrationInForce) {
  page->showGroup(SettingsPage::Group::Rig);
  auto* rig = page->findChild<RigDrawing*>();
  ASSERT_NE(rig, nullptr);
  page->showLine(line.snapshot, PullDetail::Everything);
  EXPECT_EQ(rig->distanceMm(0), 0) << "this line does not tell";
  line.rig = nominalRig();
  if (line.rig.id.empty()) line.rig.id = "nominal";
  page->showLine(makeSnapshot(), PullDetail::Everything);
  for (int c = 0; c < kCameraCount; ++c)
    EXPECT_NEAR(rig->distanceMm(c), nominalStations()[static_cast<std::size_t>(c)].distanceMm, 1e-6);
  const QImage drawn = rig->grab().toImage();
  if (const QByteArray kept = qgetenv("VIGNOLE_KEEP_PICTURES"); !kept.isEmpty()) {
    EXPECT_TRUE(page->grab().save(QString::fromLocal8Bit(kept) + QStringLiteral("/rig.png")));
  }
  line.rig.rangeFinders[2].cameraFromWorld.translationMm.z() += 80;
  page->showLine(makeSnapshot(), PullDetail::Everything);
  EXPECT_NE(rig->grab().toImage(), drawn) << "a camera stands farther away";
}

}  // namespace
}  // namespace vignole
