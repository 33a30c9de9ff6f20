#include "engine/archive/rail_writer.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <fcntl.h>
#include <mutex>
#include <optional>
#include <sys/file.h>
#include <thread>
#include <unistd.h>
#include <variant>

#include "engine/archive/archive.h"
#include "engine/archive/passing_rail.h"
#include "engine/archive/rail_delivery.h"
#include "engine/archive/rail_rows.h"

namespace vignole {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kRetry{500};
constexpr std::size_t kBlockProfiles = 4096;  ///< before that many wait, they are stored
constexpr std::size_t kSpareResults = 64;

struct Begin {
  RailBegin rail;
  RailPapers papers;
  std::shared_ptr<const MeasuringSetup> setup;
  TimeUs time;
};
struct Measured {
  std::unique_ptr<ProfileResult> result;
  bool withPoints;
};
struct End {
  TriggerLedger ledger;
  std::vector<StageStatistics> stages;
  TimeUs time;
};
struct LostProfile {};
using Item = std::variant<Begin, Measured, LostProfile, End>;

/// Held as long as the writer lives, and let go by the system if the process dies.
class WriterLock {
 public:
  static Expected<WriterLock> take(const std::filesystem::path& archive) {
    const std::string file = archive.string() + "-writer";
    WriterLock lock;
    lock.descriptor_ = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0640);
    if (lock.descriptor_ < 0) return worldError(file, "cannot be made; look at the rights of the folder");
    if (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0)
      return worldError(archive.string(), "another program is measuring into it; stop that one, or name another file");
    return lock;
  }
  ~WriterLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  WriterLock(WriterLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  WriterLock& operator=(WriterLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

 private:
  WriterLock() = default;
  int descriptor_ = -1;
};

/// Rails that a program left behind when it died: what it had stored is put in order as that of a finished rail.
void interruptRunning(Database& database, const std::string& line) {
  Transaction transaction(database);
  std::vector<std::int64_t> left;
  database.query("select id from rail where state = :a and line = :b",
                 {static_cast<std::int64_t>(RailState::Running), line}, "i",
                 [&](const Row& row) { left.push_back(row.integer(0)); });
  for (const std::int64_t key : left) {
    joinBlocks(database, key);
    database.run("update rail set state = :a where id = :b", {static_cast<std::int64_t>(RailState::Interrupted), key});
    database.run("update rail set digest = :a where id = :b", {railDigest(database, key), key});
  }
  transaction.commit();
}

/// What the archive needs of a result, into memory that is used again.
void copyNeeded(const ProfileResult& from, bool withPoints, ProfileResult& into) {
  into.rail = from.rail;
  Profile& p = into.profile;
  p.trigger = from.profile.trigger;
  p.positionMm = from.profile.positionMm;
  p.missing = from.profile.missing;
  p.overloaded = from.profile.overloaded;
  p.pointsOfCamera = from.profile.pointsOfCamera;
  p.correlatedPoints = from.profile.correlatedPoints;
  p.points.clear();
  p.lineEnds.clear();
  if (withPoints) {
    p.points = from.profile.points;
    p.lineEnds = from.profile.lineEnds;
  }
  Registration& r = into.registration;
  r.valid = from.registration.valid;
  r.reason = from.registration.reason;
  r.worldFromSection = from.registration.worldFromSection;
  r.rmsMm = from.registration.rmsMm;
  r.inliers = from.registration.inliers;
  r.points = static_cast<int>(from.profile.points.size());
  r.looksLike = from.registration.looksLike;
  into.measurement.dimensions = from.measurement.dimensions;
  into.measurement.verdict = from.measurement.verdict;
}

}  // namespace

struct RailWriter::Impl {
  Impl(RailWriterSettings s, std::shared_ptr<Database> d, WriterLock l)
      : settings(std::move(s)), database(std::move(d)), lock(std::move(l)) {}

  // What is handed over.
  void push(Item item) {
    {
      const std::scoped_lock held(mutex);
      queue.push_back(std::move(item));
    }
    changed.notify_all();
  }
  std::unique_ptr<ProfileResult> spareResult() {
    const std::scoped_lock held(mutex);
    if (spare.empty()) return std::make_unique<ProfileResult>();
    auto result = std::move(spare.back());
    spare.pop_back();
    return result;
  }
  void add(const ProfileResult& result);

