// The pin plate before the rig: arcs where the geometry says, shadows, noise as asked for, the same bytes from any
// thread.

#include "engine/simulator/virtual_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>

#include "engine/optics/nominal_rig.h"
#include "engine/optics/plane_map.h"
#include "engine/simulator/line_bound.h"
#include "engine/simulator/rig_geometry.h"

namespace vignole {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kWidth = 1400, kHeight = 1024;
using Picture = std::vector<std::uint8_t>;

VirtualPlateSettings usual(int placements = 1) {
  VirtualPlateSettings s;
  s.plate = plate13();
  s.placements = usualPlacements(placements, 1);
  return s;
}
VirtualPlateSettings quiet(int placements = 1) {
  VirtualPlateSettings s = usual(placements);
  EXPECT_TRUE(applyEffect(s.effects, "all=off"));
  return s;
}
std::shared_ptr<const VirtualPlate> make(const VirtualPlateSettings& s) {
  auto plate = VirtualPlate::create(s);
  EXPECT_TRUE(plate.has_value()) << (plate ? "" : plate.error().message());
  return plate ? *plate : nullptr;
}
Picture render(const VirtualPlate& plate, int camera, int placement) {
  Picture picture(static_cast<std::size_t>(kWidth) * kHeight, 99);
  plate.render(camera, placement, {picture.data(), kWidth, kHeight, kWidth});
  return picture;
}
Point2 inWorld(const VirtualPlate& plate, int camera, const Point2& px) {
  const PlanePoint p = PlaneMap(plate.calibration().rangeFinders[static_cast<std::size_t>(camera)])(px.x(), px.y());
  return {p.x, p.y};
}

TEST(VirtualPlate, SameBytesFromAnyThreadInAnyOrder) {
  VirtualPlateSettings s = usual(2);
  s.plateErrorMm = 0.05;
  s.spurious = 2;
  const auto plate = make(s), again = make(s);
  std::vector<Picture> expected, got(8);
  for (int i = 0; i < 8; ++i) expected.push_back(render(*plate, i % 4, i / 4));
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 2; ++t)
      threads.emplace_back([&, t] {
        for (int i = 7 - t; i >= 0; i -= 2) got[static_cast<std::size_t>(i)] = render(*again, i % 4, i / 4);
      });
  }
  for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(got[i] == expected[i]) << i;
  s.seed = 2;
  s.rigSeed = 1;
  EXPECT_FALSE(render(*make(s), 0, 0) == expected[0]);
}

TEST(VirtualPlate, StandsBeforeTheRigOfItsSeed) {
  VirtualPlateSettings s = usual();
  s.rigSeed = 7;
  EXPECT_EQ(toToml(make(s)->calibration()), toToml(simulator::drawRig(7).calibration));
  EXPECT_EQ(toToml(VirtualPlate::nominalRig()), toToml(nominalRig()));
}

TEST(VirtualPlate, ArcsLieOnTheTruePinsInEveryPlacement) {
  VirtualPlateSettings s = usual(5);
  s.plateErrorMm = 0.05;
  s.radiusErrorMm = 0.01;
  s.leanMrad = 0.3;
  const auto plate = make(s);
  for (int placement = 0; placement < 5; ++placement)
    for (int camera = 0; camera < kCameraCount; ++camera)
      for (const Pin& pin : plate->truePlate().pins) {
        const Point2 centre = s.placements[static_cast<std::size_t>(placement)].worldFromPlate * pin.centreMm;
        for (const Point2& px : plate->visibleArc(camera, placement, pin.number))
          // A lean of 1 mrad makes the cut an ellipse by less than a millionth.
          EXPECT_NEAR((inWorld(*plate, camera, px) - centre).norm(), pin.radiusMm, 1e-5);
      }
}

