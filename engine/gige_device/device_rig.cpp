#include "engine/gige_device/device_rig.h"

#include <algorithm>
#include <arpa/inet.h>
#include <chrono>
#include <utility>

namespace vignole::gige_device {

namespace {

using Clock = std::chrono::steady_clock;

// After the last camera has been armed: who armed it has the time to say so to the others.
constexpr std::chrono::milliseconds kStartDelay{100};
// Cameras that have all died may come back; then again their client may not.
constexpr std::chrono::seconds kIdleEnd{10};
constexpr std::uint32_t kLoopback = 0x7f000000, kLoopbackMask = 0xff000000;

Clock::duration seconds(double s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

}  // namespace

DeviceRig::DeviceRig(DeviceRigSettings settings, std::shared_ptr<FrameProvider> frames)
    : settings_(std::move(settings)),
      frames_(std::move(frames)),
      faults_(std::make_shared<FaultPlan>(settings_.seed, settings_.faults)) {}

Expected<std::unique_ptr<DeviceRig>> DeviceRig::start(DeviceRigSettings settings,
                                                      std::shared_ptr<FrameProvider> frames) {
  if (settings.cameras < 1 || settings.cameras > 4) return inputError("cameras", "there can be 1 to 4");
  if (!(settings.rateHz > 0)) return inputError("rate", "must be more than 0");
  in_addr in{};
  if (::inet_pton(AF_INET, settings.firstAddress.c_str(), &in) != 1)
    return inputError(settings.firstAddress, "is no address; write 127.x.y.z");
  const std::uint32_t first = ntohl(in.s_addr);
  const std::uint32_t last = first + static_cast<std::uint32_t>(settings.cameras - 1);
  if ((first & kLoopbackMask) != kLoopback || (last & kLoopbackMask) != kLoopback)
    return inputError(settings.firstAddress, "simulated cameras stay on loopback; write 127.x.y.z");

  std::unique_ptr<DeviceRig> rig(new DeviceRig(std::move(settings), std::move(frames)));
  rig->firstAddress_ = first;
  for (int c = 0; c < rig->settings_.cameras; ++c) {
    const DeviceRigSettings& s = rig->settings_;
    DeviceSettings device;
    device.camera = c;
    const auto index = static_cast<std::size_t>(c);
    device.identity.serial = index < s.serials.size() ? s.serials[index] : "VG" + std::to_string(c + 1);
    device.identity.userName = "camera" + std::to_string(c + 1);
    device.identity.address = first + static_cast<std::uint32_t>(c);
    // Locally administered, and different for every address.
    device.identity.mac = 0x020000000000ULL | device.identity.address;
    device.identity.widthPx = s.widthPx;
    device.identity.heightPx = s.heightPx;
    device.identity.frameRateHz = s.rateHz;
    device.gbps = s.gbps;
    device.broadcast = s.broadcast;
    auto started = GigeDevice::start(device, rig->frames_, rig->faults_, [r = rig.get()](bool stoppedByClient) {
      {
        const std::lock_guard lock(r->mutex_);
        r->stoppedByClient_ = r->stoppedByClient_ || stoppedByClient;
      }
      r->changed_.notify_all();
    });
    if (!started) return tl::unexpected<Error>(started.error());
    rig->devices_.push_back(std::move(*started));
  }
  rig->encoder_ = std::jthread([r = rig.get()](const std::stop_token& stop) { r->run(stop); });
  return rig;
}

DeviceRig::~DeviceRig() {
  if (encoder_.joinable()) {
    encoder_.request_stop();
    encoder_.join();
  }
  devices_.clear();
}

bool DeviceRig::allArmed() const {
  return std::all_of(devices_.begin(), devices_.end(), [](const auto& d) { return d->armed(); });
}

void DeviceRig::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (!allArmed()) {
      // Whoever arms says so; the time-out is for what is seen otherwise, as a register written while acquiring.
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, stop, std::chrono::milliseconds(20), [] { return false; });
      continue;
    }
    {
      std::unique_lock lock(mutex_);
      stoppedByClient_ = false;
      count_ = 0;
      ++counters_.runs;
    }
    tickWhileWanted(stop);
    {
      const std::lock_guard lock(mutex_);
      count_ = 0;
    }
    for (const auto& device : devices_) device->encoderAtRest();
  }
}

