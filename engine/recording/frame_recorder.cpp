#include "engine/recording/frame_recorder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <variant>

#include "engine/inspection/stage_meter.h"
#include "engine/recording/recording_files.h"
#include "engine/recording/sparse_frame.h"

namespace vignole {

namespace {

constexpr int kBehindMeasuring = 10;  // niceness on a live line: who measures goes first

struct FrameItem {
  Frame frame;
  std::uint64_t digest = 0;
  std::int64_t timeUs = 0;
};
struct BeginItem {
  int camera = 0;
  RailBegin rail;
  std::uint64_t from = 0;
};
struct ChunkItem {
  ChunkHead head;
  std::string text;
};
struct PassedItem {
  RailBegin rail;
  Verdict verdict = Verdict::NotMeasured;
};
struct KeepItem {};
struct SetupItem {
  Recipe recipe;
  RigCalibration calibration;
};
using Item = std::variant<FrameItem, BeginItem, ChunkItem, PassedItem, KeepItem, SetupItem>;

void giveWay() {
  const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
  (void)::setpriority(PRIO_PROCESS, thread, kBehindMeasuring);
}

}  // namespace

struct FrameRecorder::Impl {
  explicit Impl(FrameRecorderSettings chosen) : settings(chosen) {}

  /// What the source has told of one camera, recording or not.
  struct Stream {
    std::uint64_t next = 0;  ///< everything below has been given or never will be
    std::optional<RailBegin> rail;
    std::deque<std::uint64_t> given;  ///< frames that have not come out of the extraction yet
    std::size_t waiting = 0;          ///< frames in the queue
  };

  FrameRecorderSettings settings;
  std::array<StripeDigest, kCameraCount> digests;  // each by its camera's extraction

  std::mutex orders;  // start and stop, one at a time; before `mutex`
  mutable std::mutex mutex;
  std::condition_variable_any arrived, room;
  std::atomic<bool> recording = false;  // changed under the mutex; read without it by who has nothing to do then
  std::uint64_t from = 0;               // triggers below are not recorded
  std::array<Stream, kCameraCount> streams;
  std::deque<Item> queue;
  std::set<std::uint64_t> dropped;
  RecorderState told;
  std::array<std::uint64_t, kCameraCount> framesOf{};
  double shares = 0;

  std::unique_ptr<RecordingFiles> files;
  std::jthread packer, syncer;

