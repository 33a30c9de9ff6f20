// Rails: found, replayed, reported, from an archive on disk.

#include "gui/rails/rails_page.h"

#include <QComboBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "engine/archive/generated_rails.h"
#include "gui/bridge/virtual_line.h"
#include "gui/rails/next_rail_dialog.h"
#include "gui/rails/rail_export.h"
#include "gui/rails/replay_canvas.h"
#include "gui/rails/what_if_dialog.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

class RailsPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  std::optional<Archive> archive;
  std::unique_ptr<RailsPage> page;

  void SetUp() override {
    place.archiveUrl = folder.filePath(QStringLiteral("rails.db")).toStdString();
    GeneratedRails rails;
    rails.rails = 12;
    rails.lengthM = 6;
    rails.failingShare = 0.5;
    rails.points = {true, 10, 0, PointCoding::Compact};
    ASSERT_TRUE(generateRails(place.archiveUrl, recipe(), rails));
    auto opened = Archive::open(place.archiveUrl);
    ASSERT_TRUE(opened);
    archive = std::move(*opened);
    place.archive = &*archive;
  }
  void show() {
    page = std::make_unique<RailsPage>(place);
    page->setStyleSheet(theme.styleSheet());
    page->resize(1888, 880);
    page->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().size() == 12 && page->opened() != nullptr; }, 10000));
  }
  void choose(const char* accessibleName, int index) {
    for (QComboBox* box : page->findChildren<QComboBox*>())
      if (box->accessibleName() == QLatin1String(accessibleName)) box->setCurrentIndex(index);
  }
  /// A rail with an exception, open.
  void openRejected() {
    choose("Verdict", 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().size() < 12; }, 10000));
    ASSERT_FALSE(page->found().empty());
    const std::int64_t key = page->found().front().key;
    QSignalSpy shown(page.get(), &RailsPage::profileChanged);
    page->openRail(key);
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->opened()->stored.key == key && shown.count() > 0; }, 10000));
  }
};

TEST_F(RailsPageTest, ShowsTheNewestRailAndFindsByVerdictDimensionAndId) {
  show();
  EXPECT_EQ(page->opened()->stored.key, page->found().front().key);
  choose("Verdict", 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().size() < 12; }, 10000));
  for (const RailLine& rail : page->found()) EXPECT_EQ(rail.verdict, Verdict::Fail);
  const std::size_t rejected = page->found().size();
  ASSERT_GT(rejected, 0U);
  const RailLine one = page->found().front();
  ASSERT_TRUE(one.worst);
  choose("Dimension out of tolerance", static_cast<int>(*one.worst) + 1);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return page->found().size() < rejected &&
               std::all_of(page->found().begin(), page->found().end(),
                           [&](const RailLine& rail) { return rail.worst == one.worst; });
      },
      10000));
  EXPECT_FALSE(page->found().empty());
  choose("Verdict", 0);
  choose("Dimension out of tolerance", 0);
  page->searchField().setText(QString::fromStdString(one.id));
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().size() == 1; }, 10000));
  EXPECT_EQ(page->found().front().id, one.id);
  page->searchField().setText(QStringLiteral("no such rail"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().empty(); }, 10000));
}

TEST_F(RailsPageTest, ReplaysAlongTheRailByKeysAndFromExceptionToException) {
  show();
  openRejected();
  const std::uint64_t last = page->opened()->stored.summary.profiles - 1;
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QSignalSpy shown(page.get(), &RailsPage::profileChanged);
    QTest::keyClick(page.get(), key, modifiers);
    EXPECT_TRUE(QTest::qWaitFor([&] { return shown.count() > 0; }, 10000)) << key;
  };
  page->setFocus();
  EXPECT_EQ(page->profile(), 0U);
  press(Qt::Key_Right);
  EXPECT_EQ(page->profile(), 1U);
  press(Qt::Key_End);
  EXPECT_EQ(page->profile(), last);
  press(Qt::Key_Home);
  EXPECT_EQ(page->profile(), 0U);
  press(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(static_cast<double>(page->profile()), 1000.0 / 15, 2) << "a metre";
  press(Qt::Key_Home);
  press(Qt::Key_N);
  const double at = static_cast<double>(page->profile()) * 0.015;
  bool inside = false;
  for (const DimensionSummary& d : page->opened()->stored.summary.dimensions)
    for (const DimensionException& e : d.exceptions) inside = inside || (at > e.fromM - 0.02 && at < e.toM + 0.02);
  EXPECT_TRUE(inside) << at;
}

/// The button of this accessible name below `parent`.
QPushButton* button(const QWidget& parent, const char* accessibleName) {
  for (QPushButton* b : parent.findChildren<QPushButton*>())
    if (b->accessibleName() == QLatin1String(accessibleName)) return b;
  ADD_FAILURE() << "no button " << accessibleName;
  return nullptr;
}

