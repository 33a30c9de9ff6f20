// Stripes: pictures arrive and stay when frozen, what is tried is compared on the same picture, and applied by who may,
// with a reason that is on record first, from the next rail on.

#include "gui/stripes/stripes_page.h"

#include <QAbstractSpinBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <gtest/gtest.h>

#include "engine/archive/audit_trail.h"
#include "engine/optics/nominal_rig.h"
#include "engine/stripe/stripe_extractor.h"
#include "gui/bridge/virtual_line.h"
#include "gui/stripes/pixel_view.h"
#include "gui/stripes/stripe_view.h"
#include "gui/stripes/trial_panel.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

template <typename W>
W* named(QWidget& page, const char* accessibleName) {
  for (W* w : page.findChildren<W*>())
    if (w->accessibleName().startsWith(QLatin1String(accessibleName))) return w;
  ADD_FAILURE() << accessibleName;
  return nullptr;
}

class StripesPageTest : public ::testing::Test {
 protected:
  QTemporaryDir folder;
  std::unique_ptr<VirtualLine> line;
  Theme theme;
  Session session;
  Units units;
  std::optional<Archive> archive;
  std::unique_ptr<Workplace> place;
  std::unique_ptr<StripesPage> page;

  void SetUp() override {
    VirtualLineSettings settings;
    settings.recipe = *findRecipe("60E1");
    settings.rig.section = settings.recipe.section;
    settings.rig.parameters = settings.recipe.parameters;
    settings.railLengthMm = 3000;
    auto made = VirtualLine::create(settings);
    ASSERT_TRUE(made);
    line = *std::move(made);
    place = std::make_unique<Workplace>(Workplace{theme, *line, session, units});
    place->archiveUrl = folder.filePath(QStringLiteral("a.db")).toStdString();
    auto opened = Archive::open(place->archiveUrl, Archive::Missing::Create);
    ASSERT_TRUE(opened);
    archive = std::move(*opened);
    place->archive = &*archive;
  }
  void TearDown() override {
    page.reset();
    line.reset();
  }
  void open() {
    page = std::make_unique<StripesPage>(*place);
    page->resize(1888, 880);
    page->show();
    line->start();
    ASSERT_TRUE(shown([&] { return allThere(); }));
  }
  /// Ticks until it is so.
  template <typename Condition>
  bool shown(Condition condition) {
    return QTest::qWaitFor(
        [&] {
          page->showLine(line->pull(PullDetail::Everything), PullDetail::Everything);
          return condition();
        },
        20000);
  }
  bool allThere() {
    for (int c = 0; c < kCameraCount; ++c)
      if (!picture(c) || !picture(c)->taken) return false;
    return true;
  }
  const StripePicture* picture(int camera) { return page->view(camera).picture().get(); }
  bool ticked(int times) {
    return shown([&, n = 0]() mutable { return ++n > times; });
  }
  QString cell(int row, int column) { return page->trial().comparison().item(row, column)->text(); }
};

TEST_F(StripesPageTest, FourPicturesOfOneTriggerGoOnUntilTheyAreFrozen) {
  open();
  for (int c = 0; c < kCameraCount; ++c) {
    EXPECT_EQ(picture(c)->camera, c);
    EXPECT_GT(picture(c)->figures.points, 500U) << c;
    EXPECT_FALSE(picture(c)->strokes.empty());
    EXPECT_GT(picture(c)->brightnessDn.size(), 100U);
    EXPECT_EQ(picture(c)->whole.size(), QSize(1400, 1024).scaled(page->view(c).pictureSize(), Qt::KeepAspectRatio));
  }
  const std::uint64_t before = picture(0)->trigger;
  EXPECT_TRUE(shown([&] { return picture(0)->trigger > before; }));
  QTest::keyClick(page.get(), Qt::Key_P);
  EXPECT_TRUE(page->frozen());
  EXPECT_EQ(page->view(0).accessibleDescription(), QStringLiteral("Frozen"));
  // What was under way may still come; then the pictures stay, all of one trigger.
  ASSERT_TRUE(ticked(20));
  const std::uint64_t still = picture(0)->trigger;
  ASSERT_TRUE(ticked(20));
  for (int c = 0; c < kCameraCount; ++c) EXPECT_EQ(picture(c)->trigger, still) << c;
  QTest::mouseClick(named<QPushButton>(*page, "Freeze"), Qt::LeftButton);
  EXPECT_TRUE(shown([&] { return picture(0)->trigger > still; })) << "live again";
}

