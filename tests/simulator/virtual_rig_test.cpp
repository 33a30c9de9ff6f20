// What the four cameras see: visibility, unbiased lines, noise and surface as set, the same bytes from any thread.

#include "engine/simulator/virtual_rig.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <thread>

#include "engine/optics/camera_model.h"
#include "engine/rail/catalogue.h"
#include "engine/simulator/surface.h"

namespace vignole {
namespace {

using Picture = std::vector<std::uint8_t>;

VirtualRigSettings settings60E1() {
  VirtualRigSettings s;
  if (auto section = findSection("60E1")) s.section = *std::move(section);
  s.parameters = s.section.parameters;
  return s;
}
VirtualRigSettings quiet() {
  VirtualRigSettings s = settings60E1();
  EXPECT_TRUE(applyEffect(s.effects, "all=off"));
  s.varyDimensions = false;
  return s;
}
std::shared_ptr<const VirtualRig> make(const VirtualRigSettings& s) {
  auto rig = VirtualRig::create(s);
  EXPECT_TRUE(rig.has_value()) << (rig ? "" : rig.error().message());
  return rig ? *rig : nullptr;
}
Picture render(const VirtualRig& rig, int camera, std::uint64_t trigger) {
  Picture picture(1400 * 1024, 99);
  rig.render(camera, trigger, {picture.data(), 1400, 1024, 1400});
  return picture;
}

TEST(VirtualRig, SameBytesFromAnyThreadInAnyOrder) {
  const auto rig = make(settings60E1()), again = make(settings60E1());
  std::vector<Picture> expected;
  for (int i = 0; i < 8; ++i) expected.push_back(render(*rig, i % 4, static_cast<std::uint64_t>(i / 4)));
  std::vector<Picture> got(8);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 2; ++t)
      threads.emplace_back([&, t] {
        for (int i = 7 - t; i >= 0; i -= 2)
          got[static_cast<std::size_t>(i)] = render(*again, i % 4, static_cast<std::uint64_t>(i / 4));
      });
  }
  for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(got[i] == expected[i]) << i;
  EXPECT_FALSE(expected[0] == expected[4]) << "another trigger must give another picture";
}

TEST(VirtualRig, SeedsDrawRigAndRailApart) {
  VirtualRigSettings s = settings60E1();
  s.rigSeed = 7;
  const auto a = make(s);
  s.seed = 2;
  const auto b = make(s);
  EXPECT_EQ(toToml(a->calibration()), toToml(b->calibration()));
  EXPECT_NE(a->truth(0).valueMm, b->truth(0).valueMm);
  s.rigSeed = 8;
  EXPECT_NE(toToml(make(s)->calibration()), toToml(a->calibration()));
}

TEST(VirtualRig, AnotherPassIsTheSameRailUnderTheSameRig) {
  VirtualRigSettings s = settings60E1();
  s.passSeed = 1001;
  const auto a = make(s);
  s.passSeed = 1002;
  const auto b = make(s);
  EXPECT_EQ(toToml(a->calibration()), toToml(b->calibration()));
  for (const std::uint64_t trigger : {0U, 100U}) {
    for (const Dimension d : kDimensions)
      EXPECT_NEAR(a->truth(trigger).valueMm[index(d)], b->truth(trigger).valueMm[index(d)], 1e-6) << name(d);
    EXPECT_NE(a->truth(trigger).worldFromSection.xMm, b->truth(trigger).worldFromSection.xMm) << "it wanders otherwise";
  }
  EXPECT_FALSE(render(*a, 0, 0) == render(*b, 0, 0));
}

TEST(VirtualRig, StandsNearRigC) {
  // Camera 2 of rig C by the design: (257, 295, 257); camera 3: (271, -118, 257).
  const auto rig = make(quiet());
  const auto centre = [&](std::size_t i) {
    const Extrinsics& e = rig->calibration().rangeFinders[i].cameraFromWorld;
    return Eigen::Vector3d(-(e.rotation.transpose() * e.translationMm));
  };
  EXPECT_LT((centre(0) - Eigen::Vector3d(-257, 295, 257)).norm(), 6);
  EXPECT_LT((centre(1) - Eigen::Vector3d(257, 295, 257)).norm(), 6);
  EXPECT_LT((centre(2) - Eigen::Vector3d(271, -118, 257)).norm(), 6);
  EXPECT_LT((centre(3) - Eigen::Vector3d(-271, -118, 257)).norm(), 6);
}

