// A frame packed sparsely and unpacked again: extraction gives the same result to the last bit, whatever its settings.

#include "engine/recording/sparse_frame.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

#include "engine/inspection/inspection.h"
#include "engine/recipe/recipe.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/stripe/block_scan.h"
#include "engine/stripe/ridge_kernel.h"
#include "engine/stripe/stripe_extractor.h"
#include "tests/synthetic/stripe_scene.h"

namespace vignole {
namespace {

struct OwnPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  [[nodiscard]] ImageView view() const { return {pixels.data(), width, height, width}; }
  [[nodiscard]] MutableImageView mutableView() { return {pixels.data(), width, height, width}; }
};

OwnPicture unpacked(std::span<const std::uint8_t> packed) {
  const auto size = packedSize(packed);
  EXPECT_TRUE(size);
  OwnPicture picture{size->width, size->height, {}};
  // What was in the buffer before must not matter.
  picture.pixels.assign(static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height), 0xA5);
  FrameUnpacker unpacker;
  const auto done = unpacker.unpack(packed, picture.mutableView());
  EXPECT_TRUE(done) << (done ? "" : done.error().message());
  return picture;
}

OwnPicture throughRecording(const ImageView& image, FrameKind expected = FrameKind::Sparse, double* share = nullptr) {
  FramePacker packer;
  PackedBytes packed;
  EXPECT_EQ(packer.pack(image, FrameKind::Sparse, packed), expected);
  if (share != nullptr) *share = packer.keptShare();
  return unpacked(packed);
}

bool sameBits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expectSame(const StripeResult& a, const StripeResult& b) {
  EXPECT_TRUE(sameBits(a.noiseDn, b.noiseDn)) << a.noiseDn << " " << b.noiseDn;
  EXPECT_TRUE(sameBits(a.backgroundDn, b.backgroundDn)) << a.backgroundDn << " " << b.backgroundDn;
  EXPECT_TRUE(sameBits(a.saturatedShare, b.saturatedShare));
  EXPECT_TRUE(sameBits(a.correlatedPoints, b.correlatedPoints));
  EXPECT_TRUE(sameBits(a.smoothingPx, b.smoothingPx));
  EXPECT_EQ(a.overloaded, b.overloaded);
  ASSERT_EQ(a.lines.size(), b.lines.size());
  for (std::size_t l = 0; l < a.lines.size(); ++l) {
    EXPECT_EQ(a.lines[l].first, b.lines[l].first);
    EXPECT_EQ(a.lines[l].count, b.lines[l].count);
    EXPECT_EQ(a.lines[l].rejection, b.lines[l].rejection);
  }
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const StripePoint &p = a.points[i], &q = b.points[i];
    ASSERT_TRUE(sameBits(p.x, q.x) && sameBits(p.y, q.y) && sameBits(p.nx, q.nx) && sameBits(p.ny, q.ny) &&
                sameBits(p.sigmaPx, q.sigmaPx) && sameBits(p.strength, q.strength) && sameBits(p.widthPx, q.widthPx) &&
                sameBits(p.shiftPx, q.shiftPx) && sameBits(p.ridgeSigmaPx, q.ridgeSigmaPx) &&
                sameBits(p.brightening, q.brightening) && p.flags == q.flags)
        << "point " << i << " of " << a.points.size() << " at " << p.x << ", " << p.y;
  }
}

/// Settings drawn over all that a recording promises.
StripeSettings drawnSettings(std::mt19937_64& random) {
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  StripeSettings s;
  s.sigma = uniform(1, kSparseMaxSigma);
  s.low = std::exp(uniform(std::log(0.01), std::log(60)));
  s.high = s.low * uniform(1, 4);
  s.gapDistance = uniform(0, 200);
  s.gapAngle = uniform(0, 60);
  s.minLength = std::uniform_int_distribution<int>(3, 40)(random);
  s.maxBlocks = uniform(0, 1) < 0.2 ? std::uniform_int_distribution<int>(20, 400)(random) : 3000;
  s.correction = uniform(0, 1) < 0.7;
  return s;
}

void expectSameFor(const ImageView& image, const ImageView& again, const StripeSettings& settings,
                   const StripeOptics& optics = {}) {
  SCOPED_TRACE(testing::Message() << "sigma " << settings.sigma << " low " << settings.low << " high " << settings.high
                                  << " minLength " << settings.minLength << " maxBlocks " << settings.maxBlocks);
  ASSERT_TRUE(checked(settings));
  StripeResult live, replayed;
  StripeExtractor extractor(settings, optics);
  extractor.extract(image, live);
  extractor.extract(again, replayed);
  expectSame(live, replayed);
}

/// The settings at the edges of what is promised, then some drawn ones.
void expectSameForAll(const ImageView& image, const ImageView& again, std::mt19937_64& random, int draws) {
  for (const double sigma : {1.0, 2.2, 3.0, kSparseMaxSigma})
    for (const double low : {0.001, 2.0, 6.0}) {
      StripeSettings s;
      s.sigma = sigma;
      s.low = low;
      s.minLength = low < 1 ? 3 : 10;
      expectSameFor(image, again, s);
    }
  for (int i = 0; i < draws; ++i) expectSameFor(image, again, drawnSettings(random));
}

