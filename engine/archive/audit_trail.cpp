#include "engine/archive/audit_trail.h"

#include <map>

#include "engine/archive/audit_rows.h"
#include "engine/database/digest.h"

namespace vignole {

AuditHead auditHead(Database& database) {
  const auto row = database.first("select number, digest from audit_head where id = 1", {}, "it");
  return row ? AuditHead{row->integer(0), row->text(1)} : AuditHead{};
}

std::string auditDigest(std::int64_t number, std::int64_t timeUs, const AuditNote& note, const std::string& before) {
  Digest digest;
  for (const SqlValue& value :
       SqlValues{number, timeUs, note.user, note.action, note.subject, note.reason, note.details, before})
    digest.add(value);
  return digest.finish();
}

void appendAudit(Database& database, std::int64_t timeUs, const AuditNote& said) {
  // As every database gives it back, or its digest would not fit.
  const AuditNote note{storableText(said.user), storableText(said.action), storableText(said.subject),
                       storableText(said.reason), storableText(said.details)};
  if (note.user.empty() || note.action.empty())
    throw DatabaseFailure({"audit trail", "an entry needs who and what", ErrorKind::Input});
  if (note.reason.empty()) throw DatabaseFailure({note.action, "needs a reason; say why", ErrorKind::Input});
  Transaction transaction(database);
  const AuditHead head = auditHead(database);
  const std::int64_t number = head.number + 1;
  const std::string digest = auditDigest(number, timeUs, note, head.digest);
  database.run(
      "insert into audit (number, time_us, by_user, action, subject, reason, details, before, digest) "
      "values (:a, :b, :c, :d, :e, :f, :g, :h, :i)",
      {number, timeUs, note.user, note.action, note.subject, note.reason, note.details, head.digest, digest});
  database.run("update audit_head set number = :a, digest = :b where id = 1", {number, digest});
  transaction.commit();
}

AuditTrail::AuditTrail(const Archive& archive) : database_(archive.database()) {}

Expected<void> AuditTrail::add(const std::string& user, const std::string& action, const std::string& subject,
                               const std::string& reason, const std::string& details) {
  return guarded([&] { appendAudit(*database_, systemTimeUs(), {user, action, subject, reason, details}); });
}

Expected<std::vector<AuditEntry>> AuditTrail::entries(const AuditQuery& query) const {
  return guarded([&] {
    std::vector<AuditEntry> entries;
    database_->query(
        "select number, time_us, by_user, action, subject, reason, details, digest from audit "
        "where number < :a and time_us >= :b and time_us < :c and (:d = '' or by_user = :e) "
        "and (:f = '' or action = :g) and (:h = '' or subject = :i) order by number desc limit :j",
        {query.beforeNumber > 0 ? query.beforeNumber : INT64_MAX, query.fromUs.value_or(INT64_MIN),
         query.toUs.value_or(INT64_MAX), query.user, query.user, query.action, query.action, query.subject,
         query.subject, atMost(query.limit)},
        "iittttt"
        "t",
        [&](const Row& row) {
          entries.push_back({row.integer(0), row.integer(1), row.text(2), row.text(3), row.text(4), row.text(5),
                             row.text(6), row.text(7)});
        });
    return entries;
  });
}

Expected<std::vector<std::string>> AuditTrail::verify() const {
  return guarded([&] {
    const auto held = database_->lock();
    std::vector<std::string> wrong;
    std::map<std::int64_t, std::string> digests;  // those that rails refer to would do, but entries are few
    std::int64_t number = 0;
    std::string before;
    database_->query(
        "select number, time_us, by_user, action, subject, reason, details, before, digest from audit order by number",
        {},
        "iitttttt"
        "t",
        [&](const Row& row) {
          const std::int64_t here = row.integer(0);
          if (here != number + 1)
            wrong.push_back(here == number + 2 ? "entry " + std::to_string(number + 1) + " is missing"
                                               : "entries " + std::to_string(number + 1) + " to " +
                                                     std::to_string(here - 1) + " are missing");
          else if (row.text(7) != before)
            wrong.push_back("entry " + std::to_string(here) + " does not follow the one before it");
          const AuditNote note{row.text(2), row.text(3), row.text(4), row.text(5), row.text(6)};
          if (auditDigest(here, row.integer(1), note, row.text(7)) != row.text(8))
            wrong.push_back("entry " + std::to_string(here) + " was changed");
          number = here;
          before = row.text(8);
          digests[here] = before;
        });
    const AuditHead head = auditHead(*database_);
    if (head.number > number)
      wrong.push_back("entries " + std::to_string(number + 1) + " to " + std::to_string(head.number) +
                      " at the end are missing");
    else if (head.number != number || head.digest != before)
      wrong.emplace_back("the end of the trail is not the one that was written last");
    database_->query("select id, name, audit_number, audit_digest from rail where audit_number > 0 order by id", {},
                     "itit", [&](const Row& row) {
                       const auto entry = digests.find(row.integer(2));
                       if (entry == digests.end() || entry->second != row.text(3))
                         wrong.push_back("rail " + row.text(1) + " (" + std::to_string(row.integer(0)) +
                                         ") was measured after entry " + std::to_string(row.integer(2)) +
                                         ", which is not the one that is there now");
                     });
    return wrong;
  });
}

}  // namespace vignole
