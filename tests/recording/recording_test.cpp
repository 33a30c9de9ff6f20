// What was recorded is there again; what was cut off or damaged costs no more than itself.

#include "engine/recording/recording.h"

#include <cstring>
#include <fstream>
#include <random>

#include "engine/recording/verify_recording.h"
#include "tests/recording/recorded_rail.h"

namespace vignole {
namespace {

using namespace vignole::testing;

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// One recording for all tests that only read.
struct Made {
  RecordingFolder folder;
  std::filesystem::path file = folder.file("rails.vgr");
  std::shared_ptr<const VirtualRig> rig = makeRig({"frame-loss=0.2@2", "missed-trigger=0.1@3"});
  RunResult live = record(file, rig, 2, 12);
  std::string bytes = bytesOf(file);
};
const Made& made() {
  static const Made one;
  return one;
}

TEST(Recording, MeasuredAgainGivesTheSameToTheLastBitLossesIncluded) {
  EXPECT_EQ(made().live.profiles.size() + made().live.triggers.lost, 24U);
  EXPECT_GT(made().live.triggers.incomplete, 0U);
  const RunResult again = replay(made().file);
  EXPECT_EQ(again.profiles, made().live.profiles);
  EXPECT_EQ(again.rails, made().live.rails);
  EXPECT_EQ(again.triggers.reasons, made().live.triggers.reasons);
  EXPECT_TRUE(again == made().live);
}

TEST(Recording, KnowsWhatItWasRecordedWith) {
  const auto recording = opened(made().file);
  ASSERT_TRUE(recording && recording->setup());
  EXPECT_TRUE(recording->closed());
  EXPECT_TRUE(recording->problems().empty());
  const RecordedSetup& setup = *recording->setup();
  EXPECT_EQ(setup.program, "test");
  EXPECT_EQ(setup.simdTarget, stripeSimdTarget());
  EXPECT_EQ(setup.origin, "{\"seed\":5}");
  EXPECT_EQ(toToml(setup.recipe), toToml(recipe60()));
  EXPECT_EQ(toToml(setup.calibration), toToml(made().rig->calibration()));
  ASSERT_EQ(recording->rails().size(), 2U);
  EXPECT_EQ(recording->rails()[1].begin.rail.firstTrigger, 12U);
  EXPECT_EQ(recording->rails()[1].endTrigger, 24U);
  EXPECT_EQ(recording->rails()[0].begin.rail.heat, "virtual-5");
}

TEST(Recording, AnyFrameIsFoundByItsTrigger) {
  const auto recording = opened(made().file);
  std::vector<std::uint8_t> pixels(1400 * 1024);
  for (const std::uint64_t trigger : {23U, 0U, 11U}) {
    const auto frame = recording->frame(0, trigger);
    ASSERT_TRUE(frame) << frame.error().message();
    made().rig->render(0, trigger, {pixels.data(), 1400, 1024, 1400});
    StripeResult live, again;
    StripeExtractor extractor(recipe60().stripe);
    extractor.extract({pixels.data(), 1400, 1024, 1400}, live);
    extractor.extract(frame->image, again);
    EXPECT_EQ(StripeDigest().of(live), StripeDigest().of(again));
  }
  EXPECT_FALSE(recording->frame(0, 24));
  EXPECT_FALSE(recording->frame(7, 0));
}

TEST(Recording, VerifyExtractsEveryFrameAgain) {
  const RecordingCheck check = verifyRecording(*opened(made().file), [](double) {});
  EXPECT_TRUE(check.good());
  EXPECT_GT(check.frames, 80U);
  EXPECT_EQ(check.compared, check.frames);
  EXPECT_EQ(check.sparseFrames, check.frames);
  EXPECT_EQ(check.whyNotCompared, "");
}

TEST(Recording, ADigestOfOtherPointsIsNoticed) {
  const RecordingFolder folder;
  std::string bytes = made().bytes;
  const auto recording = opened(made().file);
  const auto frame = std::find_if(recording->chunks().begin(), recording->chunks().end(),
                                  [](const ChunkPlace& c) { return c.head.kind == ChunkKind::Frame; });
  ChunkHead head = frame->head;
  head.digest ^= 1;
  const ChunkHeadBytes changed = written(head);
  std::memcpy(bytes.data() + frame->offset, changed.data(), changed.size());
  bytes.resize(bytes.size() - kChunkHeadSize);  // without its index
  writeBytes(folder.file("a.vgr"), bytes);
  const RecordingCheck check = verifyRecording(*opened(folder.file("a.vgr")), [](double) {});
  EXPECT_EQ(check.different, 1U);
  EXPECT_FALSE(check.good());
}

TEST(Recording, CutOffAnywhereWhatCameBeforeIsReadable) {
  const RecordingFolder folder;
  const auto whole = opened(made().file);
  std::vector<std::uint64_t> cuts = {0,
                                     7,
                                     15,
                                     16,
                                     17,
                                     40,
                                     kRecordingSignature.size() + kChunkHeadSize,
                                     made().bytes.size() - 1,
                                     made().bytes.size() - kChunkHeadSize,
                                     made().bytes.size() - kChunkHeadSize - 5};
  std::mt19937_64 random(4);
  for (int i = 0; i < 60; ++i)
    cuts.push_back(std::uniform_int_distribution<std::uint64_t>(0, made().bytes.size())(random));
  for (std::size_t i = 0; i < whole->chunks().size(); i += 9)  // at, just behind and within a head
    for (const std::uint64_t more : {0U, 1U, 47U, 48U, 49U}) cuts.push_back(whole->chunks()[i].offset + more);
  for (const std::uint64_t cut : cuts) {
    SCOPED_TRACE(cut);
    std::string bytes = made().bytes.substr(0, cut);
    writeBytes(folder.file("cut.vgr"), bytes);
    std::size_t expected = 0;
    for (const ChunkPlace& c : whole->chunks())
      expected += c.offset + kChunkHeadSize + c.head.size <= cut && c.head.kind == ChunkKind::Frame ? 1 : 0;
    const auto recording = Recording::open(folder.file("cut.vgr"));
    if (!recording) {
      EXPECT_EQ(expected, 0U) << recording.error().message();
      EXPECT_EQ(recording.error().message().find('\n'), std::string::npos);
      continue;
    }
    EXPECT_EQ((*recording)->frames(), expected);
    EXPECT_EQ((*recording)->closed(), cut == made().bytes.size());
    EXPECT_EQ((*recording)->problems().empty(), cut == made().bytes.size());
  }
}

TEST(Recording, ARecordingThatWasCutOffMeasuresAsFarAsItGoes) {
  const RecordingFolder folder;
  const auto whole = opened(made().file);
  const auto place = std::find_if(whole->chunks().begin(), whole->chunks().end(), [](const ChunkPlace& c) {
    return c.head.kind == ChunkKind::Frame && c.head.trigger == 20;
  });
  // Cameras are some triggers apart in the file; of those before this one it has all.
  std::uint64_t complete = 20;
  for (auto c = place; c != whole->chunks().end(); ++c)
    if (c->head.kind == ChunkKind::Frame || c->head.kind == ChunkKind::Lost)
      complete = std::min(complete, c->head.trigger);
  writeBytes(folder.file("cut.vgr"), made().bytes.substr(0, place->offset + 100));
  const RunResult again = replay(folder.file("cut.vgr"));
  ASSERT_GE(again.rails.size(), 2U);
  EXPECT_EQ(again.triggers.seen, again.triggers.measured + again.triggers.incomplete + again.triggers.lost);
  constexpr std::uint64_t kMissedAtMost = 3;  // triggers in a row that a camera may have missed before the cut
  for (std::size_t i = 0; i < made().live.profiles.size(); ++i) {
    const std::string& profile = made().live.profiles[i];
    if (std::stoull(profile) + kMissedAtMost >= complete) break;
    ASSERT_LT(i, again.profiles.size());
    EXPECT_EQ(again.profiles[i], profile);
  }
}

TEST(Recording, ADamagedChunkCostsItselfAndIsToldAsLost) {
  const RecordingFolder folder;
  const auto whole = opened(made().file);
  const auto place = std::find_if(whole->chunks().begin(), whole->chunks().end(), [](const ChunkPlace& c) {
    return c.head.kind == ChunkKind::Frame && c.head.camera == 0 && c.head.trigger == 5;
  });
  for (const bool inHead : {false, true})
    for (const bool indexed : {false, true}) {
      SCOPED_TRACE(::testing::Message() << inHead << indexed);
      std::string bytes = made().bytes;
      bytes[place->offset + (inHead ? 9 : 3000)] ^= 0x55;
      if (!indexed) bytes.resize(bytes.size() - 1);
      writeBytes(folder.file("bad.vgr"), bytes);
      const auto recording = opened(folder.file("bad.vgr"));
      ASSERT_TRUE(recording);
      EXPECT_EQ(recording->closed(), indexed);
      EXPECT_EQ(recording->damagedBytes() > 0, !indexed);
      if (inHead && !indexed) {
        EXPECT_EQ(recording->frames() + 1, whole->frames());
      } else {
        EXPECT_EQ(verifyRecording(*recording, [](double) {}).damagedChunks, inHead && indexed ? 0U : 1U);
      }
      const RunResult again = replay(folder.file("bad.vgr"));
      EXPECT_EQ(again.triggers.seen, 24U);
      if (!inHead) {
        EXPECT_EQ(again.triggers.reasons.at("camera 1: damaged recording"), 1U);
      }
    }
}

TEST(Recording, ADamagedSetupLeavesTheFrames) {
  const RecordingFolder folder;
  std::string bytes = made().bytes;
  bytes[kRecordingSignature.size() + kChunkHeadSize + 100] ^= 1;
  writeBytes(folder.file("bad.vgr"), bytes);
  const auto recording = opened(folder.file("bad.vgr"));
  ASSERT_TRUE(recording);
  EXPECT_FALSE(recording->setup());
  EXPECT_FALSE(recording->problems().empty());
  EXPECT_TRUE(recording->frame(0, 3));
}

TEST(Recording, FilesThatAreNoneAreRefusedInOneLine) {
  const RecordingFolder folder;
  writeBytes(folder.file("text.vgr"), "this is a text and no recording at all");
  writeBytes(folder.file("empty.vgr"), "");
  writeBytes(folder.file("head.vgr"), "VignoleRecording");
  for (const char* name : {"text.vgr", "empty.vgr", "head.vgr", "none.vgr", "."}) {
    const auto recording = Recording::open(folder.file(name));
    ASSERT_FALSE(recording) << name;
    EXPECT_NE(recording.error().message().find(folder.path().string()), std::string::npos);
  }
}

// Heads with good checksums and sizes that are lies, at random: nothing is believed, no memory is taken for them.
TEST(Recording, LiesAreNotBelieved) {
  const RecordingFolder folder;
  std::mt19937_64 random(8);
  const auto draw = [&](std::uint64_t most) { return std::uniform_int_distribution<std::uint64_t>(0, most)(random); };
  const auto whole = opened(made().file);
  for (int i = 0; i < 150; ++i) {
    std::string bytes = made().bytes.substr(0, 200'000 + draw(100'000));
    for (int k = 0; k < 4; ++k) {
      const ChunkPlace& place = whole->chunks()[draw(8)];
      ChunkHead head = place.head;
      switch (draw(4)) {
        case 0:
          head.size = static_cast<std::uint32_t>(draw(0xFFFFFFFF));
          break;
        case 1:
          head.trigger = draw(~std::uint64_t{0});
          break;
        case 2:
          head.kind = static_cast<ChunkKind>(draw(255));
          break;
        case 3:
          head.camera = static_cast<std::uint8_t>(draw(255));
          break;
        default:
          head.timeUs = static_cast<std::int64_t>(draw(~std::uint64_t{0}));
      }
      const ChunkHeadBytes changed = written(head);
      if (place.offset + changed.size() <= bytes.size())
        std::memcpy(bytes.data() + place.offset, changed.data(), changed.size());
    }
    if (draw(1) == 0) {  // an index that leads anywhere
      ChunkHead index{.kind = ChunkKind::Index, .trigger = draw(1'000'000)};
      index.size = static_cast<std::uint32_t>(draw(200));
      ChunkHead last{.kind = ChunkKind::Last, .trigger = bytes.size()};
      const ChunkHeadBytes a = written(index), b = written(last);
      bytes.append(reinterpret_cast<const char*>(a.data()), a.size());
      bytes.append(index.size, 'x');
      bytes.append(reinterpret_cast<const char*>(b.data()), b.size());
    }
    writeBytes(folder.file("lie.vgr"), bytes);
    const auto recording = Recording::open(folder.file("lie.vgr"));
    if (!recording) continue;
    const auto source = makeRecordingSource(*recording);
    for (int camera = 0; camera < kCameraCount; ++camera)
      for (int n = 0; n < 60; ++n)
        if (std::holds_alternative<SourceEnd>(source->next(camera, {}))) break;
  }
}

TEST(Recording, WholeFramesComeBackPixelByPixelAndAllowAnySigma) {
  const RecordingFolder folder;
  const auto rig = makeRig();
  record(folder.file("whole.vgr"), rig, 1, 2, true);
  const auto recording = opened(folder.file("whole.vgr"));
  std::vector<std::uint8_t> pixels(1400 * 1024);
  rig->render(2, 1, {pixels.data(), 1400, 1024, 1400});
  const auto frame = recording->frame(2, 1);
  ASSERT_TRUE(frame);
  EXPECT_EQ(std::memcmp(frame->image.data, pixels.data(), pixels.size()), 0);
  StripeSettings broad;
  broad.sigma = 6;
  EXPECT_TRUE(recording->allows(broad));
  const auto sparse = opened(made().file)->allows(broad);
  ASSERT_FALSE(sparse);
  EXPECT_NE(sparse.error().message().find("--record-full"), std::string::npos);
  broad.sigma = 4;
  EXPECT_TRUE(opened(made().file)->allows(broad));
}

TEST(Recording, MeasuredWithAnotherRecipeItGivesWhatTheFramesWouldHaveGiven) {
  Recipe other = recipe60();
  other.stripe.sigma = 3.4;
  other.stripe.low = 3;
  other.stripe.high = 30;
  other.stripe.gapDistance = 20;
  const auto live = makeVirtualSource(made().rig, {2, 15.0 * 12, false});
  const RunResult expected = run(*live, other, made().rig->calibration());
  const auto source = makeRecordingSource(opened(made().file));
  const RunResult again = run(*source, other, made().rig->calibration());
  EXPECT_EQ(again.profiles, expected.profiles);
  EXPECT_NE(again.profiles, made().live.profiles);
}

TEST(Recording, ReplayInTimeTakesAsLongAsItTook) {
  const auto recording = opened(made().file);
  std::int64_t first = 0, last = 0;
  for (const ChunkPlace& c : recording->chunks())
    if (c.head.kind == ChunkKind::Frame) {
      first = first == 0 ? c.head.timeUs : std::min(first, c.head.timeUs);
      last = std::max(last, c.head.timeUs);
    }
  const auto source = makeRecordingSource(recording, {.paced = true});
  EXPECT_FALSE(source->live());
  const auto start = std::chrono::steady_clock::now();
  const RunResult again = run(*source, recipe60(), made().rig->calibration());
  EXPECT_GE(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            1e-6 * static_cast<double>(last - first));
  EXPECT_EQ(again.profiles, made().live.profiles);
}

}  // namespace
}  // namespace vignole
