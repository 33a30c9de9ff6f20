// Recipes lived through: a draft with another tolerance, its difference, approval by somebody else, with a password.

#include "gui/recipes/recipes_page.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "engine/archive/user_register.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

class RecipesPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  std::optional<Archive> archive;
  std::unique_ptr<RecipesPage> page;

  void SetUp() override {
    place.archiveUrl = folder.filePath(QStringLiteral("recipes.db")).toStdString();
    auto opened = Archive::open(place.archiveUrl, Archive::Missing::Create);
    ASSERT_TRUE(opened);
    archive = std::move(*opened);
    place.archive = &*archive;
    UserRegister people(*archive);
    ASSERT_TRUE(people.add("Ada", Role::Administrator, "ada's password", "Ada", "first"));
    for (const char* name : {"Ben", "Cleo"})
      ASSERT_TRUE(people.add(name, Role::QA, std::string(name) + "'s password", "Ada", "QA"));
    page = std::make_unique<RecipesPage>(place);
    page->resize(1888, 880);
    page->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->entries().empty(); }, 10000));
  }
  template <typename W>
  W* named(const char* accessibleName) {
    for (W* w : page->findChildren<W*>())
      if (w->accessibleName() == QLatin1String(accessibleName)) return w;
    ADD_FAILURE() << accessibleName;
    return nullptr;
  }
  void press(const char* button) {
    QSignalSpy answered(page.get(), &RecipesPage::answered);
    ASSERT_TRUE(named<QPushButton>(button)->isEnabled()) << button;
    QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 20000));
  }
  bool waitForState(RecipeState state) {
    return QTest::qWaitFor(
        [&] {
          return page->chosen() >= 0 &&
                 page->entries()[static_cast<std::size_t>(page->chosen())].version.state == state;
        },
        10000);
  }
};

TEST_F(RecipesPageTest, AnOperatorReadsAndChangesNothing) {
  EXPECT_FALSE(named<QPushButton>("Save as a new draft")->isEnabled());
  EXPECT_FALSE(named<QPushButton>("Approve the draft")->isEnabled());
}

TEST_F(RecipesPageTest, ADraftIsApprovedBySomebodyElseWithReasonAndPassword) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  auto* limits = named<QTableWidget>("Tolerances of the chosen recipe");
  limits->item(static_cast<int>(index(Dimension::WT)), 3)->setText(QStringLiteral("0.8"));
  press("Save as a new draft");
  EXPECT_TRUE(RecipeHistory(*archive).names()->empty()) << "not without saying what is new";
  named<QLineEdit>("What is new in the draft")->setText(QStringLiteral("thinner webs"));
  press("Save as a new draft");
  ASSERT_TRUE(waitForState(RecipeState::Draft));
  const RecipesPage::Entry draft = page->entries()[static_cast<std::size_t>(page->chosen())];
  EXPECT_EQ(*draft.recipe.limits[index(Dimension::WT)].upperMm, 0.8);
  EXPECT_EQ(draft.version.createdBy, "Ben");
  EXPECT_EQ(named<QTableWidget>("What differs")->rowCount(), 1) << "against the program's own";
  EXPECT_FALSE(named<QPushButton>("Approve the draft")->isEnabled()) << "not by its author";

  session.enter(QStringLiteral("Cleo"), Role::QA);
  named<QLineEdit>("Reason for the approval")->setText(QStringLiteral("customer asked"));
  named<QLineEdit>("Your password")->setText(QStringLiteral("not hers"));
  press("Approve the draft");
  EXPECT_EQ(page->entries()[static_cast<std::size_t>(page->chosen())].version.state, RecipeState::Draft);
  named<QLineEdit>("Your password")->setText(QStringLiteral("Cleo's password"));
  press("Approve the draft");
  ASSERT_TRUE(waitForState(RecipeState::Approved));
  const auto approved = RecipeHistory(*archive).approved(draft.version.name);
  ASSERT_TRUE(approved && *approved);
  EXPECT_EQ((*approved)->decidedBy, "Cleo");
  EXPECT_EQ((*approved)->reason, "customer asked");
  if (const QByteArray kept = qgetenv("VIGNOLE_KEEP_PICTURES"); !kept.isEmpty()) {
    page->setStyleSheet(theme.styleSheet());
    page->grab().save(QString::fromLocal8Bit(kept) + QStringLiteral("/recipes.png"));
  }
}

TEST_F(RecipesPageTest, LimitsThatAreNoneAreRefusedAndNothingIsKept) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  auto* limits = named<QTableWidget>("Tolerances of the chosen recipe");
  limits->item(0, 3)->setText(QStringLiteral("much"));
  press("Save as a new draft");
  limits->item(0, 3)->setText(QStringLiteral("-2"));
  press("Save as a new draft");
  EXPECT_TRUE(RecipeHistory(*archive).names()->empty());
}

}  // namespace
}  // namespace vignole
