// Calibration: the wizard of the range finders lived through by clicks on the virtual rig, its refusals, its cancel;
// history, comparison, revert.

#include "gui/calibration/calibration_page.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "engine/archive/audit_trail.h"
#include "engine/simulator/virtual_rig.h"
#include "gui/bridge/calibration_in_force.h"
#include "gui/calibration/calibration_overview.h"
#include "gui/calibration_encoder/encoder_panel.h"
#include "gui/calibration_lens/lens_wizard.h"
#include "gui/calibration_records/calibration_desk.h"
#include "gui/calibration_reference/reference_panel.h"
#include "gui/calibration_rig/rig_wizard.h"
#include "gui/calibration_study/study_panel.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

constexpr int kLong = 240000;

/// Stands still before the virtual rig of a seed; knows its exact calibration.
class RigLine : public FakeLine {
 public:
  RigCalibration used;
  int changes = 0;
  explicit RigLine(std::uint64_t seed) : seed_(seed) {
    VirtualRigSettings settings;
    settings.section = recipe().section;
    settings.rigSeed = seed;
    used = (*VirtualRig::create(settings))->calibration();
    isRunning = false;
    snapshot = emptySnapshot(LineState::Stopped);
  }
  [[nodiscard]] RigCalibration calibration() override { return used; }
  void useCalibration(const RigCalibration& calibration) override {
    used = calibration;
    ++changes;
  }
  [[nodiscard]] std::optional<std::uint64_t> virtualRigSeed() const override { return seed_; }

 private:
  std::uint64_t seed_;
};

class CalibrationPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  RigLine line{3};
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  std::optional<Archive> archive;
  std::unique_ptr<CalibrationPage> page;

  void SetUp() override {
    place.archiveUrl = folder.filePath(QStringLiteral("calibrations.db")).toStdString();
    auto opened = Archive::open(place.archiveUrl, Archive::Missing::Create);
    ASSERT_TRUE(opened) << opened.error().message();
    archive = std::move(*opened);
    place.archive = &*archive;
    session.enter(QStringLiteral("tessa"), Role::Technician);
  }
  void open() {
    page = std::make_unique<CalibrationPage>(place);
    page->setStyleSheet(theme.styleSheet());
    page->resize(1920, 912);
    page->show();
    page->showLine(line.snapshot, PullDetail::Everything);
  }
  RigWizard& wizard() { return page->rigWizard(); }
  template <typename W>
  W* named(const char* accessibleName) {
    for (W* w : page->findChildren<W*>())
      if (w->accessibleName() == QLatin1String(accessibleName) && w->isVisible()) return w;
    ADD_FAILURE() << "no " << accessibleName;
    return nullptr;
  }
  void click(const char* accessibleName) {
    auto* button = named<QPushButton>(accessibleName);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(button->isEnabled()) << accessibleName << ": " << words().toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// All that is written on the page.
  QString words() {
    QStringList all;
    for (QLabel* label : page->findChildren<QLabel*>())
      if (label->isVisible()) all << label->text();
    return all.join(QStringLiteral(" | "));
  }
  /// For people to look at, in both themes and the least size: VIGNOLE_KEEP_PICTURES=DIR.
  void keep(const char* name) {
    const QString where = qEnvironmentVariable("VIGNOLE_KEEP_PICTURES");
    EXPECT_LE(page->minimumSizeHint().width(), 1366) << name;
    EXPECT_LE(page->minimumSizeHint().height(), 624) << name;
    if (where.isEmpty()) return;
    for (const bool dark : {false, true})
      for (const QSize size : {QSize(1920, 912), QSize(1366, 624)}) {
        theme.setDark(dark);
        page->setStyleSheet(theme.styleSheet());
        page->resize(size);
        page->grab().save(QDir(where).filePath(QStringLiteral("%1-%2-%3.png")
                                                   .arg(QLatin1String(name))
                                                   .arg(dark ? QStringLiteral("dark") : QStringLiteral("light"))
                                                   .arg(size.width())));
      }
    theme.setDark(false);
    page->setStyleSheet(theme.styleSheet());
    page->resize(1920, 912);
  }
  void waitForSight() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return wizard().sight() && !wizard().looking(); }, kLong));
  }
  /// To the first placement with so few of them.
  void startWith(int placements, int fault = 0) {
    open();
    click("Calibrate the range finders with the pin plate");
    named<QSpinBox>("Number of placements")->setValue(placements);
    named<QComboBox>("The virtual plate, for training")->setCurrentIndex(fault);
    click("First placement");
    waitForSight();
  }
  void placeAsShown() {
    click("Place as shown");
    waitForSight();
  }
  void solveFrom(int placements) {
    for (int i = 0; i < placements; ++i) {
      ASSERT_EQ(wizard().stage(), RigWizard::Stage::Placement);
      ASSERT_EQ(wizard().placement(), i);
      waitForSight();
      placeAsShown();
      if (i + 1 < placements) click("Next placement");
    }
    QSignalSpy solved(&wizard(), &RigWizard::solved);
    click("Solve");
    ASSERT_TRUE(QTest::qWaitFor([&] { return solved.count() > 0; }, kLong));
  }
};

