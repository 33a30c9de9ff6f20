// Repeatability from stored runs, against the engine's own study of the same profiles.

#include "gui/quality/quality_page.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "engine/archive/generated_rails.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

class QualityPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  std::optional<Archive> archive;
  std::unique_ptr<QualityPage> page;

  void SetUp() override {
    place.archiveUrl = folder.filePath(QStringLiteral("rails.db")).toStdString();
    GeneratedRails rails;
    rails.rails = 5;
    rails.lengthM = 25;
    ASSERT_TRUE(generateRails(place.archiveUrl, recipe(), rails));
    auto opened = Archive::open(place.archiveUrl);
    ASSERT_TRUE(opened);
    archive = std::move(*opened);
    place.archive = &*archive;
    page = std::make_unique<QualityPage>(place);
    page->resize(1888, 880);
    page->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->rails().size() == 5; }, 10000));
  }
  void press() {
    QSignalSpy answered(page.get(), &QualityPage::resultChanged);
    for (QPushButton* button : page->findChildren<QPushButton*>())
      if (button->accessibleName() == QStringLiteral("Compare the chosen runs"))
        QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 20000));
  }
};

TEST_F(QualityPageTest, OneRunIsTooFewAndIsSaid) {
  page->setRun(0, true);
  press();
  EXPECT_FALSE(page->result());
}

TEST_F(QualityPageTest, GivesWhatTheEngineGivesForTheChosenRuns) {
  page->choose(Dimension::HW);
  for (int i = 0; i < 5; ++i) page->setRun(i, true);
  press();
  ASSERT_TRUE(page->result());
  const RepeatabilityResult& result = *page->result();
  EXPECT_EQ(result.runs.size(), 5U);
  EXPECT_EQ(result.sections.size(), 3U) << "25 m in stretches of 10 m";

  std::vector<RepeatabilityRun> runs;
  for (auto rail = page->rails().rbegin(); rail != page->rails().rend(); ++rail) {
    RepeatabilityRun run{rail->id, {}, {}};
    const auto profiles = RailArchive(*archive).profiles(rail->key);
    for (const ProfileRecord& p : *profiles) {
      run.positionM.push_back(p.positionMm / 1000);
      run.valueMm.push_back(*p.dimensions[index(Dimension::HW)].valueMm);
    }
    runs.push_back(run);
  }
  const auto expected = repeatabilityStudy(runs);
  ASSERT_TRUE(expected);
  EXPECT_EQ(result.srMm, expected->srMm);
  EXPECT_EQ(result.meanRangeMm, expected->meanRangeMm);
  if (const QByteArray kept = qgetenv("VIGNOLE_KEEP_PICTURES"); !kept.isEmpty()) {
    page->setStyleSheet(theme.styleSheet());
    page->grab().save(QString::fromLocal8Bit(kept) + QStringLiteral("/quality.png"));
  }
}

}  // namespace
}  // namespace vignole