/// Share of a primitive's length that a camera's visible lines cover.
double coverage(const VirtualRig& rig, int camera, const std::string& primitive) {
  const RangeFinderCalibration& finder = rig.calibration().rangeFinders[static_cast<std::size_t>(camera)];
  const Lens<double> l = lens(finder.intrinsics);
  const Section& section = rig.settings().section;
  const Primitive& shape = section.primitives[*section.find(primitive)].shape;
  const auto lines = rig.visibleLines(camera, 0);
  int hit = 0;
  constexpr int kSteps = 100;
  for (int i = 0; i < kSteps; ++i) {
    const Point2 p = pointAt(shape, length(shape) * (i + 0.5) / kSteps);
    const Point2 pixel =
        project<double>(l, finder.cameraFromWorld.rotation, finder.cameraFromWorld.translationMm, {p.x(), p.y(), 0});
    double nearest = 1e9;
    for (const auto& line : lines)
      for (const Point2& q : line) nearest = std::min(nearest, (q - pixel).norm());
    hit += nearest < 1 ? 1 : 0;
  }
  return static_cast<double>(hit) / kSteps;
}

TEST(VirtualRig, WhoSeesWhatIsThatOfTheDesign) {
  VirtualRigSettings s = quiet();
  s.temperatureC = 15;
  const auto rig = make(s);
  constexpr int kUpperRight = 1, kLowerRight = 2, kLowerLeft = 3, kUpperLeft = 0;
  for (const int camera : {kUpperLeft, kUpperRight}) EXPECT_GT(coverage(*rig, camera, "AHT"), 0.99);
  EXPECT_GT(coverage(*rig, kUpperRight, "AHTR2"), 0.99);
  EXPECT_NEAR(coverage(*rig, kUpperLeft, "AHTR2"), 0.78, 0.12);
  EXPECT_GT(coverage(*rig, kUpperRight, "AHTR1"), 0.99);
  EXPECT_NEAR(coverage(*rig, kLowerRight, "AHTR1"), 0.33, 0.12);
  EXPECT_GT(coverage(*rig, kUpperRight, "SHR"), 0.99);
  EXPECT_GT(coverage(*rig, kLowerRight, "SHR"), 0.99);
  EXPECT_GT(coverage(*rig, kLowerRight, "SHBR"), 0.99);
  EXPECT_LT(coverage(*rig, kUpperRight, "SHBR"), 0.01);
  EXPECT_GT(coverage(*rig, kUpperRight, "SWR"), 0.99);
  EXPECT_GT(coverage(*rig, kLowerRight, "SWR"), 0.85);
  EXPECT_GT(coverage(*rig, kUpperRight, "SWBR"), 0.99);
  EXPECT_GT(coverage(*rig, kUpperRight, "SBTR"), 0.99);
  EXPECT_LT(coverage(*rig, kLowerRight, "SBTR"), 0.01);
  EXPECT_GT(coverage(*rig, kUpperRight, "SBR"), 0.99);
  EXPECT_GT(coverage(*rig, kLowerRight, "SBR"), 0.99);
  for (const int camera : {kLowerLeft, kLowerRight}) EXPECT_GT(coverage(*rig, camera, "SBB"), 0.99);
  EXPECT_LT(coverage(*rig, kUpperRight, "SBB"), 0.01);
  EXPECT_LT(coverage(*rig, kUpperLeft, "SWR"), 0.01);
}

TEST(VirtualRig, AllIsSeenWhereverTheRailWanders) {
  // Foot bottom, crown and edges must stay in the pictures and the fans throughout.
  const auto rig = make(settings60E1());
  double most = 0;
  for (std::uint64_t trigger = 0; trigger < 4000; trigger += 200)
    for (int camera = 0; camera < 4; ++camera) {
      double run = 0;
      for (const auto& line : rig->visibleLines(camera, trigger))
        for (std::size_t i = 1; i < line.size(); ++i) run += (line[i] - line[i - 1]).norm();
      EXPECT_GT(run, 900) << "camera " << camera + 1 << " trigger " << trigger;
      most = std::max(most, run);
    }
  EXPECT_LT(most, 2000);
}

