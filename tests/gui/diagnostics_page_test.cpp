// Diagnostics: where every trigger went, what falls behind, and a bundle for whoever helps from afar.

#include "gui/diagnostics/diagnostics_page.h"

#include <QDir>
#include <QFile>
#include <QHeaderView>
#include <QImage>
#include <QLayout>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/optics/nominal_rig.h"
#include "gui/diagnostics/pipeline_panel.h"
#include "gui/diagnostics/support_bundle.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

class DiagnosticsPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  EventLoopWatchdog watchdog;
  std::unique_ptr<DiagnosticsPage> page;

  void SetUp() override {
    line.snapshot = makeSnapshot();
    line.rig = nominalRig();
  }
  void open() {
    page = std::make_unique<DiagnosticsPage>(place, watchdog);
    page->resize(1888, 880);
    page->show();
    tick();
  }
  void tick() { page->showLine(line.snapshot, PullDetail::Everything); }
  /// The cell beside the row of that name; "" if there is none.
  static QString beside(const QTableWidget& table, const char* name, int column = 1) {
    for (int row = 0; row < table.rowCount(); ++row)
      if (table.item(row, 0)->text() == QLatin1String(name)) return table.item(row, column)->text();
    return {};
  }
  QStringList written(const QString& parent) {
    const QStringList made = QDir(parent).entryList({QStringLiteral("vignole-support-*")}, QDir::Dirs);
    return made.isEmpty() ? QStringList() : QDir(parent + QLatin1Char('/') + made.front()).entryList(QDir::Files);
  }
  QByteArray read(const QString& parent, const char* name) {
    const QStringList made = QDir(parent).entryList({QStringLiteral("vignole-support-*")}, QDir::Dirs);
    QFile file(parent + QLatin1Char('/') + made.value(0) + QLatin1Char('/') + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
};

TEST_F(DiagnosticsPageTest, TheLedgerEndsInNothingThatIsNotAccountedFor) {
  for (StageStatistics& stage : line.snapshot.stages) stage.count = line.snapshot.triggers.seen + 2;
  open();
  EXPECT_EQ(beside(page->ledger(), "Under way"), QStringLiteral("2"));
  EXPECT_EQ(beside(page->ledger(), "Not accounted for"), QStringLiteral("0"));
  // At rest nothing is under way any more: two frames came in and are in no book.
  line.isRunning = false;
  tick();
  EXPECT_EQ(beside(page->ledger(), "Not accounted for"), QStringLiteral("2"));
  EXPECT_TRUE(beside(page->ledger(), "Under way").isEmpty());
}

TEST_F(DiagnosticsPageTest, ACameraThatLosesFramesIsNamedWithItsCount) {
  line.snapshot = makeSnapshot({.lostCamera = 2});
  open();
  EXPECT_EQ(page->cameras().item(2, 0)->text(), QStringLiteral("Camera 3: lost"));
  EXPECT_NE(page->cameras().item(2, 3)->text(), QStringLiteral("0"));
  EXPECT_EQ(page->cameras().item(1, 3)->text(), QStringLiteral("0"));
  EXPECT_FALSE(beside(page->ledger(), "    camera 3: frame lost").isEmpty());
  EXPECT_EQ(page->ledger().item(page->ledger().rowCount() - 1, 0)->text(), QStringLiteral("Not accounted for"))
      << "the column ends in it";
}

TEST_F(DiagnosticsPageTest, WhatTheComputerDoesNotTellIsSaid) {
  open();
  EXPECT_TRUE(QTest::qWaitFor([&] {
    tick();
    return beside(page->computer(), "Disk").contains(QStringLiteral(" GB"));
  }));
  EXPECT_EQ(beside(page->computer(), "Archive"), QStringLiteral("rails are not kept"));
  EXPECT_FALSE(beside(page->computer(), "Temperature", 3).isEmpty());
  EXPECT_EQ(page->cameras().item(0, 4)->text(), QStringLiteral("–")) << "this line does not tell its exposure";
}

TEST_F(DiagnosticsPageTest, AStageBehindAndADroppingQueueChangeThePicture) {
  open();
  auto* picture = page->findChild<PipelinePanel*>();
  const QImage before = picture->grab().toImage();
  line.snapshot.stages[4].meanMs = 20;  // of 15 ms that there are
  tick();
  const QImage behind = picture->grab().toImage();
  EXPECT_NE(behind, before);
  line.snapshot.stages[8].overflows = 3;
  tick();
  EXPECT_NE(picture->grab().toImage(), behind);
}

TEST_F(DiagnosticsPageTest, TheBundleHoldsStateRecipeCalibrationAndNoPictureOfALineThatRests) {
  line.isRunning = false;
  open();
  session.enter(QStringLiteral("Benedikt"), Role::Technician);
  ASSERT_TRUE(page->saveSupport(folder.path()));
  EXPECT_FALSE(page->saveSupport(folder.path())) << "one at a time";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->note().isEmpty(); }, 20000));
  EXPECT_EQ(written(folder.path()), QStringList({QStringLiteral("calibration.toml"), QStringLiteral("recipe.toml"),
                                                 QStringLiteral("state.json")}));
  const auto state = nlohmann::json::parse(read(folder.path(), "state.json").toStdString());
  EXPECT_EQ(state["stages"].size(), 14U);
  EXPECT_EQ(state["triggers"]["seen"], line.snapshot.triggers.seen);
  for (const char* file : {"state.json", "recipe.toml", "calibration.toml"}) {
    EXPECT_FALSE(read(folder.path(), file).isEmpty()) << file;
    EXPECT_FALSE(read(folder.path(), file).contains("Benedikt")) << file;
    EXPECT_FALSE(read(folder.path(), file).contains("password")) << file;
  }
}