TEST_F(CalibrationPageTest, TheRangeFindersAreCalibratedAndPutBack) {
  const std::string before = line.used.id;
  startWith(2);
  keep("rig-1-placement-off");
  // As it comes out of its box the plate lies elsewhere: what to do is said, and there is no going on.
  EXPECT_FALSE(named<QPushButton>("Next placement")->isEnabled());
  EXPECT_TRUE(words().contains(QStringLiteral("turned by 12° clockwise"))) << words().toStdString();
  EXPECT_TRUE(words().contains(QStringLiteral("17 mm to the left"))) << words().toStdString();
  placeAsShown();
  keep("rig-2-placement-good");
  EXPECT_TRUE(named<QPushButton>("Next placement")->isEnabled()) << words().toStdString();
  ASSERT_TRUE(wizard().sight()->usable());
  for (const auto& found : wizard().sight()->found) EXPECT_GE(found.size(), 8U);
  click("Next placement");
  waitForSight();
  // The plate still lies as in the first placement, so it is told to be turned.
  EXPECT_FALSE(named<QPushButton>("Solve")->isEnabled());
  placeAsShown();
  QSignalSpy solved(&wizard(), &RigWizard::solved);
  click("Solve");
  keep("rig-3-solve");
  ASSERT_TRUE(QTest::qWaitFor([&] { return solved.count() > 0; }, kLong));
  ASSERT_EQ(wizard().stage(), RigWizard::Stage::Compare) << words().toStdString();
  keep("rig-4-compare");
  ASSERT_TRUE(wizard().solution());
  ASSERT_TRUE(wizard().solution()->mayBeUsed()) << words().toStdString();
  for (const DimensionWorth& w : wizard().solution()->worth) {
    ASSERT_TRUE(w.newMm) << name(w.dimension);
    EXPECT_GT(*w.newMm, 0);
    EXPECT_LT(*w.newMm, w.dimension == Dimension::HR ? 20 : 0.1) << name(w.dimension);
    EXPECT_FALSE(w.largest.empty());
  }
  EXPECT_EQ(line.used.id, before) << "applied before it was confirmed";
  click("Next");
  keep("rig-5-apply");
  QSignalSpy applied(&wizard(), &RigWizard::applied);
  click("Put in force");
  ASSERT_TRUE(QTest::qWaitFor([&] { return applied.count() == 1; }, kLong));
  EXPECT_EQ(line.changes, 0) << "without a reason";
  QTest::keyClicks(named<QLineEdit>("Reason for the new calibration"), QStringLiteral("camera 2 was changed"));
  click("Put in force");
  ASSERT_TRUE(QTest::qWaitFor([&] { return applied.count() == 2; }, kLong));
  ASSERT_EQ(line.changes, 1) << words().toStdString();
  EXPECT_NE(line.used.id, before);
  EXPECT_EQ(line.used.intervalDays, 90);
  keep("rig-6-applied");
  const auto trail = AuditTrail(*archive).entries();
  ASSERT_TRUE(trail);
  ASSERT_FALSE(trail->empty());
  EXPECT_EQ(trail->front().action, "calibration in force");
  EXPECT_EQ(trail->front().user, "tessa");
  EXPECT_EQ(trail->front().reason, "camera 2 was changed");
  // A program that starts later takes it up.
  const auto later = calibrationInForce(*archive, RigLine(3).used);
  ASSERT_TRUE(later) << later.error().message();
  ASSERT_TRUE(*later);
  EXPECT_EQ((*later)->id, line.used.id);
  EXPECT_FALSE(*calibrationInForce(*archive, RigLine(4).used)) << "of another rig";

  // The exact one is kept as well and comes back.
  ASSERT_TRUE(CalibrationHistory(*archive).add(RigLine(3).used, "tessa", "as delivered"));
  click("Close");
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->desk().all().size() == 2; }, kLong));
  QSignalSpy compared(&page->overview(), &CalibrationOverview::compared);
  page->overview().chooseKept(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return compared.count() > 0; }, kLong));
  ASSERT_TRUE(page->overview().comparison()) << words().toStdString();
  for (const Dimension d : {Dimension::RH, Dimension::HW, Dimension::FW, Dimension::WT}) {
    const double off = page->overview().comparison()->differenceMm[index(d)];
    EXPECT_LT(std::abs(off), 0.1) << name(d);
    EXPECT_NE(off, 0) << name(d);
  }
  keep("overview-compared");
  QSignalSpy reverted(&page->overview(), &CalibrationOverview::reverted);
  QTest::keyClicks(named<QLineEdit>("Reason for putting it back in force"), QStringLiteral("lens was loose"));
  click("Put the chosen calibration in force");
  ASSERT_TRUE(QTest::qWaitFor([&] { return reverted.count() > 0; }, kLong));
  EXPECT_EQ(line.used.id, before) << words().toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->desk().uses().size() == 2; }, kLong));
  EXPECT_EQ(page->desk().uses().front().reason, "lens was loose");
}

