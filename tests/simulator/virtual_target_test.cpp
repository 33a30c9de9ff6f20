// Flat targets before a camera: dots and edges where the projection puts them, through distortion and blur.

#include "engine/simulator/virtual_target.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>

#include "engine/optics/camera_model.h"
#include "engine/simulator/rig_geometry.h"

namespace vignole {
namespace {

constexpr int kWidth = 1400, kHeight = 1024;
using Picture = std::vector<std::uint8_t>;

/// Without noise, evenly lit; black print at 0, so that light is what is white.
VirtualTargetSettings quiet(const char* words, std::size_t camera = 0) {
  VirtualTargetSettings s;
  s.target = *parseTarget(words);
  s.camera = simulator::drawRig(5).calibration.rangeFinders[camera];
  s.readNoiseDn = s.shotNoise = s.speckle = s.gradient = 0;
  s.brightDn = 240;
  s.darkDn = 10;
  return s;
}
std::shared_ptr<const VirtualTarget> make(const VirtualTargetSettings& s) {
  auto target = VirtualTarget::create(s);
  EXPECT_TRUE(target.has_value()) << (target ? "" : target.error().message());
  return target ? *target : nullptr;
}
Picture render(const VirtualTarget& target, const Extrinsics& pose, int view = 0, bool laser = false) {
  Picture picture(static_cast<std::size_t>(kWidth) * kHeight, 99);
  target.render(pose, view, laser, {picture.data(), kWidth, kHeight, kWidth});
  return picture;
}
double at(const Picture& picture, long x, long y) { return picture[static_cast<std::size_t>(y * kWidth + x)]; }

Point2 pixelOf(const Intrinsics& in, const Extrinsics& pose, const Point2& onTarget) {
  return project<double>(lens(in), pose.rotation, pose.translationMm, Point3(onTarget.x(), onTarget.y(), 0));
}

/// Centre of gravity of the picture of a dot: of its contour, as the lens draws it.
Point2 trueCentroid(const Intrinsics& in, const Extrinsics& pose, const Point2& centre, double radius) {
  constexpr int kCorners = 2000;
  double area = 0;
  Point2 moment(0, 0);
  const auto corner = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    return pixelOf(in, pose, centre + radius * Point2(std::cos(angle), std::sin(angle)));
  };
  const Point2 origin = pixelOf(in, pose, centre);
  for (int i = 0; i < kCorners; ++i) {
    const Point2 a = corner(i) - origin, b = corner(i + 1) - origin;
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross / 2;
    moment += cross / 6 * (a + b);
  }
  return origin + moment / area;
}

Point2 darkCentroid(const Picture& picture, const Point2& near, int reach, double bright) {
  double sum = 0;
  Point2 moment(0, 0);
  const long cx = std::lround(near.x()), cy = std::lround(near.y());
  for (long y = cy - reach; y <= cy + reach; ++y)
    for (long x = cx - reach; x <= cx + reach; ++x) {
      const double dark = bright - at(picture, x, y);
      sum += dark;
      moment += dark * Point2(static_cast<double>(x), static_cast<double>(y));
    }
  return moment / sum;
}

TEST(VirtualTarget, DotsHaveTheirCentreOfGravityWhereTheProjectionHasIt) {
  for (const char* words : {"circles:13x9:12:6", "acircles:7x13:7:4", "dotplate:9x7:12:6"})
    for (const std::size_t camera : {0U, 1U}) {  // one lens of each model
      const VirtualTargetSettings s = quiet(words, camera);
      const auto target = make(s);
      const Intrinsics& in = s.camera.intrinsics;
      double worst = 0, sum2 = 0;
      int n = 0;
      Point2 mean(0, 0);
      const auto views = usualViews(s.target, in, 7, 3);
      for (const Extrinsics& pose : {views[1], views[4]}) {
        const Picture picture = render(*target, pose);
        for (const Point2& point : s.target.points()) {
          const Point2 truth = trueCentroid(in, pose, point, s.target.diameterMm / 2);
          double radius = 0;
          for (const Point2& rim : {Point2(1, 0), Point2(0, 1), Point2(-1, 0), Point2(0, -1)})
            radius = std::max(radius, (pixelOf(in, pose, point + s.target.diameterMm / 2 * rim) - truth).norm());
          const int reach = static_cast<int>(std::ceil(radius)) + 4;
          if (truth.x() < reach + 1 || truth.y() < reach + 1 || truth.x() > kWidth - reach - 2 ||
              truth.y() > kHeight - reach - 2)
            continue;
          const Point2 error = darkCentroid(picture, truth, reach, s.brightDn) - truth;
          worst = std::max(worst, error.norm());
          sum2 += error.squaredNorm();
          mean += error;
          ++n;
        }
      }
      EXPECT_GT(n, 110) << words;
      EXPECT_LT(worst, 0.005) << words << " camera " << camera + 1;
      EXPECT_LT(std::sqrt(sum2 / n), 0.002) << words;
      EXPECT_LT((mean / n).norm(), 0.0005) << words << ": no bias";
      RecordProperty(std::string(words) + "_" + std::to_string(camera) + "_worst_px", std::to_string(worst));
    }
}

TEST(VirtualTarget, EdgesOfAChessboardLieOnTheirLines) {
  for (const std::size_t camera : {0U, 1U}) {
    const VirtualTargetSettings s = quiet("chessboard:11x7:14", camera);
    const auto target = make(s);
    const Intrinsics& in = s.camera.intrinsics;
    double sum = 0, sum2 = 0;
    int n = 0;
    for (const Extrinsics& pose : usualViews(s.target, in, 3, 8)) {
      const Picture picture = render(*target, pose);
      for (int column = 0; column < s.target.columns; ++column)
        for (int row = 0; row + 1 < s.target.rows; ++row) {
          // The middle of a side between two squares, and where the row (or column) of pixels nearest to it crosses it.
          const Point2 a(column * 14.0, row * 14.0), b(column * 14.0, (row + 1) * 14.0), middle = (a + b) / 2;
          const Point2 p = pixelOf(in, pose, middle), along = pixelOf(in, pose, middle + Point2(0, 0.3)) - p;
          if (p.x() < 20 || p.y() < 20 || p.x() > kWidth - 20 || p.y() > kHeight - 20) continue;
          const bool alongRow = std::abs(along.y()) > std::abs(along.x());
          const double fixed = std::round(alongRow ? p.y() : p.x());
          const double expected = alongRow ? p.x() + along.x() / along.y() * (fixed - p.y())
                                           : p.y() + along.y() / along.x() * (fixed - p.x());
          // The edge by the light on both sides of it: as much is missing here as there is too much there.
          constexpr int kReach = 12;
          const long start = std::lround(expected) - kReach, end = start + 2 * kReach;
          const auto light = [&](long k) {
            return alongRow ? at(picture, k, std::lround(fixed)) : at(picture, std::lround(fixed), k);
          };
          const double before = light(start), after = light(end);
          double filled = 0;
          for (long k = start; k <= end; ++k) filled += (light(k) - after) / (before - after);
          const double edge = static_cast<double>(start) - 0.5 + filled;
          sum += edge - expected;
          sum2 += (edge - expected) * (edge - expected);
          ++n;
        }
    }
    EXPECT_GT(n, 170);
    EXPECT_NEAR(sum / n, 0, 0.0015);
    EXPECT_LT(std::sqrt(sum2 / n), 0.008);
  }
}

TEST(VirtualTarget, PointsErrAsAskedAndArePrintedWhereTheyErr) {
  VirtualTargetSettings s = quiet("circles:9x7:16:8");
  s.targetErrorMm = 0.1;
  const auto target = make(s);
  const Intrinsics& in = s.camera.intrinsics;
  const Extrinsics pose = usualViews(s.target, in, 1, 1)[0];
  const Picture picture = render(*target, pose);
  const auto pixels = target->truePixels(pose);
  double most = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Point2 ideal = pixelOf(in, pose, s.target.points()[i]);
    most = std::max(most, (pixels[i] - ideal).norm());
    // Seen almost frontally, the centre of gravity is the centre's picture to 0.02 px.
    EXPECT_LT((darkCentroid(picture, pixels[i], 26, s.brightDn) - pixels[i]).norm(), 0.05);
  }
  EXPECT_GT(most, 0.3);  // 0.1 mm are 0.5 px
  EXPECT_LT(most, 0.9);
}

