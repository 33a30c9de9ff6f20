#include "engine/archive/retention.h"

#include <algorithm>

#include "engine/archive/audit_rows.h"
#include "engine/archive/rail_rows.h"

namespace vignole {

namespace {

constexpr std::size_t kRailsAtOnce = 100;
constexpr TimeUs kDayUs = 86'400'000'000;

TimeUs before(TimeUs now, int days) { return days > 0 ? now - days * kDayUs : 0; }

struct Candidate {
  std::int64_t key = 0;
  std::string id;
  TimeUs beganUs = 0;
  std::uint64_t profiles = 0;
};

/// Old enough rails, oldest first: those that go, and into `plan` why others stay.
std::vector<Candidate> candidates(Database& database, const RetentionPolicy& policy, RetentionPlan& plan) {
  std::vector<Candidate> going;
  database.query(
      "select r.id, r.name, r.began_us, r.profiles, r.verdict, r.held_us, (select count(*) from recording c where "
      "c.rail "
      "= r.id) from rail r where r.began_us < :a and r.state <> :b order by r.id",
      {std::max(plan.beforeUs, plan.rejectedBeforeUs), static_cast<std::int64_t>(RailState::Running)}, "itiiiii",
      [&](const Row& row) {
        const bool rejected = row.integer(4) == static_cast<std::int64_t>(Verdict::Fail) ||
                              row.integer(4) == static_cast<std::int64_t>(Verdict::NotMeasured);
        const TimeUs began = row.integer(2);
        if (!row.null(5)) {
          ++plan.keptHeld;
        } else if (rejected ? began >= plan.rejectedBeforeUs : began >= plan.beforeUs) {
          if (rejected && began < plan.beforeUs) ++plan.keptRejected;
        } else if (policy.keepWithRecording && row.integer(6) > 0) {
          ++plan.keptWithRecording;
        } else {
          going.push_back({row.integer(0), row.text(1), began, static_cast<std::uint64_t>(row.integer(3))});
        }
      });
  return going;
}

std::uint64_t number(const std::optional<Row>& row, std::size_t i) {
  return row ? static_cast<std::uint64_t>(row->integer(i)) : 0;
}

std::uint64_t bytesOf(Database& database, std::int64_t key) {
  return number(database.first("select sum(length(content)) from profile_block where rail = :a", {key}, "i"), 0) +
         number(database.first("select sum(length(content)) from profile_points where rail = :a", {key}, "i"), 0);
}

void count(RetentionPlan& plan, const Candidate& rail, std::uint64_t bytes) {
  ++plan.rails;
  plan.profiles += rail.profiles;
  plan.bytes += bytes;
  plan.firstUs = std::min(plan.firstUs.value_or(rail.beganUs), rail.beganUs);
  plan.lastUs = std::max(plan.lastUs.value_or(rail.beganUs), rail.beganUs);
}

RetentionPlan emptyPlan(const RetentionPolicy& policy, TimeUs now) {
  RetentionPlan plan;
  plan.beforeUs = before(now, policy.keepDays);
  plan.rejectedBeforeUs = before(now, policy.keepRejectedDays);
  plan.pointsBeforeUs = before(now, policy.keepPointsDays);
  return plan;
}

/// Rails that stay and are old enough to lose their points: those of rails that are held stay.
constexpr const char* kLosingPoints = "select id from rail where began_us < :a and state <> :b and held_us is null";

std::vector<std::int64_t> railsLosingPoints(Database& database, const RetentionPlan& plan,
                                            const std::vector<Candidate>& going) {
  std::vector<std::int64_t> rails;
  if (plan.pointsBeforeUs == 0) return rails;
  database.query(kLosingPoints, {plan.pointsBeforeUs, static_cast<std::int64_t>(RailState::Running)}, "i",
                 [&](const Row& row) { rails.push_back(row.integer(0)); });
  std::erase_if(rails, [&](std::int64_t key) {
    return std::binary_search(going.begin(), going.end(), Candidate{key, "", 0, 0},
                              [](const Candidate& a, const Candidate& b) { return a.key < b.key; });
  });
  return rails;
}

std::string namesOf(const std::vector<Candidate>& rails, std::size_t from, std::size_t to) {
  std::string names;
  for (std::size_t i = from; i < to; ++i) names += (names.empty() ? "" : " ") + rails[i].id;
  return names;
}

void countPoints(Database& database, std::int64_t key, RetentionPlan& plan) {
  const auto row =
      database.first("select count(*), sum(length(content)) from profile_points where rail = :a", {key}, "ii");
  plan.profilesLosingPoints += number(row, 0);
  plan.bytesOfPoints += number(row, 1);
}

}  // namespace

Expected<RetentionPlan> planRetention(const Archive& archive, const RetentionPolicy& policy, TimeUs now) {
  return guarded([&] {
    Database& database = *archive.database();
    const Snapshot snapshot(database);
    RetentionPlan plan = emptyPlan(policy, now);
    const std::vector<Candidate> going = candidates(database, policy, plan);
    for (const Candidate& rail : going) count(plan, rail, bytesOf(database, rail.key));
    for (const std::int64_t key : railsLosingPoints(database, plan, going)) countPoints(database, key, plan);
    return plan;
  });
}

Expected<RetentionPlan> applyRetention(const Archive& archive, const RetentionPolicy& policy, TimeUs now,
                                       const std::string& user, const std::string& reason,
                                       const std::function<bool(double)>& progress) {
  return guarded([&] {
    Database& database = *archive.database();
    RetentionPlan plan = emptyPlan(policy, now);
    const std::vector<Candidate> going = candidates(database, policy, plan);
    const std::vector<std::int64_t> losing = railsLosingPoints(database, plan, going);
    const std::size_t all = going.size() + losing.size();
    std::size_t done = 0;
    for (std::size_t from = 0; from < going.size(); from += kRailsAtOnce) {
      const std::size_t to = std::min(from + kRailsAtOnce, going.size());
      Transaction transaction(database);
      std::uint64_t removed = 0;
      RetentionPlan next = plan;
      for (std::size_t i = from; i < to; ++i) {
        const std::uint64_t bytes = bytesOf(database, going[i].key);
        // Held meanwhile: it stays.
        database.run("delete from rail where id = :a and held_us is null", {going[i].key});
        if (database.changedRows() == 0) continue;
        ++removed;
        count(next, going[i], bytes);
      }
      appendAudit(database, systemTimeUs(),
                  {user, "rails pruned", "measured before " + isoTime(plan.beforeUs), reason,
                   std::to_string(removed) + " rails: " + namesOf(going, from, to)});
      transaction.commit();
      plan = next;
      done = to;
      if (progress && !progress(static_cast<double>(done) / static_cast<double>(all))) return plan;
    }
    for (std::size_t from = 0; from < losing.size(); from += kRailsAtOnce) {
      const std::size_t to = std::min(from + kRailsAtOnce, losing.size());
      Transaction transaction(database);
      RetentionPlan next = plan;
      for (std::size_t i = from; i < to; ++i) {
        countPoints(database, losing[i], next);
        // One that is not as it was written does not become whole by this.
        const auto digest = database.first("select digest from rail where id = :a", {losing[i]}, "t");
        const bool whole = digest && digest->text(0) == railDigest(database, losing[i]);
        database.run("delete from profile_points where rail = :a", {losing[i]});
        if (whole && database.changedRows() > 0)
          database.run("update rail set digest = :a where id = :b", {railDigest(database, losing[i]), losing[i]});
      }
      if (next.profilesLosingPoints > plan.profilesLosingPoints)
        appendAudit(database, systemTimeUs(),
                    {user, "points pruned", "measured before " + isoTime(plan.pointsBeforeUs), reason,
                     "points of " + std::to_string(next.profilesLosingPoints - plan.profilesLosingPoints) +
                         " profiles, rails with the keys " + std::to_string(losing[from]) + " to " +
                         std::to_string(losing[to - 1])});
      transaction.commit();
      plan = next;
      done = going.size() + to;
      if (progress && !progress(static_cast<double>(done) / static_cast<double>(all))) return plan;
    }
    return plan;
  });
}

}  // namespace vignole