TEST(SparseFrame, PromisesWhatTheExtractionReads) {
  // The proof in sparse_frame.h is for windows of these two sizes and two blocks around the light.
  EXPECT_EQ(scanRadius(1), 2);
  EXPECT_EQ(scanRadius(kSparseMaxSigma), 3);
  EXPECT_EQ(reachPx(ridgeFilter(kSparseMaxSigma, 0)), 2 * kBlock);
}

struct Scene {
  const char* section;
  std::vector<std::string> effects, faults;
};

class RenderedRails : public testing::TestWithParam<Scene> {};

TEST_P(RenderedRails, GiveTheSamePointsWhateverTheSettings) {
  const auto recipe = findRecipe(GetParam().section);
  ASSERT_TRUE(recipe);
  VirtualRigSettings settings;
  settings.section = recipe->section;
  settings.parameters = recipe->parameters;
  settings.seed = 11;
  ASSERT_TRUE(applyWords(settings, GetParam().effects, {}, GetParam().faults));
  const auto rig = VirtualRig::create(settings);
  ASSERT_TRUE(rig);
  std::mt19937_64 random(7);
  OwnPicture picture{1400, 1024, std::vector<std::uint8_t>(1400 * 1024)};
  double sum = 0;
  int frames = 0;
  for (std::uint64_t trigger = 0; trigger < 3; ++trigger)
    for (int camera = 0; camera < kCameraCount; ++camera) {
      (*rig)->render(camera, 401 * trigger, picture.mutableView());
      double share = 0;
      const OwnPicture again = throughRecording(picture.view(), FrameKind::Sparse, &share);
      sum += share;
      ++frames;
      expectSameForAll(picture.view(), again.view(), random, 6);
      // As the inspection extracts it: with what is known of the camera.
      expectSameFor(picture.view(), again.view(), recipe->stripe,
                    extractionOptics((*rig)->calibration(), recipe->section, camera));
      if (testing::Test::HasFatalFailure()) return;
    }
  EXPECT_LT(sum / frames, 0.08);
  EXPECT_GT(sum / frames, 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Effects, RenderedRails,
    testing::Values(Scene{"60E1", {}, {}}, Scene{"54E3", {"all=off"}, {}}, Scene{"ASYM54", {"read-noise=1"}, {}},
                    Scene{"115RE", {"read-noise=6", "ambient=30", "speckle=0.5"}, {}},
                    Scene{"49E1", {"reflections=0.6", "crosstalk=0.2", "scale=0.6", "defocus=3"}, {}},
                    Scene{"60E2", {"ambient=0", "read-noise=0.3"}, {"saturated@2", "black@3"}}));

TEST(SparseFrame, TheScenesOfTheExtractionGiveTheSamePoints) {
  std::mt19937_64 random(3);
  for (const char* name : synthetic::kSceneNames) {
    SCOPED_TRACE(name);
    const synthetic::StripeScene scene = synthetic::stripeScene(name, 61);
    const OwnPicture again = throughRecording(scene.view());
    expectSameForAll(scene.view(), again.view(), random, 8);
  }
}

/// Lines, spots, texture and noise at random in a picture of any size.
OwnPicture drawnPicture(std::mt19937_64& random) {
  const auto whole = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  OwnPicture picture{whole(32, 1400), whole(32, 1100), {}};
  std::vector<double> light(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  const double base = uniform(0, 150), slopeX = uniform(-0.05, 0.05), slopeY = uniform(-0.05, 0.05);
  struct Line {
    double x, y, nx, ny, contrast, sigma, from, to;
  };
  std::vector<Line> lines(static_cast<std::size_t>(whole(0, 4)));
  for (Line& l : lines) {
    const double angle = uniform(0, 3.2);
    l = {uniform(0, picture.width), uniform(0, picture.height),
         std::cos(angle),           std::sin(angle),
         std::exp(uniform(1, 5.5)), uniform(0.7, 5),
         uniform(-600, 0),          uniform(0, 600)};
  }
  const int spots = whole(0, 30);
  std::vector<std::array<int, 3>> spotAt;
  for (int i = 0; i < spots; ++i)
    spotAt.push_back({whole(0, picture.width - 1), whole(0, picture.height - 1), whole(20, 250)});
  std::normal_distribution<double> noise(0, uniform(0.01, 9));
  picture.pixels.resize(light.size());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      double v = base + slopeX * x + slopeY * y;
      for (const Line& l : lines) {
        const double d = (x - l.x) * l.nx + (y - l.y) * l.ny, s = (y - l.y) * l.nx - (x - l.x) * l.ny;
        if (s > l.from && s < l.to) v += l.contrast * std::exp(-d * d / (2 * l.sigma * l.sigma));
      }
      picture.pixels[static_cast<std::size_t>(y * picture.width + x)] =
          static_cast<std::uint8_t>(std::clamp(std::lround(v + noise(random)), 0L, 255L));
    }
  for (const auto& [x, y, dn] : spotAt)
    picture.pixels[static_cast<std::size_t>(y * picture.width + x)] = static_cast<std::uint8_t>(dn);
  return picture;
}

TEST(SparseFrame, PicturesOfAnySizeAndContentGiveTheSamePoints) {
  std::mt19937_64 random(23);
  int sparse = 0;
  const char* wished = std::getenv("VIGNOLE_PICTURES");
  const int pictures = wished != nullptr ? std::atoi(wished) : 60;
  for (int i = 0; i < pictures; ++i) {
    SCOPED_TRACE(i);
    const OwnPicture picture = drawnPicture(random);
    FramePacker packer;
    PackedBytes packed;
    sparse += packer.pack(picture.view(), FrameKind::Sparse, packed) == FrameKind::Sparse ? 1 : 0;
    const OwnPicture again = unpacked(packed);
    for (int k = 0; k < 6; ++k) expectSameFor(picture.view(), again.view(), drawnSettings(random));
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(3 * sparse, pictures);
}

TEST(SparseFrame, FlatPicturesOfAnyBrightnessKeepTheirStatistics) {
  for (const int dn : {0, 1, 127, 254, 255}) {
    const OwnPicture flat{640, 480, std::vector<std::uint8_t>(640 * 480, static_cast<std::uint8_t>(dn))};
    const OwnPicture again = throughRecording(flat.view());
    EXPECT_EQ(again.pixels, flat.pixels) << dn;
    expectSameFor(flat.view(), again.view(), {});
  }
}

TEST(SparseFrame, TextureEverywhereIsKeptWhole) {
  std::mt19937_64 random(5);
  OwnPicture picture{640, 480, std::vector<std::uint8_t>(640 * 480)};
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x)
      picture.pixels[static_cast<std::size_t>(y * 640 + x)] = (x / 5 + y / 7) % 2 == 0 ? 200 : 10;
  EXPECT_EQ(throughRecording(picture.view(), FrameKind::Whole).pixels, picture.pixels);
}

TEST(SparseFrame, AWholeFrameComesBackToTheLastPixelWhateverItsStride) {
  const synthetic::StripeScene scene = synthetic::stripeScene("rail", 3);
  FramePacker packer;
  PackedBytes packed;
  const ImageView part{scene.pixels.data() + 17, 1000, 700, 1400};
  EXPECT_EQ(packer.pack(part, FrameKind::Whole, packed), FrameKind::Whole);
  EXPECT_EQ(packer.keptShare(), 1);
  const OwnPicture again = unpacked(packed);
  ASSERT_EQ(again.width, 1000);
  for (int y = 0; y < 700; ++y) ASSERT_EQ(std::memcmp(again.view().row(y), part.row(y), 1000), 0) << y;
}

TEST(SparseFrame, ThePixelsAroundTheLineAreTheCamerasOwn) {
  const synthetic::StripeScene scene = synthetic::stripeScene("clean", 8);
  const OwnPicture again = throughRecording(scene.view());
  for (const synthetic::TruthSample& s : scene.truth) {
    const int x = static_cast<int>(std::lround(s.x)), y = static_cast<int>(std::lround(s.y));
    for (int dy = -12; dy <= 12; ++dy)
      for (int dx = -12; dx <= 12; ++dx) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= 1400 || y + dy >= 1024) continue;
        ASSERT_EQ(again.view().row(y + dy)[x + dx], scene.view().row(y + dy)[x + dx]);
      }
  }
}