TEST_F(RailsPageTest, TheDrawnDimensionIsChosenAndThePointsBeforeRegistrationAreShown) {
  show();
  openRejected();
  const auto* canvas = page->findChild<ReplayCanvas*>();
  ASSERT_NE(canvas, nullptr);
  choose("Dimension that is drawn", static_cast<int>(Dimension::WT) + 1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return canvas->drawing().selected == Dimension::WT; }, 10000));
  QList<QPushButton*> before;
  for (QPushButton* button : page->findChildren<QPushButton*>()) {
    if (button->accessibleName() == "Show the points before registration") before << button;
    EXPECT_FALSE(button->accessibleName().isEmpty());
  }
  ASSERT_EQ(before.size(), 1);
  QTest::mouseClick(before.front(), Qt::LeftButton);
  EXPECT_TRUE(canvas->drawing().beforeRegistration);
  page->goTo(1);
  EXPECT_TRUE(canvas->drawing().beforeRegistration) << "stays from profile to profile";
  QTest::mouseClick(before.front(), Qt::LeftButton);
  EXPECT_FALSE(canvas->drawing().beforeRegistration);
}

TEST_F(RailsPageTest, FindsByTimeAndSectionAndClearsWhatFoundNothing) {
  show();
  choose("Time", 2);  // the made rails are of January 2025
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().empty(); }, 10000));
  QPushButton* clear = button(*page, "Clear search and filters");
  ASSERT_TRUE(QTest::qWaitFor([&] { return clear->isVisible(); }, 10000));
  QTest::mouseClick(clear, Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->found().size() == 12; }, 10000));
  EXPECT_FALSE(clear->isVisible());
  choose("Section", 1);  // 115RE, the first of the catalogue
  EXPECT_TRUE(QTest::qWaitFor([&] { return page->found().empty(); }, 10000));
}

TEST_F(RailsPageTest, WhatIfJudgesTheRailsFoundWithOtherLimits) {
  show();
  ASSERT_TRUE(page->opened()->recipe);
  QTest::mouseClick(button(*page, "Judge the rails found with other limits"), Qt::LeftButton);
  auto* dialog = page->findChild<WhatIfDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto run = [&] {
    QSignalSpy done(dialog, &WhatIfDialog::finished);
    QTest::mouseClick(button(*dialog, "Judge the rails with these limits"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return done.count() == 1; }, 30000));
  };
  for (const QWidget* w : dialog->findChildren<QLineEdit*>())
    EXPECT_GE(w->height(), w->minimumSizeHint().height()) << w->accessibleName().toStdString();
  EXPECT_LE(dialog->height(), 720) << "a small screen holds it";
  run();
  EXPECT_EQ(dialog->judged().size(), 12U);
  EXPECT_EQ(dialog->changed(), 0U) << "with the limits of the recipe";
  // Without limits of any dimension no rail has a verdict.
  for (QLineEdit* field : dialog->findChildren<QLineEdit*>()) field->clear();
  run();
  EXPECT_EQ(dialog->changed(), 12U);
  EXPECT_TRUE(dialog->summary().startsWith(QStringLiteral("12 of 12"))) << dialog->summary().toStdString();
  // What is no number is refused before anything is judged.
  dialog->findChildren<QLineEdit*>().front()->setText(QStringLiteral("thick"));
  dialog->start();
  EXPECT_FALSE(dialog->running());
  EXPECT_TRUE(dialog->summary().contains(QStringLiteral("no number"))) << dialog->summary().toStdString();
}

TEST_F(RailsPageTest, ARailIsExportedWithEveryProfile) {
  const auto rails = RailArchive(*archive).search({});
  ASSERT_TRUE(rails);
  const auto rail = RailArchive(*archive).open(rails->front().key);
  const auto profiles = RailArchive(*archive).profiles(rails->front().key);
  ASSERT_TRUE(rail && profiles);
  const auto read = [&](const char* name) {
    const QString file = folder.filePath(QLatin1String(name));
    EXPECT_TRUE(exportRail(*rail, *profiles, file.toStdString()));
    QFile in(file);
    EXPECT_TRUE(in.open(QIODevice::ReadOnly));
    return in.readAll();
  };
  EXPECT_EQ(read("rail.csv").count('\n'), static_cast<qsizetype>(profiles->size()) + 1);
  const QJsonObject json = QJsonDocument::fromJson(read("rail.json")).object();
  EXPECT_EQ(json["rail"].toString().toStdString(), rail->summary.rail.id);
  const QJsonArray rows = json["profiles"].toArray();
  ASSERT_EQ(rows.size(), static_cast<qsizetype>(profiles->size()));
  EXPECT_NEAR(rows[7].toObject()["WT"].toObject()["value_mm"].toDouble(),
              *(*profiles)[7].dimensions[index(Dimension::WT)].valueMm, 1e-9);
  EXPECT_FALSE(exportRail(*rail, *profiles, folder.filePath(QStringLiteral("rail.xyz")).toStdString()));
}

