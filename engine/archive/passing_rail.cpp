#include "engine/archive/passing_rail.h"

#include <algorithm>
#include <chrono>

#include "engine/archive/audit_rows.h"
#include "engine/archive/kept_texts.h"
#include "engine/archive/rail_rows.h"
#include "engine/database/digest.h"
#include "engine/optics/calibration_age.h"

namespace vignole {

PassingRail::PassingRail(const RailBegin& rail, const RailPapers& papers, std::shared_ptr<const MeasuringSetup> setup,
                         const MeasuringPlace& place, const PointsPolicy& policy, std::size_t pointsMemoryBytes,
                         TimeUs now)
    : setup_(std::move(setup)),
      policy_(policy),
      pointsMemoryBytes_(pointsMemoryBytes),
      summariser_(rail, setup_->recipe, setup_->calibration.id) {
  rail_.uid = newUid();
  rail_.place = place;
  rail_.papers = papers;
  rail_.beganUs = rail_.endedUs = now;
  const auto began = std::chrono::floor<std::chrono::seconds>(
      std::chrono::sys_time<std::chrono::microseconds>(std::chrono::microseconds(now)));
  calibrationWarning_ = warningOf(setup_->calibration, ageOf(setup_->calibration, began));
}

bool PassingRail::keptAnyway(std::uint64_t profile) const {
  return policy_.everyNthProfile > 0 && profile % policy_.everyNthProfile == 0;
}

void PassingRail::pack() {
  if (packed_.empty() && !pending_.empty()) packed_ = packProfiles(pending_);
}

void PassingRail::add(const ProfileResult& result, bool withPoints) {
  packed_.clear();
  const std::uint64_t profile = profilesStored_ + pending_.size();
  summariser_.add(result);
  for (std::size_t d = 0; d < kDimensionCount; ++d)
    if (const auto excess = vignole::excessMm(kDimensions[d], result.measurement.dimensions[d]))
      rail_.excessMm[d] = std::max(rail_.excessMm[d].value_or(*excess), *excess);
  pending_.push_back(recordOf(result.profile, result.registration, result.measurement));
  const bool everyRail = policy_.everyNthRail > 0;
  if (!withPoints || (!keptAnyway(profile) && !policy_.ofRejectedRails && !everyRail)) return;
  Points points{profile, packPoints(result.profile, policy_.coding)};
  if (keptAnyway(profile)) {
    sure_.push_back(std::move(points));
    return;
  }
  undecidedBytes_ += points.content.size();
  undecided_.push_back(std::move(points));
}

void PassingRail::end(const TriggerLedger& ledger, std::vector<StageStatistics> stages, RailState state, TimeUs now) {
  ended_ = true;
  ledger_ = ledger;
  rail_.stages = std::move(stages);
  rail_.state = state;
  rail_.endedUs = now;
}

void PassingRail::storeFirst(Database& database, TimeUs now, StoredRail& rail) const {
  const AuditHead head = auditHead(database);
  rail.auditNumber = head.number;
  rail.auditDigest = head.digest;
  rail.recipe = keepRecipe(database, setup_->recipe, now);
  rail.calibration = keepCalibration(database, setup_->calibration, now, "", "measured with");
  rail.key = insertRail(database, rail);
}

void PassingRail::storePoints(Database& database, const StoredRail& rail, bool undecidedToo) const {
  const auto put = [&](const std::vector<Points>& all) {
    for (const Points& p : all)
      database.run("insert into profile_points (rail, profile, content) values (:a, :b, :c)",
                   {rail.key, static_cast<std::int64_t>(p.profile), p.content});
  };
  put(sure_);
  if (undecidedToo) put(undecided_);
}

void PassingRail::storeEnd(Database& database, StoredRail& rail) const {
  insertLedger(database, rail);
  joinBlocks(database, rail.key);
  database.run("update rail set digest = :a where id = :b", {railDigest(database, rail.key), rail.key});
}

void PassingRail::store(Database& database, TimeUs now) {
  StoredRail next = rail_;
  const std::string section = setup_->recipe.section.name;
  next.summary = summariser_.summary(ledger_);
  next.summary.rail.sectionName = section;
  next.summary.calibrationWarning = calibrationWarning_;
  if (!ended_) {
    next.endedUs = now;
    next.summary.triggers.seen = next.summary.profiles;  // what is known of them so far
  }
  for (DimensionSummary& d : next.summary.dimensions) d.track.clear();
  PerDimension<std::size_t> exceptions = exceptionsStored_;

  Transaction transaction(database);
  if (next.key == 0) storeFirst(database, now, next);
  pack();
  insertBlock(database, next.key, profilesStored_, pending_.size(), packed_);
  updateRail(database, next, exceptions);
  const bool failing = std::any_of(next.summary.dimensions.begin(), next.summary.dimensions.end(),
                                   [](const DimensionSummary& d) { return !d.exceptions.empty(); });
  const bool wholeRail = policy_.everyNthRail > 0 && static_cast<std::uint64_t>(next.key) % policy_.everyNthRail == 0;
  const bool bad =
      failing || (ended_ && (next.summary.verdict == Verdict::Fail || next.summary.verdict == Verdict::NotMeasured));
  const bool keep = wholeRail || (policy_.ofRejectedRails && bad);
  const bool toDisk = keep || (!ended_ && undecidedBytes_ > pointsMemoryBytes_);
  storePoints(database, next, toDisk);
  if (ended_ && !keep && undecidedOnDisk_)
    database.run("delete from profile_points where rail = :a and (:b = 0 or profile % :c <> 0)",
                 {next.key, static_cast<std::int64_t>(policy_.everyNthProfile),
                  static_cast<std::int64_t>(std::max<std::uint64_t>(policy_.everyNthProfile, 1))});
  if (ended_) storeEnd(database, next);
  transaction.commit();

  rail_ = std::move(next);
  exceptionsStored_ = exceptions;
  profilesStored_ += pending_.size();
  pending_.clear();
  packed_.clear();
  sure_.clear();
  if (toDisk || ended_) {
    undecidedOnDisk_ = undecidedOnDisk_ || toDisk;
    undecided_.clear();
    undecidedBytes_ = 0;
  }
}

}  // namespace vignole