TEST_F(StripesPageTest, TheLineThatIsShownIsTheOneThatIsMeasuredWith) {
  open();
  QTest::keyClick(page.get(), Qt::Key_P);
  ASSERT_TRUE(ticked(20));
  for (int c = 0; c < kCameraCount; ++c) {
    StripeResult again;
    StripeExtractor(findRecipe("60E1")->stripe, extractionOptics(line->calibration(), findRecipe("60E1")->section, c))
        .extract(picture(c)->taken->frame.image, again);
    const StripeResult& shown = picture(c)->taken->stripe;
    ASSERT_EQ(again.points.size(), shown.points.size());
    for (std::size_t i = 0; i < again.points.size(); ++i) {
      ASSERT_EQ(again.points[i].x, shown.points[i].x);
      ASSERT_EQ(again.points[i].y, shown.points[i].y);
    }
  }
}

TEST_F(StripesPageTest, WhatIsTriedIsComparedOnTheFrozenPicture) {
  open();
  auto* sigma = named<QDoubleSpinBox>(*page, "Smoothing on trial");
  EXPECT_FALSE(named<QPushButton>(*page, "Discard")->isEnabled());
  QTest::mouseClick(named<QPushButton>(*page, "Smoothing: more"), Qt::LeftButton);
  EXPECT_NEAR(sigma->value(), 2.3, 1e-9);
  sigma->setValue(4.0);
  EXPECT_TRUE(page->frozen()) << "old and new are seen on the same picture";
  ASSERT_TRUE(shown([&] {
    return picture(0)->trial.has_value() && page->trial().comparison().item(0, 2)->text() != QStringLiteral("–");
  }));
  const StripeTrial& trial = *picture(0)->trial;
  EXPECT_EQ(trial.taken->frame.image.data, picture(0)->taken->frame.image.data) << "the same picture";
  EXPECT_GT(trial.difference.meanShiftPx, 0);
  EXPECT_GE(trial.difference.largestShiftPx, trial.difference.meanShiftPx);
  EXPECT_NE(cell(5, 2), QStringLiteral("–"));
  const auto views = page->findChildren<PixelView*>();
  ASSERT_EQ(views.size(), 2);
  EXPECT_NE(views[0]->taken(), nullptr);
  EXPECT_NE(views[1]->taken(), nullptr);
  EXPECT_NE(views[0]->taken(), views[1]->taken());

  QTest::keyClick(page.get(), Qt::Key_3);
  EXPECT_EQ(page->chosen(), 2);
  EXPECT_EQ(views[0]->taken()->frame.camera, 2);
  QTest::mouseClick(named<QPushButton>(*page, "Discard"), Qt::LeftButton);
  EXPECT_NEAR(sigma->value(), 2.2, 1e-9);
  EXPECT_FALSE(page->frozen());
}

TEST_F(StripesPageTest, ALowerThresholdGainsPointsAndAHigherOneLosesSome) {
  open();
  const auto gained = [&] { return picture(0)->trial->difference.gained; };
  named<QDoubleSpinBox>(*page, "High threshold on trial")->setValue(120);
  named<QDoubleSpinBox>(*page, "Low threshold on trial")->setValue(80);
  ASSERT_TRUE(shown([&] { return picture(0)->trial && picture(0)->trial->difference.lost > 20; }));
  EXPECT_EQ(gained(), 0U);
  EXPECT_LT(picture(0)->trial->figures.points, picture(0)->figures.points);
  ASSERT_TRUE(picture(0)->trial->difference.where);
}

TEST_F(StripesPageTest, ExposureIsTriedOnTheSameMoment) {
  open();
  auto* exposure = named<QDoubleSpinBox>(*page, "Exposure on trial");
  ASSERT_TRUE(exposure->isEnabled());
  EXPECT_NEAR(exposure->value(), 15, 1e-9);
  exposure->setValue(6);
  ASSERT_TRUE(shown([&] { return picture(0)->trial.has_value(); }));
  EXPECT_NE(picture(0)->trial->taken->frame.image.data, picture(0)->taken->frame.image.data);
  EXPECT_EQ(picture(0)->trial->taken->frame.trigger, picture(0)->trigger);
  EXPECT_LT(picture(0)->trial->figures.meanDn, 0.7 * picture(0)->figures.meanDn);
}

