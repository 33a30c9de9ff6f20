#include "engine/gige_device/gvcp.h"

#include <algorithm>

namespace vignole::gige_device {

namespace {

constexpr std::size_t kHeaderBytes = 8;
constexpr std::uint8_t kKey = 0x42;

}  // namespace

std::uint16_t readBe16(ByteView bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] << 8 | bytes[at + 1]);
}
std::uint32_t readBe32(ByteView bytes, std::size_t at) {
  return static_cast<std::uint32_t>(readBe16(bytes, at)) << 16 | readBe16(bytes, at + 2);
}
void putBe16(std::uint8_t* to, std::uint16_t value) {
  to[0] = static_cast<std::uint8_t>(value >> 8);
  to[1] = static_cast<std::uint8_t>(value);
}
void putBe32(std::uint8_t* to, std::uint32_t value) {
  putBe16(to, static_cast<std::uint16_t>(value >> 16));
  putBe16(to + 2, static_cast<std::uint16_t>(value));
}
void putBe64(std::uint8_t* to, std::uint64_t value) {
  putBe32(to, static_cast<std::uint32_t>(value >> 32));
  putBe32(to + 4, static_cast<std::uint32_t>(value));
}

std::optional<GvcpCommand> readCommand(ByteView datagram) {
  if (datagram.size() < kHeaderBytes || datagram[0] != kKey) return {};
  GvcpCommand command;
  command.flags = datagram[1];
  command.command = readBe16(datagram, 2);
  command.id = readBe16(datagram, 6);
  if (command.id == 0) return {};
  const std::size_t said = readBe16(datagram, 4);
  command.complete = said <= datagram.size() - kHeaderBytes;
  command.payload = datagram.subspan(kHeaderBytes, std::min(said, datagram.size() - kHeaderBytes));
  return command;
}

Bytes acknowledge(const GvcpCommand& command, GvcpStatus status, ByteView payload) {
  if (status != GvcpStatus::Success) payload = {};
  Bytes out(kHeaderBytes + payload.size());
  putBe16(out.data(), static_cast<std::uint16_t>(status));
  putBe16(out.data() + 2, static_cast<std::uint16_t>(command.command + 1));
  putBe16(out.data() + 4, static_cast<std::uint16_t>(payload.size()));
  putBe16(out.data() + 6, command.id);
  std::copy(payload.begin(), payload.end(), out.begin() + kHeaderBytes);
  return out;
}

std::optional<ResendRequest> readResendRequest(const GvcpCommand& command) {
  const ByteView p = command.payload;
  if (p.size() < 12 || readBe16(p, 0) != 0) return {};
  ResendRequest request;
  request.frameId = readBe16(p, 2);
  request.firstPacket = readBe32(p, 4);
  request.lastPacket = readBe32(p, 8);
  if (command.extendedIds()) {
    if (p.size() < 20) return {};
    request.frameId = static_cast<std::uint64_t>(readBe32(p, 12)) << 32 | readBe32(p, 16);
  } else {
    request.firstPacket &= 0xffffff;
    request.lastPacket &= 0xffffff;
  }
  if (request.lastPacket < request.firstPacket) return {};
  return request;
}

}  // namespace vignole::gige_device
