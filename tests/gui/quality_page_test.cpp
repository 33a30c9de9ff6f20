// Repeatability and accuracy by clicks, against the engine's own studies of the same profiles.

#include "gui/quality/quality_page.h"

#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "engine/archive/generated_rails.h"
#include "gui/plots/runs_plot.h"
#include "report/dimension_text.h"
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
  /// For eyes, where a folder is named.
  void keep(const QByteArray& name) {
    const QByteArray kept = qgetenv("VIGNOLE_KEEP_PICTURES");
    if (kept.isEmpty()) return;
    page->setStyleSheet(theme.styleSheet());
    QTest::qWait(0);
    page->grab().save(QString::fromLocal8Bit(kept + '/' + name + ".png"));
  }
  template <typename Widget>
  Widget* named(const char* accessibleName) {
    for (Widget* widget : page->template findChildren<Widget*>())
      if (widget->accessibleName() == QLatin1String(accessibleName)) return widget;
    ADD_FAILURE() << "nothing is named " << accessibleName;
    return nullptr;
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
}

TEST_F(QualityPageTest, EveryDimensionIsInTheTableAndAChosenRowIsDrawn) {
  for (int i = 0; i < 5; ++i) page->setRun(i, true);
  press();
  auto* table = named<QTableWidget>("Every dimension; the chosen one is drawn");
  ASSERT_EQ(table->rowCount(), static_cast<int>(kDimensionCount));
  for (const Dimension d : kDimensions) {
    const auto& is = page->studied()->dimensions[index(d)].repeatability;
    ASSERT_TRUE(is) << name(d);
    EXPECT_EQ(table->item(static_cast<int>(index(d)), table->columnCount() - 3)->text(),
              numberText(is->srMm, decimalsOf(d)))
        << name(d);
  }
  table->selectRow(static_cast<int>(index(Dimension::FTr)));
  EXPECT_EQ(page->chosen(), Dimension::FTr);
  const RunsPlot* values = page->findChildren<RunsPlot*>().front();
  ASSERT_EQ(values->curves().size(), 5);
  EXPECT_EQ(values->levels().size(), 3) << "expected value and both limits";
}

TEST_F(QualityPageTest, TooFewRunsSayHowManyAreMissing) {
  page->setRun(0, true);
  press();
  EXPECT_TRUE(page->words().contains(QStringLiteral("choose 1 more"))) << page->words().toStdString();
}

TEST_F(QualityPageTest, AccuracyAsksForItsReferenceAndGivesWhatTheEngineGives) {
  page->showKind(RunsStudyKind::Accuracy);
  page->choose(Dimension::FW);
  for (int i = 0; i < 5; ++i) page->setRun(i, true);
  press();
  EXPECT_EQ(page->accuracy(), nullptr);
  EXPECT_TRUE(page->words().contains(QStringLiteral("reference"))) << page->words().toStdString();

  const QString file = folder.filePath(QStringLiteral("cmm.csv"));
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write("dimension,position_m,value,u\nFW,10,150.02,0.001\nFW,20,149.98,0.001\nHW,10,71.97,0.01\n");
  out.close();
  QSignalSpy answered(page.get(), &QualityPage::resultChanged);
  page->openReference(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 20000));
  ASSERT_NE(page->accuracy(), nullptr) << page->words().toStdString();
  EXPECT_EQ(page->accuracy()->positions, 2U);
  EXPECT_EQ(page->accuracy()->runs, 5U);

  std::vector<AccuracyPoint> points;
  for (const auto& [at, reference] : {std::pair{10.0, 150.02}, std::pair{20.0, 149.98}})
    for (auto rail = page->rails().rbegin(); rail != page->rails().rend(); ++rail) {
      const auto profiles = RailArchive(*archive).profiles(rail->key);
      const auto nearest = std::min_element(profiles->begin(), profiles->end(), [&](const auto& a, const auto& b) {
        return std::abs(a.positionMm / 1000 - at) < std::abs(b.positionMm / 1000 - at);
      });
      const DimensionResult& is = nearest->dimensions[index(Dimension::FW)];
      points.push_back({at, rail->id, *is.valueMm, reference, is.uMm, 0.001});
    }
  const auto expected = accuracyStudy(points);
  ASSERT_TRUE(expected);
  EXPECT_NEAR(page->accuracy()->whole.bias, expected->whole.bias, 1e-9);
  EXPECT_NEAR(page->accuracy()->whole.rms, expected->whole.rms, 1e-9);
  EXPECT_NEAR(page->accuracy()->enMax, expected->enMax, 1e-9);
}