TEST_F(StripesPageTest, ATechnicianAppliesWithAReasonFromTheNextRailAndItIsOnRecord) {
  open();
  auto* apply = named<QPushButton>(*page, "Use what is on trial");
  auto* reason = named<QLineEdit>(*page, "Reason");
  EXPECT_FALSE(apply->isEnabled()) << "an operator tries, a technician applies";
  session.enter(QStringLiteral("Ben"), Role::Technician);
  ASSERT_TRUE(apply->isEnabled());
  const auto waits = [&] { return line->pull(PullDetail::Everything).nextStripe.has_value(); };
  const auto used = [&] { return line->pull(PullDetail::Everything).recipe->stripe.sigma; };

  named<QDoubleSpinBox>(*page, "Smoothing on trial")->setValue(4.0);
  QTest::mouseClick(apply, Qt::LeftButton);
  EXPECT_TRUE(page->trial().message().contains(QStringLiteral("reason"))) << "not without a reason";
  EXPECT_FALSE(waits());
  QTest::keyClicks(reason, QStringLiteral("broad line"));
  QTest::mouseClick(apply, Qt::LeftButton);
  ASSERT_TRUE(shown([&] { return reason->text().isEmpty(); }));
  const auto entries = AuditTrail(*archive).entries();
  ASSERT_TRUE(entries);
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->front().user, "Ben");
  EXPECT_EQ(entries->front().reason, "broad line");
  EXPECT_EQ(entries->front().details, "sigma 2.2 -> 4");
  ASSERT_TRUE(shown([&] { return used() == 4.0; })) << "with the next rail";
  EXPECT_FALSE(waits());
  EXPECT_TRUE(line->running());
  ASSERT_TRUE(shown(
      [&] { return named<QDoubleSpinBox>(*page, "Smoothing on trial")->value() == 4.0 && !page->trial().differs(); }));
}

TEST_F(StripesPageTest, WhatCannotBeRecordedIsNotChanged) {
  place->archive = nullptr;
  open();
  session.enter(QStringLiteral("Ben"), Role::Technician);
  named<QDoubleSpinBox>(*page, "Smoothing on trial")->setValue(4.0);
  QTest::keyClicks(named<QLineEdit>(*page, "Reason"), QStringLiteral("broad line"));
  QTest::mouseClick(named<QPushButton>(*page, "Use what is on trial"), Qt::LeftButton);
  EXPECT_TRUE(page->trial().message().contains(QStringLiteral("archive")));
  EXPECT_FALSE(line->pull(PullDetail::Everything).nextStripe);
}

TEST_F(StripesPageTest, TheRefusalOfASettingIsSaid) {
  open();
  named<QDoubleSpinBox>(*page, "Low threshold on trial")->setValue(50);  // above the high one
  EXPECT_FALSE(page->trial().message().isEmpty());
  ASSERT_TRUE(ticked(10));
  EXPECT_FALSE(picture(0)->trial);
}

TEST_F(StripesPageTest, ThePicturesBehindAProfileAreShownAlsoWhenTheyAreNoLongerHeld) {
  open();
  ASSERT_TRUE(shown([&] { return line->pull(PullDetail::Everything).latest != nullptr; }));
  const auto profile = line->pull(PullDetail::Everything).latest;
  const std::uint64_t later = profile->profile.trigger + 4 * LatestFrames::kHeld;
  ASSERT_TRUE(shown([&] { return picture(0)->trigger > later; }));
  page->showBehind(*profile);
  ASSERT_TRUE(shown([&] {
    return picture(0)->trigger == profile->profile.trigger && picture(3)->trigger == profile->profile.trigger;
  }));
  EXPECT_TRUE(page->frozen());
  EXPECT_TRUE(allThere());
  // Key B: the newest.
  QTest::keyClick(page.get(), Qt::Key_B);
  EXPECT_TRUE(shown([&] { return picture(0)->trigger > profile->profile.trigger; }));
  EXPECT_TRUE(page->frozen());
}

TEST_F(StripesPageTest, WhoLeavesLetsGoOfEveryFrame) {
  open();
  EXPECT_TRUE(line->frames()->watched());
  page->hide();
  EXPECT_FALSE(line->frames()->watched());
  EXPECT_EQ(line->frames()->latest(0), nullptr);
  page->show();
  const std::uint64_t before = picture(0)->trigger;
  EXPECT_TRUE(shown([&] { return picture(0)->trigger > before; }));
}

TEST_F(StripesPageTest, ThePixelsAreSavedAsTheyAre) {
  open();
  QTest::keyClick(page.get(), Qt::Key_P);
  ASSERT_TRUE(ticked(20));
  const QString file = folder.filePath(QStringLiteral("picture.png"));
  page->savePicture(file);
  ASSERT_TRUE(shown([&] { return page->trial().message().contains(QStringLiteral("is written")); }));
  const QImage saved(file);
  const ImageView& image = picture(0)->taken->frame.image;
  ASSERT_EQ(saved.size(), QSize(image.width, image.height));
  for (int y = 0; y < image.height; y += 37)
    for (int x = 0; x < image.width; x += 11) ASSERT_EQ(qRed(saved.pixel(x, y)), image.row(y)[x]);
  page->savePicture(folder.filePath(QStringLiteral("nowhere/picture.png")));
  EXPECT_TRUE(shown([&] { return page->trial().message().contains(QStringLiteral("cannot be written")); }));
}