TEST(SparseFrame, DamagedBytesAreRefusedOrGiveAPictureNeverMore) {
  const synthetic::StripeScene scene = synthetic::stripeScene("rail", 4);
  FramePacker packer;
  PackedBytes packed;
  packer.pack(scene.view(), FrameKind::Sparse, packed);
  OwnPicture into{1400, 1024, std::vector<std::uint8_t>(1400 * 1024)};
  FrameUnpacker unpacker;
  for (std::size_t size = 0; size < packed.size(); size += 1 + size / 40)
    EXPECT_FALSE(unpacker.unpack(std::span(packed).first(size), into.mutableView())) << size;
  PackedBytes longer = packed;
  longer.push_back(0);
  EXPECT_FALSE(unpacker.unpack(longer, into.mutableView()));
  std::mt19937_64 random(9);
  for (int i = 0; i < 2000; ++i) {
    PackedBytes changed = packed;
    for (int k = 0; k < 3; ++k)
      changed[std::uniform_int_distribution<std::size_t>(5, i % 2 == 0 ? 400 : packed.size() - 1)(random)] ^=
          static_cast<std::uint8_t>(std::uniform_int_distribution<int>(1, 255)(random));
    (void)unpacker.unpack(changed, into.mutableView());  // the sanitizers watch
  }
  // The unpacker is none the worse for it.
  ASSERT_TRUE(unpacker.unpack(packed, into.mutableView()));
  expectSameFor(scene.view(), into.view(), {});
}

}  // namespace
}  // namespace vignole
