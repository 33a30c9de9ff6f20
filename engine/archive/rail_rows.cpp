#include "engine/archive/rail_rows.h"

#include <algorithm>

#include "engine/database/digest.h"

namespace vignole {

namespace {

constexpr std::size_t kBlockProfiles = 4096;

std::int64_t whole(std::uint64_t value) { return static_cast<std::int64_t>(value); }
std::int64_t whole(std::size_t value, int /*a size*/) { return static_cast<std::int64_t>(value); }
std::uint64_t counted(std::int64_t value) { return static_cast<std::uint64_t>(std::max<std::int64_t>(value, 0)); }
template <typename Enum>
std::int64_t number(Enum value) {
  return static_cast<std::int64_t>(value);
}

template <typename Enum>
Enum enumOf(std::int64_t number, Enum last) {
  return number >= 0 && number <= static_cast<std::int64_t>(last) ? static_cast<Enum>(number) : last;
}

constexpr const char* kRailColumns =
    "uid, line, name, heat, strand, order_number, shift, operator_name, section, recipe, recipe_name, calibration, "
    "calibration_name, calibration_warning, source, program, machine, began_us, ended_us, first_trigger, spacing_mm, "
    "announced_mm, "
    "speed_mm_per_s, temperature_c, temperature_u_c, length_m, profiles, verdict, state, other_section, "
    "other_profiles, other_chi2, other_chi2_here, seen, measured, incomplete, lost, not_stored, audit_number, "
    "audit_digest";
constexpr const char* kRailKinds =
    "ttttttttt"
    "itittttt"
    "iii"
    "rrrrrr"
    "iii"
    "tirr"
    "iiiiii"
    "t";

void updateRow(Database& database, const StoredRail& rail) {
  const RailSummary& s = rail.summary;
  const auto& other = s.looksLike;
  database.run(
      "update rail set ended_us = :a, length_m = :b, profiles = :c, verdict = :d, state = :e, other_section = :f, "
      "other_profiles = :g, other_chi2 = :h, other_chi2_here = :i, seen = :j, measured = :k, incomplete = :l, "
      "lost = :m, not_stored = :n where id = :o",
      {rail.endedUs, s.lengthM, whole(s.profiles), number(s.verdict), number(rail.state),
       other ? SqlValue(other->section) : SqlValue(), other ? SqlValue(whole(other->profiles)) : SqlValue(),
       other ? SqlValue(other->chi2) : SqlValue(), other ? SqlValue(other->chi2OfRecipe) : SqlValue(),
       whole(s.triggers.seen), whole(s.triggers.measured), whole(s.triggers.incomplete), whole(s.triggers.lost),
       whole(rail.notStored), rail.key});
}

void replaceDimensions(Database& database, const StoredRail& rail) {
  database.run("delete from rail_dimension where rail = :a", {rail.key});
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    const DimensionSummary& d = rail.summary.dimensions[i];
    const bool round = !d.radius.empty();
    database.run(
        "insert into rail_dimension (rail, dimension, nominal_mm, lower_mm, upper_mm, measured, not_measured, mean_mm, "
        "s_mm, min_mm, max_mm, u_mm, u_calibration_mm, radius_mm, radius_u_mm, excess_mm, verdict, reason) values (:a, "
        ":b, :c, :d, :e, "
        ":f, :g, :h, :i, :j, :k, :l, :m, :n, :o, :p, :q, :r)",
        {rail.key, whole(i, 0), d.nominalMm, orNull(d.lowerMm), orNull(d.upperMm), whole(d.values.count()),
         whole(d.notMeasured), d.values.mean(), d.values.sd(), d.values.min(), d.values.max(), d.uMm, d.uCalibrationMm,
         round ? SqlValue(d.radius.radiusMm()) : SqlValue(), round ? SqlValue(d.radius.uMm()) : SqlValue(),
         orNull(rail.excessMm[i]), number(d.verdict), d.reason});
  }
}

/// The last one that is stored may have grown since.
void replaceExceptions(Database& database, const StoredRail& rail, PerDimension<std::size_t>& known) {
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    const auto& exceptions = rail.summary.dimensions[i].exceptions;
    if (exceptions.empty()) continue;
    const std::size_t from = known[i] > 0 ? known[i] - 1 : 0;
    database.run("delete from rail_exception where rail = :a and dimension = :b and place >= :c",
                 {rail.key, whole(i, 0), whole(from, 0)});
    for (std::size_t e = from; e < exceptions.size(); ++e)
      database.run(
          "insert into rail_exception (rail, dimension, place, from_m, to_m, worst_mm) values (:a, :b, :c, :d, :e, :f)",
          {rail.key, whole(i, 0), whole(e, 0), exceptions[e].fromM, exceptions[e].toM, exceptions[e].worstMm});
    known[i] = exceptions.size();
  }
}

