#include "engine/archive/schema.h"

#include <algorithm>

namespace vignole {

namespace {

// Times are microseconds since 1970, UTC; lengths of tables in their names' unit. What SQLite and PostgreSQL call
// differently stands in braces: {key} a key given by the database, {real} a double, {bytes}, {text} compared by bytes,
// {packed} a table that is its own index; {server} begins what PostgreSQL alone is told.
const std::vector<Migration> kMigrations = {
    {1,
     {"create table recipe (id {key}, name {text} not null, version integer not null, digest {text} not null unique, "
      "content {text} not null, state integer not null, created_us bigint not null, created_by {text} not null, "
      "note {text} not null, decided_us bigint, decided_by {text}, reason {text})",
      "create unique index recipe_version on recipe (name, version) where version > 0",

      "create table calibration (id {key}, name {text} not null, method {text} not null, made {text} not null, "
      "digest {text} not null unique, content {text} not null, stored_us bigint not null, stored_by {text} not null, "
      "reason {text} not null)",
      "create table calibration_use (id {key}, calibration bigint not null references calibration (id), "
      "since_us bigint not null, by_user {text} not null, reason {text} not null)",

      "create table rail (id {key}, uid {text} not null unique, line {text} not null, name {text} not null, "
      "heat {text} not null, strand {text} not null, order_number {text} not null, shift {text} not null, "
      "operator_name {text} not null, section {text} not null, recipe bigint not null references recipe (id), "
      "recipe_name {text} not null, calibration bigint references calibration (id), calibration_name {text} not null, "
      "calibration_warning {text} not null, "
      "source {text} not null, program {text} not null, machine {text} not null, began_us bigint not null, "
      "ended_us bigint not null, first_trigger bigint not null, spacing_mm {real} not null, "
      "announced_mm {real} not null, speed_mm_per_s {real} not null, temperature_c {real} not null, "
      "temperature_u_c {real} not null, length_m {real} not null, profiles bigint not null, verdict integer not null, "
      "state integer not null, other_section {text}, other_profiles bigint, other_chi2 {real}, other_chi2_here {real}, "
      "seen bigint not null, measured bigint not null, incomplete bigint not null, lost bigint not null, "
      "not_stored bigint not null, audit_number bigint not null, audit_digest {text} not null, digest {text})",
      "create index rail_began on rail (began_us)", "create index rail_name on rail (name)",
      "create index rail_heat on rail (heat, began_us)", "create index rail_section on rail (section, began_us)",
      "create index rail_verdict on rail (verdict, began_us)", "create index rail_state on rail (state)",

      "create table rail_dimension (rail bigint not null references rail (id) on delete cascade, "
      "dimension integer not null, nominal_mm {real} not null, lower_mm {real}, upper_mm {real}, "
      "measured bigint not null, not_measured bigint not null, mean_mm {real} not null, s_mm {real} not null, "
      "min_mm {real} not null, max_mm {real} not null, u_mm {real} not null, u_calibration_mm {real} not null, "
      "radius_mm {real}, radius_u_mm {real}, "
      "excess_mm {real}, verdict integer not null, reason {text} not null, primary key (rail, dimension)) {packed}",
      "create index dimension_excess on rail_dimension (dimension, excess_mm)",
      "create index dimension_verdict on rail_dimension (dimension, verdict)",

      "create table rail_exception (rail bigint not null references rail (id) on delete cascade, "
      "dimension integer not null, place integer not null, from_m {real} not null, to_m {real} not null, "
      "worst_mm {real} not null, primary key (rail, dimension, place)) {packed}",

      "create table rail_reason (rail bigint not null references rail (id) on delete cascade, reason {text} not null, "
      "triggers bigint not null, primary key (rail, reason)) {packed}",

      "create table rail_stage (rail bigint not null references rail (id) on delete cascade, place integer not null, "
      "name {text} not null, items bigint not null, mean_ms {real} not null, sd_ms {real} not null, "
      "ucl99_ms {real} not null, max_ms {real} not null, queue_capacity bigint not null, "
      "queue_high_water bigint not null, overflows bigint not null, cpu_ms {real} not null, "
      "primary key (rail, place)) {packed}",

      "create table profile_block (rail bigint not null references rail (id) on delete cascade, "
      "first bigint not null, profiles bigint not null, content {bytes} not null, primary key (rail, first))",
      "create table profile_points (rail bigint not null references rail (id) on delete cascade, "
      "profile bigint not null, content {bytes} not null, primary key (rail, profile))",
      // Packed already.
      "{server}alter table profile_block alter column content set storage external",
      "{server}alter table profile_points alter column content set storage external",
      "create table recording (id {key}, rail bigint not null references rail (id) on delete cascade, "
      "place {text} not null, digest {text} not null, stored_us bigint not null)",

      "create table alarm (id {key}, uid {text} not null unique, rule {text} not null, source {text} not null, "
      "priority "
      "integer not null, "
      "cause {text} not null, consequence {text} not null, action {text} not null, details {text} not null, rail text "
      "not "
      "null, "
      "raised_us bigint not null, cleared_us bigint, acknowledged_us bigint, acknowledged_by {text} not null, "
      "shelved_until_us bigint, shelved_by {text} not null, shelving_reason {text} not null)",
      "create index alarm_raised on alarm (raised_us)",
      "create table alarm_step (id {key}, alarm {text} not null, time_us bigint not null, kind {text} not null, "
      "who {text} not null, content {text} not null)",
      "create index alarm_step_alarm on alarm_step (alarm)",
      "create table event (id {key}, time_us bigint not null, source {text} not null, content {text} not null, "
      "by_user {text} not null)",
      "create index event_time on event (time_us)",

      "create table account (name {text} not null primary key, role integer not null, password {text} not null, "
      "created_us bigint not null, disabled integer not null, must_change integer not null, "
      "failures integer not null, locked_until_us bigint not null, last_sign_in_us bigint)",

      "create table audit (number bigint not null primary key, time_us bigint not null, by_user {text} not null, "
      "action {text} not null, subject {text} not null, reason {text} not null, details {text} not null, "
      "before {text} not null, digest {text} not null)",
      "create table audit_head (id integer not null primary key, number bigint not null, digest {text} not null)",
      "insert into audit_head (id, number, digest) values (1, 0, '')"}},
    {2,
     {// Why a rail stays whatever its age: an evidence pack was handed out.
      "alter table rail add column held_us bigint", "alter table rail add column held_why {text}",
      "create index recording_rail on recording (rail)"}},
};

std::string inDialect(std::string_view statement, ArchiveKind kind) {
  struct Word {
    std::string_view name, sqlite, postgresql;
  };
  static constexpr std::array<Word, 6> kWords = {
      {{"{key}", "integer primary key autoincrement", "bigserial primary key"},
       {"{real}", "real", "double precision"},
       {"{bytes}", "blob", "bytea"},
       {"{packed}", "without rowid", ""},
       {"{text}", "text", "text collate \"C\""},
       {"{server}", "", ""}}};
  std::string text(statement);
  for (const Word& word : kWords)
    for (std::size_t at = text.find(word.name); at != std::string::npos; at = text.find(word.name, at))
      text.replace(at, word.name.size(), kind == ArchiveKind::Sqlite ? word.sqlite : word.postgresql);
  return text;
}

}  // namespace

const std::vector<Migration>& migrations() { return kMigrations; }

int schemaVersion(Database& database) {
  if (!database.hasTable("archive")) return 0;
  const auto row = database.first("select version from archive", {}, "i");
  return row ? static_cast<int>(row->integer(0)) : 0;
}

void migrate(Database& database, std::span<const Migration> steps) {
  const std::string where = shown(database.url());
  const int latest = steps.empty() ? 0 : steps.back().version;
  const auto refuseLater = [&](int version) {
    if (version > latest)
      throw DatabaseFailure({where,
                             "is of a later version (" + std::to_string(version) + ") than this program knows (" +
                                 std::to_string(latest) + "); use the program that made it",
                             ErrorKind::Input});
    return version;
  };
  if (refuseLater(schemaVersion(database)) == latest) return;
  Transaction transaction(database);
  int version = refuseLater(schemaVersion(database));  // another program may have been quicker
  if (version == 0) {
    if (!database.empty())
      throw DatabaseFailure({where, "holds the tables of another program; name another file", ErrorKind::Input});
    database.run("create table archive (version integer not null)");
    database.run("insert into archive (version) values (0)");
  }
  for (const Migration& step : steps) {
    if (step.version <= version) continue;
    for (const std::string_view statement : step.statements)
      if (database.url().kind == ArchiveKind::Postgresql || !statement.starts_with("{server}"))
        database.run(inDialect(statement, database.url().kind));
    database.run("update archive set version = :a", {static_cast<std::int64_t>(step.version)});
    version = step.version;
  }
  transaction.commit();
}

}  // namespace vignole
