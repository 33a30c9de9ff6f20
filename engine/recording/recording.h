#pragma once
// A recording to be read: what was recorded when, and any frame by its trigger. Files may be cut off, damaged or made
// by somebody with bad intentions: what can be read of them is read, and no size in them is believed.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/acquisition/frame.h"
#include "engine/geometry/expected.h"
#include "engine/recording/chunk.h"
#include "engine/recording/recorded_setup.h"
#include "engine/recording/sparse_frame.h"

namespace vignole {

struct RecordedRail {
  RecordedRailBegin begin;
  std::optional<std::uint64_t> endTrigger;  ///< empty: the recording ends before the rail does
  std::uint64_t triggers = 0;               ///< of which any camera has a frame
  std::uint64_t frames = 0, lost = 0, dropped = 0;
};

/// What one camera's stream gives at a trigger, in the order in which it gives it.
struct RecordedEvent {
  enum class Kind : std::uint8_t { RailEnd, RailBegin, Frame, Lost, Dropped };  ///< at equal triggers in this order
  Kind kind = Kind::Frame;
  std::uint64_t trigger = 0;
  std::size_t chunk = 0;  ///< in chunks(); of RailBegin: in rails()
};

/// Immutable; any thread.
class Recording {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<const Recording>> open(const std::filesystem::path& file);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// False: whoever wrote it did not come to the end, or still writes.
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] std::uint64_t damagedBytes() const { return damagedBytes_; }
  /// One line each: what could not be read and why; empty if all is well.
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

  /// What the first rail was measured with; empty if that is damaged (problems() says why).
  [[nodiscard]] const std::optional<RecordedSetup>& setup() const { return setup_; }
  /// Setups that differ from it came later.
  [[nodiscard]] bool setupChanges() const { return setupChanges_; }
  [[nodiscard]] const std::vector<RecordedRail>& rails() const { return rails_; }
  [[nodiscard]] const std::vector<ChunkPlace>& chunks() const { return chunks_; }
  [[nodiscard]] const std::vector<RecordedEvent>& events(int camera) const {
    return events_[static_cast<std::size_t>(camera)];
  }
  [[nodiscard]] const std::string& endError(int camera) const { return endErrors_[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] const std::set<std::uint64_t>& dropped() const { return dropped_; }

  /// Whether frames with another sigma give what the camera's own would; the error says what to do.
  [[nodiscard]] Expected<void> allows(const StripeSettings& settings) const;

  /// The bytes of a chunk, checked.
  [[nodiscard]] Expected<PackedBytes> read(const ChunkPlace& chunk) const;
  /// One picture, for who looks. The error tells whether there is none or a damaged one.
  [[nodiscard]] Expected<Frame> frame(int camera, std::uint64_t trigger) const;

 private:
  explicit Recording(std::filesystem::path file) : file_(std::move(file)) {}
  Expected<void> load();
  bool readAt(std::uint64_t offset, std::span<std::uint8_t> to) const;
  bool loadIndex();
  void scan();
  void interpret();
  void interpretText(std::size_t chunk);
  void order();
  [[nodiscard]] std::size_t railOf(std::uint64_t trigger) const;
  void problem(std::string line);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t bytes_ = 0, damagedBytes_ = 0, frames_ = 0;
  bool closed_ = false, setupChanges_ = false, sparse_ = false;
  std::vector<std::string> problems_;
  std::vector<ChunkPlace> chunks_;
  std::optional<RecordedSetup> setup_;
  std::string setupText_;
  std::vector<RecordedRail> rails_;  // by first trigger
  std::set<std::uint64_t> dropped_;
  std::array<std::vector<RecordedEvent>, kCameraCount> events_;
  std::array<std::string, kCameraCount> endErrors_;
};

}  // namespace vignole
