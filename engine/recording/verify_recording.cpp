#include "engine/recording/verify_recording.h"

#include "engine/acquisition/frame_memory.h"
#include "engine/inspection/inspection.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {

namespace {

constexpr std::size_t kMostFindings = 100;

std::string whereOf(const ChunkHead& head) {
  const std::string trigger = "trigger " + std::to_string(head.trigger);
  return head.camera < kCameraCount ? "camera " + std::to_string(head.camera + 1) + ", " + trigger : trigger;
}

/// One after the other: unpacks, extracts, compares.
class Replay {
 public:
  explicit Replay(const Recording& recording) {
    const auto& setup = recording.setup();
    if (!setup) {
      why_ = "it is not known any more with which recipe they were extracted";
    } else if (setup->simdTarget != stripeSimdTarget()) {
      why_ = "they were extracted on " + setup->simdTarget + ", this machine works with " + stripeSimdTarget();
    } else {
      for (int camera = 0; camera < kCameraCount; ++camera)
        extractors_.emplace_back(setup->recipe.stripe,
                                 extractionOptics(setup->calibration, setup->recipe.section, camera));
    }
  }

  void check(const ChunkHead& head, const PackedBytes& packed, RecordingCheck& result) {
    const auto size = packedSize(packed);
    if (!size) return find(head, size.error().what, result);
    ++result.frames;
    result.sparseFrames += size->kind == FrameKind::Sparse ? 1 : 0;
    const std::size_t bytes = static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height);
    if (bytes > room_) {
      pixels_ = makeFrameMemory(bytes);
      room_ = bytes;
    }
    const MutableImageView image{pixels_.get(), size->width, size->height, size->width};
    if (const auto done = unpacker_.unpack(packed, image); !done) return find(head, done.error().what, result);
    if (head.camera >= kCameraCount) return find(head, "is of no camera", result);
    if (!why_.empty() || head.digest == 0) {
      result.whyNotCompared = why_.empty() ? "no points were extracted when they were recorded" : why_;
      return;
    }
    extractors_[head.camera].extract(image, stripe_);
    ++result.compared;
    if (digest_.of(stripe_) == head.digest) return;
    ++result.different;
    add({whereOf(head), "extraction gives other points than when it was recorded"}, result);
  }

  /// Of the frames to come the recording does not say so.
  void recipeChanged() { why_ = "their recipe or calibration is not the first one"; }

  static void find(const ChunkHead& head, const std::string& what, RecordingCheck& result) {
    ++result.damagedChunks;
    add({whereOf(head), what}, result);
  }
  static void add(RecordingFinding finding, RecordingCheck& result) {
    if (result.findings.size() < kMostFindings) result.findings.push_back(std::move(finding));
  }

 private:
  std::vector<StripeExtractor> extractors_;
  std::string why_;
  FrameUnpacker unpacker_;
  FrameMemory pixels_;
  std::size_t room_ = 0;
  StripeResult stripe_;
  StripeDigest digest_;
};

}  // namespace

RecordingCheck verifyRecording(const Recording& recording, const std::function<void(double)>& progress,
                               const std::stop_token& stop) {
  RecordingCheck result;
  Replay replay(recording);
  std::optional<std::uint64_t> setup;
  for (const ChunkPlace& chunk : recording.chunks()) {
    if (stop.stop_requested()) break;
    ++result.chunks;
    const auto bytes = recording.read(chunk);
    if (!bytes) {
      Replay::find(chunk.head, bytes.error().what, result);
      continue;
    }
    if (chunk.head.kind == ChunkKind::Setup) {
      if (setup && *setup != chunk.head.checksum) replay.recipeChanged();
      setup = chunk.head.checksum;
    }
    if (chunk.head.kind == ChunkKind::Frame) replay.check(chunk.head, *bytes, result);
    progress(static_cast<double>(chunk.offset) / static_cast<double>(recording.bytes()));
  }
  return result;
}

}  // namespace vignole