TEST(VirtualPlate, ATiltedPlateStretchesItsPinsAndTheirDistances) {
  VirtualPlateSettings s = usual();
  const double tilt = 5 * kDegree;
  s.placements.front().tiltYRad = tilt;
  const auto plate = make(s);
  Point2 middle(0, 0);
  for (const Pin& pin : s.plate.pins) middle += pin.centreMm / 13;
  int seen = 0;
  for (const Pin& pin : s.plate.pins) {
    // Turned about y, the axis leans along x: what the plane cuts is 1 / cos as wide, and the centres lie as far apart.
    const Point2 centre =
        middle + Point2((pin.centreMm.x() - middle.x()) / std::cos(tilt), pin.centreMm.y() - middle.y());
    for (const Point2& px : plate->visibleArc(1, 0, pin.number)) {
      const Point2 d = inWorld(*plate, 1, px) - centre;
      EXPECT_NEAR(std::hypot(d.x() * std::cos(tilt), d.y()), pin.radiusMm, 1e-6);
      ++seen;
    }
  }
  EXPECT_GT(seen, 300);
}

TEST(VirtualPlate, EveryCameraSeesAllPinsByTheArcsOfTheDesign) {
  std::vector<double> degrees;
  for (const std::uint64_t rigSeed : {1U, 2U, 3U}) {
    VirtualPlateSettings s = usual();
    s.rigSeed = rigSeed;
    const auto plate = make(s);
    for (int camera = 0; camera < kCameraCount; ++camera)
      for (const Pin& pin : plate->truePlate().pins) {
        const auto arc = plate->visibleArc(camera, 0, pin.number);
        ASSERT_GE(arc.size(), 2U) << "camera " << camera + 1 << " pin " << pin.number;
        const Point2 a = inWorld(*plate, camera, arc.front()) - pin.centreMm;
        const Point2 b = inWorld(*plate, camera, arc.back()) - pin.centreMm;
        // A rig off its drawing may have a pin on the border of its picture.
        if (std::any_of(arc.begin(), arc.end(), [](const Point2& p) { return std::min(p.x(), kWidth - p.x()) < 2; }))
          continue;
        degrees.push_back(std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))) / kDegree);
        EXPECT_LT(degrees.back(), 161) << "80 degrees to each side at most";
      }
  }
  std::sort(degrees.begin(), degrees.end());
  EXPECT_GT(degrees.size(), 145U);
  // Optics design, section 1.10: 58-152 degrees. Pin 9 stands in the shadows of pins 2 and 4 for camera 4 and keeps 30.
  EXPECT_GT(degrees.front(), 25);
  EXPECT_GT(degrees[degrees.size() / 20], 58);
  EXPECT_NEAR(degrees[degrees.size() / 2], 146, 6);
}

TEST(VirtualPlate, LightLiesOnTheVisibleArcsAndNowhereElse) {
  VirtualPlateSettings s = quiet(2);
  s.effects.defocus = 1;
  const auto plate = make(s);
  for (int camera = 0; camera < kCameraCount; ++camera) {
    const Picture picture = render(*plate, camera, 1);
    std::vector<char> near(picture.size(), 0);
    for (const Pin& pin : s.plate.pins)
      for (const Point2& px : plate->visibleArc(camera, 1, pin.number)) {
        for (int dy = -9; dy <= 9; ++dy)
          for (int dx = -9; dx <= 9; ++dx) {
            const long x = std::lround(px.x()) + dx, y = std::lround(px.y()) + dy;
            if (x >= 0 && y >= 0 && x < kWidth && y < kHeight) near[static_cast<std::size_t>(y * kWidth + x)] = 1;
          }
      }
    int lit = 0, astray = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
      lit += picture[i] > 20 ? 1 : 0;
      astray += picture[i] > 20 && near[i] == 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 1000) << camera;
    EXPECT_EQ(astray, 0) << camera;
    // And the middle of every arc that is seen by more than a glance shines.
    for (const Pin& pin : s.plate.pins) {
      const auto arc = plate->visibleArc(camera, 1, pin.number);
      if (arc.size() < 15) continue;
      const Point2 middle = arc[arc.size() / 2];
      const auto at = static_cast<std::size_t>(std::lround(middle.y()) * kWidth + std::lround(middle.x()));
      EXPECT_GT(picture[at], 40) << camera << " pin " << pin.number;
    }
  }
}