StoredRail railFrom(const Row& row, std::int64_t key) {
  StoredRail rail;
  rail.key = key;
  RailSummary& s = rail.summary;
  std::size_t i = 0;
  const auto text = [&] { return row.text(i++); };
  const auto real = [&] { return row.real(i++); };
  const auto integer = [&] { return row.integer(i++); };
  rail.uid = text();
  rail.place.line = text();
  s.rail.id = text();
  s.rail.heat = text();
  rail.papers.strand = text();
  rail.papers.orderNumber = text();
  rail.papers.shift = text();
  rail.papers.operatorName = text();
  s.rail.sectionName = text();
  rail.recipe = integer();
  s.recipe = text();
  rail.calibration = integer();
  s.calibrationId = text();
  s.calibrationWarning = text();
  rail.place.source = text();
  rail.place.program = text();
  rail.place.machine = text();
  rail.beganUs = integer();
  rail.endedUs = integer();
  s.rail.firstTrigger = counted(integer());
  s.rail.spacingMm = real();
  s.rail.lengthMm = real();
  s.rail.speedMmPerS = real();
  s.rail.temperatureC = real();
  s.rail.temperatureUncertaintyC = real();
  s.lengthM = real();
  s.profiles = counted(integer());
  s.verdict = enumOf(integer(), Verdict::NoLimit);
  rail.state = enumOf(integer(), RailState::Interrupted);
  if (!row.null(i)) s.looksLike = OtherRail{row.text(i), counted(row.integer(i + 1)), row.real(i + 2), row.real(i + 3)};
  i += 4;
  s.triggers.seen = counted(integer());
  s.triggers.measured = counted(integer());
  s.triggers.incomplete = counted(integer());
  s.triggers.lost = counted(integer());
  rail.notStored = counted(integer());
  rail.auditNumber = integer();
  rail.auditDigest = text();
  return rail;
}

void loadDimensions(Database& database, StoredRail& rail) {
  for (const Dimension d : kDimensions) rail.summary.dimensions[index(d)].dimension = d;
  database.query(
      "select dimension, nominal_mm, lower_mm, upper_mm, measured, not_measured, mean_mm, s_mm, min_mm, max_mm, u_mm, "
      "u_calibration_mm, "
      "radius_mm, radius_u_mm, excess_mm, verdict, reason from rail_dimension where rail = :a order by dimension",
      {rail.key}, "irrriirrrrrrrrrit", [&](const Row& row) {
        const std::uint64_t place = counted(row.integer(0));
        if (place >= kDimensionCount) return;
        DimensionSummary& d = rail.summary.dimensions[place];
        d.nominalMm = row.real(1);
        d.lowerMm = row.realOrNone(2);
        d.upperMm = row.realOrNone(3);
        d.values = {counted(row.integer(4)), row.real(6), row.real(7), row.real(8), row.real(9)};
        d.notMeasured = counted(row.integer(5));
        d.uMm = row.real(10);
        d.uCalibrationMm = row.real(11);
        if (!row.null(12)) d.radius = {row.real(12), row.real(13)};
        rail.excessMm[place] = row.realOrNone(14);
        d.verdict = enumOf(row.integer(15), Verdict::NoLimit);
        d.reason = row.text(16);
      });
  database.query(
      "select dimension, from_m, to_m, worst_mm from rail_exception where rail = :a order by dimension, place",
      {rail.key}, "irrr", [&](const Row& row) {
        const std::uint64_t place = counted(row.integer(0));
        if (place < kDimensionCount)
          rail.summary.dimensions[place].exceptions.push_back({row.real(1), row.real(2), row.real(3)});
      });
}