TEST_F(StripesPageTest, WheelAndKeysZoomToPixelsAndBack) {
  open();
  StripeView& view = page->view(0);
  QWheelEvent wheel(view.rect().center(), view.mapToGlobal(view.rect().center()), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  EXPECT_GT(view.scale(), 1);
  QTest::keyClick(page.get(), Qt::Key_Plus);
  EXPECT_GT(view.scale(), 1.5);
  const QImage large = view.grab().toImage();
  QTest::keyClick(page.get(), Qt::Key_0);
  EXPECT_EQ(view.scale(), 1);
  EXPECT_NE(view.grab().toImage(), large);
}

// ---- made by hand ----

/// A bright horizontal line with a clipped stretch, as one camera may see it.
LatestFrames::Held drawn(int camera, std::uint64_t trigger) {
  auto pixels = std::make_shared<std::vector<std::uint8_t>>(std::size_t{640} * 480);
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) {
      const double light = (x > 300 && x < 340 ? 700 : 120) * std::exp(-0.5 * (y - 240) * (y - 240) / 9.0);
      const double noise = ((x * 7 + y * 13) % 5) - 2;
      (*pixels)[static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x)] =
          static_cast<std::uint8_t>(std::clamp(10 + noise + (x > 40 && x < 600 ? light : 0), 0.0, 255.0));
    }
  auto held = std::make_shared<ExtractedFrame>();
  held->frame = {camera, trigger, {pixels->data(), 640, 480, 640}, pixels};
  StripeExtractor(StripeSettings{}).extract(held->frame.image, held->stripe);
  return held;
}

class StripesOfAMadeLine : public ::testing::Test {
 protected:
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  std::unique_ptr<StripesPage> page;

  void SetUp() override {
    line.snapshot = makeSnapshot();
    line.pictures = std::make_shared<LatestFrames>();
    line.rig = nominalRig();
  }
  void open() {
    page = std::make_unique<StripesPage>(place);
    page->resize(1888, 880);
    page->show();
    page->showLine(line.snapshot, PullDetail::Everything);
  }
  void TearDown() override { page.reset(); }
  void offer(int camera, std::uint64_t trigger) {
    const auto held = drawn(camera, trigger);
    line.pictures->offer(held->frame, held->stripe, 0.4);
  }
  template <typename Condition>
  bool shown(Condition condition) {
    return QTest::qWaitFor(
        [&] {
          page->showLine(line.snapshot, PullDetail::Everything);
          return condition();
        },
        10000);
  }
};

TEST_F(StripesOfAMadeLine, FiguresAndSaturatedStretchAreThoseOfThePicture) {
  open();
  offer(1, 100);
  ASSERT_TRUE(shown([&] { return page->view(1).picture() != nullptr; }));
  const StripePicture& picture = *page->view(1).picture();
  EXPECT_NEAR(static_cast<double>(picture.figures.points), 558, 25);
  EXPECT_EQ(picture.figures.pieces, 1U);
  EXPECT_NEAR(picture.figures.saturatedShare, 40.0 / 558, 0.03);
  ASSERT_EQ(picture.saturated.size(), 1U);
  EXPECT_NEAR(picture.saturated.front().center().x(), 320, 8);
  EXPECT_NEAR(picture.saturated.front().center().y(), 240, 3);
  EXPECT_EQ(page->view(0).picture(), nullptr) << "the other cameras have none yet";
}

TEST_F(StripesOfAMadeLine, ALostCameraIsGreyWithItsReasonAndAge) {
  open();
  for (int c = 0; c < 4; ++c) offer(c, 5);
  ASSERT_TRUE(shown([&] { return page->view(2).picture() != nullptr; }));
  line.snapshot = makeSnapshot({.lostCamera = 2});
  page->showLine(line.snapshot, PullDetail::Everything);
  EXPECT_TRUE(page->view(2).stale());
  EXPECT_TRUE(page->view(2).accessibleDescription().contains(QStringLiteral("frame lost")));
  EXPECT_TRUE(page->view(2).accessibleDescription().contains(QStringLiteral("old")));
  EXPECT_FALSE(page->view(1).stale());
  line.snapshot = heldSnapshot(12);
  page->showLine(line.snapshot, PullDetail::Everything);
  for (int c = 0; c < 4; ++c) EXPECT_TRUE(page->view(c).stale()) << "nothing is shown as live that is not";
}