TEST_F(CalibrationPageTest, ALensIsCalibratedFromPicturesAndUsedWithThePlate) {
  open();
  click("Calibrate the lens of a camera with the flat target");
  LensWizard& lens = page->lensWizard();
  keep("lens-1-prepare");
  named<QComboBox>("Camera whose lens is calibrated")->setCurrentIndex(1);
  named<QSpinBox>("Number of pictures")->setValue(7);
  click("First picture");
  const auto seen = [&] { return QTest::qWaitFor([&] { return lens.sight() && !lens.looking(); }, kLong); };
  ASSERT_TRUE(seen());
  bool advised = false;
  for (int i = 0; i < 7; ++i) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !lens.advising(); }, kLong));
    advised = advised || !lens.nextView().words.empty();
    click("Hold as shown");
    ASSERT_TRUE(seen());
    ASSERT_TRUE(lens.sight()->usable()) << words().toStdString();
    click("Take picture");
    ASSERT_EQ(lens.taken().size(), static_cast<std::size_t>(i + 1));
    ASSERT_TRUE(seen());
    if (i == 0) {
      // Not moved: the next one would be the same pose.
      EXPECT_FALSE(named<QPushButton>("Take picture")->isEnabled());
      EXPECT_TRUE(words().contains(QStringLiteral("pose of picture 1"))) << words().toStdString();
      // Out of the picture: refused with its reason.
      named<QDoubleSpinBox>("Target to the right, mm")->setValue(400);
      ASSERT_TRUE(seen());
      EXPECT_FALSE(named<QPushButton>("Take picture")->isEnabled());
      EXPECT_TRUE(words().contains(QStringLiteral("refused"))) << words().toStdString();
      keep("lens-2-refused");
    }
  }
  keep("lens-3-pictures");
  EXPECT_TRUE(advised) << "no pose was chosen by what is uncertain";
  QSignalSpy solved(&lens, &LensWizard::solved);
  click("Solve");
  ASSERT_TRUE(QTest::qWaitFor([&] { return solved.count() > 0; }, kLong));
  ASSERT_EQ(lens.stage(), LensWizard::Stage::Result) << words().toStdString();
  keep("lens-4-result");
  ASSERT_TRUE(lens.result());
  ASSERT_TRUE(lens.result()->accepted()) << words().toStdString();
  const Intrinsics truth = RigLine(3).used.rangeFinders[1].intrinsics;
  const Intrinsics& found = lens.result()->camera.intrinsics;
  EXPECT_NEAR(found.focalMm / found.pixelWidthMm, truth.focalMm / truth.pixelWidthMm, 6);
  EXPECT_NEAR(found.cxPx, truth.cxPx, 5);
  EXPECT_EQ(lens.result()->camera.serial, RigLine(3).used.rangeFinders[1].serial);
  click("Use with the plate");
  click("Leave");
  click("Calibrate the range finders with the pin plate");
  EXPECT_TRUE(words().contains(QStringLiteral("Camera 2: lens as calibrated in this session")))
      << words().toStdString();
}