  // The writer's thread.
  void run(const std::stop_token& stop);
  std::optional<Item> take(const std::stop_token& stop, std::optional<Clock::time_point> until);
  void apply(Item item);
  void store(const std::stop_token& stop);
  void failed(const Error& error);

  const RailWriterSettings settings;
  const std::shared_ptr<Database> database;
  WriterLock lock;

  mutable std::mutex mutex;
  std::condition_variable_any changed;
  std::deque<Item> queue;
  std::size_t queuedProfiles = 0;
  std::vector<std::unique_ptr<ProfileResult>> spare;
  RailWriterStatus status;
  std::optional<Error> lost;  ///< why a rail was not stored to its end
  bool givenUp = false;       ///< not live, and the disk failed: nothing more is taken

  std::unique_ptr<RailDelivery> delivery;  ///< where the archive is on a server
  std::optional<PassingRail> passing;
  Clock::time_point lastStored = Clock::now();
  std::jthread thread;
};

void RailWriter::Impl::add(const ProfileResult& result) {
  bool withPoints = true;
  {
    std::unique_lock held(mutex);
    if (!settings.live) changed.wait(held, [this] { return queuedProfiles < settings.queueProfiles || givenUp; });
    if (givenUp) return;
    if (queuedProfiles >= settings.queueProfiles) {
      withPoints = false;
      ++status.pointsDropped;
    }
    if (queuedProfiles >= settings.queueWithoutPoints) {
      ++status.profilesLost;
      queue.emplace_back(LostProfile{});
      return;
    }
    status.queueHighWater = std::max(status.queueHighWater, ++queuedProfiles);
  }
  auto copy = spareResult();
  copyNeeded(result, withPoints, *copy);
  push(Measured{std::move(copy), withPoints});
}

std::optional<Item> RailWriter::Impl::take(const std::stop_token& stop, std::optional<Clock::time_point> until) {
  std::unique_lock held(mutex);
  const auto there = [this] { return !queue.empty(); };
  if (until)
    changed.wait_until(held, stop, *until, there);
  else
    changed.wait(held, stop, there);
  if (queue.empty()) return {};
  Item item = std::move(queue.front());
  queue.pop_front();
  return item;
}

void RailWriter::Impl::apply(Item item) {
  if (auto* begin = std::get_if<Begin>(&item)) {
    if (givenUp) return;
    passing.emplace(begin->rail, begin->papers, std::move(begin->setup), settings.place, settings.points,
                    settings.pointsMemoryMb << 20U, begin->time);
  } else if (auto* measured = std::get_if<Measured>(&item)) {
    if (passing) passing->add(*measured->result, measured->withPoints);
    {
      const std::scoped_lock held(mutex);
      --queuedProfiles;
      if (spare.size() < kSpareResults) spare.push_back(std::move(measured->result));
    }
    changed.notify_all();
  } else if (auto* end = std::get_if<End>(&item)) {
    if (passing) passing->end(end->ledger, std::move(end->stages), RailState::Finished, end->time);
  } else if (passing) {
    passing->addLost();
  }
}

void RailWriter::Impl::failed(const Error& error) {
  {
    const std::scoped_lock held(mutex);
    status.failure = error.message();
    if (!settings.live) givenUp = true;
  }
  changed.notify_all();
}

void RailWriter::Impl::store(const std::stop_token& stop) {
  if (!passing || !passing->dirty()) return;
  const std::size_t profiles = passing->pending();
  for (;;) {
    const auto stored = guarded([&] { passing->store(*database, systemTimeUs()); });
    if (stored) break;
    failed(stored.error());
    if (givenUp || stop.stop_requested()) {
      lost = stored.error();
      passing.reset();
      return;
    }
    std::unique_lock held(mutex);
    changed.wait_for(held, stop, kRetry, [] { return false; });
  }
  lastStored = Clock::now();
  const std::scoped_lock held(mutex);
  status.failure.clear();
  status.profilesStored += profiles;
  if (!passing->ended()) return;
  ++status.railsStored;
  passing.reset();
  if (delivery) delivery->railHasPassed();
}

void RailWriter::Impl::run(const std::stop_token& stop) {
  const auto every = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.commitEveryS));
  for (;;) {
    std::optional<Clock::time_point> until;
    if (passing && passing->dirty()) until = lastStored + every;
    auto item = take(stop, until);
    if (!item && stop.stop_requested()) break;
    if (item && std::holds_alternative<Begin>(*item) && passing) {
      // The one before never ended: its source failed.
      passing->end({}, {}, RailState::Interrupted, systemTimeUs());
      store(stop);
    }
    if (item) apply(std::move(*item));
    const bool due = passing && (passing->ended() || passing->pending() >= kBlockProfiles);
    if (due || (until && Clock::now() >= *until)) store(stop);
  }
  if (passing && !passing->ended()) passing->end({}, {}, RailState::Interrupted, systemTimeUs());
  store(stop);
}

