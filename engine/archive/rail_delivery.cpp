#include "engine/archive/rail_delivery.h"

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/archive/audit_rows.h"
#include "engine/archive/rail_record.h"
#include "engine/archive/rail_rows.h"
#include "engine/database/copied_rows.h"
#include "engine/database/digest.h"

namespace vignole {

namespace {

/// The key in `to` of what has the key `key` in `from`; put in if it is not there yet.
SqlValue keptText(Database& from, Database& to, const std::string& table, std::int64_t key) {
  if (key == 0) return {};
  const auto digest = from.first("select digest from " + table + " where id = :a", {key}, "t");
  if (!digest) throw DatabaseFailure({table, "of a waiting rail is missing", ErrorKind::World});
  const std::string find = "select id from " + table + " where digest = :a";
  auto known = to.first(find, {digest->text(0)}, "i");
  if (!known) {
    copyRows(from, to, columnsOf(from, table), "id", key, {}, {"id"});
    known = to.first(find, {digest->text(0)}, "i");
  }
  return known->integer(0);
}

std::uint64_t countWaiting(Database& waiting) {
  const auto row = waiting.first("select count(*) from rail where state <> :a",
                                 {static_cast<std::int64_t>(RailState::Running)}, "i");
  return static_cast<std::uint64_t>(row->integer(0));
}

}  // namespace

bool deliverRail(Database& waiting, Database& server, std::int64_t key) {
  const auto held = waiting.lock();
  const auto rail = waiting.first("select uid, recipe, calibration, digest from rail where id = :a", {key}, "tiit");
  if (!rail) return false;
  Transaction transaction(server);
  const bool there = server.first("select id from rail where uid = :a", {rail->text(0)}, "i").has_value();
  if (!there) {
    // A rail that the disk has damaged is delivered as it is, without a digest: verify tells.
    const bool whole = railDigest(waiting, key) == rail->text(3);
    const AuditHead head = auditHead(server);
    copyRows(waiting, server, columnsOf(waiting, "rail"), "id", key,
             {{"recipe", keptText(waiting, server, "recipe", rail->integer(1))},
              {"calibration", keptText(waiting, server, "calibration", rail->integer(2))},
              {"audit_number", head.number},
              {"audit_digest", head.digest},
              {"digest", {}}},
             {"id"});
    const std::int64_t keyThere = server.first("select id from rail where uid = :a", {rail->text(0)}, "i")->integer(0);
    for (const std::string& table : tablesOf(waiting))
      if (const TableColumns columns = columnsOf(waiting, table); columns.has("rail") && table != "alarm")
        copyRows(waiting, server, columns, "rail", key, {{"rail", keyThere}},
                 columns.has("id") ? std::vector<std::string>{"id"} : std::vector<std::string>{});
    if (whole) server.run("update rail set digest = :a where id = :b", {railDigest(server, keyThere), keyThere});
  }
  transaction.commit();
  waiting.run("delete from rail where id = :a", {key});
  return !there;
}

struct RailDelivery::Impl {
  Impl(std::filesystem::path f, std::string u, std::chrono::milliseconds r)
      : file(std::move(f)), url(std::move(u)), retry(r) {}

  void run(const std::stop_token& stop);
  void deliverAll(const std::stop_token& stop);

  const std::filesystem::path file;
  const std::string url;
  const std::chrono::milliseconds retry;

  mutable std::mutex mutex;
  std::condition_variable_any changed;
  bool wanted = true;  ///< there may be some from an earlier run
  bool lastTry = false;
  RailDeliveryStatus status;

  std::optional<Archive> waiting, server;
  std::jthread thread;
};

void RailDelivery::Impl::deliverAll(const std::stop_token& stop) {
  const auto done = guarded([&] {
    if (!waiting) waiting = orThrow(Archive::open(file.string()));
    for (;;) {
      const auto next = waiting->database()->first("select min(id) from rail where state <> :a",
                                                   {static_cast<std::int64_t>(RailState::Running)}, "i");
      const std::uint64_t left = countWaiting(*waiting->database());
      {
        const std::scoped_lock held(mutex);
        status.waiting = left;
      }
      if (left == 0 || (stop.stop_requested() && !lastTry)) return;
      if (!server) server = orThrow(Archive::open(url, Archive::Missing::Create));
      const bool isNew = deliverRail(*waiting->database(), *server->database(), next->integer(0));
      const std::scoped_lock held(mutex);
      status.failure.clear();
      if (isNew) ++status.delivered;
    }
  });
  const std::scoped_lock held(mutex);
  status.failure = done ? std::string() : done.error().message();
  wanted = wanted || !done;
}

void RailDelivery::Impl::run(const std::stop_token& stop) {
  for (;;) {
    {
      std::unique_lock held(mutex);
      const auto due = [this] { return wanted && status.failure.empty(); };
      changed.wait_for(held, stop, retry, due);
      if (stop.stop_requested()) break;
      if (!wanted) continue;
      wanted = false;
    }
    deliverAll(stop);
  }
  if (lastTry) deliverAll(stop);
}

RailDelivery::RailDelivery(std::filesystem::path file, std::string url, std::chrono::milliseconds retry)
    : impl_(std::make_unique<Impl>(std::move(file), std::move(url), retry)) {
  impl_->thread = std::jthread([this](const std::stop_token& stop) { impl_->run(stop); });
}

RailDelivery::~RailDelivery() = default;

void RailDelivery::railHasPassed() {
  {
    const std::scoped_lock held(impl_->mutex);
    impl_->wanted = true;
    ++impl_->status.waiting;
  }
  impl_->changed.notify_all();
}

RailDeliveryStatus RailDelivery::status() const {
  const std::scoped_lock held(impl_->mutex);
  return impl_->status;
}

Expected<void> RailDelivery::finish() {
  if (impl_->thread.joinable()) {
    {
      const std::scoped_lock held(impl_->mutex);
      impl_->lastTry = true;
    }
    impl_->thread.request_stop();
    impl_->thread.join();
  }
  const RailDeliveryStatus now = status();
  if (now.waiting == 0) return {};
  return worldError(impl_->file.string(), std::to_string(now.waiting) +
                                              " rails wait there for the server and go to it when it is back and "
                                              "something is measured: " +
                                              now.failure);
}

Expected<std::filesystem::path> waitingRailsFile(const std::filesystem::path& folder, const std::string& server,
                                                 const std::string& line) {
  std::filesystem::path in = folder;
  if (in.empty()) {
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    if (state != nullptr && *state != '\0')
      in = std::filesystem::path(state) / "vignole";
    else if (home != nullptr && *home != '\0')
      in = std::filesystem::path(home) / ".local" / "state" / "vignole";
    else
      return worldError("archive", "there is no folder for rails that wait for the server; set XDG_STATE_HOME");
  }
  std::error_code error;
  const bool made = std::filesystem::create_directories(in, error);
  if (error) return worldError(in.string(), error.message());
  if (made) std::filesystem::permissions(in, std::filesystem::perms::owner_all, error);
  return in / ("waiting-" + digestOf(server + "\n" + line).substr(0, 16) + ".db");
}

}  // namespace vignole
