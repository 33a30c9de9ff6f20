#pragma once
// Stored rails: found, opened, replayed, removed.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/rail_record.h"
#include "engine/packing/profile_record.h"

namespace vignole {

/// What one dimension must have been like somewhere on the rail.
struct DimensionQuery {
  Dimension dimension = Dimension::RH;
  /// At least one profile lay beyond a limit by more than this (0: out of tolerance at all; negative: nearer to it).
  std::optional<double> excessAboveMm;
  std::optional<Verdict> verdict;
};

/// Everything that is set must hold.
struct RailQuery {
  std::optional<TimeUs> fromUs, toUs;         ///< began at or after, began before
  std::string railId, heat, section, recipe;  ///< empty: any. Ids and heats match from their beginning
  std::vector<Verdict> verdicts;              ///< empty: any
  std::optional<RailState> state;
  std::vector<DimensionQuery> dimensions;
  std::size_t limit = 100;
  std::int64_t beforeKey = 0;  ///< the next page: the key of the last one found; 0: from the newest
};

/// A rail in a list.
struct RailLine {
  std::int64_t key = 0;
  std::string id, heat, section, recipe, line;
  TimeUs beganUs = 0, endedUs = 0;
  double lengthM = 0;
  std::uint64_t profiles = 0;
  Verdict verdict = Verdict::NotMeasured;
  RailState state = RailState::Finished;
  std::optional<Dimension> worst;  ///< the dimension furthest beyond a limit, or nearest to one
  double worstExcessMm = 0;
};

/// Why a rail stays, whatever its age.
struct RailHold {
  TimeUs sinceUs = 0;
  std::string why;
};

/// Frames that were recorded while a rail passed: a file beside the archive.
struct RecordingReference {
  std::string place;   ///< path or URL
  std::string digest;  ///< of the file, as its room makes it
  TimeUs storedUs = 0;
};

/// Thread-safe as its archive is.
class RailArchive {
 public:
  explicit RailArchive(const Archive& archive);

  [[nodiscard]] Expected<std::vector<RailLine>> search(const RailQuery& query) const;  ///< newest first
  [[nodiscard]] Expected<std::uint64_t> count() const;
  /// With the tracks of its dimensions, at most `trackBins` of equal length each.
  [[nodiscard]] Expected<StoredRail> open(std::int64_t key, std::size_t trackBins = 512) const;
  /// Profiles `first` .. `first + count`, as far as there are any, for charts and replay.
  [[nodiscard]] Expected<std::vector<ProfileRecord>> profiles(std::int64_t key, std::uint64_t first = 0,
                                                              std::uint64_t count = kMaxColumn) const;
  /// Which profiles have their points, in order.
  [[nodiscard]] Expected<std::vector<std::uint64_t>> profilesWithPoints(std::int64_t key) const;
  /// Empty where they were not kept.
  [[nodiscard]] Expected<std::optional<Profile>> points(std::int64_t key, std::uint64_t profile) const;
  /// All of them, as they are kept (packPoints), by number of the profile.
  [[nodiscard]] Expected<std::map<std::uint64_t, Bytes>> packedPoints(std::int64_t key) const;
  /// The text of the recipe and of the calibration that it was measured with; empty where there is none.
  [[nodiscard]] Expected<std::string> recipeText(const StoredRail& rail) const;
  [[nodiscard]] Expected<std::string> calibrationText(const StoredRail& rail) const;
  [[nodiscard]] Expected<std::optional<RailHold>> hold(std::int64_t key) const;
  /// Held from now on, or no longer (empty `why`). Goes into the audit trail.
  [[nodiscard]] Expected<void> setHold(std::int64_t key, const std::string& why, const std::string& user,
                                       const std::string& reason);
  [[nodiscard]] Expected<std::vector<RecordingReference>> recordings(std::int64_t key) const;  ///< oldest first
  [[nodiscard]] Expected<void> addRecording(std::int64_t key, const RecordingReference& recording);
  /// Goes into the audit trail. Refused for a rail that is held.
  [[nodiscard]] Expected<void> remove(std::int64_t key, const std::string& user, const std::string& reason);

 private:
  std::shared_ptr<Database> database_;
};

}  // namespace vignole