void loadLedger(Database& database, StoredRail& rail) {
  database.query("select reason, triggers from rail_reason where rail = :a", {rail.key}, "ti",
                 [&](const Row& row) { rail.summary.triggers.reasons[row.text(0)] = counted(row.integer(1)); });
  database.query(
      "select name, items, mean_ms, sd_ms, ucl99_ms, max_ms, queue_capacity, queue_high_water, overflows, cpu_ms "
      "from rail_stage where rail = :a order by place",
      {rail.key}, "tirrrriiir", [&](const Row& row) {
        StageStatistics s;
        s.name = row.text(0);
        s.count = counted(row.integer(1));
        s.meanMs = row.real(2);
        s.sdMs = row.real(3);
        s.ucl99Ms = row.real(4);
        s.maxMs = row.real(5);
        s.queueCapacity = static_cast<std::size_t>(counted(row.integer(6)));
        s.queueHighWater = static_cast<std::size_t>(counted(row.integer(7)));
        s.overflows = counted(row.integer(8));
        s.cpuMs = row.real(9);
        rail.stages.push_back(std::move(s));
      });
}

std::string placeOf(const Database& database, std::int64_t key) {
  return shown(database.url()) + ", rail " + std::to_string(key);
}

}  // namespace

std::int64_t insertRail(Database& database, const StoredRail& rail) {
  const RailSummary& s = rail.summary;
  const RailBegin& b = s.rail;
  return database.insert(
      std::string("insert into rail (") + kRailColumns +
          ") values (:a1, :a2, :a3, :a4, :a5, :a6, :a7, :a8, :a9, :b1, :b2, :b3, :b4, :b5, :b6, :b7, :b8, :b9, :c1, "
          ":c2, :c3, :c4, :c5, :c6, :c7, :c8, :c9, :d1, :d2, :d3, :d4, :d5, :d6, :d7, :d8, :d9, :e1, :e2, :e3, :e4)",
      {rail.uid,
       rail.place.line,
       b.id,
       b.heat,
       rail.papers.strand,
       rail.papers.orderNumber,
       rail.papers.shift,
       rail.papers.operatorName,
       b.sectionName,
       rail.recipe,
       s.recipe,
       rail.calibration == 0 ? SqlValue() : SqlValue(rail.calibration),
       s.calibrationId,
       s.calibrationWarning,
       rail.place.source,
       rail.place.program,
       rail.place.machine,
       rail.beganUs,
       rail.endedUs,
       whole(b.firstTrigger),
       b.spacingMm,
       b.lengthMm,
       b.speedMmPerS,
       b.temperatureC,
       b.temperatureUncertaintyC,
       s.lengthM,
       whole(s.profiles),
       number(s.verdict),
       number(rail.state),
       SqlValue(),
       SqlValue(),
       SqlValue(),
       SqlValue(),
       whole(s.triggers.seen),
       whole(s.triggers.measured),
       whole(s.triggers.incomplete),
       whole(s.triggers.lost),
       whole(rail.notStored),
       rail.auditNumber,
       rail.auditDigest});
}

void updateRail(Database& database, const StoredRail& rail, PerDimension<std::size_t>& known) {
  updateRow(database, rail);
  replaceDimensions(database, rail);
  replaceExceptions(database, rail, known);
}

void insertLedger(Database& database, const StoredRail& rail) {
  for (const auto& [reason, triggers] : rail.summary.triggers.reasons)
    database.run("insert into rail_reason (rail, reason, triggers) values (:a, :b, :c)",
                 {rail.key, reason, whole(triggers)});
  for (std::size_t i = 0; i < rail.stages.size(); ++i) {
    const StageStatistics& s = rail.stages[i];
    database.run(
        "insert into rail_stage (rail, place, name, items, mean_ms, sd_ms, ucl99_ms, max_ms, queue_capacity, "
        "queue_high_water, overflows, cpu_ms) values (:a, :b, :c, :d, :e, :f, :g, :h, :i, :j, :k, :l)",
        {rail.key, whole(i, 0), s.name, whole(s.count), s.meanMs, s.sdMs, s.ucl99Ms, s.maxMs, whole(s.queueCapacity, 0),
         whole(s.queueHighWater, 0), whole(s.overflows), s.cpuMs});
  }
}

void insertBlock(Database& database, std::int64_t rail, std::uint64_t first, std::size_t profiles, const Bytes& block) {
  if (profiles == 0) return;
  database.run("insert into profile_block (rail, first, profiles, content) values (:a, :b, :c, :d)",
               {rail, whole(first), whole(profiles, 0), block});
}