TEST(VirtualPlate, APinStandsInTheShadowOfAnother) {
  VirtualPlateSettings s = quiet();
  const Point2 laser = simulator::drawRig(s.rigSeed.value_or(s.seed)).lasers[1].positionMm;
  const Point2 rear(0, 86), towards = (laser - rear).normalized(), aside(-towards.y(), towards.x());
  s.plate.pins = {{1, rear, 8, 0, 0}, {2, rear + 40 * towards, 3, 0, 0}, {3, {60, 0}, 5, 0, 0}, {4, {-60, 0}, 5, 0, 0}};
  const auto shadowed = make(s);
  s.missingPins = {2};
  const auto alone = make(s);
  const auto dark = [&](const Point2& px) {
    const Point2 d = inWorld(*alone, 1, px) - rear;
    return std::abs(d.dot(aside)) < 3 - 0.3;  // the shadow narrows by less than that over its way
  };
  const auto whole = alone->visibleArc(1, 0, 1), rest = shadowed->visibleArc(1, 0, 1);
  EXPECT_GT(std::count_if(whole.begin(), whole.end(), dark), 10);
  EXPECT_EQ(std::count_if(rest.begin(), rest.end(), dark), 0);
  EXPECT_NEAR(
      static_cast<double>(rest.size()),
      static_cast<double>(whole.size() - static_cast<std::size_t>(std::count_if(whole.begin(), whole.end(), dark))), 6);
  const Point2 middle = whole[whole.size() / 2];
  const auto at = static_cast<std::size_t>(std::lround(middle.y()) * kWidth + std::lround(middle.x()));
  EXPECT_GT(render(*alone, 1, 0)[at], 40);
  EXPECT_LT(render(*shadowed, 1, 0)[at], 3);
  EXPECT_TRUE(alone->visibleArc(1, 0, 2).empty()) << "it is not there";
}

TEST(VirtualPlate, ErrorsAreUniformWithinTheirBounds) {
  VirtualPlateSettings s = usual();
  s.plateErrorMm = 0.05;
  s.radiusErrorMm = 0.01;
  double centre2 = 0, radius2 = 0, most = 0, mostRadius = 0;
  int n = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    s.seed = seed;
    s.rigSeed = 1;
    const auto plate = make(s);
    for (std::size_t i = 0; i < 13; ++i) {
      const Point2 d = plate->truePlate().pins[i].centreMm - s.plate.pins[i].centreMm;
      const double r = plate->truePlate().pins[i].radiusMm - s.plate.pins[i].radiusMm;
      centre2 += d.squaredNorm() / 2;
      radius2 += r * r;
      most = std::max(most, d.cwiseAbs().maxCoeff());
      mostRadius = std::max(mostRadius, std::abs(r));
      ++n;
    }
  }
  EXPECT_LE(most, 0.05);
  EXPECT_GT(most, 0.045);
  EXPECT_LE(mostRadius, 0.01);
  // Of 520 coordinates and 260 radii: the standard deviation is known to 2 % and 3 %.
  EXPECT_NEAR(std::sqrt(centre2 / n), 0.05 / std::sqrt(3), 0.0025);
  EXPECT_NEAR(std::sqrt(radius2 / n), 0.01 / std::sqrt(3), 0.0007);
}

