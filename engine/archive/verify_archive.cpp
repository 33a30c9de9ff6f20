#include "engine/archive/verify_archive.h"

#include "engine/archive/audit_rows.h"
#include "engine/archive/audit_trail.h"
#include "engine/archive/rail_rows.h"
#include "engine/database/digest.h"
#include "engine/packing/point_pack.h"

namespace vignole {

namespace {

constexpr std::size_t kMaxPageFindings = 20;

void add(ArchiveCheck& check, const std::string& where, const std::string& what) {
  check.findings.push_back({where, what});
}

void checkPages(Database& database, ArchiveCheck& check) {
  if (database.url().kind != ArchiveKind::Sqlite) return;
  const auto done = guarded([&] {
    database.query("pragma integrity_check(20)", {}, "t", [&](const Row& row) {
      if (row.text(0) != "ok" && check.findings.size() < kMaxPageFindings) add(check, "pages", row.text(0));
    });
    database.query("pragma foreign_key_check", {}, "t",
                   [&](const Row& row) { add(check, row.text(0), "a row refers to another that is not there"); });
  });
  if (!done) add(check, "pages", done.error().message());
}

void checkTexts(Database& database, ArchiveCheck& check, const std::string& table) {
  const auto done = guarded([&] {
    database.query("select name, digest, content from " + table + " order by id", {}, "ttt", [&](const Row& row) {
      if (digestOf(row.text(2)) != row.text(1)) add(check, table + " " + row.text(0), "its text was changed");
    });
  });
  if (!done) add(check, table, done.error().message());
}

void checkRail(Database& database, std::int64_t key, ArchiveCheck& check) {
  const StoredRail rail = loadRail(database, key);
  const std::string where = "rail " + rail.summary.rail.id + " (" + std::to_string(key) + ")";
  const auto digest = database.first("select digest from rail where id = :a", {key}, "t");
  if (rail.state != RailState::Running && (digest->null(0) || railDigest(database, key) != digest->text(0)))
    add(check, where, "is not as it was written");
  std::uint64_t expected = 0;
  database.query("select first, profiles, content from profile_block where rail = :a order by first", {key}, "iib",
                 [&](const Row& row) {
                   const auto first = static_cast<std::uint64_t>(row.integer(0));
                   const auto block = unpackProfiles(row.bytes(2));
                   if (!block) add(check, where, "profiles from " + std::to_string(first) + ": " + block.error().what);
                   if (first != expected || (block && block->size() != static_cast<std::uint64_t>(row.integer(1))))
                     add(check, where, "profiles are missing at " + std::to_string(expected));
                   expected = first + static_cast<std::uint64_t>(row.integer(1));
                 });
  if (rail.state != RailState::Running && expected != rail.summary.profiles)  // one that passes grows meanwhile
    add(check, where, "has " + std::to_string(expected) + " profiles of " + std::to_string(rail.summary.profiles));
  check.profiles += expected;
  database.query("select profile, content from profile_points where rail = :a", {key}, "ib", [&](const Row& row) {
    ++check.points;
    if (const auto points = unpackPoints(row.bytes(1)); !points)
      add(check, where, "points of profile " + std::to_string(row.integer(0)) + ": " + points.error().what);
  });
}

void checkRails(Database& database, ArchiveCheck& check, const std::function<bool(double)>& progress) {
  std::vector<std::int64_t> keys;
  database.query("select id from rail order by id", {}, "i", [&](const Row& row) { keys.push_back(row.integer(0)); });
  for (const std::int64_t key : keys) {
    ++check.rails;
    if (const auto done = guarded([&] { checkRail(database, key, check); }); !done)
      add(check, "rail " + std::to_string(key), done.error().message());
    if (progress && !progress(static_cast<double>(check.rails) / static_cast<double>(keys.size()))) return;
  }
}

}  // namespace

Expected<ArchiveCheck> verifyArchive(const Archive& archive, const std::function<bool(double)>& progress) {
  Database& database = *archive.database();
  ArchiveCheck check;
  checkPages(database, check);
  checkTexts(database, check, "recipe");
  checkTexts(database, check, "calibration");
  if (const auto done = guarded([&] { checkRails(database, check, progress); }); !done)
    add(check, "rails", done.error().message());
  const auto chain = AuditTrail(archive).verify();
  if (!chain) add(check, "audit trail", chain.error().message());
  if (chain)
    for (const std::string& what : *chain) add(check, "audit trail", what);
  const auto head = guarded([&] { return auditHead(database); });
  if (head) {
    check.auditHead = head->number;
    check.auditHeadDigest = head->digest;
    check.auditEntries = static_cast<std::uint64_t>(head->number);
  }
  return check;
}

}  // namespace vignole
