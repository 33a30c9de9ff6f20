#include "engine/archive/rail_archive.h"

#include <algorithm>
#include <cmath>

#include "engine/archive/audit_rows.h"
#include "engine/archive/rail_rows.h"
#include "engine/packing/point_pack.h"

namespace vignole {

namespace {

/// Conditions of a query, each with its parameters; the values never become part of the text.
class Conditions {
 public:
  /// `condition` names its parameter :x.
  void add(std::string condition, SqlValue value) {
    const std::size_t at = condition.find(":x");
    condition.replace(at, 2, ":p" + std::to_string(values_.size()));
    text_ += (text_.empty() ? " where " : " and ") + condition;
    values_.push_back(std::move(value));
  }
  std::string parameter(SqlValue value) {
    values_.push_back(std::move(value));
    return ":p" + std::to_string(values_.size() - 1);
  }
  void addText(const std::string& condition) { text_ += (text_.empty() ? " where " : " and ") + condition; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const SqlValues& values() const { return values_; }

 private:
  std::string text_;
  SqlValues values_;
};

void addPrefix(Conditions& conditions, const std::string& column, const std::string& prefix) {
  if (prefix.empty()) return;
  conditions.add(column + " >= :x", prefix);
  conditions.add(column + " < :x", prefix + "\xf4\x8f\xbf\xbf");  // the greatest character
}

void addDimension(Conditions& conditions, const DimensionQuery& query) {
  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };
  std::string inner = "r.id in (select rail from rail_dimension where dimension = " +
                      conditions.parameter(whole(index(query.dimension)));
  if (query.excessAboveMm) inner += " and excess_mm > " + conditions.parameter(*query.excessAboveMm);
  if (query.verdict) inner += " and verdict = " + conditions.parameter(whole(*query.verdict));
  conditions.addText(inner + ")");
}

Conditions conditionsOf(const RailQuery& query) {
  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };
  Conditions conditions;
  if (query.beforeKey > 0) conditions.add("r.id < :x", query.beforeKey);
  if (query.fromUs) conditions.add("r.began_us >= :x", *query.fromUs);
  if (query.toUs) conditions.add("r.began_us < :x", *query.toUs);
  addPrefix(conditions, "r.name", query.railId);
  addPrefix(conditions, "r.heat", query.heat);
  if (!query.section.empty()) conditions.add("r.section = :x", query.section);
  if (!query.recipe.empty()) conditions.add("r.recipe_name = :x", query.recipe);
  if (query.state) conditions.add("r.state = :x", whole(*query.state));
  if (!query.verdicts.empty()) {
    std::string list;
    for (const Verdict v : query.verdicts) list += (list.empty() ? "" : ", ") + conditions.parameter(whole(v));
    conditions.addText("r.verdict in (" + list + ")");
  }
  for (const DimensionQuery& d : query.dimensions) addDimension(conditions, d);
  return conditions;
}

void addWorst(Database& database, RailLine& line) {
  const auto worst = database.first(
      "select dimension, excess_mm from rail_dimension where rail = :a and excess_mm is not null "
      "order by excess_mm desc limit 1",
      {line.key}, "ir");
  if (!worst || worst->integer(0) < 0 || worst->integer(0) >= static_cast<std::int64_t>(kDimensionCount)) return;
  line.worst = kDimensions[static_cast<std::size_t>(worst->integer(0))];
  line.worstExcessMm = worst->real(1);
}

void addToTrack(std::vector<TrackBin>& track, double positionM, double widthM, double valueMm) {
  const auto bin = static_cast<std::size_t>(positionM / widthM + 1e-6);
  while (track.size() <= bin) {
    TrackBin empty;
    empty.positionM = (static_cast<double>(track.size()) + 0.5) * widthM;
    track.push_back(empty);
  }
  TrackBin& b = track[bin];
  b.minMm = b.count == 0 ? valueMm : std::min(b.minMm, valueMm);
  b.maxMm = b.count == 0 ? valueMm : std::max(b.maxMm, valueMm);
  b.meanMm += (valueMm - b.meanMm) / ++b.count;
}

/// Values along the rail in bins of equal length, up to the last that was measured.
void addTracks(RailSummary& summary, const std::vector<ProfileRecord>& profiles, std::size_t bins) {
  const double lengthM = summary.rail.lengthMm > 0 ? summary.rail.lengthMm / 1000 : summary.lengthM;
  const double widthM =
      std::max(summary.rail.spacingMm / 1000, lengthM / static_cast<double>(std::max<std::size_t>(bins, 1)));
  if (!(widthM > 0)) return;
  for (const ProfileRecord& profile : profiles) {
    const double positionM = profile.positionMm / 1000;
    if (!(positionM >= 0) || positionM > summary.lengthM + widthM) continue;  // damaged: no bins without end
    for (std::size_t d = 0; d < kDimensionCount; ++d)
      if (const auto& value = profile.dimensions[d].valueMm)
        addToTrack(summary.dimensions[d].track, positionM, widthM, *value);
  }
}

}  // namespace

