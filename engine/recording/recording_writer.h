#pragma once
// A recording as it is written: FILE.part, to which chunks are appended; FILE once it is closed.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/recording/chunk.h"

namespace vignole {

/// Microseconds since 1970, UTC.
[[nodiscard]] std::int64_t recordingTimeUs();

/// One thread, but for sync(). What was appended before the last sync() survives a power cut, what was appended at all
/// survives a kill.
class RecordingWriter {
 public:
  /// Nothing is seen at `file` before commit(); what lies there stays until then. A FILE.part that somebody left is
  /// left alone.
  [[nodiscard]] static Expected<std::shared_ptr<RecordingWriter>> create(const std::filesystem::path& file);
  ~RecordingWriter();  ///< leaves the part as it is
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Sets the head's checksum, size and time. False once the disk has failed: the file ends before this chunk.
  bool append(ChunkHead head, std::span<const std::uint8_t> bytes = {});
  bool append(ChunkHead head, std::string_view text);
  /// Any thread.
  void sync() const;
  [[nodiscard]] std::uint64_t bytes() const { return end_; }
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  /// Empty: all is well.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  /// Index, sync, rename. After a failure the part stays and the error names it.
  [[nodiscard]] Expected<void> commit();
  /// Takes the part away.
  void discard();

 private:
  RecordingWriter() = default;
  void fail();
  int descriptor_ = -1;
  std::filesystem::path target_, part_;
  std::uint64_t end_ = 0;
  std::vector<ChunkPlace> chunks_;
  std::string failure_;
};

}  // namespace vignole
