#include "engine/gige_device/gige_device.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include "engine/gige_device/feature_description.h"

namespace vignole::gige_device {

namespace {

constexpr std::size_t kMaxWaiting = 4;
constexpr int kControlTickMs = 50;  // how often a silent controller is looked for
// A trigger is not within the exposure before if only rounding says so.
constexpr double kExposureRounding = 1e-6;

std::string plainAddress(std::uint32_t address) {
  const in_addr in{htonl(address)};
  std::array<char, INET_ADDRSTRLEN> text{};
  return ::inet_ntop(AF_INET, &in, text.data(), text.size());
}

Expected<int> listenAt(std::uint32_t address, int camera) {
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = htonl(address);
  own.sin_port = htons(kControlPort);
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  // Several cameras hear the same broadcast; an address of one's own is nobody else's.
  if (address == INADDR_BROADCAST) ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (socket >= 0 && ::bind(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0) return socket;
  const int why = errno;
  if (socket >= 0) ::close(socket);
  const std::string where = "camera " + std::to_string(camera + 1);
  const std::string place = plainAddress(address) + ":" + std::to_string(kControlPort);
  if (why == EADDRINUSE)
    return worldError(where, place + " is taken by another program; stop it or choose another --address");
  return worldError(where, "cannot listen at " + place + " (" + std::strerror(why) + ")");
}

using Kind = ControlEvent::Kind;

}  // namespace

Expected<std::unique_ptr<GigeDevice>> GigeDevice::start(const DeviceSettings& settings,
                                                        std::shared_ptr<FrameProvider> frames,
                                                        std::shared_ptr<const FaultPlan> faults, Changed changed) {
  auto sender = StreamSender::open(settings.camera, settings.identity.address, settings.gbps, faults);
  if (!sender) return tl::unexpected<Error>(sender.error());
  const auto socket = listenAt(settings.identity.address, settings.camera);
  if (!socket) return tl::unexpected<Error>(socket.error());
  int broadcast = -1;
  if (settings.broadcast) {
    const auto heard = listenAt(INADDR_BROADCAST, settings.camera);
    if (!heard) {
      ::close(*socket);
      return tl::unexpected<Error>(heard.error());
    }
    broadcast = *heard;
  }
  const int wake = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  std::unique_ptr<GigeDevice> device(new GigeDevice(settings, std::move(frames), std::move(faults), std::move(changed),
                                                    std::move(*sender), *socket, broadcast, wake));
  return device;
}

GigeDevice::GigeDevice(const DeviceSettings& settings, std::shared_ptr<FrameProvider> frames,
                       std::shared_ptr<const FaultPlan> faults, Changed changed, std::unique_ptr<StreamSender> sender,
                       int socket, int broadcastSocket, int wake)
    : settings_(settings),
      frames_(std::move(frames)),
      faults_(std::move(faults)),
      changed_(std::move(changed)),
      sender_(std::move(sender)),
      socket_(socket),
      broadcastSocket_(broadcastSocket),
      wake_(wake),
      control_(settings.identity, [this](ControlChannel::Time) { return liveValues(); }),
      stream_(control_.streamSettings()) {
  {
    const std::lock_guard lock(mutex_);
    live(0);
  }
  controlThread_ = std::jthread([this](const std::stop_token& stop) { control(stop); });
  streamThread_ = std::jthread([this](const std::stop_token& stop) { stream(stop); });
}

GigeDevice::~GigeDevice() {
  controlThread_.request_stop();
  streamThread_.request_stop();
  const std::uint64_t one = 1;
  if (wake_ >= 0 && ::write(wake_, &one, sizeof one) < 0) {
    // The thread looks up by itself within a control tick.
  }
  sender_->abort();
  controlThread_.join();
  streamThread_.join();
  for (const int fd : {socket_, broadcastSocket_, wake_})
    if (fd >= 0) ::close(fd);
}

// ---------------------------------------------------------------------------------------------------------- control

void GigeDevice::control(const std::stop_token& stop) {
  std::array<pollfd, 3> fds = {{{socket_, POLLIN, 0}, {broadcastSocket_, POLLIN, 0}, {wake_, POLLIN, 0}}};
  while (!stop.stop_requested()) {
    ::poll(fds.data(), fds.size(), kControlTickMs);
    if (stop.stop_requested()) return;
    if ((fds[0].revents & POLLIN) != 0) receive(socket_, false);
    if (broadcastSocket_ >= 0 && (fds[1].revents & POLLIN) != 0) receive(broadcastSocket_, true);
    bool stopped = false;
    {
      const std::lock_guard lock(mutex_);
      if (dead_) continue;
      if (faults_->on("mute-control", settings_.camera, faultTime_))
        control_.keepAlive(Clock::now());  // a control side that hangs gives nobody up
      stopped = act(control_.expire(Clock::now()));
    }
    if (stopped) changed_(true);
  }
}

void GigeDevice::receive(int socket, bool broadcast) {
  std::array<std::uint8_t, 2048> buffer;
  // All that has come, and no more than that before the heartbeat is looked at.
  for (int i = 0; i < 64; ++i) {
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t bytes =
        ::recvfrom(socket, buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (bytes < 0) return;
    const ByteView datagram(buffer.data(), static_cast<std::size_t>(bytes));
    if (broadcast) {
      const auto command = readCommand(datagram);
      if (!command || command->command != static_cast<std::uint16_t>(Gvcp::Discovery)) continue;
    }
    const Peer peer{ntohl(from.sin_addr.s_addr), ntohs(from.sin_port)};
    ControlChannel::Answer answer;
    std::uint32_t address = 0;
    std::uint16_t port = 0;
    bool stopped = false, resendAnswered = false, extended = false, wasArmed = false, isArmed = false;
    {
      const std::lock_guard lock(mutex_);
      if (dead_ || faults_->on("mute-control", settings_.camera, faultTime_)) continue;
      wasArmed = acquiring_ && stream_.triggerOn;
      answer = control_.handle(datagram, peer, Clock::now());
      ++counters_.commands;
      stream_ = control_.streamSettings();
      stopped = act(answer.events);
      isArmed = acquiring_ && stream_.triggerOn;
      address = stream_.address;
      port = stream_.port;
      extended = stream_.extendedIds || faults_->on("ids-64", settings_.camera, faultTime_);
      resendAnswered = !faults_->on("no-resend", settings_.camera, faultTime_) &&
                       !faults_->on("ignore-resend", settings_.camera, faultTime_);
    }
    for (const ControlEvent& event : answer.events)
      if (event.kind == Kind::Resend && resendAnswered && port != 0)
        sender_->resend(event.resend, extended, address, port);
    if (!answer.datagram.empty())
      ::sendto(socket_, answer.datagram.data(), answer.datagram.size(), 0, reinterpret_cast<const sockaddr*>(&from),
               size);
    if (stopped || wasArmed != isArmed) changed_(stopped);
  }
}

/// Whether an acquisition was ended by it.
bool GigeDevice::act(const std::vector<ControlEvent>& events) {
  bool stopped = false;
  for (const ControlEvent& event : events) switch (event.kind) {
      case Kind::AcquisitionStart:
        startAcquisition();
        break;
      case Kind::AcquisitionStop:
        stopped = stopAcquisition() || stopped;
        break;
      case Kind::StreamClosed:
        stream_ = control_.streamSettings();
        freshIds_ = true;
        sender_->abort();
        break;
      case Kind::TimestampReset:
        line1Count_ = 0;
        clockZero_ = Clock::now();
        break;
      case Kind::SoftwareTrigger:
        if (acquiring_ && stream_.triggerOn && stream_.source == reg::TriggerSource::Software) {
          if (!encoderTicks_) live(ownCount_);
          if (!dead_) expose(ownCount_++, std::chrono::duration<double>(Clock::now().time_since_epoch()).count());
        }
        break;
      case Kind::FireTestPacket:
        if (stream_.port != 0) sender_->sendTestPacket(stream_.address, stream_.port, stream_.packetBytes);
        break;
      case Kind::Resend:
        break;  // without the lock
    }
  return stopped;
}

void GigeDevice::startAcquisition() {
  if (acquiring_) return;
  acquiring_ = true;
  control_.setAcquiring(true);
  if (freshIds_ || faults_->on("reset-ids", settings_.camera, faultTime_))
    nextId_ = static_cast<std::uint64_t>(faults_->value("start-id", settings_.camera, faultTime_, 1));
  freshIds_ = false;
  ownCount_ = taken_ = 0;
  lastScheduledS_.reset();
  nextFree_ = Clock::now();
  awake_.notify_all();
}

bool GigeDevice::stopAcquisition() {
  if (!acquiring_) return false;
  acquiring_ = false;
  control_.setAcquiring(false);
  counters_.framesAbandoned += queue_.size();
  queue_.clear();
  awake_.notify_all();
  return true;
}

/// Faults of that time come into force.
void GigeDevice::live(std::uint64_t faultTime) {
  faultTime_ = faultTime;
  const bool dead = faults_->dead(settings_.camera, faultTime);
  if (dead == dead_) return;
  dead_ = dead;
  if (dead) {
    ++counters_.deaths;
    // A camera that was alone in time goes on counting, or it would never come to its revival.
    const bool ranFree = acquiring_ && !stream_.triggerOn;
    stopAcquisition();
    if (!ranFree) nextFree_.reset();
    sender_->abort();
    return;
  }
  control_.reset();
  stream_ = control_.streamSettings();
  freshIds_ = true;
  line1Count_ = 0;
  clockZero_ = Clock::now();
  nextFree_.reset();
}

// ----------------------------------------------------------------------------------------------------------- frames

void GigeDevice::pulse(const Pulse& pulse) {
  const std::lock_guard lock(mutex_);
  encoderTicks_ = true;
  encoderCount_ = pulse.count + 1;
  lastPulse_ = pulse;
  live(pulse.count);
  if (dead_) return;
  ++counters_.pulses;
  // What the counter shows with the frame of this pulse is how many came before.
  if (acquiring_ && stream_.triggerOn &&
      (stream_.source == reg::TriggerSource::Line1 ||
       (stream_.source == reg::TriggerSource::Line2 && pulse.railBegins)))
    expose(pulse.count, pulse.scheduledS);
  ++line1Count_;
}

void GigeDevice::encoderAtRest() {
  const std::lock_guard lock(mutex_);
  encoderTicks_ = false;
  encoderCount_ = 0;
  lastPulse_ = {};
  live(0);
}

void GigeDevice::expose(std::uint64_t trigger, double scheduledS) {
  if (faults_->drawn("missed-trigger", settings_.camera, trigger)) {
    ++counters_.triggersMissed;
    return;
  }
  if ((lastScheduledS_ && scheduledS - *lastScheduledS_ < stream_.exposureUs * 1e-6 - kExposureRounding) ||
      queue_.size() >= kMaxWaiting) {
    ++counters_.triggersIgnored;
    return;
  }
  lastScheduledS_ = scheduledS;
  Exposure e;
  e.trigger = trigger;
  e.frameId = nextId_++;
  e.timestamp = timestamp();
  e.clockNs = clockNs();
  e.encoderCount = encoderTicks_ ? lastPulse_.count : 0;
  e.positionUm = lastPulse_.positionUm;
  e.lineStatus = liveValues().lineStatus;
  e.settings = stream_;
  ++counters_.framesTaken;
  queue_.push_back(std::move(e));
  ++taken_;
  if (stream_.mode == reg::AcquisitionMode::SingleFrame ||
      (stream_.mode == reg::AcquisitionMode::MultiFrame && taken_ >= stream_.frames)) {
    acquiring_ = false;  // what waits is still sent
    control_.setAcquiring(false);
  }
  awake_.notify_all();
}

void GigeDevice::freeRun() {
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(std::max(1 / stream_.frameRateHz, dead_ ? 0.0 : stream_.exposureUs * 1e-6)));
  // Frames that nobody had the time for are not made up for.
  nextFree_ = std::max(*nextFree_ + period, Clock::now());
  const std::uint64_t count = ownCount_++;
  if (!encoderTicks_) live(count);
  if (!dead_ && acquiring_) {
    lastScheduledS_.reset();
    expose(count, 0);
  }
}

void GigeDevice::stream(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::optional<Exposure> exposure;
    {
      std::unique_lock lock(mutex_);
      const auto freeRuns = [this] { return nextFree_ && (dead_ || (acquiring_ && !stream_.triggerOn)); };
      const auto due = [&] { return freeRuns() && Clock::now() >= *nextFree_; };
      if (queue_.empty() && !due()) {
        // A change of settings is seen at the next command's notification or within this time.
        const auto until = freeRuns() ? *nextFree_ : Clock::now() + std::chrono::milliseconds(100);
        awake_.wait_until(lock, stop, until, [&] { return !queue_.empty() || due(); });
      }
      if (stop.stop_requested()) return;
      if (due()) freeRun();
      if (queue_.empty()) continue;
      exposure = std::move(queue_.front());
      queue_.pop_front();
      sending_ = true;
    }
    sendExposure(*exposure, stop);
    {
      const std::lock_guard lock(mutex_);
      sending_ = false;
    }
  }
}

void GigeDevice::sendExposure(const Exposure& e, const std::stop_token& stop) {
  const int camera = settings_.camera;
  const auto count = [this](std::uint64_t DeviceCounters::*which) {
    const std::lock_guard lock(mutex_);
    ++(counters_.*which);
  };
  if (faults_->drawn("frame-loss", camera, e.trigger)) return count(&DeviceCounters::framesLost);
  const double slowMs = faults_->value("slow", camera, e.trigger, 0);
  if (slowMs > 0) {
    std::unique_lock lock(mutex_);
    awake_.wait_for(lock, stop, std::chrono::duration<double, std::milli>(slowMs), [this] { return dead_; });
  }
  const ProvidedFrame provided = frames_->frame(camera, e.trigger, stop);
  const StreamSettings& s = e.settings;
  if (provided.image.empty() || s.port == 0 || s.offsetX + s.width > provided.image.width ||
      s.offsetY + s.height > provided.image.height)
    return count(&DeviceCounters::framesAbandoned);
  OutgoingFrame frame;
  frame.frameId = e.frameId;
  frame.extendedIds = s.extendedIds || faults_->on("ids-64", camera, e.trigger);
  frame.trigger = e.trigger;
  frame.info = {e.timestamp,
                reg::kMono8,
                static_cast<std::uint32_t>(s.width),
                static_cast<std::uint32_t>(s.height),
                static_cast<std::uint32_t>(s.offsetX),
                static_cast<std::uint32_t>(s.offsetY),
                0};
  frame.image = {provided.image.row(s.offsetY) + s.offsetX, s.width, s.height, provided.image.stride};
  frame.lease = provided.lease;
  if (s.chunkMode) {
    appendChunkTag(frame.chunks, static_cast<std::uint32_t>(ChunkId::Image),
                   static_cast<std::uint32_t>(s.width * s.height));
    for (const std::size_t i : s.chunks) {
      const ChunkFeature& chunk = kChunks[i];
      const std::uint64_t value = chunk.id == ChunkId::EncoderCount      ? e.encoderCount
                                  : chunk.id == ChunkId::EncoderPosition ? static_cast<std::uint64_t>(e.positionUm)
                                  : chunk.id == ChunkId::LineStatus      ? e.lineStatus
                                                                         : e.clockNs;
      std::uint8_t* to = (frame.chunks.resize(frame.chunks.size() + chunk.bytes), frame.chunks.data());
      to += frame.chunks.size() - chunk.bytes;
      if (chunk.bytes == 8)
        putBe64(to, value);
      else
        putBe32(to, static_cast<std::uint32_t>(value));
      appendChunkTag(frame.chunks, static_cast<std::uint32_t>(chunk.id), chunk.bytes);
    }
    frame.info.chunkBytes = static_cast<std::uint32_t>(frame.chunks.size());
  }
  frame.address = s.address;
  frame.port = s.port;
  frame.packetBytes = s.packetBytes;
  frame.packetDelayS = s.packetDelayS;
  frame.corruptLeader = faults_->drawn("corrupt-leader", camera, e.trigger);
  {
    const std::lock_guard lock(mutex_);
    if (dead_) {
      ++counters_.framesAbandoned;
      return;
    }
  }
  count(sender_->send(std::move(frame), stop) ? &DeviceCounters::framesSent : &DeviceCounters::framesAbandoned);
}

// ------------------------------------------------------------------------------------------------------------ state

std::uint64_t GigeDevice::clockNs() const {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - clockZero_).count());
}

