#pragma once
// Writes rails into an archive while they pass, on a thread of its own: at least once in commitEveryS what has been
// measured is on disk. Whoever measures never waits for the disk on a live line: what finds the queue full loses first
// its points, then itself, and is counted. Into an archive on a server by way of a file (rail_delivery.h).

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "engine/archive/rail_record.h"
#include "engine/packing/point_pack.h"

namespace vignole {

/// Whose points are kept. A rail counts as rejected when it fails or was not measured.
struct PointsPolicy {
  bool ofRejectedRails = true;
  std::uint64_t everyNthProfile = 100;  ///< of every rail; 0: none
  std::uint64_t everyNthRail = 0;       ///< all of every N-th rail; 0: none
  PointCoding coding = PointCoding::Compact;
};

struct RailWriterSettings {
  MeasuringPlace place;
  PointsPolicy points;
  double commitEveryS = 0.5;
  bool live = true;                        ///< false: who measures waits where the disk is slower
  std::size_t queueProfiles = 256;         ///< with points
  std::size_t queueWithoutPoints = 16384;  ///< beyond, profiles are lost and counted (live)
  std::size_t pointsMemoryMb = 256;        ///< of a rail whose verdict is not known yet; beyond, on disk
  std::filesystem::path waitingFolder;     ///< where rails wait for a server; empty: the user's own state
  double deliveryRetryS = 2;               ///< a server that was away is asked again after so long
};

/// What the rails to come are measured with.
struct MeasuringSetup {
  Recipe recipe;
  RigCalibration calibration;
};

struct RailWriterStatus {
  std::size_t queued = 0, queueHighWater = 0;  ///< profiles
  std::size_t queueCapacity = 0;               ///< beyond, profiles are lost
  std::uint64_t railsStored = 0, profilesStored = 0;
  std::uint64_t pointsDropped = 0;  ///< profiles that lost their points
  std::uint64_t profilesLost = 0;
  std::uint64_t railsWaiting = 0;  ///< on disk, for the server
  std::string failure;             ///< why nothing is written, or goes to the server, at the moment; empty: all is well
};

/// begin, add and end are called by one thread (the inspection's last stage) and are quick; the rest by any.
class RailWriter {
 public:
  /// Makes the archive if there is none; a server that is away is no obstacle on a live line. Rails that a program
  /// which died left running here (same `place.line`) become interrupted. Refuses a second writer on the same file.
  [[nodiscard]] static Expected<std::unique_ptr<RailWriter>> open(std::string_view url, RailWriterSettings settings);
  ~RailWriter();  ///< as close(), the error lost
  RailWriter(const RailWriter&) = delete;
  RailWriter& operator=(const RailWriter&) = delete;

  void begin(const RailBegin& rail, const RailPapers& papers, std::shared_ptr<const MeasuringSetup> setup);
  void add(const ProfileResult& result);
  void end(const TriggerLedger& ledger, const std::vector<StageStatistics>& stages);

  [[nodiscard]] RailWriterStatus status() const;
  /// Waits until everything is on disk, then stops. An error if that failed, or if rails still wait for a server.
  [[nodiscard]] Expected<void> close();

 private:
  struct Impl;
  explicit RailWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