RailArchive::RailArchive(const Archive& archive) : database_(archive.database()) {}

Expected<std::vector<RailLine>> RailArchive::search(const RailQuery& query) const {
  return guarded([&] {
    const auto held = database_->lock();
    Conditions conditions = conditionsOf(query);
    const std::string limit = conditions.parameter(atMost(query.limit));
    std::vector<RailLine> lines;
    database_->query(
        "select r.id, r.name, r.heat, r.section, r.recipe_name, r.line, r.began_us, r.ended_us, r.length_m, "
        "r.profiles, r.verdict, r.state from rail r" +
            conditions.text() + " order by r.id desc limit " + limit,
        conditions.values(),
        "ittttt"
        "iiriii",
        [&](const Row& row) {
          RailLine line;
          line.key = row.integer(0);
          line.id = row.text(1);
          line.heat = row.text(2);
          line.section = row.text(3);
          line.recipe = row.text(4);
          line.line = row.text(5);
          line.beganUs = row.integer(6);
          line.endedUs = row.integer(7);
          line.lengthM = row.real(8);
          line.profiles = static_cast<std::uint64_t>(row.integer(9));
          line.verdict = static_cast<Verdict>(std::clamp<std::int64_t>(row.integer(10), 0, 4));
          line.state = static_cast<RailState>(std::clamp<std::int64_t>(row.integer(11), 0, 2));
          lines.push_back(std::move(line));
        });
    for (RailLine& line : lines) addWorst(*database_, line);
    return lines;
  });
}

Expected<std::uint64_t> RailArchive::count() const {
  return guarded([&] {
    const auto row = database_->first("select count(*) from rail", {}, "i");
    return static_cast<std::uint64_t>(row ? row->integer(0) : 0);
  });
}

Expected<StoredRail> RailArchive::open(std::int64_t key, std::size_t trackBins) const {
  return guarded([&] {
    const auto held = database_->lock();
    StoredRail rail = loadRail(*database_, key);
    addTracks(rail.summary, loadProfiles(*database_, key, 0, kMaxColumn), trackBins);
    return rail;
  });
}

Expected<std::vector<ProfileRecord>> RailArchive::profiles(std::int64_t key, std::uint64_t first,
                                                           std::uint64_t count) const {
  return guarded([&] { return loadProfiles(*database_, key, first, count); });
}

Expected<std::vector<std::uint64_t>> RailArchive::profilesWithPoints(std::int64_t key) const {
  return guarded([&] {
    std::vector<std::uint64_t> profiles;
    database_->query("select profile from profile_points where rail = :a order by profile", {key}, "i",
                     [&](const Row& row) { profiles.push_back(static_cast<std::uint64_t>(row.integer(0))); });
    return profiles;
  });
}

