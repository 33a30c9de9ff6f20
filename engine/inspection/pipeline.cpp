#include "engine/inspection/pipeline.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>

#include "engine/inspection/bounded_queue.h"
#include "engine/inspection/ledger_book.h"
#include "engine/inspection/object_pool.h"
#include "engine/inspection/stage_meter.h"
#include "engine/profile/assembler.h"

namespace vignole {

namespace {

struct ExtractedStripe {
  std::uint64_t trigger = 0;
  StripeResult stripe;
};
using StripePtr = ObjectPool<ExtractedStripe>::Ptr;
using ContourPtr = ObjectPool<PartialContour>::Ptr;
using AssemblyPtr = ObjectPool<Assembly>::Ptr;

/// What goes through the four lines: the stage's product, or a token that passes through as it is.
template <typename Product>
using Message = std::variant<Product, FrameLost, RailBegin, RailEnd, SourceEnd>;
using StripeMessage = Message<StripePtr>;
using ContourMessage = Message<ContourPtr>;
/// To the last stage: what the assembler settled, or the end.
using AssemblyMessage = std::variant<AssemblyPtr, SourceEnd>;

constexpr const char* kOverflow = "queue overflow";

std::uint64_t triggerOf(const Frame& frame) { return frame.trigger; }
std::uint64_t triggerOf(const StripePtr& stripe) { return stripe->trigger; }
std::uint64_t triggerOf(const ContourPtr& contour) { return contour->trigger; }

/// A token as the message of the next stage.
template <typename To>
struct PassOn {
  To operator()(FrameLost& token) const { return std::move(token); }
  To operator()(RailBegin& token) const { return std::move(token); }
  To operator()(RailEnd& token) const { return token; }
  To operator()(SourceEnd& token) const { return std::move(token); }
  template <typename Product>
  To operator()(Product& /*never a product*/) const {
    return SourceEnd{"pipeline: a product where a token was expected"};
  }
};

/// No exception leaves a thread: a stage whose work throws (memory, most likely) loses that frame and says so.
template <typename Work>
bool done(const Work& work) {
  try {
    work();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

struct Pipeline::Impl {
  template <typename T>
  using PerCamera = std::array<T, kCameraCount>;

  Impl(FrameSource& from, PipelineWork stageWork, InspectionObserver watcher, InspectionSettings chosen)
      : source(from), work(std::move(stageWork)), observer(std::move(watcher)), settings(chosen), live(from.live()) {
    for (std::size_t c = 0; c < kCameraCount; ++c) {
      toExtract[c] = std::make_unique<BoundedQueue<FrameMessage>>(settings.queueCapacity);
      toTranslate[c] = std::make_unique<BoundedQueue<StripeMessage>>(settings.queueCapacity);
    }
  }

  // Pools before queues: what still lies in a queue goes back to its pool.
  ObjectPool<ExtractedStripe> stripes;
  ObjectPool<PartialContour> contours;
  ObjectPool<Assembly> assemblies;

  FrameSource& source;
  PipelineWork work;
  InspectionObserver observer;
  InspectionSettings settings;
  bool live;

  PerCamera<std::unique_ptr<BoundedQueue<FrameMessage>>> toExtract;
  PerCamera<std::unique_ptr<BoundedQueue<StripeMessage>>> toTranslate;
  BoundedQueue<ContourMessage, kCameraCount> toProfile{settings.queueCapacity};
  BoundedQueue<AssemblyMessage> toMeasure{settings.queueCapacity};

  PerCamera<StageMeter> acquireMeter, extractMeter, translateMeter;
  StageMeter profileMeter, measureMeter;
  LedgerBook book;

  std::stop_source stopRequest;  // ends the acquisition only: what it delivered drains through the stages
  mutable std::mutex stateMutex;
  std::condition_variable stateChanged;
  bool started = false, finished = false;
  std::thread::id lastThread;
  std::vector<std::jthread> threads;  // last: joined first

  void start();
  void acquire(int camera);
  void extract(int camera);
  void translate(int camera);
  void profile();
  void measure();

  /// Live: a full queue drops the product and leaves a token in its place. Otherwise waits. `more`: the caller has its
  /// next message already, so the next stage need not be woken for this one alone.
  template <typename Queue, typename Item>
  void send(Queue& queue, Item&& message, int camera, std::size_t lane = 0, bool more = false);
  template <typename To>
  void sendAssembly(To& queue, AssemblyPtr assembly);
  void addToAssembler(ProfileAssembler& assembler, int camera, ContourMessage& message);
  void handle(const Assembly& assembly, ProfileResult& result);
};

template <typename Queue, typename Item>
void Pipeline::Impl::send(Queue& queue, Item&& message, int camera, std::size_t lane, bool more) {
  const auto wake = more ? Queue::Wake::Later : Queue::Wake::Now;
  if (!live) {
    queue.push(std::forward<Item>(message), {}, lane, wake);
    return;
  }
  if (message.index() != 0) {
    queue.pushToken(std::forward<Item>(message), lane);
    return;
  }
  if (queue.tryPush(std::forward<Item>(message), lane, wake)) return;
  // tryPush left the message untouched.
  FrameLost lost{camera, triggerOf(std::get<0>(message)), kOverflow};  // NOLINT(bugprone-use-after-move)
  message = std::move(lost);
  queue.pushToken(std::forward<Item>(message), lane);
}

void Pipeline::Impl::acquire(int camera) {
  const auto c = static_cast<std::size_t>(camera);
  const std::stop_token stop = stopRequest.get_token();
  for (bool ended = false; !ended;) {
    FrameMessage message = SourceEnd{};
    const StopWatch watch;
    if (!stop.stop_requested() && !done([&] { message = source.next(camera, stop); }))
      message = SourceEnd{"camera " + std::to_string(camera + 1) + ": the source failed unexpectedly"};
    if (Frame* frame = std::get_if<Frame>(&message)) {
      acquireMeter[c].add(watch.ms());
      frame->camera = camera;
    }
    ended = std::holds_alternative<SourceEnd>(message);
    send(*toExtract[c], std::move(message), camera);
  }
}

void Pipeline::Impl::extract(int camera) {
  const auto c = static_cast<std::size_t>(camera);
  for (bool ended = false; !ended;) {
    FrameMessage message = std::move(*toExtract[c]->pop());
    ended = std::holds_alternative<SourceEnd>(message);
    StripeMessage out;
    if (const Frame* frame = std::get_if<Frame>(&message)) {
      const StopWatch watch;
      StripePtr stripe = stripes.take();
      stripe->trigger = frame->trigger;
      const bool extracted = done([&] { work.extract(camera, frame->image, stripe->stripe); });
      const double ms = watch.ms();
      if (extracted && observer.frameExtracted) done([&] { observer.frameExtracted(*frame, stripe->stripe, ms); });
      if (extracted) {
        out = std::move(stripe);
      } else {
        out = FrameLost{camera, frame->trigger, "extraction failed"};
      }
      message = SourceEnd{};  // gives the buffer back before the next stage is waited for
      extractMeter[c].add(ms);
    } else {
      out = std::visit(PassOn<StripeMessage>{}, message);
    }
    send(*toTranslate[c], std::move(out), camera, 0, !toExtract[c]->empty());
  }
}

void Pipeline::Impl::translate(int camera) {
  const auto c = static_cast<std::size_t>(camera);
  for (bool ended = false; !ended;) {
    StripeMessage message = std::move(*toTranslate[c]->pop());
    ended = std::holds_alternative<SourceEnd>(message);
    ContourMessage out;
    if (const StripePtr* stripe = std::get_if<StripePtr>(&message)) {
      const StopWatch watch;
      ContourPtr contour = contours.take();
      const ExtractedStripe& from = **stripe;
      if (done([&] { work.translate(camera, from.trigger, from.stripe, *contour); })) {
        // Who and when is the pipeline's to say, whatever the work wrote.
        contour->camera = camera;
        contour->trigger = from.trigger;
        out = std::move(contour);
      } else {
        out = FrameLost{camera, from.trigger, "translation failed"};
      }
      translateMeter[c].add(watch.ms());
    } else {
      out = std::visit(PassOn<ContourMessage>{}, message);
    }
    send(toProfile, std::move(out), camera, c, !toTranslate[c]->empty());
  }
}

void Pipeline::Impl::addToAssembler(ProfileAssembler& assembler, int camera, ContourMessage& message) {
  std::visit(
      [&](auto& item) {
        if constexpr (std::is_same_v<std::decay_t<decltype(item)>, ContourPtr>) {
          assembler.add(*item);
        } else {
          assembler.add(camera, item);
        }
      },
      message);
}

template <typename To>
void Pipeline::Impl::sendAssembly(To& queue, AssemblyPtr assembly) {
  const bool isProfile = assembly->kind == Assembly::Kind::Profile;
  AssemblyMessage message = std::move(assembly);
  if (!live) {
    queue.push(std::move(message));
    return;
  }
  if (isProfile) {
    if (queue.tryPush(std::move(message))) return;
    // tryPush left the message untouched: the trigger is told as lost instead.
    Assembly& dropped = *std::get<AssemblyPtr>(message);  // NOLINT(bugprone-use-after-move)
    dropped.kind = Assembly::Kind::Lost;
    dropped.lost = 1;
    dropped.reasons.assign(1, kOverflow);
    // What its cameras had lost before is not forgotten with it.
    for (std::size_t c = 0; c < kCameraCount; ++c)
      if (!dropped.profile.missing[c].empty())
        dropped.reasons.push_back(cameraReason(static_cast<int>(c), dropped.profile.missing[c]));
  }
  queue.pushToken(std::move(message));
}

void Pipeline::Impl::profile() {
  const auto ahead = static_cast<std::uint64_t>(std::max(settings.pendingProfiles, 1));
  ProfileAssembler assembler({live ? ahead : 0});
  AssemblyPtr out = assemblies.take();
  double busyMs = 0;
  while (!assembler.ended()) {
    // Who is too far ahead is held back (not when live), so that what waits for the slowest camera stays bounded.
    auto taken =
        toProfile.pop({}, [&](std::size_t lane) { return live || assembler.lead(static_cast<int>(lane)) < ahead; });
    StopWatch watch;
    addToAssembler(assembler, static_cast<int>(taken->lane), taken->item);
    while (assembler.next(*out)) {
      busyMs += watch.ms();
      if (out->kind == Assembly::Kind::Profile) {
        profileMeter.add(busyMs);
        busyMs = 0;
      }
      sendAssembly(toMeasure, std::move(out));
      out = assemblies.take();
      watch = {};
    }
    busyMs += watch.ms();
  }
  toMeasure.pushToken(SourceEnd{assembler.error()});
}

void Pipeline::Impl::handle(const Assembly& assembly, ProfileResult& result) {
  switch (assembly.kind) {
    case Assembly::Kind::RailBegan:
      book.beginRail();
      if (observer.railBegan) observer.railBegan(*assembly.rail);
      break;
    case Assembly::Kind::Lost:
      book.enterLost(assembly.lost, assembly.reasons);
      break;
    case Assembly::Kind::RailEnded:
      if (observer.railEnded) observer.railEnded(*assembly.rail, book.ofThisRail());
      break;
    case Assembly::Kind::Profile: {
      const StopWatch watch;
      if (!done([&] { work.measure(*assembly.rail, result.profile, result.registration, result.measurement); })) {
        result.registration.valid = false;
        result.registration.reason = "measurement failed";
        result.measurement = {};
      }
      measureMeter.add(watch.ms());
      book.enterProfile(result.profile, result.registration);
      if (observer.profileMeasured) observer.profileMeasured(result);
      break;
    }
  }
}

void Pipeline::Impl::measure() {
  {
    const std::scoped_lock lock(stateMutex);
    lastThread = std::this_thread::get_id();
  }
  ProfileResult result;
  for (;;) {
    AssemblyMessage message = std::move(*toMeasure.pop());
    if (const SourceEnd* end = std::get_if<SourceEnd>(&message)) {
      if (observer.ended) observer.ended(end->error);
      break;
    }
    Assembly& assembly = *std::get<AssemblyPtr>(message);
    result.rail = assembly.rail;
    std::swap(result.profile, assembly.profile);  // buffers go round
    handle(assembly, result);
  }
  const std::scoped_lock lock(stateMutex);
  finished = true;
  stateChanged.notify_all();
}

void Pipeline::Impl::start() {
  const std::scoped_lock lock(stateMutex);
  if (started) return;
  started = true;
  threads.reserve(3 * kCameraCount + 2);
  threads.emplace_back([this] { measure(); });
  threads.emplace_back([this] { profile(); });
  for (int c = 0; c < kCameraCount; ++c) {
    threads.emplace_back([this, c] { translate(c); });
    threads.emplace_back([this, c] { extract(c); });
    threads.emplace_back([this, c] { acquire(c); });
  }
}

Pipeline::Pipeline(FrameSource& source, PipelineWork work, InspectionObserver observer, InspectionSettings settings)
    : impl_(std::make_unique<Impl>(source, std::move(work), std::move(observer), settings)) {}

Pipeline::~Pipeline() { stop(); }

void Pipeline::start() { impl_->start(); }

void Pipeline::stop() { impl_->stopRequest.request_stop(); }

void Pipeline::wait() {
  std::unique_lock lock(impl_->stateMutex);
  if (!impl_->started || impl_->lastThread == std::this_thread::get_id()) return;
  impl_->stateChanged.wait(lock, [this] { return impl_->finished; });
}

bool Pipeline::running() const {
  const std::scoped_lock lock(impl_->stateMutex);
  return impl_->started && !impl_->finished;
}

TriggerLedger Pipeline::triggers() const { return impl_->book.total(); }

namespace {

StageStatistics statisticsOf(const std::string& name, const StageMeter& meter) {
  const StageMeter::Reading reading = meter.read();
  const RunningStatistics& ms = reading.busyMs;
  StageStatistics stage;
  stage.name = name;
  stage.count = ms.count();
  stage.meanMs = ms.mean();
  stage.sdMs = ms.sd();
  stage.ucl99Ms = ucl99(ms);
  stage.maxMs = ms.max();
  stage.cpuMs = reading.cpuMs;
  return stage;
}

template <typename Queue>
StageStatistics statisticsOf(const std::string& name, const StageMeter& meter, const Queue& queueInFront) {
  StageStatistics stage = statisticsOf(name, meter);
  stage.queueCapacity = queueInFront.capacity();
  stage.queueDepth = queueInFront.depth();
  stage.queueHighWater = queueInFront.highWater();
  stage.overflows = queueInFront.overflows();
  return stage;
}

}  // namespace

std::vector<StageStatistics> Pipeline::stages() const {
  std::vector<StageStatistics> all;
  const auto numbered = [](const char* stage, std::size_t c) { return std::string(stage) + std::to_string(c + 1); };
  for (std::size_t c = 0; c < kCameraCount; ++c)
    all.push_back(statisticsOf(numbered("acquire.", c), impl_->acquireMeter[c]));
  for (std::size_t c = 0; c < kCameraCount; ++c)
    all.push_back(statisticsOf(numbered("extract.", c), impl_->extractMeter[c], *impl_->toExtract[c]));
  for (std::size_t c = 0; c < kCameraCount; ++c)
    all.push_back(statisticsOf(numbered("translate.", c), impl_->translateMeter[c], *impl_->toTranslate[c]));
  all.push_back(statisticsOf("profile", impl_->profileMeter, impl_->toProfile));
  all.push_back(statisticsOf("measure", impl_->measureMeter, impl_->toMeasure));
  return all;
}

}  // namespace vignole
