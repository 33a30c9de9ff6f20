#pragma once
// Records the frames of a running inspection, with all that is needed to measure them again. Whoever measures never
// waits on a live line: what finds the queue full loses the recording of its trigger, which is counted.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"
#include "engine/recording/recorded_setup.h"

namespace vignole {

/// Which rails' recordings are kept when the rail has passed; by default all. A rail that fails or was not measured
/// counts as rejected; one whose verdict never comes (a stop in the middle of it) is kept.
struct KeepPolicy {
  bool all = true;
  bool rejected = false;
  std::uint64_t everyNth = 0;  ///< 0: none
};

struct RecordingOrder {
  /// A file for everything, or a folder that exists: in it one file a rail, ID-TIME.vgr.
  std::filesystem::path path;
  bool whole = false;  ///< every pixel (1.4 MB a frame before packing) instead of sparse frames
  KeepPolicy keep;     ///< needs a folder
  /// A file that has grown to this goes on in a next one (NAME-2.vgr), which is a recording by itself. 0: no limit.
  std::uint64_t mostMbOfFile = 0;
  /// Of all recordings in the folder: the oldest are removed. 0: no limit.
  std::uint64_t mostMbOfFolder = 0;
  RecordedSetup setup;
  std::function<RailNotes(const RailBegin&)> notes;  ///< asked once a rail and camera; may be empty
};

struct FrameRecorderSettings {
  bool live = true;  ///< false: who measures waits where packing is slower
  /// Of each camera, that wait to be packed: they keep buffers of the source.
  std::size_t framesHeld = 8;
  double syncEveryS = 1;  ///< so much a power cut may cost
};

struct RecorderState {
  bool recording = false;
  std::filesystem::path path;  ///< what start() was given
  std::string failure;         ///< why nothing is recorded though asked for; empty: all is well
  double megabytes = 0;        ///< written since the start
  std::uint64_t triggers = 0, frames = 0;
  std::uint64_t wholeFrames = 0;  ///< of them
  std::uint64_t dropped = 0;      ///< triggers whose recording was given up
  std::uint64_t filesKept = 0, filesDiscarded = 0;
  double keptShare = 0;     ///< of the pixels, mean
  double packCpuMs = 0;     ///< CPU time of packing and writing, a frame
  std::size_t waiting = 0;  ///< frames in the queue
};

/// Any thread may start, stop and ask. Triggers count on while it lives: one for each run of a source.
class FrameRecorder {
 public:
  explicit FrameRecorder(FrameRecorderSettings settings = {});
  ~FrameRecorder();  ///< as stop(), the error lost
  FrameRecorder(const FrameRecorder&) = delete;
  FrameRecorder& operator=(const FrameRecorder&) = delete;

  /// From the next trigger on, before or in the middle of a run. Refuses while it records.
  [[nodiscard]] Expected<void> start(RecordingOrder order);
  /// Waits until all that was handed over is written, then closes. Does nothing if it does not record.
  [[nodiscard]] Expected<void> stop();
  [[nodiscard]] RecorderState state() const;
  /// Recipe and calibration of the rails to come (in a folder: of the next file).
  void use(const Recipe& recipe, const RigCalibration& calibration);
  /// To be told of every rail when it has passed the last stage, if files are kept by verdict.
  void railPassed(const RailBegin& rail, Verdict verdict);
  /// The rail in the gauge is kept whatever its verdict.
  void keepThisRail();

  // What the taps call.
  void sourceGave(int camera, const FrameMessage& message);
  void extracted(const Frame& frame, const StripeResult& stripe);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The source as it is; the recorder hears what it gives.
[[nodiscard]] std::unique_ptr<FrameSource> tapped(std::unique_ptr<FrameSource> source,
                                                  std::shared_ptr<FrameRecorder> recorder);
/// `watch`, and the recorder gets what is extracted. Both taps are needed.
[[nodiscard]] InspectionObserver tapped(InspectionObserver watch, std::shared_ptr<FrameRecorder> recorder);

}  // namespace vignole