RailWriter::RailWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
  impl_->thread = std::jthread([this](const std::stop_token& stop) { impl_->run(stop); });
}

RailWriter::~RailWriter() { (void)close(); }

Expected<std::unique_ptr<RailWriter>> RailWriter::open(std::string_view url, RailWriterSettings settings) {
  const auto parsed = parseArchiveUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  std::string file = parsed->file.string();
  const bool server = parsed->kind == ArchiveKind::Postgresql;
  if (server) {
    const auto there = Archive::open(url, Archive::Missing::Create);
    if (!there && (there.error().kind == ErrorKind::Input || !settings.live)) return tl::unexpected(there.error());
    const auto waiting = waitingRailsFile(settings.waitingFolder, shown(*parsed), settings.place.line);
    if (!waiting) return tl::unexpected(waiting.error());
    file = waiting->string();
  }
  auto archive = Archive::open("sqlite:" + file, Archive::Missing::Create);
  if (!archive) return tl::unexpected(archive.error());
  auto lock = WriterLock::take(file);
  if (!lock) return tl::unexpected(lock.error());
  const auto database = archive->database();
  if (const auto done = guarded([&] { interruptRunning(*database, settings.place.line); }); !done)
    return tl::unexpected(done.error());
  const auto retry = std::chrono::milliseconds(std::max<std::int64_t>(1, std::llround(1000 * settings.deliveryRetryS)));
  auto impl = std::make_unique<Impl>(std::move(settings), database, std::move(*lock));
  if (server) impl->delivery = std::make_unique<RailDelivery>(file, std::string(url), retry);
  return std::unique_ptr<RailWriter>(new RailWriter(std::move(impl)));
}

void RailWriter::begin(const RailBegin& rail, const RailPapers& papers, std::shared_ptr<const MeasuringSetup> setup) {
  impl_->push(Begin{rail, papers, std::move(setup), systemTimeUs()});
}

void RailWriter::add(const ProfileResult& result) { impl_->add(result); }

void RailWriter::end(const TriggerLedger& ledger, const std::vector<StageStatistics>& stages) {
  impl_->push(End{ledger, stages, systemTimeUs()});
}

RailWriterStatus RailWriter::status() const {
  const std::scoped_lock held(impl_->mutex);
  RailWriterStatus status = impl_->status;
  status.queued = impl_->queuedProfiles;
  status.queueCapacity = impl_->settings.queueWithoutPoints;
  if (impl_->delivery) {
    const RailDeliveryStatus delivery = impl_->delivery->status();
    status.railsStored = delivery.delivered;
    status.railsWaiting = delivery.waiting;
    if (status.failure.empty()) status.failure = delivery.failure;
  }
  return status;
}

Expected<void> RailWriter::close() {
  if (impl_->thread.joinable()) {
    impl_->thread.request_stop();
    impl_->thread.join();
  }
  const Expected<void> delivered = impl_->delivery ? impl_->delivery->finish() : Expected<void>{};
  if (impl_->lost) return tl::unexpected(*impl_->lost);
  return delivered;
}

}  // namespace vignole