TEST(NextRail, IsEnteredByHandAndRefusesATemperatureThatIsNone) {
  const Theme theme;
  RailAnnouncements rails;
  NextRailDialog dialog(theme, rails);
  dialog.setStyleSheet(theme.styleSheet());
  dialog.show();
  const auto enter = [&](const char* field, const char* text) {
    for (QLineEdit* edit : dialog.findChildren<QLineEdit*>())
      if (edit->accessibleName() == QString::fromUtf8(field)) {
        edit->clear();
        QTest::keyClicks(edit, QLatin1String(text));
      }
  };
  QPushButton* announce = button(dialog, "For the next rail");
  for (const QWidget* w : dialog.findChildren<QWidget*>())
    EXPECT_TRUE(w->width() >= w->minimumSizeHint().width() && w->height() >= w->minimumSizeHint().height())
        << w->accessibleName().toStdString();
  QTest::mouseClick(announce, Qt::LeftButton);
  EXPECT_FALSE(rails.waiting()) << "nothing was entered";
  enter("Rail", "0412-3-07");
  enter("Strand", "3");
  enter("Temperature, \u00b0C", "hot");
  QTest::mouseClick(announce, Qt::LeftButton);
  EXPECT_FALSE(rails.waiting());
  EXPECT_TRUE(dialog.message().contains(QStringLiteral("no number"))) << dialog.message().toStdString();
  enter("Temperature, \u00b0C", "61.5");
  QTest::mouseClick(announce, Qt::LeftButton);
  ASSERT_TRUE(rails.waiting());
  EXPECT_EQ(rails.waiting()->id, "0412-3-07");
  EXPECT_EQ(rails.waiting()->strand, "3");
  EXPECT_EQ(rails.waiting()->temperatureC, 61.5);
  EXPECT_TRUE(dialog.message().contains(QStringLiteral("0412-3-07"))) << dialog.message().toStdString();
  QTest::mouseClick(button(dialog, "Withdraw"), Qt::LeftButton);
  EXPECT_FALSE(rails.waiting());
}

TEST_F(RailsPageTest, TheWayBackLeadsToTheLiveRail) {
  show();
  QSignalSpy live(page.get(), &RailsPage::liveAsked);
  for (QPushButton* button : page->findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Back to live")) QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(live.count(), 1);
}

TEST(RailsWithoutAnArchive, SayWhyAndWhatToDo) {
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  RailsPage page(place);
  QSignalSpy changed(&page, &RailsPage::listChanged);
  page.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return changed.count() > 0; }, 10000));
  EXPECT_TRUE(page.found().empty());
}

TEST(RailRecorder, WhatTheLineMeasuresIsInTheArchive) {
  const QTemporaryDir folder;
  const std::string url = folder.filePath(QStringLiteral("live.db")).toStdString();
  auto writer = RailWriter::open(url, {});
  ASSERT_TRUE(writer);
  VirtualLineSettings settings;
  settings.recipe = *findRecipe("60E1");
  settings.rig.section = settings.recipe.section;
  settings.rig.parameters = settings.recipe.parameters;
  settings.railLengthMm = 300;
  auto line = VirtualLine::create(settings);
  ASSERT_TRUE(line);
  (*line)->record(writer->get());
  ASSERT_NE((*line)->announcements(), nullptr);
  (*line)->announcements()->announce({"0412-3-07", "263417", "3", "A-77", {}});
  const auto frames = (*line)->frames();
  const FramesWatcher watcher(frames);
  (*line)->start();
  EXPECT_TRUE(QTest::qWaitFor([&] { return frames->latest(0) != nullptr; }, 30000)) << "pictures are seen all the same";
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*line)->pull(PullDetail::Everything).railsPassed >= 2; }, 30000));
  (*line)->stop();
  line->reset();
  ASSERT_TRUE((*writer)->close());
  const auto archive = Archive::open(url);
  ASSERT_TRUE(archive);
  const auto rails = RailArchive(*archive).search({});
  ASSERT_TRUE(rails);
  ASSERT_GE(rails->size(), 2U);
  EXPECT_EQ(rails->back().profiles, 20U);
  EXPECT_EQ(rails->back().state, RailState::Finished);
  EXPECT_EQ(rails->back().id, "0412-3-07");
  EXPECT_EQ(rails->back().heat, "263417");
  const auto first = RailArchive(*archive).open(rails->back().key);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->papers.strand, "3");
  EXPECT_EQ(first->papers.orderNumber, "A-77");
  EXPECT_NE((*rails)[rails->size() - 2].id, "0412-3-07") << "it was announced for one rail";
}

}  // namespace
}  // namespace vignole