  void hear(int camera, const FrameMessage& message);
  void put(Item item);
  void lose(int camera, std::uint64_t trigger, const std::string& reason);
  void drop(std::uint64_t trigger);
  void pack(const std::stop_token& stop);
  void write(FrameItem& item, FramePacker& packing, PackedBytes& bytes);
  void syncNowAndThen(const std::stop_token& stop) const;
};

FrameRecorder::FrameRecorder(FrameRecorderSettings settings) : impl_(std::make_unique<Impl>(settings)) {}
FrameRecorder::~FrameRecorder() { (void)stop(); }

// ---- orders

Expected<void> FrameRecorder::start(RecordingOrder order) {
  Impl& i = *impl_;
  const std::scoped_lock one(i.orders);
  if (i.files) return inputError(order.path.string(), "cannot be recorded: another recording is under way");
  std::uint64_t from = 0;
  {
    const std::scoped_lock lock(i.mutex);
    for (const Impl::Stream& s : i.streams) from = std::max(from, s.next);
  }
  // The files first, which takes a while; then again what the first trigger is.
  const std::filesystem::path path = order.path;
  auto files = RecordingFiles::open(std::move(order), from);
  if (!files) return tl::unexpected(files.error());
  i.files = std::move(*files);
  const std::scoped_lock lock(i.mutex);
  for (const Impl::Stream& s : i.streams) from = std::max(from, s.next);
  i.from = from;
  i.told = {};
  i.told.recording = true;
  i.told.path = path;
  i.framesOf = {};
  i.shares = 0;
  i.dropped.clear();
  i.queue.clear();
  // The rail in the gauge is that of the foremost camera; the others will tell of it when they come to it.
  const RailBegin* current = nullptr;
  for (const Impl::Stream& s : i.streams)
    if (s.rail && (current == nullptr || s.rail->firstTrigger > current->firstTrigger)) current = &*s.rail;
  for (int camera = 0; camera < kCameraCount; ++camera) {
    Impl::Stream& s = i.streams[static_cast<std::size_t>(camera)];
    s.given.clear();
    s.waiting = 0;
    if (s.rail && s.rail->firstTrigger == current->firstTrigger) i.queue.push_back(BeginItem{camera, *s.rail, from});
  }
  i.recording = true;
  i.packer = std::jthread([&i](const std::stop_token& stop) { i.pack(stop); });
  i.syncer = std::jthread([&i](const std::stop_token& stop) { i.syncNowAndThen(stop); });
  return {};
}

Expected<void> FrameRecorder::stop() {
  Impl& i = *impl_;
  const std::scoped_lock one(i.orders);
  if (!i.files) return {};
  {
    const std::scoped_lock lock(i.mutex);
    i.recording = false;
  }
  i.room.notify_all();
  i.packer.request_stop();  // ends when the queue is empty
  i.packer.join();
  i.syncer.request_stop();
  i.syncer.join();
  auto closed = i.files->close();
  const std::scoped_lock lock(i.mutex);
  i.told.recording = false;
  i.told.megabytes = 1e-6 * static_cast<double>(i.files->bytes());
  i.told.filesKept = i.files->kept();
  i.told.filesDiscarded = i.files->discarded();
  if (!closed) i.told.failure = closed.error().message();
  i.files.reset();
  return closed;
}

RecorderState FrameRecorder::state() const {
  const Impl& i = *impl_;
  const std::scoped_lock lock(i.mutex);
  RecorderState state = i.told;
  state.waiting = i.queue.size();
  state.triggers = *std::max_element(i.framesOf.begin(), i.framesOf.end());
  state.dropped = i.dropped.size();
  if (state.frames > 0) {
    state.keptShare = i.shares / static_cast<double>(state.frames);
    state.packCpuMs /= static_cast<double>(state.frames);
  }
  return state;
}

void FrameRecorder::use(const Recipe& recipe, const RigCalibration& calibration) {
  const std::scoped_lock lock(impl_->mutex);
  if (impl_->recording) impl_->put(SetupItem{recipe, calibration});
}

void FrameRecorder::railPassed(const RailBegin& rail, Verdict verdict) {
  const std::scoped_lock lock(impl_->mutex);
  if (impl_->recording) impl_->put(PassedItem{rail, verdict});
}

void FrameRecorder::keepThisRail() {
  const std::scoped_lock lock(impl_->mutex);
  if (impl_->recording) impl_->put(KeepItem{});
}

// ---- what is heard; under the mutex

void FrameRecorder::Impl::put(Item item) {
  queue.push_back(std::move(item));
  arrived.notify_one();
}

void FrameRecorder::Impl::lose(int camera, std::uint64_t trigger, const std::string& reason) {
  put(ChunkItem{{.kind = ChunkKind::Lost, .camera = static_cast<std::uint8_t>(camera), .trigger = trigger}, reason});
}

void FrameRecorder::Impl::drop(std::uint64_t trigger) {
  if (dropped.insert(trigger).second) put(ChunkItem{{.kind = ChunkKind::Dropped, .trigger = trigger}, {}});
}

void FrameRecorder::Impl::hear(int camera, const FrameMessage& message) {
  Stream& stream = streams[static_cast<std::size_t>(camera)];
  const auto head = [camera](ChunkKind kind, std::uint64_t trigger) {
    return ChunkHead{.kind = kind, .camera = static_cast<std::uint8_t>(camera), .trigger = trigger};
  };
  if (const auto* frame = std::get_if<Frame>(&message)) {
    stream.next = std::max(stream.next, frame->trigger + 1);
    if (recording && frame->trigger >= from) stream.given.push_back(frame->trigger);
  } else if (const auto* lost = std::get_if<FrameLost>(&message)) {
    stream.next = std::max(stream.next, lost->trigger + 1);
    if (recording && lost->trigger >= from) lose(camera, lost->trigger, lost->reason);
  } else if (const auto* rail = std::get_if<RailBegin>(&message)) {
    stream.rail = *rail;
    stream.next = std::max(stream.next, rail->firstTrigger);
    if (recording) put(BeginItem{camera, *rail, std::max(from, rail->firstTrigger)});
  } else if (const auto* end = std::get_if<RailEnd>(&message)) {
    stream.rail.reset();
    stream.next = std::max(stream.next, end->endTrigger);
    if (recording && end->endTrigger > from) put(ChunkItem{head(ChunkKind::RailEnd, end->endTrigger), {}});
  } else if (const auto* over = std::get_if<SourceEnd>(&message)) {
    stream.rail.reset();
    if (recording) put(ChunkItem{head(ChunkKind::SourceEnd, stream.next), over->error});
  }
}

void FrameRecorder::sourceGave(int camera, const FrameMessage& message) {
  if (camera < 0 || camera >= kCameraCount) return;
  const std::scoped_lock lock(impl_->mutex);
  impl_->hear(camera, message);
}

void FrameRecorder::extracted(const Frame& frame, const StripeResult& stripe) {
  Impl& i = *impl_;
  if (!i.recording || frame.camera < 0 || frame.camera >= kCameraCount) return;
  const auto c = static_cast<std::size_t>(frame.camera);
  std::unique_lock lock(i.mutex);
  if (!i.recording || frame.trigger < i.from) return;
  Impl::Stream& stream = i.streams[c];
  // Frames come out of the extraction in their order: what was given before and never came was lost on the way.
  while (!stream.given.empty() && stream.given.front() < frame.trigger) {
    i.lose(frame.camera, stream.given.front(), "queue overflow");
    stream.given.pop_front();
  }
  if (!stream.given.empty() && stream.given.front() == frame.trigger) stream.given.pop_front();
  if (!i.settings.live) i.room.wait(lock, [&] { return stream.waiting < i.settings.framesHeld || !i.recording; });
  if (!i.recording) return;
  if (stream.waiting >= i.settings.framesHeld || i.dropped.contains(frame.trigger)) {
    i.drop(frame.trigger);
    return;
  }
  ++stream.waiting;
  lock.unlock();
  const std::uint64_t digest = i.digests[c].of(stripe);
  lock.lock();
  if (i.recording)
    i.put(FrameItem{frame, digest, recordingTimeUs()});
  else
    --stream.waiting;
}

// ---- packing

void FrameRecorder::Impl::write(FrameItem& item, FramePacker& packing, PackedBytes& bytes) {
  const auto c = static_cast<std::size_t>(item.frame.camera);
  const ChunkHead head{.kind = ChunkKind::Frame,
                       .camera = static_cast<std::uint8_t>(item.frame.camera),
                       .trigger = item.frame.trigger,
                       .digest = item.digest,
                       .timeUs = item.timeUs};
  const bool wanted = files->wants(item.frame.trigger);
  const bool whole = wanted && packing.pack(item.frame.image, files->frameKind(), bytes) == FrameKind::Whole;
  item.frame.lease.reset();  // the source has its buffer back before the disk is waited for
  {
    const std::scoped_lock lock(mutex);
    --streams[c].waiting;
  }
  room.notify_all();
  if (wanted) files->add(head, bytes);
  const std::string failure = files->failure();
  const std::scoped_lock lock(mutex);
  told.failure = failure;
  if (!wanted) {
    if (!failure.empty()) dropped.insert(item.frame.trigger);
    return;
  }
  ++told.frames;
  ++framesOf[c];
  told.wholeFrames += whole ? 1 : 0;
  shares += packing.keptShare();
  told.packCpuMs = threadCpuMs();
  told.megabytes = 1e-6 * static_cast<double>(files->bytes());
  told.filesKept = files->kept();
  told.filesDiscarded = files->discarded();
}

void FrameRecorder::Impl::pack(const std::stop_token& stop) {
  if (settings.live) giveWay();
  FramePacker packing;
  PackedBytes bytes;
  for (;;) {
    std::optional<Item> item;
    {
      std::unique_lock lock(mutex);
      arrived.wait(lock, stop, [this] { return !queue.empty(); });
      if (queue.empty()) return;
      item.emplace(std::move(queue.front()));
      queue.pop_front();
    }
    if (auto* frame = std::get_if<FrameItem>(&*item)) {
      write(*frame, packing, bytes);
    } else if (auto* begin = std::get_if<BeginItem>(&*item)) {
      files->begin(begin->camera, begin->rail, begin->from);
    } else if (auto* chunk = std::get_if<ChunkItem>(&*item)) {
      files->add(chunk->head, std::span(reinterpret_cast<const std::uint8_t*>(chunk->text.data()), chunk->text.size()));
    } else if (auto* passed = std::get_if<PassedItem>(&*item)) {
      files->passed(passed->rail, passed->verdict);
    } else if (std::holds_alternative<KeepItem>(*item)) {
      files->keepLatest();
    } else if (auto* setup = std::get_if<SetupItem>(&*item)) {
      files->use(std::move(setup->recipe), std::move(setup->calibration));
    }
  }
}

void FrameRecorder::Impl::syncNowAndThen(const std::stop_token& stop) const {
  std::mutex unused;
  std::condition_variable_any never;
  std::unique_lock lock(unused);
  const auto every = std::chrono::duration<double>(settings.syncEveryS);
  while (!stop.stop_requested()) {
    never.wait_for(lock, stop, every, [] { return false; });
    files->sync();
  }
}

// ---- taps

namespace {

class TappedSource : public FrameSource {
 public:
  TappedSource(std::unique_ptr<FrameSource> source, std::shared_ptr<FrameRecorder> recorder)
      : source_(std::move(source)), recorder_(std::move(recorder)) {}

  [[nodiscard]] FrameMessage next(int camera, std::stop_token stop) override {
    FrameMessage message = source_->next(camera, std::move(stop));
    recorder_->sourceGave(camera, message);
    return message;
  }
  [[nodiscard]] bool live() const override { return source_->live(); }

 private:
  std::unique_ptr<FrameSource> source_;
  std::shared_ptr<FrameRecorder> recorder_;
};

}  // namespace

std::unique_ptr<FrameSource> tapped(std::unique_ptr<FrameSource> source, std::shared_ptr<FrameRecorder> recorder) {
  return std::make_unique<TappedSource>(std::move(source), std::move(recorder));
}

InspectionObserver tapped(InspectionObserver watch, std::shared_ptr<FrameRecorder> recorder) {
  watch.frameExtracted = [recorder = std::move(recorder), extracted = std::move(watch.frameExtracted)](
                             const Frame& frame, const StripeResult& stripe, double extractMs) {
    if (extracted) extracted(frame, stripe, extractMs);
    recorder->extracted(frame, stripe);
  };
  return watch;
}

}  // namespace vignole
