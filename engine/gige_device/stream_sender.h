#pragma once
// The stream of one camera: frames cut into packets, sent at the pace of its wire, kept for a while so that lost
// packets can be sent again. send() from one thread, resend() from any.

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"
#include "engine/gige_device/fault_plan.h"
#include "engine/gige_device/gvsp.h"

namespace vignole::gige_device {

/// A frame on its way. The image is width x height pixels of `info`, its rows `stride` apart.
struct OutgoingFrame {
  std::uint64_t frameId = 1;
  bool extendedIds = false;
  std::uint64_t trigger = 0;  ///< which packets are lost is a matter of this
  ImageInfo info;
  ImageView image;
  std::shared_ptr<const void> lease;
  Bytes chunks;  ///< behind the image; info.chunkBytes of it
  std::uint32_t address = 0;
  std::uint16_t port = 0;
  int packetBytes = 1500;
  double packetDelayS = 0;
  bool corruptLeader = false;
};

struct StreamCounters {
  std::uint64_t packets = 0;         ///< sent, without those sent again
  std::uint64_t packetsDropped = 0;  ///< by the fault, sent again or not
  std::uint64_t resendRequests = 0, packetsResent = 0, resendsRefused = 0;
};

class StreamSender {
 public:
  /// A socket of that address with a port of the system's choice. `gbps` 0: as fast as it goes.
  [[nodiscard]] static Expected<std::unique_ptr<StreamSender>> open(int camera, std::uint32_t address, double gbps,
                                                                    std::shared_ptr<const FaultPlan> faults);
  ~StreamSender();
  StreamSender(const StreamSender&) = delete;
  StreamSender& operator=(const StreamSender&) = delete;

  /// Returns when the last packet is on the wire; false if it was broken off.
  bool send(OutgoingFrame frame, const std::stop_token& stop);
  /// Breaks a frame off that is being sent, and forgets those that were.
  void abort();
  /// Sends what was asked for again; packets of frames that are forgotten are answered as unavailable.
  void resend(const ResendRequest& request, bool extendedIds, std::uint32_t address, std::uint16_t port);
  void sendTestPacket(std::uint32_t address, std::uint16_t port, int packetBytes);

  [[nodiscard]] StreamCounters counters() const;
  [[nodiscard]] std::uint16_t port() const { return port_; }

 private:
  struct Sent;
  StreamSender(int camera, int socket, std::uint16_t port, double gbps, std::shared_ptr<const FaultPlan> faults);

  int camera_, socket_;
  std::uint16_t port_;
  double bytesPerS_;  ///< 0: unlimited
  std::shared_ptr<const FaultPlan> faults_;
  std::mutex mutex_;
  std::deque<std::shared_ptr<Sent>> ring_;
  std::atomic<std::uint64_t> aborts_{0};
  struct {
    std::atomic<std::uint64_t> packets{0}, packetsDropped{0}, resendRequests{0}, packetsResent{0}, resendsRefused{0};
  } counters_;
};

}  // namespace vignole::gige_device