std::uint64_t GigeDevice::timestamp() const {
  return stream_.timestampCounter == reg::TimestampCounter::Line1 ? line1Count_ : clockNs();
}

LiveValues GigeDevice::liveValues() const {
  LiveValues values;
  values.timestamp = timestamp();
  values.encoderCount = encoderCount_;
  values.encoderPositionUm = lastPulse_.positionUm;
  values.lineStatus = encoderTicks_ ? kLine1Encoder | (lastPulse_.railPresent ? kLine2RailPresent : 0u) : 0u;
  values.resendOffered = !faults_->on("no-resend", settings_.camera, faultTime_);
  return values;
}

bool GigeDevice::armed() const {
  const std::lock_guard lock(mutex_);
  return acquiring_ && stream_.triggerOn && stream_.source != reg::TriggerSource::Software;
}

bool GigeDevice::acquiring() const {
  const std::lock_guard lock(mutex_);
  return acquiring_;
}

bool GigeDevice::dead() const {
  const std::lock_guard lock(mutex_);
  return dead_;
}

bool GigeDevice::hasRoom() const {
  const std::lock_guard lock(mutex_);
  return !acquiring_ || queue_.size() < kMaxWaiting || faults_->value("slow", settings_.camera, encoderCount_, 0) > 0;
}

DeviceCounters GigeDevice::counters() const {
  const std::lock_guard lock(mutex_);
  DeviceCounters c = counters_;
  c.stream = sender_->counters();
  return c;
}

}  // namespace vignole::gige_device
