// Stripes on the virtual line: pictures arrive, what is tried is compared on the same picture and applied by who may.

#include "gui/stripes/stripes_page.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/bridge/virtual_line.h"
#include "gui/stripes/stripe_view.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

class StripesPageTest : public ::testing::Test {
 protected:
  std::unique_ptr<VirtualLine> line;
  Theme theme;
  Session session;
  Units units;
  std::unique_ptr<Workplace> place;
  std::unique_ptr<StripesPage> page;

  void SetUp() override {
    VirtualLineSettings settings;
    settings.recipe = *findRecipe("60E1");
    settings.rig.section = settings.recipe.section;
    settings.rig.parameters = settings.recipe.parameters;
    auto made = VirtualLine::create(settings);
    ASSERT_TRUE(made);
    line = *std::move(made);
    place = std::make_unique<Workplace>(Workplace{theme, *line, session, units});
    page = std::make_unique<StripesPage>(*place);
    page->resize(1888, 880);
    page->show();
    line->start();
    ASSERT_TRUE(shown([&] { return allThere(); }));
  }
  void TearDown() override {
    page.reset();
    line.reset();
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
      if (!page->view(c).picture()) return false;
    return true;
  }
  template <typename W>
  W* named(const char* accessibleName) {
    for (W* w : page->findChildren<W*>())
      if (w->accessibleName().startsWith(QLatin1String(accessibleName))) return w;
    ADD_FAILURE() << accessibleName;
    return nullptr;
  }
};

TEST_F(StripesPageTest, FourPicturesWithTheirLinesGoOn) {
  for (int c = 0; c < kCameraCount; ++c) {
    EXPECT_GT(page->view(c).picture()->inUse.stripe.points.size(), 500U) << c;
    EXPECT_EQ(page->view(c).picture()->camera, c);
  }
  const std::uint64_t before = page->view(0).picture()->trigger;
  EXPECT_TRUE(shown([&] { return page->view(0).picture()->trigger > before; }));
  QTest::keyClick(page.get(), Qt::Key_P);
  EXPECT_TRUE(page->frozen());
  // What was under way may still come; then the picture stays.
  ASSERT_TRUE(shown([&, n = 0]() mutable { return ++n > 20; }));
  const std::uint64_t still = page->view(0).picture()->trigger;
  ASSERT_TRUE(shown([&, n = 0]() mutable { return ++n > 40; }));
  EXPECT_EQ(page->view(0).picture()->trigger, still);
}

TEST_F(StripesPageTest, WhatIsTriedIsComparedOnTheFrozenPictureAndAppliedByATechnicianWithAReason) {
  named<QDoubleSpinBox>("Smoothing")->setValue(4.0);
  EXPECT_TRUE(page->frozen()) << "old and new are seen on the same picture";
  ASSERT_TRUE(shown([&] { return page->view(0).picture()->trial.has_value(); }));
  const StripePicture& picture = *page->view(0).picture();
  EXPECT_NE(picture.trial->stripe.points.front().sigmaPx, picture.inUse.stripe.points.front().sigmaPx);
  EXPECT_EQ(page->onTrial().sigma, 4.0);

  auto* apply = named<QPushButton>("Use what is on trial");
  EXPECT_FALSE(apply->isEnabled()) << "an operator tries, a technician applies";
  session.enter(QStringLiteral("Ben"), Role::Technician);
  ASSERT_TRUE(apply->isEnabled());
  const auto used = [&] { return line->pull(PullDetail::Everything).recipe->stripe.sigma; };
  const auto restart = [&] {
    line->stop();
    ASSERT_TRUE(shown([&] { return !line->running(); }));
    line->start();
  };
  QTest::mouseClick(apply, Qt::LeftButton);
  restart();
  EXPECT_NE(used(), 4.0) << "not without a reason";
  named<QDoubleSpinBox>("Smoothing")->setValue(4.0);
  named<QLineEdit>("Reason")->setText(QStringLiteral("broad line"));
  QTest::mouseClick(apply, Qt::LeftButton);
  EXPECT_NE(used(), 4.0) << "the running rail keeps what it began with";
  restart();
  EXPECT_EQ(used(), 4.0);
}

TEST(StripesOfALineWithoutPictures, SaySo) {
  test::FakeLine line;
  line.snapshot = test::makeSnapshot();
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, line, session, units};
  StripesPage page(place);
  page.show();
  page.showLine(line.snapshot, PullDetail::Everything);
  EXPECT_FALSE(page.view(0).accessibleDescription().isEmpty());
}

}  // namespace
}  // namespace vignole
