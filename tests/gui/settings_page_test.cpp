// Settings: who may what, theme and units at once.

#include "gui/settings/settings_page.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "engine/archive/user_register.h"
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
  }
  template <typename W>
  W* named(const char* accessibleName) {
    for (W* w : page->findChildren<W*>())
      if (w->accessibleName() == QLatin1String(accessibleName)) return w;
    ADD_FAILURE() << accessibleName;
    return nullptr;
  }
  void signIn(const char* name, const char* password, const char* button = "Sign in") {
    auto* panel = page->findChild<SignInPanel*>();
    QSignalSpy answered(panel, &SignInPanel::answered);
    ASSERT_TRUE(QTest::qWaitFor([&] { return named<QLineEdit>("Name")->isVisible(); }, 10000));
    QTest::keyClicks(named<QLineEdit>("Name"), QLatin1String(name));
    QTest::keyClicks(named<QLineEdit>("Password"), QLatin1String(password));
    QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 20000));
    named<QLineEdit>("Name")->clear();
  }
};

TEST_F(SettingsPageTest, TheFirstOneIsTheAdministratorWhoEntersOthers) {
  signIn("Ana", "short", "Enter as the first administrator");
  EXPECT_TRUE(session.user().isEmpty()) << "too short a password";
  signIn("Ana", "long enough", "Enter as the first administrator");
  EXPECT_EQ(session.user(), QStringLiteral("Ana"));
  EXPECT_EQ(session.role(), Role::Administrator);

  QTest::keyClicks(named<QLineEdit>("Name of the new person"), QStringLiteral("Ben"));
  QTest::keyClicks(named<QLineEdit>("First password of the new person"), QStringLiteral("another one"));
  QTest::keyClicks(named<QLineEdit>("Reason for entering the person"), QStringLiteral("new technician"));
  named<QComboBox>("Role of the new person")->setCurrentIndex(1);
  QTest::mouseClick(named<QPushButton>("Enter a person"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return UserRegister(*archive).accounts()->size() == 2; }, 20000));

  QTest::mouseClick(named<QPushButton>("Sign out"), Qt::LeftButton);
  EXPECT_EQ(session.role(), Role::Operator);
  signIn("Ben", "wrong one");
  EXPECT_TRUE(session.user().isEmpty());
  signIn("Ben", "another one");
  EXPECT_EQ(session.role(), Role::Technician);
  EXPECT_FALSE(named<QPushButton>("Enter a person")->isVisible()) << "people are the administrator's";
}

TEST_F(SettingsPageTest, ThemeAndUnitChangeAtOnce) {
  auto* box = named<QComboBox>("Unit of lengths");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(units.length(), Units::Length::Inch);
  auto* look = named<QComboBox>("Theme");
  QTest::keyClick(look, Qt::Key_Down);
  EXPECT_TRUE(theme.dark());
}

}  // namespace
}  // namespace vignole
