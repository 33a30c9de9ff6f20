// Recipes lived through: a draft with another tolerance, its difference, approval by somebody else, with a password.

#include "gui/recipes/recipes_page.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

#include "engine/archive/audit_trail.h"
#include "engine/archive/generated_rails.h"
#include "engine/archive/user_register.h"
#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"
#include "engine/recipe/recipe_fields.h"
#include "gui/rails/what_if_dialog.h"
#include "gui/recipes/section_dialog.h"
#include "gui/recipes/section_drawing.h"
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
  /// For eyes, where a folder is named.
  void keep(const QByteArray& name, QWidget* widget = nullptr) {
    const QByteArray kept = qgetenv("VIGNOLE_KEEP_PICTURES");
    if (kept.isEmpty()) return;
    page->setStyleSheet(theme.styleSheet());
    QTest::qWait(0);
    (widget != nullptr ? widget : static_cast<QWidget*>(page.get()))
        ->grab()
        .save(QString::fromLocal8Bit(kept + '/' + name + ".png"));
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
  keep("recipes");
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

TEST_F(RecipesPageTest, ASettingOutOfRangeIsRefusedAtItsFieldAndOneInRangeIsInTheDifference) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  auto* settings = named<QTableWidget>("Settings of the chosen recipe");
  int row = -1;
  for (int i = 0; i < settings->rowCount(); ++i)
    if (settings->item(i, 0)->data(Qt::UserRole).toString() == QStringLiteral("stripe.t_l_dn")) row = i;
  ASSERT_GE(row, 0);
  named<QLineEdit>("What is new in the draft")->setText(QStringLiteral("weaker lines"));
  for (const char* bad : {"weak", "300", "99"}) {  // no number, out of range, above the high threshold
    settings->item(row, 1)->setText(QString::fromLatin1(bad));
    press("Save as a new draft");
    EXPECT_TRUE(RecipeHistory(*archive).names()->empty()) << bad;
    EXPECT_TRUE(page->words().contains(QStringLiteral("threshold"))) << bad << ": " << page->words().toStdString();
    EXPECT_EQ(settings->currentRow(), row) << bad;
  }
  settings->item(row, 1)->setText(QStringLiteral("5,5"));
  press("Save as a new draft");
  ASSERT_TRUE(waitForState(RecipeState::Draft)) << page->words().toStdString();
  EXPECT_EQ(page->entries()[static_cast<std::size_t>(page->chosen())].recipe.stripe.low, 5.5);
  const auto* differences = named<QTableWidget>("What differs");
  ASSERT_EQ(differences->rowCount(), 1);
  EXPECT_EQ(differences->item(0, 2)->text(), QStringLiteral("5.5"));
  keep("recipes-settings");
}

TEST_F(RecipesPageTest, AnotherNameMakesACopy) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  const std::string original = page->entries()[static_cast<std::size_t>(page->chosen())].recipe.name;
  named<QLineEdit>("Name of the draft; another name makes a copy")->setText(QStringLiteral("order 88214"));
  named<QLineEdit>("What is new in the draft")->setText(QStringLiteral("copy"));
  press("Save as a new draft");
  ASSERT_TRUE(waitForState(RecipeState::Draft)) << page->words().toStdString();
  EXPECT_EQ(RecipeHistory(*archive).names()->front(), "order 88214");
  EXPECT_NE(original, "order 88214");
}

TEST_F(RecipesPageTest, OnlyWhatIsApprovedIsChosenForTheNextRail) {
  EXPECT_FALSE(named<QPushButton>("Use the chosen recipe for the next rail")->isEnabled()) << "the program's own";
  Recipe other = *makeRecipe("54E1", "X", "A");
  RecipeHistory history(*archive);
  const auto draft = history.addDraft(other, "Ben", "for tests");
  ASSERT_TRUE(draft);
  ASSERT_TRUE(history.approve(draft->key, "Cleo", "fine"));
  QSignalSpy changed(page.get(), &RecipesPage::entriesChanged);
  page->load();
  ASSERT_TRUE(QTest::qWaitFor([&] { return changed.count() > 0; }, 10000));
  for (int i = 0; i < static_cast<int>(page->entries().size()); ++i)
    if (page->entries()[static_cast<std::size_t>(i)].version.key == draft->key) page->choose(i);
  press("Use the chosen recipe for the next rail");
  ASSERT_TRUE(line.asked) << "an operator may";
  EXPECT_EQ(line.asked->section.name, "54E1");
  const auto audit = AuditTrail(*archive).entries({{}, {}, {}, "recipe chosen", {}, 10, 0});
  ASSERT_TRUE(audit);
  EXPECT_EQ(audit->size(), 1U);
}