/// Centre of gravity across the line along the image row or column that crosses it best.
double centreAcross(const Picture& picture, const Point2& at, bool alongRow, double background) {
  double sum = 0, moment = 0;
  const int middle = static_cast<int>(std::lround(alongRow ? at.x() : at.y()));
  const int fixed = static_cast<int>(std::lround(alongRow ? at.y() : at.x()));
  for (int k = middle - 12; k <= middle + 12; ++k) {
    const std::size_t i =
        alongRow ? static_cast<std::size_t>(fixed * 1400 + k) : static_cast<std::size_t>(k * 1400 + fixed);
    const double light = picture[i] - background;
    sum += light;
    moment += light * k;
  }
  return sum > 0 ? moment / sum : 1e9;
}

TEST(VirtualRig, StraightPartsHaveTheirCentreOnTheProjection) {
  VirtualRigSettings s = quiet();
  s.effects.defocus = 1;
  const auto rig = make(s);
  for (const auto& [camera, primitive] :
       {std::pair{1, "SHR"}, {2, "SHR"}, {2, "SBB"}, {3, "SBB"}, {1, "SBTR"}, {0, "SWL"}, {3, "SHBL"}}) {
    const Picture picture = render(*rig, camera, 0);
    const RangeFinderCalibration& f = rig->calibration().rangeFinders[static_cast<std::size_t>(camera)];
    const Lens<double> l = lens(f.intrinsics);
    const Transform2 pose = rig->truth(0).worldFromSection;
    const Section& section = s.section;
    const Primitive& shape = section.primitives[*section.find(primitive)].shape;
    const double growth = 1 + 11.5e-6 * 5;
    const auto pixel = [&](double along) {
      const Point2 w = pose * Point2(growth * pointAt(shape, along));
      return Point2(project<double>(l, f.cameraFromWorld.rotation, f.cameraFromWorld.translationMm, {w.x(), w.y(), 0}));
    };
    double bias = 0;
    int count = 0;
    for (double along = 0.3 * length(shape); along < 0.7 * length(shape); along += 0.1) {
      const Point2 p = pixel(along), step = pixel(along + 0.1) - p;
      const bool alongRow = std::abs(step.y()) > std::abs(step.x());
      // The projection where the image row (column) through the pixel centre meets the line.
      const double fixed = std::round(alongRow ? p.y() : p.x());
      const double slope = alongRow ? step.x() / step.y() : step.y() / step.x();
      const double expected = alongRow ? p.x() + slope * (fixed - p.y()) : p.y() + slope * (fixed - p.x());
      bias += centreAcross(picture, p, alongRow, 0) - expected;
      ++count;
    }
    EXPECT_NEAR(bias / count, 0, 0.01) << primitive << " in camera " << camera + 1;
  }
}

TEST(VirtualRig, LineIsAsBrightAsItShouldBe) {
  VirtualRigSettings s = settings60E1();
  const auto rig = make(s);
  std::vector<int> peaks;
  for (int camera = 0; camera < 4; ++camera) {
    const Picture picture = render(*rig, camera, 3);
    for (const auto& line : rig->visibleLines(camera, 3))
      for (const Point2& p : line) {
        int peak = 0;
        for (int y = -2; y <= 2; ++y)
          for (int x = -2; x <= 2; ++x) {
            const int c = std::clamp(static_cast<int>(std::lround(p.x())) + x, 0, 1399);
            const int r = std::clamp(static_cast<int>(std::lround(p.y())) + y, 0, 1023);
            peak = std::max<int>(peak, picture[static_cast<std::size_t>(r * 1400 + c)]);
          }
        peaks.push_back(peak);
      }
  }
  std::sort(peaks.begin(), peaks.end());
  const auto at = [&](double q) { return peaks[static_cast<std::size_t>(q * static_cast<double>(peaks.size() - 1))]; };
  RecordProperty("peak_p10", at(0.1));
  RecordProperty("peak_median", at(0.5));
  RecordProperty("peak_p90", at(0.9));
  std::printf("peaks: p10 %d median %d p90 %d p99 %d\n", at(0.1), at(0.5), at(0.9), at(0.99));
  EXPECT_GT(at(0.5), 60);
  EXPECT_LT(at(0.5), 200);
}

