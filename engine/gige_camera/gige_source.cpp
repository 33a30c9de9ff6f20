#include "engine/gige_camera/gige_source.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "engine/gige_camera/gige_camera.h"
#include "engine/synchronisation/arrival_alignment.h"

namespace vignole {

namespace {

using gige::Arrival;
using gige::CameraInbox;
using gige::GigeCamera;
using gige::nowS;
using namespace std::chrono_literals;

constexpr std::size_t kCameras = 4;
constexpr const char* kCameraLost = "camera lost";
constexpr const char* kOverflow = "queue overflow";
constexpr auto kLook = 20ms;    // how often a camera is looked after
constexpr auto kRetry = 200ms;  // between two attempts to open a camera again
constexpr int kBracketAttempts = 25;

/// One thread a camera, joined.
template <typename Work>
void forEachCamera(const Work& work) {
  std::array<std::jthread, kCameras> threads;
  for (std::size_t c = 0; c < kCameras; ++c) threads[c] = std::jthread([&work, c] { work(c); });
}

}  // namespace

const char* name(CountSource source) {
  switch (source) {
    case CountSource::Auto:
      return "auto";
    case CountSource::Timestamp:
      return "timestamp";
    case CountSource::Chunk:
      return "chunk";
    case CountSource::FrameId:
      return "frame-id";
  }
  return "frame-id";
}

struct GigeSource::Impl {
  struct Lane {
    std::shared_ptr<CameraInbox> inbox;
    std::unique_ptr<GigeCamera> camera;
    // The rest under mutex.
    CameraWatch watch;
    std::uint64_t epoch = 0;
    std::optional<std::int64_t> offset;  ///< trigger = place + offset
    ArrivalAlignment alignment;
    bool down = false;
    std::uint64_t reconnections = 0, failedOpenings = 0, unaligned = 0;
  };

  explicit Impl(GigeSourceSettings chosen) : settings(std::move(chosen)), line(settings.line) {
    for (std::size_t c = 0; c < kCameras; ++c) {
      lanes[c].inbox = std::make_shared<CameraInbox>(settings.inboxFrames);
      lanes[c].camera = std::make_unique<GigeCamera>(static_cast<int>(c), settings.cameras[c], lanes[c].inbox);
      lanes[c].watch = CameraWatch(settings.watch);
    }
  }
  ~Impl();

  Expected<void> openAll();
  Expected<void> openPatiently(std::size_t c, const std::stop_token& stop);
  FrameMessage next(int camera, const std::stop_token& stop);
  void look(std::size_t c);
  void take(std::size_t c, Arrival arrival);
  [[nodiscard]] std::optional<std::uint64_t> triggerOf(std::size_t c, const Arrival& arrival);
  void pokeOthers(std::size_t c);
  void control(std::size_t c, const std::stop_token& stop);
  void reopen(std::size_t c, const std::stop_token& stop);
  void align(std::size_t c);
  [[nodiscard]] std::optional<std::int64_t> lagBehind(std::size_t reference, std::size_t c);
  /// By whose counts the camera's place can be found, the soundest first.
  [[nodiscard]] std::vector<std::size_t> othersThatCount(std::size_t c) const;
  [[nodiscard]] std::optional<std::int64_t> commonOffset(std::size_t c) const;
  [[nodiscard]] bool everybodyElseIsLost(std::size_t c) const;