/// Until the last camera has been stopped by its client, or none has been there for a while.
bool DeviceRig::wanted() {
  bool acquiring = false, dead = false;
  for (const auto& device : devices_) {
    acquiring = acquiring || device->acquiring();
    dead = dead || device->dead();
  }
  const std::lock_guard lock(mutex_);
  if (acquiring) {
    stoppedByClient_ = false;
    lastAcquiring_ = Clock::now();
    return true;
  }
  return !(stoppedByClient_ && !dead) && Clock::now() - lastAcquiring_ < kIdleEnd;
}

bool DeviceRig::waitForRoom(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (std::all_of(devices_.begin(), devices_.end(), [](const auto& d) { return d->hasRoom(); })) return true;
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, std::chrono::milliseconds(1), [] { return false; });
  }
  return false;
}

void DeviceRig::tickWhileWanted(const std::stop_token& stop) {
  const double periodS = 1 / settings_.rateHz;
  const Clock::time_point begin = Clock::now() + kStartDelay;
  Clock::time_point due = begin;
  bool railBefore = false;
  for (std::uint64_t count = 0; !stop.stop_requested(); ++count) {
    if (frames_->triggers() && count >= *frames_->triggers()) {  // nothing moves any more
      std::unique_lock lock(mutex_);
      while (!stop.stop_requested()) {
        lock.unlock();
        const bool still = wanted();
        lock.lock();
        if (!still) return;
        changed_.wait_for(lock, stop, std::chrono::milliseconds(20), [] { return false; });
      }
      return;
    }
    if (!frames_->prepare(count, stop)) return;
    // The clock of the faults: a trigger is not held up by what it will find dead.
    if (!waitForRoom(stop)) return;
    for (;;) {
      if (!wanted()) return;
      std::unique_lock lock(mutex_);
      const auto until = std::min(due, Clock::now() + std::chrono::milliseconds(20));
      if (Clock::now() >= due) break;
      changed_.wait_until(lock, stop, until, [] { return false; });
      if (stop.stop_requested()) return;
    }
    const Clock::time_point now = Clock::now();
    const bool late = now - due > seconds(periodS / 2);
    Pulse pulse;
    pulse.count = count;
    pulse.positionUm = static_cast<std::int64_t>(static_cast<double>(count) * settings_.spacingMm * 1000 + 0.5);
    pulse.railPresent = frames_->railPresent(count);
    pulse.railBegins = pulse.railPresent && !railBefore;
    pulse.scheduledS = static_cast<double>(count) * periodS;
    railBefore = pulse.railPresent;
    for (const auto& device : devices_) device->pulse(pulse);
    {
      const std::lock_guard lock(mutex_);
      count_ = count + 1;
      ++counters_.triggers;
      if (late) ++counters_.lateTicks;
      const double elapsedS = std::chrono::duration<double>(now - begin).count();
      if (count > 0 && elapsedS > 0) counters_.rateHz = static_cast<double>(count) / elapsedS;
    }
    // A tick that came late is not made up for by quick ones behind it.
    due = (late ? now : due) + seconds(periodS);
  }
}

std::uint64_t DeviceRig::nextTrigger() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

EncoderCounters DeviceRig::encoder() const {
  const std::lock_guard lock(mutex_);
  return counters_;
}

std::string DeviceRig::address(int camera) const {
  const in_addr in{htonl(firstAddress_ + static_cast<std::uint32_t>(camera))};
  std::array<char, INET_ADDRSTRLEN> text{};
  return ::inet_ntop(AF_INET, &in, text.data(), text.size());
}

}  // namespace vignole::gige_device
