#pragma once
// Into which file what is recorded goes, and which files stay: one for everything, or one a rail that is kept or
// dropped when the rail has passed; a next one when a file has grown large.

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/recording/frame_recorder.h"
#include "engine/recording/recording_writer.h"
#include "engine/recording/sparse_frame.h"

namespace vignole {

/// One thread, but for sync() and the counters.
class RecordingFiles {
 public:
  /// Makes the file for everything, so that an error shows at once; files of rails come with their rails.
  [[nodiscard]] static Expected<std::unique_ptr<RecordingFiles>> open(RecordingOrder order, std::uint64_t fromTrigger);

  /// One camera's stream tells of a rail, of which `from` is the first trigger that is recorded.
  void begin(int camera, const RailBegin& rail, std::uint64_t from);
  /// Whether what belongs to this trigger goes anywhere.
  [[nodiscard]] bool wants(std::uint64_t trigger) const;
  /// Frame, Lost, Dropped, RailEnd (its trigger is the one behind the last), SourceEnd.
  void add(const ChunkHead& head, std::span<const std::uint8_t> bytes);
  void passed(const RailBegin& rail, Verdict verdict);
  void keepLatest();
  void use(Recipe recipe, RigCalibration calibration);
  [[nodiscard]] Expected<void> close();
  [[nodiscard]] FrameKind frameKind() const { return order_.whole ? FrameKind::Whole : FrameKind::Sparse; }

  void sync() const;
  [[nodiscard]] std::string failure() const;
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t kept() const { return kept_; }
  [[nodiscard]] std::uint64_t discarded() const { return discarded_; }

 private:
  struct File {
    std::uint64_t from = 0;
    std::shared_ptr<RecordingWriter> writer;  ///< null: this rail is not recorded
    std::optional<RailBegin> rail;            ///< as it was told; of the file for everything: the latest
    bool keep = false;                        ///< whatever the verdict
  };
  explicit RecordingFiles(RecordingOrder order);
  [[nodiscard]] File* fileOf(std::uint64_t trigger);
  [[nodiscard]] File* fileOf(const RailBegin& rail);
  Expected<void> make(File& file, const std::filesystem::path& path);
  void makeForRail(const RailBegin& rail, std::uint64_t from);
  void writeBegin(File& file, int camera, const RailBegin& rail, std::uint64_t from);
  void growOver(File& full);
  void finish(std::deque<File>::iterator file, bool keep);
  void fail(const Error& error);
  [[nodiscard]] std::filesystem::path nextPath();

  RecordingOrder order_;
  bool folder_ = false;
  std::deque<File> files_;  // by `from`
  std::uint64_t highest_ = 0, rails_ = 0, parts_ = 1;
  std::optional<Error> error_;
  std::atomic<std::uint64_t> bytes_ = 0, kept_ = 0, discarded_ = 0;
  mutable std::mutex mutex_;  // of writers_ and failure_
  std::vector<std::shared_ptr<RecordingWriter>> writers_;
  std::string failure_;
};

/// Removes the oldest recordings of a folder until they take no more than so much; `latest` stays.
void pruneRecordings(const std::filesystem::path& folder, std::uint64_t mostMb, const std::filesystem::path& latest);

}  // namespace vignole