TEST(VirtualPlate, NoiseIsScaledToTheBoundThatIsAskedFor) {
  for (const double boundPx : {0.05, 0.1, 0.2}) {
    VirtualPlateSettings s = usual();
    s.noisePx = boundPx;
    s.exposureMs = 7;  // the factor is that of the usual exposure, whatever the picture's
    const double factor = make(s)->noiseFactor();
    // The bound by hand, off pictures without noise.
    VirtualPlateSettings clean = usual();
    for (const char* off : {"read-noise=off", "shot-noise=off", "speckle=off"})
      EXPECT_TRUE(applyEffect(clean.effects, off));
    const auto twin = make(clean);
    Effects scaled;
    scaled.readNoiseDn *= factor;
    scaled.shotNoise *= factor * factor;
    scaled.speckle *= factor;
    std::vector<double> bounds;
    for (int camera = 0; camera < kCameraCount; ++camera) {
      const Picture picture = render(*twin, camera, 0);
      for (const Pin& pin : s.plate.pins)
        for (const auto& place : simulator::readPlaces(twin->visibleArc(camera, 0, pin.number),
                                                       {picture.data(), kWidth, kHeight, kWidth}, 12))
          bounds.push_back(1 / std::sqrt(simulator::informationPerPx(place.light, simulator::pictureNoise(scaled))));
    }
    EXPECT_GT(bounds.size(), 1500U);
    std::nth_element(bounds.begin(), bounds.begin() + static_cast<std::ptrdiff_t>(bounds.size() / 2), bounds.end());
    EXPECT_NEAR(bounds[bounds.size() / 2], boundPx, 0.005 * boundPx);
    // And the pictures have that noise: on the ground, where nothing shines.
    s.exposureMs = 15;
    const Picture picture = render(*make(s), 0, 0);
    double sum = 0, square = 0;
    constexpr int kGround = 60 * kWidth;
    for (int i = 0; i < kGround; ++i) {
      const double v = picture[static_cast<std::size_t>(i)];
      sum += v, square += v * v;
    }
    const double sd = std::sqrt(square / kGround - sum / kGround * (sum / kGround));
    EXPECT_NEAR(sd, std::sqrt(simulator::pictureNoise(scaled).groundDn2), 0.03 * sd);
  }
}

TEST(VirtualPlate, ExposureScalesTheLightUntilItSaturates) {
  VirtualPlateSettings s = quiet();
  s.effects.ambientDn = 12;
  const auto at = [&](double ms) {
    s.exposureMs = ms;
    return render(*make(s), 0, 0);
  };
  const Picture usualOne = at(15), third = at(5), longest = at(150);
  EXPECT_EQ(usualOne[0], 12);
  EXPECT_EQ(third[0], 4);
  EXPECT_EQ(longest[0], 120);
  int compared = 0, saturated = 0;
  for (std::size_t i = 0; i < usualOne.size(); ++i) {
    if (usualOne[i] > 60 && usualOne[i] < 255) {
      EXPECT_NEAR(third[i], usualOne[i] / 3.0, 0.7);
      ++compared;
    }
    saturated += longest[i] == 255 ? 1 : 0;
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(saturated, 1000);
}

TEST(VirtualPlate, SpuriousArcsShineClearOfThePins) {
  VirtualPlateSettings s = quiet(2);
  const Picture without = render(*make(s), 2, 0);
  s.spurious = 3;
  const auto plate = make(s);
  const Picture with = render(*plate, 2, 0), elsewhere = render(*plate, 2, 1), other = render(*plate, 1, 0);
  int more = 0, less = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    more += with[i] > without[i] + 30 ? 1 : 0;
    less += with[i] < without[i] ? 1 : 0;
  }
  EXPECT_GT(more, 60);
  EXPECT_EQ(less, 0);
  for (const Pin& pin : s.plate.pins)
    for (const Point2& px : plate->visibleArc(2, 0, pin.number)) {
      const auto at = static_cast<std::size_t>(std::lround(px.y()) * kWidth + std::lround(px.x()));
      EXPECT_NEAR(with[at], without[at], 1);
    }
  EXPECT_FALSE(with == elsewhere);
  EXPECT_FALSE(with == other);
}