Expected<std::optional<Profile>> RailArchive::points(std::int64_t key, std::uint64_t profile) const {
  return guarded([&]() -> std::optional<Profile> {
    const auto row = database_->first("select content from profile_points where rail = :a and profile = :b",
                                      {key, static_cast<std::int64_t>(profile)}, "b");
    if (!row) return {};
    return orThrow(unpackPoints(row->bytes(0)));
  });
}

Expected<std::map<std::uint64_t, Bytes>> RailArchive::packedPoints(std::int64_t key) const {
  return guarded([&] {
    std::map<std::uint64_t, Bytes> all;
    database_->query("select profile, content from profile_points where rail = :a order by profile", {key}, "ib",
                     [&](const Row& row) { all.emplace(static_cast<std::uint64_t>(row.integer(0)), row.bytes(1)); });
    return all;
  });
}

Expected<std::string> RailArchive::recipeText(const StoredRail& rail) const {
  return guarded([&] {
    const auto row = database_->first("select content from recipe where id = :a", {rail.recipe}, "t");
    return row ? row->text(0) : std::string();
  });
}

Expected<std::string> RailArchive::calibrationText(const StoredRail& rail) const {
  return guarded([&] {
    const auto row = database_->first("select content from calibration where id = :a", {rail.calibration}, "t");
    return row ? row->text(0) : std::string();
  });
}

Expected<std::optional<RailHold>> RailArchive::hold(std::int64_t key) const {
  return guarded([&]() -> std::optional<RailHold> {
    const auto row = database_->first("select held_us, held_why from rail where id = :a", {key}, "it");
    if (!row || row->null(0)) return {};
    return RailHold{row->integer(0), row->text(1)};
  });
}

Expected<void> RailArchive::setHold(std::int64_t key, const std::string& why, const std::string& user,
                                    const std::string& reason) {
  return guarded([&] {
    Transaction transaction(*database_);
    const StoredRail rail = loadRail(*database_, key);
    const TimeUs now = systemTimeUs();
    appendAudit(*database_, now,
                {user, why.empty() ? "rail released" : "rail held", rail.summary.rail.id, reason,
                 "uid " + rail.uid + (why.empty() ? "" : ", " + why)});
    database_->run("update rail set held_us = :a, held_why = :b where id = :c",
                   {why.empty() ? SqlValue() : SqlValue(now), why.empty() ? SqlValue() : SqlValue(why), key});
    transaction.commit();
  });
}

Expected<std::vector<RecordingReference>> RailArchive::recordings(std::int64_t key) const {
  return guarded([&] {
    std::vector<RecordingReference> all;
    database_->query("select place, digest, stored_us from recording where rail = :a order by id", {key}, "tti",
                     [&](const Row& row) {
                       all.push_back({row.text(0), row.text(1), row.integer(2)});
                     });
    return all;
  });
}

Expected<void> RailArchive::addRecording(std::int64_t key, const RecordingReference& recording) {
  return guarded([&] {
    database_->run("insert into recording (rail, place, digest, stored_us) values (:a, :b, :c, :d)",
                   {key, recording.place, recording.digest, recording.storedUs});
  });
}

Expected<void> RailArchive::remove(std::int64_t key, const std::string& user, const std::string& reason) {
  return guarded([&] {
    Transaction transaction(*database_);
    const StoredRail rail = loadRail(*database_, key);
    if (rail.state == RailState::Running)
      throw DatabaseFailure(
          {"rail " + rail.summary.rail.id, "is passing; it can be removed when it has", ErrorKind::Input});
    if (const auto held =
            database_->first("select held_why from rail where id = :a and held_us is not null", {key}, "t"))
      throw DatabaseFailure(
          {"rail " + rail.summary.rail.id, "is held (" + held->text(0) + "); release it first", ErrorKind::Input});
    appendAudit(*database_, systemTimeUs(),
                {user, "rail removed", rail.summary.rail.id, reason,
                 "uid " + rail.uid + ", measured " + isoTime(rail.beganUs)});
    database_->run("delete from rail where id = :a", {key});
    transaction.commit();
  });
}

}  // namespace vignole