TEST(VirtualTarget, AMirroredTargetIsPrintedTheOtherWayRound) {
  VirtualTargetSettings s = quiet("dotplate:7x5:14:7");
  const Extrinsics pose = usualViews(s.target, s.camera.intrinsics, 1, 1)[0];
  const auto usual = make(s);
  s.mirrored = true;
  const auto mirrored = make(s);
  EXPECT_LT((usual->truePixels(pose)[0] - mirrored->truePixels(pose)[6]).norm(), 1e-9);
  // The filled corner is beside point 0 in both.
  for (const auto& target : {usual, mirrored}) {
    const Picture picture = render(*target, pose);
    const auto pixels = target->truePixels(pose);
    const auto beyond = [&](std::size_t corner, std::size_t inner) {
      const Point2 p = pixels[corner] + 0.58 * (pixels[corner] - pixels[inner]);
      return at(picture, std::lround(p.x()), std::lround(p.y()));
    };
    EXPECT_LT(beyond(0, 8), 40);
    EXPECT_GT(beyond(6, 12), 200);
    EXPECT_GT(beyond(28, 22), 200);
    EXPECT_GT(beyond(34, 26), 200);
  }
}

TEST(VirtualTarget, LightPrintOnDarkIsTheNegative) {
  VirtualTargetSettings s = quiet("circles:7x5:16:8");
  const Extrinsics pose = usualViews(s.target, s.camera.intrinsics, 1, 1)[0];
  const Point2 dot = make(s)->truePixels(pose)[10];
  s.target.lightDots = true;
  const Picture light = render(*make(s), pose);
  EXPECT_EQ(at(light, std::lround(dot.x()), std::lround(dot.y())), 240);
  EXPECT_EQ(at(light, std::lround(dot.x()) + 40, std::lround(dot.y())), 10);
}