TEST(VirtualRig, BackgroundHasTheNoiseThatIsSet) {
  VirtualRigSettings s = settings60E1();
  s.effects.readNoiseDn = 5;
  s.effects.ambientDn = 40;
  const auto rig = make(s);
  const Picture picture = render(*rig, 0, 1);
  double sum = 0, square = 0;
  int n = 0;
  for (std::size_t y = 0; y < 150; ++y)
    for (std::size_t x = 0; x < 1400; ++x) {
      const double v = picture[y * 1400 + x];
      sum += v;
      square += v * v;
      ++n;
    }
  const double mean = sum / n, sd = std::sqrt(square / n - mean * mean);
  EXPECT_NEAR(mean, 40, 0.1);
  EXPECT_NEAR(sd, std::sqrt(25 + 40 * 60.0 / 10000 + 1.0 / 12), 0.1);
}

TEST(VirtualRig, SpeckleHasTheContrastAndTheGrainThatAreSet) {
  const std::vector<float> field = simulator::speckleField(3, 0.22);
  double sum = 0, square = 0, lag1 = 0;
  for (int y = 0; y < simulator::kSpeckleSize; ++y)
    for (int x = 0; x < simulator::kSpeckleSize; ++x) {
      const auto i = static_cast<std::size_t>(y * simulator::kSpeckleStride + x);
      sum += field[i];
      square += field[i] * field[i];
      lag1 += field[i] * field[i + 1];
    }
  const double n = simulator::kSpeckleSize * simulator::kSpeckleSize;
  const double mean = sum / n, variance = square / n - mean * mean;
  EXPECT_NEAR(mean, 1, 0.01);
  EXPECT_NEAR(std::sqrt(variance), 0.22, 0.01);
  EXPECT_NEAR((lag1 / n - mean * mean) / variance, 0.5, 0.08);  // half its height one pixel away: 2 px wide
}

TEST(VirtualRig, SpeckleAppearsInThePicture) {
  VirtualRigSettings s = quiet();
  const auto smooth = make(s);
  s.effects.speckle = 0.22;
  const auto rough = make(s);
  const Picture a = render(*smooth, 2, 0), b = render(*rough, 2, 0);
  double sum = 0, square = 0;
  int n = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] < 60 || b[i] == 255) continue;
    const double ratio = static_cast<double>(b[i]) / a[i];
    sum += ratio;
    square += ratio * ratio;
    ++n;
  }
  ASSERT_GT(n, 1000);
  const double mean = sum / n;
  EXPECT_NEAR(mean, 1, 0.03);
  EXPECT_NEAR(std::sqrt(square / n - mean * mean), 0.22, 0.03);
}

TEST(VirtualRig, MillScaleCoversTheShareThatIsSet) {
  const simulator::Surface surface(5);
  const float bare = surface.reflectance(0, 0, 0);
  for (const double share : {0.15, 0.5}) {
    int covered = 0, n = 0;
    for (double around = 0; around < 768; around += 2)
      for (double along = 0; along < 4096; along += 7) {
        covered += surface.reflectance(around, along, share) < 0.85F * bare ? 1 : 0;
        ++n;
      }
    EXPECT_NEAR(static_cast<double>(covered) / n, share, 0.03);
  }
}

TEST(VirtualRig, EffectsAndFaultsAreRead) {
  Effects e;
  EXPECT_TRUE(applyEffect(e, "ambient=20"));
  EXPECT_EQ(e.ambientDn, 20);
  EXPECT_TRUE(applyEffect(e, "all=off"));
  for (const auto& [name, value] : list(e)) EXPECT_EQ(value, 0) << name;
  EXPECT_TRUE(applyEffect(e, "speckle=on"));
  EXPECT_EQ(e.speckle, 0.22);
  for (const char* bad : {"speckel=on", "speckle", "speckle=maybe", "speckle=7", "all=3", "speckle=-1"}) {
    const auto refused = applyEffect(e, bad);
    ASSERT_FALSE(refused.has_value()) << bad;
    EXPECT_EQ(refused.error().message().find('\n'), std::string::npos);
  }
  const auto fault = parseFault("frame-loss=0.01@2:100-200");
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->kind, "frame-loss");
  EXPECT_EQ(fault->value, 0.01);
  EXPECT_EQ(fault->camera, 1);
  EXPECT_EQ(fault->from, 100U);
  EXPECT_EQ(fault->to, 200U);
  const auto wrong = parseFault("wrong-rail=54E1:5-");
  ASSERT_TRUE(wrong.has_value());
  EXPECT_EQ(wrong->text, "54E1");
  EXPECT_EQ(wrong->from, 5U);
  EXPECT_EQ(wrong->to, ~std::uint64_t{0});
  for (const char* bad :
       {"explode", "frame-loss", "frame-loss=2", "black=1", "black@5", "black:9-3", "move=x", "wrong-rail"})
    EXPECT_FALSE(parseFault(bad).has_value()) << bad;
}