TEST_F(CalibrationPageTest, AReferencePieceTellsAGoodCalibrationFromABadOne) {
  open();
  click("Check the calibration on a reference piece");
  named<QSpinBox>("Profiles that are averaged")->setValue(30);
  QSignalSpy checked(&page->reference(), &ReferencePanel::checked);
  click("Measure the piece");
  ASSERT_TRUE(QTest::qWaitFor([&] { return checked.count() == 1; }, kLong));
  ASSERT_TRUE(page->reference().result()) << words().toStdString();
  keep("reference-good");
  EXPECT_GE(page->reference().result()->profiles, 25);
  EXPECT_TRUE(page->reference().result()->agrees());
  for (const ReferenceRow& row : page->reference().result()->rows) {
    if (row.dimension == Dimension::HR) continue;
    ASSERT_TRUE(row.measuredMm) << name(row.dimension) << row.reason;
    EXPECT_LT(std::abs(*row.measuredMm - row.certifiedMm), 0.03) << name(row.dimension);
  }
  // Camera 2 has moved since: the check finds it.
  line.used.rangeFinders[1].cameraFromWorld.translationMm += Eigen::Vector3d(0.4, 0.2, 0);
  click("Measure the piece");
  ASSERT_TRUE(QTest::qWaitFor([&] { return checked.count() == 2; }, kLong));
  ASSERT_TRUE(page->reference().result()) << words().toStdString();
  keep("reference-bad");
  EXPECT_FALSE(page->reference().result()->agrees());
  EXPECT_TRUE(words().contains(QStringLiteral("does not agree"))) << words().toStdString();
}

TEST_F(CalibrationPageTest, TheEncoderIsCalibratedAndASlippingWheelIsTold) {
  open();
  click("Calibrate the encoder over a known length");
  click("Drive the rail");
  ASSERT_TRUE(page->encoder().result()) << words().toStdString();
  keep("encoder");
  const PerPulse& along = page->encoder().result()->vz;
  ASSERT_TRUE(along.uMm);
  EXPECT_NEAR(along.mm, 0.05, 4 * *along.uMm + 1e-9);
  EXPECT_TRUE(words().contains(QStringLiteral("One pulse is"))) << words().toStdString();
  named<QDoubleSpinBox>("Slip of the virtual second encoder, ppm")->setValue(2000);
  click("Drive the rail");
  ASSERT_TRUE(page->encoder().result());
  EXPECT_TRUE(words().contains(QStringLiteral("slips"))) << words().toStdString();
  keep("encoder-slip");
}

TEST_F(CalibrationPageTest, AStudyTellsWhichSettingMatters) {
  open();
  click("Study which settings of the calibration matter");
  page->study().setLevels(QStringLiteral("exposure_ms"), {});
  page->study().setLevels(QStringLiteral("sigma_px"), QStringLiteral("1.5, 4"));
  page->study().setLevels(QStringLiteral("max_ellipses"), QStringLiteral("13, 8"));
  QSignalSpy studied(&page->study(), &StudyPanel::studied);
  click("Start the study");
  ASSERT_TRUE(QTest::qWaitFor([&] { return studied.count() == 1; }, kLong));
  ASSERT_TRUE(page->study().study()) << words().toStdString();
  keep("study");
  EXPECT_EQ(page->study().study()->design.runs.size(), 4U);
  ASSERT_NE(page->study().study()->of(Response::Cd), nullptr);
  // Nonsense is told, not run.
  page->study().setLevels(QStringLiteral("sigma_px"), QStringLiteral("-2, 900"));
  click("Start the study");
  ASSERT_EQ(studied.count(), 2);
  EXPECT_FALSE(page->study().study());
  EXPECT_TRUE(words().contains(QStringLiteral("is -2"))) << words().toStdString();
  // Cancelled.
  page->study().setLevels(QStringLiteral("sigma_px"), QStringLiteral("1.5, 2, 3, 4"));
  click("Start the study");
  click("Cancel");
  ASSERT_TRUE(QTest::qWaitFor([&] { return studied.count() == 3; }, kLong));
  EXPECT_FALSE(page->study().study());
  EXPECT_TRUE(words().contains(QStringLiteral("Cancelled"))) << words().toStdString();
}

TEST_F(CalibrationPageTest, AMirroredPlateIsRefusedWithItsReason) {
  startWith(2, 1);
  placeAsShown();
  keep("rig-refused-mirrored");
  EXPECT_FALSE(named<QPushButton>("Next placement")->isEnabled());
  EXPECT_TRUE(words().contains(QStringLiteral("mirror image"))) << words().toStdString();
}