TEST_F(RecipesPageTest, WhatIfNeedsTwentyStoredRails) {
  press("Judge stored rails by the chosen recipe");
  EXPECT_EQ(page->whatIfDialog(), nullptr);
  EXPECT_TRUE(page->words().contains(QStringLiteral("20"))) << page->words().toStdString();
  GeneratedRails rails;
  rails.rails = 20;
  rails.lengthM = 1;
  ASSERT_TRUE(generateRails(place.archiveUrl, recipe(), rails));
  press("Judge stored rails by the chosen recipe");
  ASSERT_NE(page->whatIfDialog(), nullptr) << page->words().toStdString();
  EXPECT_TRUE(QTest::qWaitFor([&] { return page->whatIfDialog()->judged().size() == 20; }, 30000));
  EXPECT_EQ(page->whatIfDialog()->changed(), 0U) << "the same limits";
}

std::string group(int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; }
std::string group(int code, double value) { return group(code, plainNumber(value)); }

/// 60E1 as loose lines and arcs; without the primitive of that name.
QString drawing(const QTemporaryDir& folder, const std::string& without) {
  std::string text = group(0, "SECTION") + group(2, "ENTITIES");
  const Section section = *findSection("60E1");
  for (const NamedPrimitive& p : section.primitives) {
    if (p.name == without) continue;
    if (const auto* arc = std::get_if<Arc>(&p.shape)) {
      const double degree = std::numbers::pi / 180, a = arc->startAngleRad, b = a + arc->sweepRad;
      text += group(0, "ARC") + group(8, "0") + group(10, arc->centre.x()) + group(20, arc->centre.y()) +
              group(30, 0.0) + group(40, arc->radiusMm) + group(50, std::min(a, b) / degree) +
              group(51, std::max(a, b) / degree);
    } else {
      const Point2 a = startPoint(p.shape), b = endPoint(p.shape);
      text += group(0, "LINE") + group(8, "0") + group(10, a.x()) + group(20, a.y()) + group(30, 0.0) +
              group(11, b.x()) + group(21, b.y()) + group(31, 0.0);
    }
  }
  text += group(0, "ENDSEC") + group(0, "EOF");
  const QString file = folder.filePath(QStringLiteral("mine.dxf"));
  EXPECT_TRUE(writeFile(file.toStdString(), text));
  return file;
}

TEST_F(RecipesPageTest, ADrawingThatIsOpenIsRefusedWhereItIsOpen) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  SectionDialog& dialog = page->sectionDialog();
  dialog.openFile(drawing(folder, "SHR"));
  EXPECT_FALSE(dialog.section());
  EXPECT_TRUE(dialog.words().contains(QStringLiteral("does not close"))) << dialog.words().toStdString();
  ASSERT_TRUE(dialog.drawing().gap());
  ASSERT_TRUE(dialog.drawing().gap()->other);
  EXPECT_NEAR((*dialog.drawing().gap()->other - dialog.drawing().gap()->end).norm(), 21.0, 0.1) << "the length of SHR";
  dialog.show();
  keep("section-refused", &dialog);
}

TEST_F(RecipesPageTest, ADrawingBecomesADraftOfItsOwnSection) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  SectionDialog& dialog = page->sectionDialog();
  dialog.openFile(drawing(folder, ""));
  ASSERT_TRUE(dialog.section()) << dialog.words().toStdString();
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  dialog.grab();
  const auto& labels = dialog.drawing().labels();
  EXPECT_GE(labels.size(), dialog.section()->primitives.size() * 9 / 10) << "nearly every primitive is named";
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(labels[i].intersects(labels[j]));
  keep("section", &dialog);
  QSignalSpy answered(page.get(), &RecipesPage::answered);
  for (QPushButton* button : dialog.findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Keep the section and make a draft of it"))
      QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 10000)) << dialog.words().toStdString();
  ASSERT_TRUE(waitForState(RecipeState::Draft)) << page->words().toStdString();
  const Recipe& made = page->entries()[static_cast<std::size_t>(page->chosen())].recipe;
  EXPECT_EQ(made.section.name, "mine");
  EXPECT_EQ(made.name, "mine X/A");
}

TEST_F(RecipesPageTest, NothingIsClippedAtEitherSize) {
  session.enter(QStringLiteral("Ben"), Role::QA);
  for (const QSize size : {QSize(1920, 856), QSize(1366, 624)}) {
    page->resize(size);
    QTest::qWait(0);
    EXPECT_GE(page->width(), page->minimumSizeHint().width());
    EXPECT_GE(page->height(), page->minimumSizeHint().height());
    keep(QByteArray("recipes-") + QByteArray::number(size.width()));
  }
  theme.setDark(true);
  page->resize(1920, 856);
  keep("recipes-dark");
}

}  // namespace
}  // namespace vignole
