#include "report/profile_drawing.h"

#include <gtest/gtest.h>

#include "painted_rail.h"
#include "report/magnified_outline.h"

namespace vignole::test {

TEST(ProfileDrawing, ModelAloneIsDrawnWithoutAProfile) {
  const PaintedRail rail = paintedRail();
  const QImage image = drawn(rail, lightPalette(), [](ProfileDrawing& d) {
    d.profile = nullptr;
    d.registration = nullptr;
    d.measurement = nullptr;
  });
  keep(image, "model-only");
  EXPECT_GT(pixelsOf(image, lightPalette().model), 500);
  EXPECT_EQ(pixelsOf(image, lightPalette().out), 0);
}

TEST(ProfileDrawing, GoodRailUsesNoColour) {
  const PaintedRail rail = paintedRail();
  for (const Palette* palette : {&lightPalette(), &darkPalette()}) {
    const QImage image = drawn(rail, *palette, [](ProfileDrawing& d) { d.selected = Dimension::HW; });
    keep(image, palette->dark ? "good-dark" : "good-light");
    EXPECT_GT(pixelsOf(image, palette->t1), 1500);
    EXPECT_EQ(pixelsOf(image, palette->out) + pixelsOf(image, palette->invalid), 0);
  }
}

TEST(ProfileDrawing, MarksWhatIsOutAndWhatIsNear) {
  PaintedRail rail = paintedRail();
  setValue(rail, Dimension::WT, 1.032);
  setValue(rail, Dimension::RASl, 1.19);
  for (const Palette* palette : {&lightPalette(), &darkPalette()}) {
    const QImage image = drawn(rail, *palette);
    keep(image, palette->dark ? "out-dark" : "out-light");
    EXPECT_GT(pixelsOf(image, palette->out), 800);
    EXPECT_GT(pixelsOf(image, palette->nearInk), 100);
  }
}

TEST(ProfileDrawing, MissingCameraLeavesADottedStretchWithItsReason) {
  const PaintedRail rail = paintedRail(2);
  const QImage image = drawn(rail, lightPalette());
  keep(image, "camera-3-missing");
  EXPECT_GT(pixelsOf(image, lightPalette().invalid), 400);
}

TEST(ProfileDrawing, HeldIsGrey) {
  PaintedRail rail = paintedRail();
  setValue(rail, Dimension::WT, 1.032);
  const QImage image = drawn(rail, lightPalette(), [](ProfileDrawing& d) {
    d.held = true;
    d.heldNote = "last profile at 23.18 m, 2 min 14 s ago";
    d.selected = Dimension::WT;
  });
  keep(image, "held");
  EXPECT_EQ(pixelsOf(image, lightPalette().out), 0);
  EXPECT_GT(pixelsOf(image, lightPalette().t3), 1000);
}

TEST(ProfileDrawing, NotRegisteredSaysWhy) {
  PaintedRail rail = paintedRail();
  rail.result.registration.valid = false;
  rail.result.registration.reason = "only 12 points";
  const QImage image = drawn(rail, lightPalette());
  keep(image, "not-registered");
  EXPECT_GT(pixelsOf(image, lightPalette().invalid), 100);
}

TEST(ProfileDrawing, CamerasHaveTheirColours) {
  const PaintedRail rail = paintedRail();
  const QImage image = drawn(rail, lightPalette(), [](ProfileDrawing& d) { d.byCamera = true; });
  keep(image, "by-camera");
  for (const QColor& colour : lightPalette().camera) EXPECT_GT(pixelsOf(image, colour), 200);
}

TEST(ProfileDrawing, PointsBeforeRegistrationStandBesideThoseAfterIt) {
  const PaintedRail rail = paintedRail();
  const QImage image = drawn(rail, lightPalette(), [](ProfileDrawing& d) { d.beforeRegistration = true; });
  keep(image, "before-registration");
  EXPECT_GT(pixelsOf(image, lightPalette().camera[1]), 500) << "as seen";
  EXPECT_GT(pixelsOf(image, lightPalette().t1), 500) << "registered";
  // A rail that lay where the section is drawn: both fall together.
  PaintedRail still = paintedRail();
  for (ProfilePoint& p : still.result.profile.points) {
    const Point2 at = still.result.registration.worldFromSection.inverse() * Point2(p.x, p.y);
    p.x = at.x(), p.y = at.y();
  }
  still.result.registration.worldFromSection = {};
  const QImage same = drawn(still, lightPalette(), [](ProfileDrawing& d) { d.beforeRegistration = true; });
  EXPECT_LT(pixelsOf(same, lightPalette().camera[1]), pixelsOf(image, lightPalette().camera[1]) / 2);
}

TEST(ProfileDrawing, EveryViewMagnificationSizeAndChoicePaints) {
  PaintedRail rail = paintedRail();
  setValue(rail, Dimension::FTr, 0.9);
  for (const ProfileView view : {ProfileView::Whole, ProfileView::Head, ProfileView::Web, ProfileView::Foot}) {
    const QImage image = drawn(rail, lightPalette(), [&](ProfileDrawing& d) { d.view = view; });
    keep(image, "view-" + std::to_string(static_cast<int>(view)));
    EXPECT_GT(pixelsOf(image, lightPalette().t1), 500);
  }
  for (const Dimension d : kDimensions)
    keep(drawn(rail, darkPalette(), [&](ProfileDrawing& drawing) { drawing.selected = d; }),
         "selected-" + std::string(name(d)));
  for (const double magnification : {1.0, 5.0, 100.0})
    keep(drawn(rail, lightPalette(), [&](ProfileDrawing& d) { d.magnification = magnification; }),
         "x" + std::to_string(static_cast<int>(magnification)));
  for (const QSize size : {QSize(1, 1), QSize(60, 40), QSize(500, 400), QSize(1900, 1000)})
    keep(drawn(rail, lightPalette(), {}, size), "size-" + std::to_string(size.width()));
}

TEST(ProfileDrawing, SurvivesPartialAndInconsistentInput) {
  PaintedRail rail = paintedRail();
  rail.result.profile.points.resize(40);
  EXPECT_GT(pixelsOf(drawn(rail, lightPalette()), lightPalette().model), 200);
  rail.result.registration.residualMm.clear();
  rail.result.registration.primitiveOfPoint[3] = 9999;
  rail.result.measurement.dimensions[index(Dimension::WT)].anchors.clear();
  rail.result.measurement.dimensions[index(Dimension::WT)].valueMm.reset();
  EXPECT_GT(pixelsOf(drawn(rail, lightPalette(), [](ProfileDrawing& d) { d.selected = Dimension::WT; }),
                     lightPalette().model),
            200);
}

TEST(MagnifiedOutline, BinsGiveBackTheDeviationTheyWereMadeWith) {
  const PaintedRail rail = paintedRail();
  MagnifiedOutline outline(rail.recipe.section, {});
  outline.place(rail.result.profile, rail.result.registration, true);
  ASSERT_EQ(outline.points().size(), rail.result.profile.points.size());
  EXPECT_TRUE(outline.unassigned().empty());
  double worst = 0;
  for (const OutlineBin& bin : outline.bins()) {
    ASSERT_TRUE(bin.seen);
    const double expected = 0.12 * std::sin(bin.point.x() / 17.0) - 0.1 * std::cos(bin.point.y() / 23.0);
    worst = std::max(worst, std::abs(static_cast<double>(bin.deviationMm) - expected));
  }
  EXPECT_LT(worst, 0.08);  // noise of 0.02 mm in the mean of 2 points, 1400 bins
}

TEST(MagnifiedOutline, AnUnregisteredProfileIsNotPlaced) {
  PaintedRail rail = paintedRail();
  rail.result.registration.valid = false;
  MagnifiedOutline outline(rail.recipe.section, {});
  outline.place(rail.result.profile, rail.result.registration, true);
  for (const OutlineBin& bin : outline.bins()) EXPECT_FALSE(bin.seen);
}

TEST(MagnifiedOutline, ThinnestWebLiesInTheMiddleOfItsStraightPart) {
  const PaintedRail rail = paintedRail();
  const MagnifiedOutline outline(rail.recipe.section, {});
  EXPECT_NEAR(thinnestWebHeightMm(rail.recipe.section, outline.bins()), 76.3, 0.3);
}

}  // namespace vignole::test