TEST_F(CalibrationPageTest, ThePlateOfAnotherCertificateIsNotPutInForce) {
  startWith(2, 2);
  placeAsShown();
  click("Next placement");
  waitForSight();
  placeAsShown();
  QSignalSpy solved(&wizard(), &RigWizard::solved);
  click("Solve");
  ASSERT_TRUE(QTest::qWaitFor([&] { return solved.count() > 0; }, kLong));
  keep("rig-refused-plate");
  ASSERT_EQ(wizard().stage(), RigWizard::Stage::Compare);
  ASSERT_TRUE(wizard().solution());
  EXPECT_FALSE(wizard().solution()->mayBeUsed());
  EXPECT_FALSE(named<QPushButton>("Next")->isEnabled());
  EXPECT_TRUE(words().contains(QStringLiteral("refused"))) << words().toStdString();
  EXPECT_EQ(line.changes, 0);
}

TEST_F(CalibrationPageTest, ASolutionThatIsCancelledChangesNothing) {
  startWith(2);
  placeAsShown();
  click("Next placement");
  waitForSight();
  placeAsShown();
  QSignalSpy solved(&wizard(), &RigWizard::solved);
  click("Solve");
  click("Cancel");
  ASSERT_TRUE(QTest::qWaitFor([&] { return solved.count() > 0; }, kLong));
  EXPECT_EQ(wizard().stage(), RigWizard::Stage::Placement);
  EXPECT_FALSE(wizard().solution());
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return words().contains(QStringLiteral("Cancelled: nothing has changed")); }, kLong))
      << words().toStdString();
  EXPECT_EQ(line.changes, 0);
}

TEST_F(CalibrationPageTest, WhileTheLineMeasuresTheWizardIsClosedAndOffersToStopIt) {
  open();
  click("Calibrate the range finders with the pin plate");
  line.isRunning = true;
  line.snapshot = emptySnapshot(LineState::Measuring);
  page->showLine(line.snapshot, PullDetail::Everything);
  EXPECT_TRUE(wizard().closedByLine());
  keep("rig-closed");
  EXPECT_TRUE(words().contains(QStringLiteral("Closed while the line measures")));
  click("Stop the line");
  EXPECT_EQ(line.stops, 1);
  line.snapshot = emptySnapshot(LineState::Stopped);
  page->showLine(line.snapshot, PullDetail::Everything);
  EXPECT_FALSE(wizard().closedByLine());
}

TEST_F(CalibrationPageTest, AnOperatorSeesWhoMayCalibrate) {
  session.leave();
  open();
  keep("overview-operator");
  EXPECT_FALSE(named<QPushButton>("Calibrate the range finders with the pin plate")->isEnabled());
  EXPECT_TRUE(words().contains(QStringLiteral("technician")));
  session.enter(QStringLiteral("tessa"), Role::Technician);
  EXPECT_TRUE(named<QPushButton>("Calibrate the range finders with the pin plate")->isEnabled());
}

TEST_F(CalibrationPageTest, ACameraThatHasMovedIsNamed) {
  open();
  auto track = std::make_shared<DriftTrack>();
  track->baselineRails = 6;
  track->latest.rails = 3;
  line.snapshot.drift = track;
  page->showLine(line.snapshot, PullDetail::Everything);
  EXPECT_TRUE(words().contains(QStringLiteral("3 of 6 rails"))) << words().toStdString();
  auto moved = std::make_shared<DriftTrack>(*track);
  moved->latest.learning = false;
  moved->latest.rails = 20;
  for (int rail = 0; rail < 14; ++rail)
    moved->rails.push_back({{0.001, 0.002, 0.002 * rail, 0.001}, {.012, .012, .012, .012}});
  moved->latest.cameras[2].alarm = true;
  moved->latest.cameras[2].valueMm = 0.026;
  moved->latest.cameras[2].limitMm = 0.012;
  moved->latest.cameras[2].words = "camera 3 has moved by 0.026 mm; calibrate the range finders";
  line.snapshot.drift = moved;
  page->showLine(line.snapshot, PullDetail::Everything);
  keep("overview-drift");
  EXPECT_TRUE(words().contains(QStringLiteral("camera 3 has moved"))) << words().toStdString();
}

}  // namespace
}  // namespace vignole