TEST(VirtualPlate, FaultsStrikeTheirCameraInTheirPlacements) {
  VirtualPlateSettings s = usual(3);
  const auto healthy = make(s);
  for (const char* text : {"black@2:2-2", "saturated@2:2-2", "move=2@2:2-2", "turn=1@2:2-2"}) {
    s.faults = {*parseFault(text)};
    const auto sick = make(s);
    EXPECT_FALSE(render(*sick, 1, 1) == render(*healthy, 1, 1)) << text;
    EXPECT_TRUE(render(*sick, 1, 0) == render(*healthy, 1, 0)) << text;
    EXPECT_TRUE(render(*sick, 1, 2) == render(*healthy, 1, 2)) << text;
    EXPECT_TRUE(render(*sick, 0, 1) == render(*healthy, 0, 1)) << text;
  }
  s.faults = {*parseFault("move=1@2")};
  const auto moved = make(s);
  // 1 mm at about 400 mm with f 16 and 7.4 um: 5.4 px.
  EXPECT_NEAR((moved->visibleArc(1, 0, 1).front() - healthy->visibleArc(1, 0, 1).front()).norm(), 5.4, 1);
  EXPECT_TRUE(make([&] {
                VirtualPlateSettings black = usual();
                black.faults = {*parseFault("black")};
                return black;
              }())
                  ->visibleArc(0, 0, 1)
                  .empty());
}

TEST(VirtualPlate, UsualPlacementsAreThoseOfTheDesign) {
  const auto placements = usualPlacements(6, 3);
  ASSERT_EQ(placements.size(), 6U);
  EXPECT_EQ(placements[0].worldFromPlate.angleRad, 0);
  EXPECT_EQ(placements[0].worldFromPlate.xMm, 0);
  const std::array<double, 4> degrees = {0, 180, 4, 176};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(placements[i].worldFromPlate.angleRad / kDegree, degrees[i], 0.31) << i;
  for (const PlatePlacement& p : placements)
    EXPECT_LT((p.worldFromPlate * Point2(0, 86) - Point2(0, 86)).norm(), 9) << "turned about the field's middle";
  const PlatePlacement further = turned(placements[2], 3 * kDegree);
  EXPECT_NEAR(further.worldFromPlate.angleRad - placements[2].worldFromPlate.angleRad, 3 * kDegree, 1e-12);
  // The first four are the same however many follow.
  EXPECT_EQ(usualPlacements(4, 3)[3].worldFromPlate.xMm, placements[3].worldFromPlate.xMm);
}

TEST(VirtualPlate, WhatMakesNoSenseIsRefusedInOneLine) {
  const auto refused = [](const std::function<void(VirtualPlateSettings&)>& spoil, const std::string& why) {
    VirtualPlateSettings s = usual();
    spoil(s);
    const auto plate = VirtualPlate::create(s);
    ASSERT_FALSE(plate.has_value()) << why;
    EXPECT_NE(plate.error().message().find(why), std::string::npos) << plate.error().message();
    EXPECT_EQ(plate.error().message().find('\n'), std::string::npos);
  };
  refused([](auto& s) { s.placements.clear(); }, "placements");
  refused([](auto& s) { s.plate.pins.clear(); }, "pins");
  refused([](auto& s) { s.plateErrorMm = -1; }, "plate-error-um");
  refused([](auto& s) { s.exposureMs = 0; }, "exposure");
  refused([](auto& s) { s.missingPins = {99}; }, "missing pin 99");
  refused([](auto& s) { s.spurious = -1; }, "spurious");
  refused([](auto& s) { s.faults = {*parseFault("frame-loss=0.1")}; }, "frame-loss");
  refused([](auto& s) { s.noisePx = 5; }, "choose less");
  refused([](auto& s) { s.noisePx = 0.0005; }, "choose more");
  refused(
      [](auto& s) {
        s.noisePx = 0.1;
        EXPECT_TRUE(applyEffect(s.effects, "all=off"));
      },
      "no noise to scale");
}

}  // namespace
}  // namespace vignole
