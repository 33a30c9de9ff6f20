#include "engine/archive/calibration_history.h"

#include "engine/archive/audit_rows.h"
#include "engine/archive/kept_texts.h"
#include "engine/database/digest.h"

namespace vignole {

std::int64_t keepCalibration(Database& database, const RigCalibration& calibration, TimeUs now, const std::string& user,
                             const std::string& reason) {
  const std::string text = toToml(calibration), digest = digestOf(text);
  Transaction transaction(database);
  const auto known = database.first("select id from calibration where digest = :a", {digest}, "i");
  const std::int64_t key =
      known ? known->integer(0)
            : database.insert(
                  "insert into calibration (name, method, made, digest, content, stored_us, stored_by, "
                  "reason) values (:a, :b, :c, :d, :e, :f, :g, :h)",
                  {calibration.id, calibration.method, calibration.created, digest, text, now, user, reason});
  transaction.commit();
  return key;
}

CalibrationHistory::CalibrationHistory(const Archive& archive) : database_(archive.database()) {}

Expected<std::int64_t> CalibrationHistory::add(const RigCalibration& calibration, const std::string& user,
                                               const std::string& reason) {
  return guarded([&] {
    const TimeUs now = systemTimeUs();
    Transaction transaction(*database_);
    const auto before = database_->first("select count(*) from calibration", {}, "i");
    const std::int64_t key = keepCalibration(*database_, calibration, now, user, reason);
    const auto after = database_->first("select count(*) from calibration", {}, "i");
    if (before->integer(0) != after->integer(0))
      appendAudit(*database_, now, {user, "calibration stored", calibration.id, reason, calibration.method});
    transaction.commit();
    return key;
  });
}

Expected<void> CalibrationHistory::putInForce(std::int64_t key, const std::string& user, const std::string& reason) {
  return guarded([&] {
    const TimeUs now = systemTimeUs();
    Transaction transaction(*database_);
    const auto row = database_->first("select name from calibration where id = :a", {key}, "t");
    if (!row)
      throw DatabaseFailure({"calibration", "there is none with the key " + std::to_string(key), ErrorKind::Input});
    const auto former = database_->first(
        "select c.name from calibration_use u join calibration c on c.id = u.calibration order by u.id desc limit 1",
        {}, "t");
    database_->run("insert into calibration_use (calibration, since_us, by_user, reason) values (:a, :b, :c, :d)",
                   {key, now, user, reason});
    appendAudit(*database_, now,
                {user, "calibration in force", row->text(0), reason,
                 former ? "before: " + former->text(0) : std::string("the first")});
    transaction.commit();
  });
}

Expected<std::vector<StoredCalibration>> CalibrationHistory::all() const {
  return guarded([&] {
    std::vector<StoredCalibration> all;
    database_->query("select id, name, method, made, stored_us, stored_by, reason from calibration order by id desc",
                     {}, "itttitt", [&](const Row& row) {
                       all.push_back({row.integer(0), row.text(1), row.text(2), row.text(3), row.integer(4),
                                      row.text(5), row.text(6)});
                     });
    return all;
  });
}

Expected<std::vector<CalibrationUse>> CalibrationHistory::uses() const {
  return guarded([&] {
    std::vector<CalibrationUse> uses;
    database_->query(
        "select u.calibration, c.name, u.since_us, u.by_user, u.reason from calibration_use u "
        "join calibration c on c.id = u.calibration order by u.id desc",
        {}, "ititt", [&](const Row& row) {
          uses.push_back({row.integer(0), row.text(1), row.integer(2), row.text(3), row.text(4)});
        });
    return uses;
  });
}

Expected<std::string> CalibrationHistory::text(std::int64_t key) const {
  return guarded([&] {
    const auto row = database_->first("select content from calibration where id = :a", {key}, "t");
    if (!row)
      throw DatabaseFailure({"calibration", "there is none with the key " + std::to_string(key), ErrorKind::Input});
    return row->text(0);
  });
}

}  // namespace vignole
