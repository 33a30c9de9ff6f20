#pragma once
// One simulated camera: its sockets, its control side, its stream, its faults. Two threads: one answers, one sends.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/acquisition/frame_provider.h"
#include "engine/gige_device/control_channel.h"
#include "engine/gige_device/stream_sender.h"

namespace vignole::gige_device {

/// One trigger of the encoder, the same for all cameras.
struct Pulse {
  std::uint64_t count = 0;
  std::int64_t positionUm = 0;
  bool railPresent = true, railBegins = false;
  double scheduledS = 0;  ///< since the encoder began to tick, as if every tick came in time
};

struct DeviceCounters {
  std::uint64_t pulses = 0;           ///< that reached the camera while it was alive
  std::uint64_t framesTaken = 0;      ///< each has an id
  std::uint64_t framesSent = 0;       ///< whole, but for dropped packets
  std::uint64_t framesLost = 0;       ///< by the fault
  std::uint64_t framesAbandoned = 0;  ///< taken but not sent whole: stopped, died, or nowhere to go
  std::uint64_t triggersMissed = 0;   ///< by the fault
  std::uint64_t triggersIgnored = 0;  ///< came within the exposure, or while four frames waited to be sent
  std::uint64_t deaths = 0;
  std::uint64_t commands = 0;  ///< answered datagrams of the control channel
  StreamCounters stream;
};

struct DeviceSettings {
  int camera = 0;  ///< 0..3
  CameraIdentity identity;
  double gbps = 1;         ///< of its wire; 0: unlimited
  bool broadcast = false;  ///< answers discovery broadcasts as well
};

class GigeDevice {
 public:
  /// Whether a client has stopped the acquisition (or left), or something else has changed.
  using Changed = std::function<void(bool stoppedByClient)>;

  /// Answers from now on. `changed` is called by the device's threads, without its locks.
  [[nodiscard]] static Expected<std::unique_ptr<GigeDevice>> start(const DeviceSettings& settings,
                                                                   std::shared_ptr<FrameProvider> frames,
                                                                   std::shared_ptr<const FaultPlan> faults,
                                                                   Changed changed);
  ~GigeDevice();
  GigeDevice(const GigeDevice&) = delete;
  GigeDevice& operator=(const GigeDevice&) = delete;

  void pulse(const Pulse& pulse);
  void encoderAtRest();  ///< its count is 0 again

  /// Acquiring, and waiting for triggers of a line.
  [[nodiscard]] bool armed() const;
  [[nodiscard]] bool acquiring() const;
  [[nodiscard]] bool dead() const;
  /// Whether the next pulse would find room; one that is made slow by a fault shall not hold the others up.
  [[nodiscard]] bool hasRoom() const;
  [[nodiscard]] DeviceCounters counters() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// A frame that has been taken and not been sent yet.
  struct Exposure {
    std::uint64_t trigger = 0, frameId = 0, timestamp = 0;
    std::uint64_t encoderCount = 0, clockNs = 0;
    std::int64_t positionUm = 0;
    std::uint32_t lineStatus = 0;
    StreamSettings settings;
  };

  GigeDevice(const DeviceSettings& settings, std::shared_ptr<FrameProvider> frames,
             std::shared_ptr<const FaultPlan> faults, Changed changed, std::unique_ptr<StreamSender> sender, int socket,
             int broadcastSocket, int wake);
  void control(const std::stop_token& stop);
  void receive(int socket, bool broadcast);
  void stream(const std::stop_token& stop);
  void sendExposure(const Exposure& exposure, const std::stop_token& stop);
  // With mutex_ held:
  bool act(const std::vector<ControlEvent>& events);
  void live(std::uint64_t faultTime);
  void startAcquisition();
  bool stopAcquisition();
  void expose(std::uint64_t trigger, double scheduledS);
  void freeRun();
  [[nodiscard]] std::uint64_t clockNs() const;
  [[nodiscard]] std::uint64_t timestamp() const;
  [[nodiscard]] LiveValues liveValues() const;

  DeviceSettings settings_;
  std::shared_ptr<FrameProvider> frames_;
  std::shared_ptr<const FaultPlan> faults_;
  Changed changed_;
  std::unique_ptr<StreamSender> sender_;
  int socket_, broadcastSocket_, wake_;

  mutable std::mutex mutex_;
  std::condition_variable_any awake_;
  ControlChannel control_;
  StreamSettings stream_;
  bool acquiring_ = false, dead_ = false, encoderTicks_ = false, freshIds_ = true;
  std::uint64_t faultTime_ = 0;  ///< the trigger that faults go by: the encoder's, or else of the camera's own
  std::uint64_t nextId_ = 1, ownCount_ = 0, taken_ = 0, line1Count_ = 0;
  Clock::time_point clockZero_ = Clock::now();
  std::optional<Clock::time_point> nextFree_;  ///< when a camera without triggers takes its next frame
  std::optional<double> lastScheduledS_;
  Pulse lastPulse_;
  std::uint64_t encoderCount_ = 0;  ///< triggers issued
  std::deque<Exposure> queue_;
  bool sending_ = false;
  DeviceCounters counters_;

  std::jthread controlThread_, streamThread_;
};

}  // namespace vignole::gige_device