/// Standard deviation of the blur of the board's left border, px, by the light's slope across it.
double borderBlur(const Picture& picture, const Point2& place, double bright) {
  const long y = std::lround(place.y()), x0 = std::lround(place.x());
  double sum = 0, moment = 0, square = 0;
  for (long x = x0 - 20; x < x0 + 20; ++x) {
    const double slope = (at(picture, x + 1, y) - at(picture, x, y)) / bright;
    sum += slope;
    moment += slope * static_cast<double>(x - x0);
    square += slope * static_cast<double>((x - x0) * (x - x0));
  }
  return std::sqrt(square / sum - moment / sum * (moment / sum));
}

TEST(VirtualTarget, BlurIsThatOfTheThinLens) {
  const VirtualTargetSettings s = quiet("circles:5x5:12:6");
  const auto target = make(s);
  const Intrinsics& in = s.camera.intrinsics;
  for (const double distance : {300.0, 400.0, 500.0}) {
    Extrinsics pose;
    pose.translationMm = {-24, -24, distance};
    const Picture picture = render(*target, pose);
    const Point2 border = pixelOf(in, pose, {-12, 30});
    const double disk = 16.15 / 8 * 16.15 / (400 - 16.15) * std::abs(distance - 400) / distance / 0.0074;
    const double diffraction = 0.45 * 550e-6 * 8 / 0.0074;
    // The border divides one pixel: of light that steps by that share and then by the rest.
    const double share = border.x() + 0.5 - std::floor(border.x() + 0.5);
    EXPECT_NEAR(borderBlur(picture, border, s.brightDn),
                std::sqrt(disk * disk / 16 + diffraction * diffraction + share * (1 - share)), 0.03)
        << distance;
  }
}

TEST(VirtualTarget, TheLaserLineIsWhereItsPlaneMeetsTheTarget) {
  VirtualTargetSettings s = quiet("circles:2x2:50:2", 2);  // almost all white
  const auto target = make(s);
  const Intrinsics& in = s.camera.intrinsics;
  const Extrinsics& world = s.camera.cameraFromWorld;
  const Point3 normal = world.rotation * s.camera.lightPlane.normal;
  const double offset = s.camera.lightPlane.distanceMm + normal.dot(world.translationMm);
  int lines = 0;
  double sum = 0, sum2 = 0;
  int n = 0;
  for (const Extrinsics& pose : usualViews(s.target, in, 5, 4, &s.camera)) {
    const Picture lit = render(*target, pose, 0, true);
    // The line on the target: normal . (R p + t) = offset.
    const Point3 inTarget = pose.rotation.transpose() * normal;
    const double rest = offset - normal.dot(pose.translationMm);
    const Point2 across(inTarget.x(), inTarget.y());
    const Point2 foot = across * (rest / across.squaredNorm());
    const Point2 along = Point2(-across.y(), across.x()).normalized();
    bool any = false;
    for (double t = -200; t < 200; t += 3) {
      const Point2 place = foot + t * along;
      if (place.x() < -35 || place.y() < -35 || place.x() > 85 || place.y() > 85) continue;
      const auto points = s.target.points();
      if (std::any_of(points.begin(), points.end(), [&](const Point2& dot) { return (place - dot).norm() < 12; }))
        continue;
      const Point2 p = pixelOf(in, pose, place), step = pixelOf(in, pose, place + 0.2 * along) - p;
      if (p.x() < 25 || p.y() < 25 || p.x() > kWidth - 25 || p.y() > kHeight - 25) continue;
      const bool alongRow = std::abs(step.y()) > std::abs(step.x());
      const double fixed = std::round(alongRow ? p.y() : p.x());
      const double expected =
          alongRow ? p.x() + step.x() / step.y() * (fixed - p.y()) : p.y() + step.y() / step.x() * (fixed - p.x());
      double light = 0, moment = 0;
      for (long k = std::lround(expected) - 20; k <= std::lround(expected) + 20; ++k) {
        const double dn = (alongRow ? at(lit, k, std::lround(fixed)) : at(lit, std::lround(fixed), k)) - 0.12 * 240;
        if (dn < 1) continue;
        light += dn;
        moment += dn * static_cast<double>(k);
      }
      ASSERT_GT(light, 100);
      any = true;
      sum += moment / light - expected;
      sum2 += std::pow(moment / light - expected, 2);
      ++n;
    }
    lines += any ? 1 : 0;
  }
  EXPECT_EQ(lines, 5);
  EXPECT_GT(n, 100);
  EXPECT_NEAR(sum / n, 0, 0.01);
  EXPECT_LT(std::sqrt(sum2 / n), 0.03);
}