TEST_F(StripesOfAMadeLine, PicturesThatAreGoneSaySo) {
  open();
  offer(0, 900);
  ASSERT_TRUE(shown([&] { return page->view(0).picture() != nullptr; }));
  MadeProfile lost;
  lost.lostCamera = 3;
  page->showBehind(makeProfile(lost));
  ASSERT_TRUE(shown([&] { return page->view(0).picture()->taken == nullptr; }));
  EXPECT_TRUE(page->view(0).accessibleDescription().contains(QStringLiteral("no longer held")));
  EXPECT_TRUE(page->view(3).accessibleDescription().contains(QStringLiteral("frame lost")));
}

TEST_F(StripesOfAMadeLine, ALineWithoutPicturesSaysSoAndItsExposureIsNotOffered) {
  line.pictures = nullptr;
  open();
  EXPECT_FALSE(page->view(0).accessibleDescription().isEmpty());
  EXPECT_FALSE(named<QDoubleSpinBox>(*page, "Exposure on trial")->isEnabled());
}

TEST_F(StripesOfAMadeLine, EveryControlHasANameAndNothingIsClippedInAnySize) {
  open();
  session.enter(QStringLiteral("Ben"), Role::Technician);
  // In the window the page is given its size; what it needs is asked after it has made itself small.
  page->layout()->setSizeConstraint(QLayout::SetNoConstraint);
  page->setMinimumSize(1, 1);
  page->setStyleSheet(theme.styleSheet());
  for (const QSize size : {QSize(1366, 624), QSize(1600, 740), QSize(1920, 912), QSize(3840, 1992)}) {
    page->resize(size);
    ASSERT_EQ(page->size(), size) << size.width();
    page->showLine(line.snapshot, PullDetail::Everything);
    QCoreApplication::processEvents();
    EXPECT_LE(page->layout()->totalMinimumSize().height(), size.height()) << size.width();
    EXPECT_LE(page->layout()->totalMinimumSize().width(), size.width());
    for (const QWidget* w : page->findChildren<QWidget*>()) {
      if (!w->isVisible() || w->parentWidget()->inherits("QAbstractScrollArea") || w->inherits("QScrollBar") ||
          w->parentWidget()->inherits("QAbstractSpinBox"))
        continue;
      const std::string who = std::string(w->metaObject()->className()) + " \"" + w->accessibleName().toStdString() +
                              "\" at width " + std::to_string(size.width());
      EXPECT_GE(w->width(), w->minimumSizeHint().width()) << who;
      EXPECT_GE(w->height(), w->minimumSizeHint().height()) << who;
      EXPECT_TRUE(w->parentWidget()->rect().contains(w->geometry())) << who;
      const bool control = qobject_cast<const QPushButton*>(w) || qobject_cast<const QAbstractSpinBox*>(w) ||
                           (qobject_cast<const QLineEdit*>(w) && !w->parentWidget()->inherits("QAbstractSpinBox"));
      if (control) {
        EXPECT_FALSE(w->accessibleName().isEmpty()) << who;
      }
    }
  }
}

TEST(LineDifferenceOfTwoExtractions, CountsGainedLostAndShift) {
  StripeResult before, after;
  for (int x = 0; x < 100; ++x) {
    StripePoint p;
    p.x = static_cast<float>(x);
    p.y = 50;
    if (x < 80) before.points.push_back(p);
    p.y = 50.25F;
    if (x >= 10) after.points.push_back(p);
  }
  before.lines = {{0, 80, Rejection::None}};
  after.lines = {{0, 90, Rejection::None}};
  const LineDifference d = lineDifference(before, after);
  EXPECT_EQ(d.gained, 19U) << "79 + 1.48 px still has a neighbour";
  EXPECT_EQ(d.lost, 9U);
  EXPECT_NEAR(d.meanShiftPx, 0.25, 1e-6);
  EXPECT_NEAR(d.largestShiftPx, 0.25, 1e-6);
  ASSERT_TRUE(d.where);
  EXPECT_NEAR(static_cast<double>(d.where->x), 90, 2);
  const LineDifference none = lineDifference(before, before);
  EXPECT_EQ(none.gained + none.lost, 0U);
  EXPECT_FALSE(none.where);
  after.lines[0].rejection = Rejection::Weaker;
  EXPECT_EQ(lineDifference(before, after).lost, 80U) << "rejected lines do not count";
}

}  // namespace
}  // namespace vignole
