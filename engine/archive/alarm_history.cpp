#include "engine/archive/alarm_history.h"

#include "engine/database/database.h"
#include "engine/database/digest.h"

namespace vignole {

AlarmHistory::AlarmHistory(const Archive& archive) : database_(archive.database()) {}

Expected<std::string> AlarmHistory::save(const AlarmRecord& alarm) {
  return guarded([&] {
    const std::string uid = alarm.uid.empty() ? newUid() : alarm.uid;
    Transaction transaction(*database_);
    database_->run("delete from alarm where uid = :a", {uid});
    database_->run(
        "insert into alarm (uid, rule, source, priority, cause, consequence, action, details, rail, raised_us, "
        "cleared_us, "
        "acknowledged_us, acknowledged_by, shelved_until_us, shelved_by, shelving_reason) values (:a, :b, :c, :d, :e, "
        ":f, :g, :h, :i, :j, :k, :l, :m, :n, :o, :p)",
        {uid, alarm.rule, alarm.source, static_cast<std::int64_t>(alarm.priority), alarm.cause, alarm.consequence,
         alarm.action, alarm.details, alarm.rail, alarm.raisedUs, orNull(alarm.clearedUs), orNull(alarm.acknowledgedUs),
         alarm.acknowledgedBy, orNull(alarm.shelvedUntilUs), alarm.shelvedBy, alarm.shelvingReason});
    transaction.commit();
    return uid;
  });
}

Expected<std::vector<AlarmRecord>> AlarmHistory::alarms(const AlarmQuery& query) const {
  return guarded([&] {
    std::vector<AlarmRecord> alarms;
    database_->query(
        std::string(
            "select uid, rule, source, priority, cause, consequence, action, details, rail, raised_us, cleared_us, "
            "acknowledged_us, acknowledged_by, shelved_until_us, shelved_by, shelving_reason from alarm "
            "where raised_us >= :a and raised_us < :b") +
            (query.activeOnly ? " and cleared_us is null" : "") + " order by raised_us desc, id desc limit :c",
        {query.fromUs.value_or(INT64_MIN), query.toUs.value_or(INT64_MAX), atMost(query.limit)}, "tttitttttiiititt",
        [&](const Row& row) {
          AlarmRecord a;
          a.uid = row.text(0);
          a.rule = row.text(1);
          a.source = row.text(2);
          a.priority = static_cast<int>(row.integer(3));
          a.cause = row.text(4);
          a.consequence = row.text(5);
          a.action = row.text(6);
          a.details = row.text(7);
          a.rail = row.text(8);
          a.raisedUs = row.integer(9);
          a.clearedUs = row.integerOrNone(10);
          a.acknowledgedUs = row.integerOrNone(11);
          a.acknowledgedBy = row.text(12);
          a.shelvedUntilUs = row.integerOrNone(13);
          a.shelvedBy = row.text(14);
          a.shelvingReason = row.text(15);
          alarms.push_back(std::move(a));
        });
    return alarms;
  });
}

Expected<void> AlarmHistory::addStep(const AlarmStep& step) {
  return guarded([&] {
    database_->run("insert into alarm_step (alarm, time_us, kind, who, content) values (:a, :b, :c, :d, :e)",
                   {step.alarm, step.timeUs, step.kind, step.who, step.text});
  });
}

Expected<std::vector<AlarmStep>> AlarmHistory::steps(const std::string& alarmUid) const {
  return guarded([&] {
    std::vector<AlarmStep> steps;
    database_->query("select alarm, time_us, kind, who, content from alarm_step where alarm = :a order by id",
                     {alarmUid}, "tittt", [&](const Row& row) {
                       steps.push_back({row.text(0), row.integer(1), row.text(2), row.text(3), row.text(4)});
                     });
    return steps;
  });
}

Expected<void> AlarmHistory::addEvent(const EventRecord& event) {
  return guarded([&] {
    database_->run("insert into event (time_us, source, content, by_user) values (:a, :b, :c, :d)",
                   {event.timeUs, event.source, event.text, event.user});
  });
}

Expected<std::vector<EventRecord>> AlarmHistory::events(std::optional<TimeUs> fromUs, std::optional<TimeUs> toUs,
                                                        std::size_t limit) const {
  return guarded([&] {
    std::vector<EventRecord> events;
    database_->query(
        "select time_us, source, content, by_user from event where time_us >= :a and time_us < :b "
        "order by time_us desc, id desc limit :c",
        {fromUs.value_or(INT64_MIN), toUs.value_or(INT64_MAX), atMost(limit)}, "ittt", [&](const Row& row) {
          events.push_back({row.integer(0), row.text(1), row.text(2), row.text(3)});
        });
    return events;
  });
}

}  // namespace vignole
