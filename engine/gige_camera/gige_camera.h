#pragma once
// One camera on the network: found at its address, checked, set up, streamed from. Only for this room.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "engine/geometry/expected.h"
#include "engine/gige_camera/camera_stream.h"

namespace vignole::gige {

/// Every call may come from any thread: one mutex owns the device, and what talks to it waits for its turn.
class GigeCamera {
 public:
  GigeCamera(int index, GigeCameraSettings settings, std::shared_ptr<CameraInbox> inbox);
  ~GigeCamera();
  GigeCamera(const GigeCamera&) = delete;
  GigeCamera& operator=(const GigeCamera&) = delete;

  /// Finds it, checks its serial and writes the settings, with the trigger armed; nothing streams yet.
  [[nodiscard]] Expected<void> open();
  /// A new stream with its buffers.
  [[nodiscard]] Expected<void> prepareStream(std::uint64_t epoch);
  [[nodiscard]] Expected<void> startAcquisition();
  /// Ends the stream and gives the camera back. One that does not answer is not asked to stop.
  void close(bool answers);

  /// A slow line can wait longer for missing packets than a fast one: two periods and a bit, the setting at least.
  void adaptRetention(double triggersPerS);
  /// Of the trigger: begins at 0, or is told. Errors where the camera cannot.
  [[nodiscard]] Expected<void> resetCount();
  [[nodiscard]] Expected<std::int64_t> count();
  [[nodiscard]] bool countIsCommon() const;  ///< the same number in all cameras by itself (chunk)

  /// Whether anything answers at its address, controlled or not; half a second at most, does not wait for its turn.
  [[nodiscard]] bool answers() const;
  [[nodiscard]] bool controlLost() const { return controlLost_.load(); }
  /// The last open() failed because another program controls the camera.
  [[nodiscard]] bool wasDenied() const { return denied_.load(); }
  [[nodiscard]] const std::string& where() const { return where_; }
  void report(CameraReport& report) const;  ///< all but state and why

 private:
  [[nodiscard]] Expected<void> openDevice();
  [[nodiscard]] Expected<void> writeSettings();
  [[nodiscard]] Expected<void> chooseCount();
  [[nodiscard]] Expected<void> choosePackets();
  void closeLocked(bool answers);
  static void controlWasLost(ArvGvDevice* device, void* self);

  const int index_;
  const GigeCameraSettings settings_;
  const std::string where_;
  std::shared_ptr<CameraInbox> inbox_;
  std::atomic<bool> controlLost_ = false, denied_ = false;
  mutable std::mutex deviceMutex_;
  Owned<ArvDevice> device_;
  Owned<ArvCamera> camera_;
  unsigned long lostSignal_ = 0;
  StreamSettings streamSettings_;
  std::string latch_, latchValue_;

  mutable std::mutex reportMutex_;  // never held while the device is talked to
  GigeIdentity identity_;
  CountSource count_ = CountSource::FrameId;
  int packetBytes_ = 0, retentionMs_ = 0;
  std::shared_ptr<CameraStream> stream_;
  CameraCounters earlier_;  ///< of streams that were closed
};

}  // namespace vignole::gige
