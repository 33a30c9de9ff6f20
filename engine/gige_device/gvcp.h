#pragma once
// GVCP, the control protocol of GigE Vision: datagrams to and from a camera's port 3956. Bytes in, values out; no
// sockets here. All numbers on the wire are big-endian.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vignole::gige_device {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

[[nodiscard]] std::uint16_t readBe16(ByteView bytes, std::size_t at);
[[nodiscard]] std::uint32_t readBe32(ByteView bytes, std::size_t at);
void putBe16(std::uint8_t* to, std::uint16_t value);
void putBe32(std::uint8_t* to, std::uint32_t value);
void putBe64(std::uint8_t* to, std::uint64_t value);

enum class Gvcp : std::uint16_t {
  Discovery = 0x0002,
  PacketResend = 0x0040,
  ReadRegister = 0x0080,
  WriteRegister = 0x0082,
  ReadMemory = 0x0084,
  WriteMemory = 0x0086,
};

enum class GvcpStatus : std::uint16_t {
  Success = 0x0000,
  NotImplemented = 0x8001,
  InvalidParameter = 0x8002,
  InvalidAddress = 0x8003,
  WriteProtect = 0x8004,
  BadAlignment = 0x8005,
  AccessDenied = 0x8006,
  Busy = 0x8007,
  InvalidHeader = 0x800e,
};

/// Data of one READMEM or WRITEMEM.
inline constexpr std::size_t kMaxMemoryBytes = 536;

struct GvcpCommand {
  std::uint8_t flags = 0;
  std::uint16_t command = 0, id = 0;
  ByteView payload;      ///< of the datagram that was read
  bool complete = true;  ///< false: the datagram is not as long as its header says
  [[nodiscard]] bool answerWanted() const { return (flags & 0x01) != 0; }
  [[nodiscard]] bool extendedIds() const { return (flags & 0x10) != 0; }
};

/// Nothing for what is no GVCP command (too short, wrong key, id 0): a camera does not answer that.
[[nodiscard]] std::optional<GvcpCommand> readCommand(ByteView datagram);

/// The answer to `command`, as its acknowledge; a status that is no success carries no payload.
[[nodiscard]] Bytes acknowledge(const GvcpCommand& command, GvcpStatus status, ByteView payload = {});

struct ResendRequest {
  std::uint64_t frameId = 0;
  std::uint32_t firstPacket = 0, lastPacket = 0;
};
/// Nothing if it is of another stream than the first, too short or backwards.
[[nodiscard]] std::optional<ResendRequest> readResendRequest(const GvcpCommand& command);

}  // namespace vignole::gige_device
