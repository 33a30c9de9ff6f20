#pragma once
// The cameras of the rig as GigE Vision devices on loopback addresses, and the encoder that triggers them together.
// Needs no root: any address of 127/8 may be bound.

#include <array>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/gige_device/gige_device.h"

namespace vignole::gige_device {

struct DeviceRigSettings {
  int cameras = 4;                          ///< 1..4
  std::string firstAddress = "127.0.0.11";  ///< the others follow; the control port is always 3956
  std::vector<std::string> serials;         ///< one a camera; VG1 ... where there are fewer
  double rateHz = 20;                       ///< triggers a second; frames a second while TriggerMode is Off
  double spacingMm = 15;                    ///< travel between two triggers
  double gbps = 1;                          ///< wire of each camera; 0: unlimited
  std::uint64_t seed = 1;                   ///< of what the faults take
  std::vector<Fault> faults;                ///< those of the picture are the provider's business
  bool broadcast = false;                   ///< answer discovery broadcasts as well
  int widthPx = 1400, heightPx = 1024;
};

struct EncoderCounters {
  std::uint64_t triggers = 0;   ///< of all runs
  std::uint64_t lateTicks = 0;  ///< more than half a period late: the machine was too slow to render or to send
  std::uint64_t runs = 0;       ///< how often all cameras were armed
  double rateHz = 0;            ///< reached, over the last run
};

class DeviceRig {
 public:
  /// Answers from now on; the encoder rests until all cameras are armed (camera_contract.h). It slows down rather than
  /// show a frame late: pictures that are not ready yet hold it back.
  [[nodiscard]] static Expected<std::unique_ptr<DeviceRig>> start(DeviceRigSettings settings,
                                                                  std::shared_ptr<FrameProvider> frames);
  ~DeviceRig();
  DeviceRig(const DeviceRig&) = delete;
  DeviceRig& operator=(const DeviceRig&) = delete;

  void addFaults(std::vector<Fault> faults) { faults_->add(std::move(faults)); }
  /// The trigger that will come next.
  [[nodiscard]] std::uint64_t nextTrigger() const;
  [[nodiscard]] EncoderCounters encoder() const;
  [[nodiscard]] DeviceCounters counters(int camera) const {
    return devices_[static_cast<std::size_t>(camera)]->counters();
  }
  [[nodiscard]] int cameras() const { return settings_.cameras; }
  [[nodiscard]] std::string address(int camera) const;

 private:
  DeviceRig(DeviceRigSettings settings, std::shared_ptr<FrameProvider> frames);
  void run(const std::stop_token& stop);
  void tickWhileWanted(const std::stop_token& stop);
  [[nodiscard]] bool allArmed() const;
  [[nodiscard]] bool wanted();
  bool waitForRoom(const std::stop_token& stop);

  DeviceRigSettings settings_;
  std::uint32_t firstAddress_ = 0;
  std::shared_ptr<FrameProvider> frames_;
  std::shared_ptr<FaultPlan> faults_;
  std::vector<std::unique_ptr<GigeDevice>> devices_;

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  bool stoppedByClient_ = false;
  std::uint64_t count_ = 0;
  EncoderCounters counters_;
  std::chrono::steady_clock::time_point lastAcquiring_;
  std::jthread encoder_;
};

}  // namespace vignole::gige_device