TEST(VirtualTarget, NoiseIsAsSetAndTheSameFromAnyThread) {
  VirtualTargetSettings s = quiet("circles:2x2:90:2");
  s.readNoiseDn = 3;
  s.shotNoise = 1;
  s.brightDn = 180;
  const auto target = make(s), again = make(s);
  const Extrinsics pose = usualViews(s.target, s.camera.intrinsics, 1, 1)[0];
  std::vector<Picture> got(4);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 2; ++t)
      threads.emplace_back([&, t] {
        for (int i = 3 - t; i >= 0; i -= 2) got[static_cast<std::size_t>(i)] = render(*again, pose, i / 2, i % 2 == 1);
      });
  }
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(got[static_cast<std::size_t>(i)] == render(*target, pose, i / 2, i % 2 == 1)) << i;
  EXPECT_FALSE(got[0] == got[2]) << "another view has another noise";
  const Point2 middle = pixelOf(s.camera.intrinsics, pose, {45, 45});
  double sum = 0, square = 0;
  int n = 0;
  for (long y = std::lround(middle.y()) - 60; y < std::lround(middle.y()) + 60; ++y)
    for (long x = std::lround(middle.x()) - 60; x < std::lround(middle.x()) + 60; ++x) {
      sum += at(got[0], x, y), square += at(got[0], x, y) * at(got[0], x, y), ++n;
    }
  const double sd = std::sqrt(square / n - sum / n * (sum / n));
  EXPECT_NEAR(sum / n, 180, 0.2);
  EXPECT_NEAR(sd, std::sqrt(9 + 180 * 60.0 / 10000 + 1.0 / 12), 0.07);
}

TEST(UsualViews, ShowTheTargetOverThePictureFromAllSides) {
  for (const char* words : {kUsualTarget, "chessboard:9x6:15", "acircles:4x11:12:8", "circles:9x7:25:12"}) {
    const PlanarTarget target = *parseTarget(words);
    const Intrinsics in = simulator::drawRig(2).calibration.rangeFinders[1].intrinsics;
    const auto views = usualViews(target, in, 16, 9);
    ASSERT_EQ(views.size(), 16U);
    int partly = 0;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9, steepest = 0;
    Eigen::Vector2d tilts(0, 0);
    for (const Extrinsics& pose : views) {
      EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-9);
      bool all = true;
      for (const Point2& point : target.points()) {
        const Point2 p = pixelOf(in, pose, point);
        all = all && p.x() > 0 && p.y() > 0 && p.x() < kWidth - 1 && p.y() < kHeight - 1;
        left = std::min(left, p.x()), right = std::max(right, p.x());
        top = std::min(top, p.y()), bottom = std::max(bottom, p.y());
      }
      partly += all ? 0 : 1;
      steepest = std::max(steepest, std::acos(pose.rotation(2, 2)));
      tilts += pose.rotation.col(2).head<2>();
    }
    EXPECT_LE(partly, 2) << words;
    EXPECT_LT(left, 100) << words;
    EXPECT_GT(right, kWidth - 100) << words;
    EXPECT_LT(top, 100) << words;
    EXPECT_GT(bottom, kHeight - 100) << words;
    EXPECT_LT(steepest, 35.1 * std::numbers::pi / 180);
    EXPECT_GT(steepest, 28 * std::numbers::pi / 180);
    EXPECT_LT((tilts / 16).norm(), 0.12) << "tilted to all sides";
    EXPECT_EQ(usualViews(target, in, 16, 9)[5].translationMm, views[5].translationMm);
  }
}

TEST(VirtualTarget, WhatMakesNoSenseIsRefusedInOneLine) {
  const std::vector<std::function<void(VirtualTargetSettings&)>> bad = {
      [](auto& s) { s.target = {}; },    [](auto& s) { s.targetErrorMm = 5; }, [](auto& s) { s.readNoiseDn = -1; },
      [](auto& s) { s.defocus = 99; },   [](auto& s) { s.darkDn = 300; },      [](auto& s) { s.speckle = 2; },
      [](auto& s) { s.shotNoise = 1e9; }};
  for (const auto& spoil : bad) {
    VirtualTargetSettings s = quiet(kUsualTarget);
    spoil(s);
    const auto target = VirtualTarget::create(s);
    ASSERT_FALSE(target.has_value());
    EXPECT_EQ(target.error().message().find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace vignole
