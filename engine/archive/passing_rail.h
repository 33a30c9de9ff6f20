#pragma once
// A rail as it passes into the archive: what has come and is not yet on disk, and how it gets there. On the writer's
// thread; for this room alone.

#include <optional>

#include "engine/archive/rail_writer.h"
#include "engine/database/database.h"
#include "engine/packing/profile_record.h"

namespace vignole {

class PassingRail {
 public:
  PassingRail(const RailBegin& rail, const RailPapers& papers, std::shared_ptr<const MeasuringSetup> setup,
              const MeasuringPlace& place, const PointsPolicy& policy, std::size_t pointsMemoryBytes, TimeUs now);

  /// `withPoints`: result.profile has them.
  void add(const ProfileResult& result, bool withPoints);
  void addLost() { ++rail_.notStored; }
  void end(const TriggerLedger& ledger, std::vector<StageStatistics> stages, RailState state, TimeUs now);
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] bool dirty() const { return ended_ || rail_.key == 0 || !pending_.empty(); }
  [[nodiscard]] std::size_t pending() const { return pending_.size(); }

  /// Does now what store() would do first, and needs no database: on another thread.
  void pack();
  /// Everything that has come goes on disk in one transaction; after a failure nothing has, and it can be tried again.
  /// Throws DatabaseFailure.
  void store(Database& database, TimeUs now);

 private:
  struct Points {
    std::uint64_t profile;
    Bytes content;
  };
  [[nodiscard]] bool keptAnyway(std::uint64_t profile) const;
  void storeFirst(Database& database, TimeUs now, StoredRail& rail) const;
  void storePoints(Database& database, const StoredRail& rail, bool undecidedToo) const;
  void storeEnd(Database& database, StoredRail& rail) const;

  StoredRail rail_;
  std::shared_ptr<const MeasuringSetup> setup_;
  std::string calibrationWarning_;
  PointsPolicy policy_;
  std::size_t pointsMemoryBytes_;
  RailSummariser summariser_;
  TriggerLedger ledger_;
  PerDimension<std::size_t> exceptionsStored_{};
  std::uint64_t profilesStored_ = 0;
  std::vector<ProfileRecord> pending_;
  Bytes packed_;                          ///< pending_ as a block; empty: not packed yet
  std::vector<Points> sure_, undecided_;  ///< undecided: only if the rail is rejected
  std::size_t undecidedBytes_ = 0;
  bool undecidedOnDisk_ = false;
  bool ended_ = false;
};

}  // namespace vignole