  GigeSourceSettings settings;
  std::array<Lane, kCameras> lanes;
  mutable std::mutex mutex;
  TriggerLine line;
  std::mutex alignMutex;                        ///< one camera at a time finds its place
  std::array<std::jthread, kCameras> controls;  // last: ended first
};

GigeSource::Impl::~Impl() {
  for (std::jthread& thread : controls) thread.request_stop();
  for (std::jthread& thread : controls)
    if (thread.joinable()) thread.join();
  forEachCamera([this](std::size_t c) { lanes[c].camera->close(!lanes[c].camera->controlLost()); });
  for (Lane& lane : lanes) lane.inbox->clear();
}

// ---- opening

Expected<void> GigeSource::Impl::openPatiently(std::size_t c, const std::stop_token& stop) {
  // A controller that died holds the camera until its heartbeat runs out.
  const double until = nowS() + settings.cameras[c].heartbeatMs / 1000.0 + 2;
  for (;;) {
    auto opened = lanes[c].camera->open();
    if (opened || !lanes[c].camera->wasDenied() || nowS() > until || stop.stop_requested()) return opened;
    std::this_thread::sleep_for(kRetry);
  }
}

Expected<void> GigeSource::Impl::openAll() {
  std::array<Expected<void>, kCameras> results;
  forEachCamera([&](std::size_t c) {
    results[c] = openPatiently(c, {});
    if (results[c]) results[c] = lanes[c].camera->prepareStream(0);
    if (results[c]) results[c] = lanes[c].camera->resetCount();
  });
  const auto failedToStart = [&](std::size_t c) -> bool {
    if (results[c]) return false;
    const std::scoped_lock lock(mutex);
    lanes[c].down = true;
    lanes[c].watch.failed(results[c].error().what);
    line.setDown(static_cast<int>(c), kCameraLost);
    return true;
  };
  for (std::size_t c = 0; c < kCameras; ++c)
    if (failedToStart(c) && settings.allAtStart) return tl::unexpected(results[c].error());
  for (std::size_t c = 0; c < kCameras; ++c)
    if (results[c]) align(c);
  // All are armed; only now does the first of them answer triggers.
  forEachCamera([&](std::size_t c) {
    if (!results[c]) return;
    {
      const std::scoped_lock lock(mutex);
      lanes[c].watch.opened(nowS());
    }
    results[c] = lanes[c].camera->startAcquisition();
  });
  for (std::size_t c = 0; c < kCameras; ++c)
    if (lanes[c].watch.state() != CameraState::Lost && failedToStart(c) && settings.allAtStart)
      return tl::unexpected(results[c].error());
  for (std::size_t c = 0; c < kCameras; ++c)
    controls[c] = std::jthread([this, c](const std::stop_token& stop) { control(c, stop); });
  return {};
}

// ---- which trigger a frame is of

/// What is to be added to the camera's count to have the reference's, both read at the same trigger.
std::optional<std::int64_t> GigeSource::Impl::lagBehind(std::size_t reference, std::size_t c) {
  for (int attempt = 0; attempt < kBracketAttempts; ++attempt) {
    const auto before = lanes[reference].camera->count();
    const auto mine = lanes[c].camera->count();
    const auto after = lanes[reference].camera->count();
    if (!before || !mine || !after) return {};
    if (*before == *after) return *before - *mine;
  }
  return {};
}

std::vector<std::size_t> GigeSource::Impl::othersThatCount(std::size_t c) const {
  std::vector<std::size_t> others;
  for (const CameraState state : {CameraState::Connected, CameraState::Connecting, CameraState::Degraded})
    for (std::size_t other = 0; other < kCameras; ++other)
      if (other != c && lanes[other].offset && lanes[other].watch.state() == state &&
          !lanes[other].camera->controlLost())
        others.push_back(other);
  return others;
}

bool GigeSource::Impl::everybodyElseIsLost(std::size_t c) const {
  for (std::size_t other = 0; other < kCameras; ++other)
    if (other != c && lanes[other].offset && lanes[other].watch.state() != CameraState::Lost) return false;
  return true;
}

/// Of a camera whose count is common to all: what the others add to theirs.
std::optional<std::int64_t> GigeSource::Impl::commonOffset(std::size_t c) const {
  if (!lanes[c].camera->countIsCommon()) return {};
  for (std::size_t other = 0; other < kCameras; ++other)
    if (other != c && lanes[other].offset && lanes[other].camera->countIsCommon()) return lanes[other].offset;
  return {};
}

void GigeSource::Impl::align(std::size_t c) {
  const std::scoped_lock alone(alignMutex);
  Lane& lane = lanes[c];
  const bool common = lane.camera->countIsCommon();
  const auto now = lane.camera->count();
  std::vector<std::size_t> references;
  {
    const std::scoped_lock lock(mutex);
    lane.offset.reset();
    lane.alignment = ArrivalAlignment();
    if (everybodyElseIsLost(c)) {
      const bool first = line.next() == 0;
      // Nobody is left who counts: triggers are counted on from here.
      if (!first) line.restartCounts();
      // Every count was reset when the cameras were opened, the common one begins at 0 by itself.
      if (first && (common || now)) lane.offset = 0;
      if (!first && !common && now) lane.offset = static_cast<std::int64_t>(line.next()) - *now;
      return;  // without an offset its first frame says it
    }
    lane.offset = commonOffset(c);
    if (lane.offset) return;
    references = othersThatCount(c);
  }
  for (const std::size_t reference : references) {
    const auto lag = lagBehind(reference, c);
    const std::scoped_lock lock(mutex);
    if (!lag || !lanes[reference].offset) continue;
    lane.offset = *lag + *lanes[reference].offset;
    return;
  }
}

std::optional<std::uint64_t> GigeSource::Impl::triggerOf(std::size_t c, const Arrival& arrival) {
  Lane& lane = lanes[c];
  if (arrival.tag.kind == FrameTag::Kind::Restarted) {
    lane.offset.reset();
    lane.alignment = ArrivalAlignment();
  }
  if (!lane.offset) lane.offset = commonOffset(c);
  if (!lane.offset && everybodyElseIsLost(c)) {
    // The first of all says where the count goes on.
    lane.offset = static_cast<std::int64_t>(line.next()) - arrival.tag.place;
  } else if (!lane.offset) {
    lane.offset = lane.alignment.add(arrival.tag.place, arrival.s);
  }
  if (!lane.offset || arrival.tag.place + *lane.offset < 0) {
    ++lane.unaligned;
    return {};
  }
  return static_cast<std::uint64_t>(arrival.tag.place + *lane.offset);
}

// ---- the frames' way

void GigeSource::Impl::take(std::size_t c, Arrival arrival) {
  const int camera = static_cast<int>(c);
  const bool rail =
      arrival.lease && (settings.cameras[c].railLine ? arrival.railLine : railInView(arrival.image, settings.presence));
  Arrival gone;  // its buffer goes back outside of the lock
  const std::scoped_lock lock(mutex);
  Lane& lane = lanes[c];
  if (arrival.epoch != lane.epoch) {
    gone = std::move(arrival);
    return;
  }
  lane.watch.frame(nowS());
  if (!lane.watch.silent()) lane.down = false;
  const auto trigger = triggerOf(c, arrival);
  if (!trigger) {
    gone = std::move(arrival);
    return;
  }
  const FrameTag& tag = arrival.tag;
  if (tag.between() > 0) {
    // Which of them is which is not known, only how many.
    line.lose(camera, *trigger, tag.missed, "missed trigger");
    line.lose(camera, *trigger - std::min(*trigger, tag.missed), tag.lost, "frame lost");
    line.lose(camera, *trigger - std::min(*trigger, tag.missed + tag.lost), tag.incomplete, "incomplete frame");
  }
  if (!arrival.lease) {
    line.lose(camera, *trigger + 1, 1, kOverflow);
    return;
  }
  for (Lane& other : lanes)
    if (!other.offset) other.alignment.addReference(*trigger, arrival.s);
  line.add(Frame{camera, *trigger, arrival.image, std::move(arrival.lease)}, rail, arrival.s);
}

void GigeSource::Impl::pokeOthers(std::size_t c) {
  for (std::size_t other = 0; other < kCameras; ++other)
    if (other != c) lanes[other].inbox->poke();
}

void GigeSource::Impl::look(std::size_t c) {
  Lane& lane = lanes[c];
  if (lane.camera->controlLost()) lane.watch.controlLost();
  lane.watch.look(nowS(), line.behind(static_cast<int>(c)));
  if (lane.watch.silent() && !lane.down) {
    lane.down = true;
    line.setDown(static_cast<int>(c), kCameraLost);
  }
}

FrameMessage GigeSource::Impl::next(int camera, const std::stop_token& stop) {
  const auto c = static_cast<std::size_t>(camera);
  while (!stop.stop_requested()) {
    {
      const std::scoped_lock lock(mutex);
      if (auto message = line.take(camera)) return *std::move(message);
      look(c);
      if (auto message = line.take(camera)) return *std::move(message);
    }
    auto arrival = lanes[c].inbox->take(stop, kLook);
    if (!arrival) continue;
    take(c, *std::move(arrival));
    pokeOthers(c);
  }
  return SourceEnd{};
}

// ---- looking after a camera

void GigeSource::Impl::control(std::size_t c, const std::stop_token& stop) {
  std::mutex sleeping;
  std::condition_variable_any never;
  while (!stop.stop_requested()) {
    bool again = false;
    double rate = 0;
    {
      const std::scoped_lock lock(mutex);
      again = lanes[c].watch.toBeOpenedAgain(line.railRunning());
      rate = line.triggersPerS();
    }
    lanes[c].camera->adaptRetention(rate);
    // Until it answers it is left as it is: its frames may still come, and Aravis would wait for it for seconds.
    if (again && lanes[c].camera->answers()) {
      reopen(c, stop);
    } else if (again) {
      const std::scoped_lock lock(mutex);
      lanes[c].watch.doesNotAnswer();
    }
    std::unique_lock lock(sleeping);
    never.wait_for(lock, stop, kLook, [] { return false; });
  }
}

void GigeSource::Impl::reopen(std::size_t c, const std::stop_token& stop) {
  Lane& lane = lanes[c];
  std::uint64_t epoch = 0;
  {
    const std::scoped_lock lock(mutex);
    epoch = ++lane.epoch;
    lane.offset.reset();
    lane.watch.failed(lane.watch.why());
    lane.down = true;
    line.setDown(static_cast<int>(c), kCameraLost);
  }
  lane.camera->close(true);
  lane.inbox->clear();
  auto opened = lane.camera->open();
  if (opened) opened = lane.camera->prepareStream(epoch);
  if (opened) {
    align(c);
    {
      const std::scoped_lock lock(mutex);
      lane.watch.opened(nowS());
      line.setUp(static_cast<int>(c));
    }
    opened = lane.camera->startAcquisition();
  }
  {
    const std::scoped_lock lock(mutex);
    if (opened) {
      ++lane.reconnections;
      return;
    }
    ++lane.failedOpenings;
    lane.watch.failed(opened.error().what);
  }
  std::mutex sleeping;
  std::condition_variable_any never;
  std::unique_lock lock(sleeping);
  never.wait_for(lock, stop, kRetry, [] { return false; });
}

// ---- what others see

Expected<std::unique_ptr<GigeSource>> GigeSource::open(GigeSourceSettings settings) {
  auto impl = std::make_unique<Impl>(std::move(settings));
  if (auto opened = impl->openAll(); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<GigeSource>(new GigeSource(std::move(impl)));
}

GigeSource::GigeSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GigeSource::~GigeSource() = default;

FrameMessage GigeSource::next(int camera, std::stop_token stop) { return impl_->next(camera, stop); }

std::vector<CameraReport> GigeSource::cameras() const {
  std::vector<CameraReport> reports(kCameras);
  for (std::size_t c = 0; c < kCameras; ++c) {
    CameraReport& report = reports[c];
    impl_->lanes[c].camera->report(report);
    switch (report.countSource) {
      case CountSource::FrameId:
        report.cannotTell =
            "a trigger that the camera misses leaves no trace in its frame ids: its profiles are one trigger off until "
            "it is opened again";
        break;
      case CountSource::Auto:
      case CountSource::Timestamp:
      case CountSource::Chunk:
        break;
    }
    const std::scoped_lock lock(impl_->mutex);
    const Impl::Lane& lane = impl_->lanes[c];
    report.state = lane.watch.state();
    report.why = lane.watch.why();
    report.counters.reconnections = lane.reconnections;
    report.counters.failedOpenings = lane.failedOpenings;
    report.counters.unaligned = lane.unaligned;
  }
  return reports;
}

TriggerLineCounts GigeSource::counts() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->line.counts();
}

double GigeSource::triggersPerS() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->line.triggersPerS();
}

std::array<Expected<GigeIdentity>, 4> identify(const std::array<GigeCameraSettings, 4>& cameras) {
  std::array<Expected<GigeIdentity>, 4> found;
  forEachCamera([&](std::size_t c) {
    GigeCamera camera(static_cast<int>(c), cameras[c], nullptr);
    auto opened = camera.open();
    CameraReport report;
    camera.report(report);
    camera.close(true);
    if (opened) {
      found[c] = report.identity;
    } else {
      found[c] = tl::unexpected(opened.error());
    }
  });
  return found;
}

}  // namespace vignole