TEST_F(QualityPageTest, ReportAndValuesAreWritten) {
  for (int i = 0; i < 5; ++i) page->setRun(i, true);
  press();
  for (const char* name : {"study.pdf", "values.csv"}) {
    const QString file = folder.filePath(QString::fromLatin1(name));
    QSignalSpy saved(page.get(), &QualityPage::saved);
    if (file.endsWith(QStringLiteral("pdf")))
      page->saveReport(file);
    else
      page->saveValues(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() > 0; }, 30000));
    EXPECT_GT(QFileInfo(file).size(), 1000) << name << ": " << page->words().toStdString();
    if (const QByteArray kept = qgetenv("VIGNOLE_KEEP_PICTURES"); !kept.isEmpty())
      QFile::copy(file, QString::fromLocal8Bit(kept + '/' + name));
  }
}

TEST_F(QualityPageTest, RunsOfAFileAreTheSameAsThoseOfTheArchive) {
  QString text = QStringLiteral("run,position_m,RH\n");
  const auto profiles = RailArchive(*archive).profiles(page->rails().front().key);
  for (int run = 1; run <= 3; ++run)
    for (const ProfileRecord& p : *profiles)
      text += QStringLiteral("%1,%2,%3\n")
                  .arg(run)
                  .arg(p.positionMm / 1000, 0, 'f', 4)
                  .arg(*p.dimensions[index(Dimension::RH)].valueMm + 0.01 * run, 0, 'f', 6);
  QFile out(folder.filePath(QStringLiteral("runs.csv")));
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(text.toUtf8());
  out.close();
  QSignalSpy read(page.get(), &QualityPage::railsChanged);
  page->openRuns(out.fileName());
  ASSERT_TRUE(QTest::qWaitFor([&] { return read.count() > 0; }, 20000));
  press();
  ASSERT_NE(page->result(), nullptr) << page->words().toStdString();
  EXPECT_NEAR(page->result()->meanRangeMm, 0.02, 1e-6);
  EXPECT_NEAR(page->result()->srMm, 0.01, 1e-6);
  page->choose(Dimension::FW);
  EXPECT_EQ(page->result(), nullptr) << "the file has no FW";
}

TEST_F(QualityPageTest, TheVirtualRigInspectsOneRailFiveTimes) {
  page->setSource(QualityPage::Source::VirtualRig);
  auto* button = named<QPushButton>("Inspect the same virtual rail five times");
  EXPECT_FALSE(button->isEnabled()) << "the live line comes first";
  line.isRunning = false;
  page->showLine(line.snapshot, PullDetail::Everything);
  ASSERT_TRUE(button->isEnabled());
  QSignalSpy answered(page.get(), &QualityPage::resultChanged);
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 240000));
  ASSERT_NE(page->result(), nullptr) << page->words().toStdString();
  EXPECT_EQ(page->result()->runs.size(), 5U);
  EXPECT_GT(page->result()->srMm, 0) << "the passes differ";
  EXPECT_LT(page->result()->meanRangeMm, 0.1);
  page->showKind(RunsStudyKind::Accuracy);
  ASSERT_NE(page->accuracy(), nullptr);
  EXPECT_LT(std::abs(page->accuracy()->whole.bias), 0.02);
  keep("quality-accuracy");
  page->showKind(RunsStudyKind::Repeatability);
  keep("quality-rig");
}

TEST_F(QualityPageTest, InspectionsAreCancelled) {
  page->setSource(QualityPage::Source::VirtualRig);
  line.isRunning = false;
  QSignalSpy answered(page.get(), &QualityPage::resultChanged);
  page->runExperiment();
  page->runExperiment();
  ASSERT_TRUE(QTest::qWaitFor([&] { return answered.count() > 0; }, 60000));
  EXPECT_TRUE(page->words().contains(QStringLiteral("cancelled"))) << page->words().toStdString();
  EXPECT_EQ(page->studied(), nullptr);
}

TEST_F(QualityPageTest, NothingIsClippedAtEitherSize) {
  for (int i = 0; i < 5; ++i) page->setRun(i, true);
  press();
  for (const QSize size : {QSize(1920, 856), QSize(1366, 624)}) {
    page->resize(size);
    QTest::qWait(0);
    EXPECT_GE(page->width(), page->minimumSizeHint().width());
    EXPECT_GE(page->height(), page->minimumSizeHint().height());
    // A minimum alone proves nothing where wrapped text takes part: the last row is really there.
    const auto* table = named<QTableWidget>("Every dimension; the chosen one is drawn");
    const QTableWidgetItem* last = table->item(static_cast<int>(kDimensionCount) - 1, 0);
    EXPECT_LE(table->visualItemRect(last).bottom(), table->viewport()->height()) << size.width();
    const QWidget* panel = table->parentWidget();
    EXPECT_TRUE(panel->rect().contains(table->geometry())) << size.width();
    const auto* figures = named<QTableWidget>("Figures of the chosen dimension, formulas and constants");
    EXPECT_LE(panel->geometry().bottom(), figures->parentWidget()->geometry().top()) << size.width();
    EXPECT_GE(figures->height(), 56) << size.width();
    keep(QByteArray("quality-") + QByteArray::number(size.width()));
  }
  theme.setDark(true);
  page->resize(1920, 856);
  keep("quality-dark");
}

}  // namespace
}  // namespace vignole