void joinBlocks(Database& database, std::int64_t rail) {
  const auto blocks = database.first("select count(*) from profile_block where rail = :a", {rail}, "i");
  if (!blocks || blocks->integer(0) < 2) return;
  const std::vector<ProfileRecord> all = loadProfiles(database, rail, 0, kMaxColumn);
  database.run("delete from profile_block where rail = :a", {rail});
  for (std::size_t first = 0; first < all.size(); first += kBlockProfiles) {
    const std::size_t profiles = std::min(kBlockProfiles, all.size() - first);
    insertBlock(database, rail, first, profiles, packProfiles(std::span(all).subspan(first, profiles)));
  }
}

StoredRail loadRail(Database& database, std::int64_t key) {
  const auto held = database.lock();
  const auto row =
      database.first(std::string("select ") + kRailColumns + " from rail where id = :a", {key}, kRailKinds);
  if (!row) throw DatabaseFailure({shown(database.url()), "holds no rail " + std::to_string(key), ErrorKind::Input});
  StoredRail rail = railFrom(*row, key);
  loadDimensions(database, rail);
  loadLedger(database, rail);
  return rail;
}

std::vector<ProfileRecord> loadProfiles(Database& database, std::int64_t key, std::uint64_t first,
                                        std::uint64_t count) {
  const auto held = database.lock();
  StoredRail rail;
  rail.key = key;
  loadDimensions(database, rail);
  std::vector<ProfileRecord> all;
  const std::uint64_t end = first + std::min(count, static_cast<std::uint64_t>(kMaxColumn));
  database.query(
      "select first, content from profile_block where rail = :a and first < :b and first + profiles > :c order by "
      "first",
      {key, whole(end), whole(first)}, "ib", [&](const Row& row) {
        auto block = unpackProfiles(row.bytes(1));
        if (!block) throw DatabaseFailure({placeOf(database, key), block.error().message(), ErrorKind::World});
        const std::uint64_t blockFirst = counted(row.integer(0));
        for (std::size_t i = 0; i < block->size(); ++i)
          if (blockFirst + i >= first && blockFirst + i < end) all.push_back(std::move((*block)[i]));
      });
  for (ProfileRecord& record : all)
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      record.dimensions[d].nominalMm = rail.summary.dimensions[d].nominalMm;
      record.dimensions[d].lowerMm = rail.summary.dimensions[d].lowerMm;
      record.dimensions[d].upperMm = rail.summary.dimensions[d].upperMm;
    }
  return all;
}

std::string railDigest(Database& database, std::int64_t key) {
  struct Part {
    const char* name;
    const char* sql;
    const char* kinds;
  };
  static const std::string kRail = std::string("select ") + kRailColumns + " from rail where id = :a";
  const std::array<Part, 7> parts = {{
      {"rail", kRail.c_str(), kRailKinds},
      {"dimensions",
       "select dimension, nominal_mm, lower_mm, upper_mm, measured, not_measured, mean_mm, s_mm, min_mm, max_mm, u_mm, "
       "u_calibration_mm, "
       "radius_mm, radius_u_mm, excess_mm, verdict, reason from rail_dimension where rail = :a order by dimension",
       "irrriirrrrrrrrrit"},
      {"exceptions",
       "select dimension, place, from_m, to_m, worst_mm from rail_exception where rail = :a order by dimension, place",
       "iirrr"},
      {"reasons", "select reason, triggers from rail_reason where rail = :a order by reason", "ti"},
      {"stages",
       "select place, name, items, mean_ms, sd_ms, ucl99_ms, max_ms, queue_capacity, queue_high_water, overflows, "
       "cpu_ms from rail_stage where rail = :a order by place",
       "itirrrriiir"},
      {"profiles", "select first, profiles, content from profile_block where rail = :a order by first", "iib"},
      {"points", "select profile, content from profile_points where rail = :a order by profile", "ib"},
  }};
  const auto held = database.lock();
  Digest digest;
  for (const Part& part : parts) {
    digest.add(SqlValue(std::string(part.name)));
    database.query(part.sql, {key}, part.kinds, [&](const Row& row) { digest.add(row); });
  }
  return digest.finish();
}

}  // namespace vignole