TEST_F(DiagnosticsPageTest, ARunningLinesPicturesAreInTheBundleAndLetGoOfAfterwards) {
  line.pictures = std::make_shared<LatestFrames>();
  open();
  std::jthread engine([&](const std::stop_token& stop) {
    for (std::uint64_t trigger = 0; !stop.stop_requested(); ++trigger) {
      for (int c = 0; c < kCameraCount; ++c) {
        auto pixels =
            std::make_shared<std::vector<std::uint8_t>>(std::size_t{64} * 48, static_cast<std::uint8_t>(50 + c));
        line.pictures->offer({c, trigger, {pixels->data(), 64, 48, 64}, pixels}, {}, 0.1);
      }
      std::this_thread::yield();
    }
  });
  ASSERT_TRUE(page->saveSupport(folder.path()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->note().isEmpty(); }, 20000));
  const QImage third = QImage::fromData(read(folder.path(), "camera3.png"));
  ASSERT_EQ(third.size(), QSize(64, 48));
  EXPECT_EQ(qRed(third.pixel(5, 5)), 52);
  EXPECT_FALSE(line.pictures->watched());
}

TEST_F(DiagnosticsPageTest, ABundleThatCannotBeWrittenSaysWhy) {
  open();
  ASSERT_TRUE(page->saveSupport(QStringLiteral("/proc/nowhere")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->note().isEmpty(); }, 20000));
  EXPECT_TRUE(page->note().contains(QStringLiteral("cannot be made"))) << page->note().toStdString();
}

TEST(SupportBundleInAThread, CancelledLeavesNothingAndNamesWhatFailed) {
  QTemporaryDir folder;
  SupportBundle bundle;
  QSignalSpy finished(&bundle, &SupportBundle::finished);
  const SupportFile waits{QStringLiteral("b"), [](const std::stop_token& stop) -> Expected<QByteArray> {
                            while (!stop.stop_requested()) std::this_thread::yield();
                            return QByteArray("x");
                          }};
  const SupportFile quick{QStringLiteral("a"),
                          [](const std::stop_token&) -> Expected<QByteArray> { return QByteArray("x"); }};
  QSignalSpy progressed(&bundle, &SupportBundle::progressed);
  ASSERT_TRUE(bundle.start(folder.filePath(QStringLiteral("one")), {quick, waits}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return progressed.count() > 0; }));
  bundle.cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }));
  EXPECT_FALSE(finished[0][0].toString().isEmpty());
  EXPECT_FALSE(QDir(folder.filePath(QStringLiteral("one"))).exists());

  const SupportFile fails{QStringLiteral("c"), [](const std::stop_token&) -> Expected<QByteArray> {
                            return tl::unexpected(worldError("camera", "gone"));
                          }};
  ASSERT_TRUE(bundle.start(folder.filePath(QStringLiteral("two")), {fails, quick}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() == 2; }));
  EXPECT_TRUE(finished[1][0].toString().contains(QStringLiteral("gone")));
  EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("two/a")))) << "the others are written";
}

TEST(ComputerStateOfFolders, TheHottestPlausibleSensorCounts) {
  QTemporaryDir folder;
  const auto put = [&](const char* file, const char* text) {
    const QString path = folder.filePath(QLatin1String(file));
    ASSERT_TRUE(QDir().mkpath(QFileInfo(path).path()));
    std::ofstream(path.toStdString()) << text;
  };
  put("thermal/thermal_zone0/temp", "41500\n");
  put("thermal/thermal_zone0/type", "x86_pkg_temp\n");
  put("thermal/cooling_device0/temp", "99000\n");
  put("hwmon/hwmon0/name", "coretemp\n");
  put("hwmon/hwmon0/temp1_input", "47250\n");
  put("hwmon/hwmon0/temp2_input", "255000\n");
  const std::string root = folder.path().toStdString();
  const ComputerState state = lookAtComputer(root, {}, {root + "/thermal", root + "/hwmon"});
  ASSERT_TRUE(state.temperatureC);
  EXPECT_DOUBLE_EQ(*state.temperatureC, 47.25);
  EXPECT_EQ(state.sensor, "coretemp");
  EXPECT_GT(state.diskBytes, 0U);
  EXPECT_FALSE(lookAtComputer(root, {}, {root + "/none", root + "/none"}).temperatureC);
}

TEST_F(DiagnosticsPageTest, NothingIsClippedInAnySizeAndEveryControlHasAName) {
  open();
  page->layout()->setSizeConstraint(QLayout::SetNoConstraint);
  page->setMinimumSize(1, 1);
  page->setStyleSheet(theme.styleSheet());
  for (const QSize size : {QSize(1366, 624), QSize(1600, 740), QSize(1920, 912), QSize(3840, 1992)}) {
    page->resize(size);
    ASSERT_EQ(page->size(), size);
    tick();
    QCoreApplication::processEvents();
    for (const QWidget* w : page->findChildren<QWidget*>()) {
      if (!w->isVisible() || w->parentWidget()->inherits("QAbstractScrollArea") || w->inherits("QScrollBar")) continue;
      const std::string who = std::string(w->metaObject()->className()) + " at width " + std::to_string(size.width());
      EXPECT_GE(w->width(), w->minimumSizeHint().width()) << who;
      EXPECT_GE(w->height(), w->minimumSizeHint().height()) << who;
      EXPECT_TRUE(w->parentWidget()->rect().contains(w->geometry())) << who;
      if (qobject_cast<const QPushButton*>(w) || qobject_cast<const QTableWidget*>(w)) {
        EXPECT_FALSE(w->accessibleName().isEmpty()) << who;
      }
    }
  }
}

}  // namespace
}  // namespace vignole
