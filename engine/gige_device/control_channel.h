#pragma once
// The control side of one camera: answers GVCP commands, keeps the control privilege and its heartbeat. Datagrams and
// times come in as arguments, so it is tested without sockets and without waiting. Not thread-safe.

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "engine/gige_device/register_map.h"

namespace vignole::gige_device {

struct Peer {
  std::uint32_t address = 0;
  std::uint16_t port = 0;
  bool operator==(const Peer&) const = default;
};

/// What registers show that others know.
struct LiveValues {
  std::uint64_t timestamp = 0, encoderCount = 0;
  std::int64_t encoderPositionUm = 0;
  std::uint32_t lineStatus = 0;
  bool resendOffered = true;
};

/// What a command asks the camera to do, beyond what is in the registers.
struct ControlEvent {
  enum class Kind {
    AcquisitionStart,
    AcquisitionStop,  ///< also when the controller has left, or has been given up
    FireTestPacket,
    SoftwareTrigger,
    TimestampReset,
    StreamClosed,  ///< its port is 0
    Resend
  } kind;
  ResendRequest resend{};
};

class ControlChannel {
 public:
  using Time = std::chrono::steady_clock::time_point;

  ControlChannel(const CameraIdentity& identity, std::function<LiveValues(Time)> live);

  struct Answer {
    Bytes datagram;  ///< empty: none
    std::vector<ControlEvent> events;
  };
  [[nodiscard]] Answer handle(ByteView datagram, Peer from, Time now);
  /// To be called now and then: gives a silent controller up.
  [[nodiscard]] std::vector<ControlEvent> expire(Time now);
  /// The heartbeat is taken as heard: while the control side hangs, nobody is given up.
  void keepAlive(Time now) { lastHeard_ = now; }
  /// Power off and on.
  void reset();

  /// The camera tells whether frames may be under way.
  void setAcquiring(bool acquiring) { acquiring_ = acquiring; }
  [[nodiscard]] StreamSettings streamSettings() const { return registers_.streamSettings(); }
  [[nodiscard]] std::optional<Peer> controller() const { return controller_; }

 private:
  [[nodiscard]] bool isController(Peer peer) const { return controller_ && *controller_ == peer; }
  void refresh(Time now);
  Bytes readRegisters(const GvcpCommand& command, Peer from);
  Bytes writeRegisters(const GvcpCommand& command, Peer from, Time now, std::vector<ControlEvent>& events);
  Bytes readMemory(const GvcpCommand& command, Peer from);
  Bytes writeMemory(const GvcpCommand& command, Peer from, Time now, std::vector<ControlEvent>& events);
  GvcpStatus write(reg::Address address, ByteView data, Peer from, Time now, std::vector<ControlEvent>& events);
  GvcpStatus writePrivilege(std::uint32_t value, Peer from, Time now, std::vector<ControlEvent>& events);
  void leave(std::vector<ControlEvent>& events);

  RegisterMap registers_;
  std::function<LiveValues(Time)> live_;
  std::optional<Peer> controller_;
  Time lastHeard_{};
  bool acquiring_ = false;
  // A client that heard no answer asks again with the same number: it must not happen twice.
  Bytes lastWrite_, lastAnswer_;
  Peer lastWriter_;
  Time lastWriteAt_{};
};

}  // namespace vignole::gige_device
