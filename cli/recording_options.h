#pragma once
// `inspect` with recordings: the options of --record, and a recording as its source.

#include <memory>
#include <string>

#include "engine/recording/frame_recorder.h"
#include "engine/recording/recording.h"

namespace CLI {
class App;
}

namespace vignole::cli {

struct RecordOptions {
  bool whole = false;
  std::string keep = "all";  ///< all, rejected, or N (every N-th); several joined by |
  std::uint64_t fileMb = 0, folderMb = 0;
};
void addRecordOptions(CLI::App& command, std::string& record, RecordOptions& options);
[[nodiscard]] Expected<void> checkRecordOptions(const RecordOptions& options, const std::string& record);
/// Of options that were checked.
[[nodiscard]] RecordingOrder recordingOrder(const RecordOptions& options, const std::string& record,
                                            RecordedSetup setup);

/// A recording that is about to be measured.
class RecordedRun {
 public:
  [[nodiscard]] static Expected<RecordedRun> open(const std::string& file, bool paced);
  [[nodiscard]] const Recording& recording() const { return *recording_; }
  /// Null if it cannot be read any more.
  [[nodiscard]] const RecordedSetup* setup() const { return recording_->setup() ? &*recording_->setup() : nullptr; }
  [[nodiscard]] Expected<Recipe> recipe() const;
  [[nodiscard]] std::unique_ptr<FrameSource> source() const;
  [[nodiscard]] double triggers() const;  ///< at least 1
  /// One line each on stderr: damage, another SIMD target.
  void warn() const;

 private:
  RecordedRun(std::shared_ptr<const Recording> recording, bool paced)
      : recording_(std::move(recording)), paced_(paced) {}
  std::shared_ptr<const Recording> recording_;
  bool paced_;
};

/// Empty where numbers are equal to the last bit.
[[nodiscard]] std::string otherMachine(const RecordedSetup& setup);

}  // namespace vignole::cli