TEST(VirtualRig, FaultsChangeThePictureWhereTheySay) {
  VirtualRigSettings s = settings60E1();
  const auto healthy = make(s);
  for (const char* text :
       {"black@2:3-3", "saturated@2:3-3", "move=2@2:3-3", "turn=1@2:3-3", "scale=0.9@2:3-3", "wrong-rail=54E1@2:3-3"}) {
    s.faults = {*parseFault(text)};
    const auto sick = make(s);
    EXPECT_FALSE(render(*sick, 1, 3) == render(*healthy, 1, 3)) << text;
    EXPECT_TRUE(render(*sick, 1, 4) == render(*healthy, 1, 4)) << text;
    if (s.faults[0].kind != "wrong-rail") {
      EXPECT_TRUE(render(*sick, 0, 3) == render(*healthy, 0, 3)) << text;
    }
  }
  s.faults = {*parseFault("black")};
  const Picture dark = render(*make(s), 1, 3);
  EXPECT_LT(*std::max_element(dark.begin(), dark.end()), 25);
  s.faults = {*parseFault("saturated")};
  const Picture bright = render(*make(s), 1, 3);
  EXPECT_GT(std::count(bright.begin(), bright.end(), 255), 5000);
}

TEST(VirtualRig, AMovedCameraSeesTheRailShifted) {
  VirtualRigSettings s = quiet();
  s.faults = {*parseFault("move=1@2")};
  const auto a = make(quiet())->visibleLines(1, 0), b = make(s)->visibleLines(1, 0);
  ASSERT_FALSE(a.empty());
  ASSERT_FALSE(b.empty());
  // 1 mm at 400 mm with f 16 and 7.4 um: 5.4 px.
  EXPECT_NEAR((a[0].front() - b[0].front()).norm(), 5.4, 0.8);
}

TEST(VirtualRig, ExposureScalesTheLightAndTheBlurOfWhatMoves) {
  VirtualRigSettings s = quiet();
  s.effects.ambientDn = 12;
  const Picture usual = render(*make(s), 1, 0);
  s.exposureMs = 5;
  const Picture third = render(*make(s), 1, 0);
  EXPECT_EQ(usual[0], 12);
  EXPECT_EQ(third[0], 4);
  int compared = 0;
  for (std::size_t i = 0; i < usual.size(); ++i)
    if (usual[i] > 60 && usual[i] < 255) {
      EXPECT_NEAR(third[i], usual[i] / 3.0, 0.7);
      ++compared;
    }
  EXPECT_GT(compared, 2000);
  // A rail that shakes: the longer the exposure, the lower the peak of the light that was gathered.
  s.effects.ambientDn = 0;
  s.effects.motion = 1;
  s.effects.vibration = 20;
  s.spacingMm = 50;
  const auto sharpness = [&](double ms) {
    s.exposureMs = ms;
    const auto rig = make(s);
    double sum = 0, square = 0;
    for (std::uint64_t trigger = 0; trigger < 8; ++trigger)
      for (const std::uint8_t dn : render(*rig, 1, trigger)) {
        const double light = dn / ms;
        sum += light, square += light * light;
      }
    return square / sum;
  };
  EXPECT_LT(sharpness(14), 0.97 * sharpness(3));
  s.exposureMs = 0;
  EXPECT_FALSE(VirtualRig::create(s).has_value());
}

}  // namespace
}  // namespace vignole
