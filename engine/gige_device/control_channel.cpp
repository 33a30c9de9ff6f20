#include "engine/gige_device/control_channel.h"

#include <algorithm>
#include <utility>

namespace vignole::gige_device {

namespace {

constexpr std::chrono::seconds kRepeatWindow{1};
using Kind = ControlEvent::Kind;

bool isWrite(const GvcpCommand& command) {
  return command.command == static_cast<std::uint16_t>(Gvcp::WriteRegister) ||
         command.command == static_cast<std::uint16_t>(Gvcp::WriteMemory);
}

}  // namespace

ControlChannel::ControlChannel(const CameraIdentity& identity, std::function<LiveValues(Time)> live)
    : registers_(identity), live_(std::move(live)) {}

void ControlChannel::reset() {
  registers_.reset();
  controller_.reset();
  acquiring_ = false;
  lastWrite_.clear();
}

ControlChannel::Answer ControlChannel::handle(ByteView datagram, Peer from, Time now) {
  Answer answer;
  const auto command = readCommand(datagram);
  if (!command) return answer;
  if (!command->complete) {
    if (command->answerWanted()) answer.datagram = acknowledge(*command, GvcpStatus::InvalidHeader);
    return answer;
  }
  if (isController(from)) lastHeard_ = now;
  if (isWrite(*command) && from == lastWriter_ && now - lastWriteAt_ < kRepeatWindow &&
      std::equal(datagram.begin(), datagram.end(), lastWrite_.begin(), lastWrite_.end())) {
    if (command->answerWanted()) answer.datagram = lastAnswer_;
    return answer;
  }
  refresh(now);
  Bytes reply;
  switch (static_cast<Gvcp>(command->command)) {
    case Gvcp::Discovery:
      reply = acknowledge(*command, GvcpStatus::Success, registers_.discovery());
      break;
    case Gvcp::PacketResend:
      // From the stream's own socket, so by address alone; never answered but by the packets.
      if (const auto request = readResendRequest(*command);
          request && (from.address == registers_.get(reg::kStreamAddress) ||
                      (controller_ && controller_->address == from.address)))
        answer.events.push_back({Kind::Resend, *request});
      return answer;
    case Gvcp::ReadRegister:
      reply = readRegisters(*command, from);
      break;
    case Gvcp::WriteRegister:
      reply = writeRegisters(*command, from, now, answer.events);
      break;
    case Gvcp::ReadMemory:
      reply = readMemory(*command, from);
      break;
    case Gvcp::WriteMemory:
      reply = writeMemory(*command, from, now, answer.events);
      break;
    default:
      reply = acknowledge(*command, GvcpStatus::NotImplemented);
  }
  if (isWrite(*command)) {
    lastWrite_.assign(datagram.begin(), datagram.end());
    lastAnswer_ = reply;
    lastWriter_ = from;
    lastWriteAt_ = now;
  }
  if (command->answerWanted()) answer.datagram = std::move(reply);
  return answer;
}

std::vector<ControlEvent> ControlChannel::expire(Time now) {
  std::vector<ControlEvent> events;
  if (controller_ && now - lastHeard_ > std::chrono::milliseconds(registers_.get(reg::kHeartbeatTimeout)))
    leave(events);
  return events;
}

void ControlChannel::refresh(Time now) {
  const LiveValues live = live_(now);
  registers_.set64(reg::kEncoderCount, live.encoderCount);
  registers_.set64(reg::kEncoderPosition, static_cast<std::uint64_t>(live.encoderPositionUm));
  registers_.set(reg::kLineStatusAll, live.lineStatus);
  const std::uint32_t capability = registers_.get(reg::kCapability) & ~reg::kCapabilityResend;
  registers_.set(reg::kCapability, capability | (live.resendOffered ? reg::kCapabilityResend : 0));
}

Bytes ControlChannel::readRegisters(const GvcpCommand& command, Peer from) {
  const std::size_t bytes = command.payload.size();
  if (bytes == 0 || bytes % 4 != 0) return acknowledge(command, GvcpStatus::InvalidHeader);
  Bytes values(bytes);
  for (std::size_t at = 0; at < bytes; at += 4) {
    const reg::Address address = readBe32(command.payload, at);
    const bool exclusive = controller_ && (registers_.get(reg::kControlPrivilege) & reg::kPrivilegeExclusive) != 0;
    if (exclusive && !isController(from) && address != reg::kControlPrivilege)
      return acknowledge(command, GvcpStatus::AccessDenied);
    if (const GvcpStatus status = registers_.read(address, std::span(values).subspan(at, 4));
        status != GvcpStatus::Success)
      return acknowledge(command, status);
  }
  return acknowledge(command, GvcpStatus::Success, values);
}

Bytes ControlChannel::writeRegisters(const GvcpCommand& command, Peer from, Time now,
                                     std::vector<ControlEvent>& events) {
  const std::size_t bytes = command.payload.size();
  if (bytes == 0 || bytes % 8 != 0) return acknowledge(command, GvcpStatus::InvalidHeader);
  std::uint8_t count[4] = {};
  for (std::size_t at = 0; at < bytes; at += 8) {
    const GvcpStatus status =
        write(readBe32(command.payload, at), command.payload.subspan(at + 4, 4), from, now, events);
    if (status != GvcpStatus::Success) return acknowledge(command, status);
    putBe16(count + 2, static_cast<std::uint16_t>(at / 8 + 1));
  }
  return acknowledge(command, GvcpStatus::Success, count);
}

Bytes ControlChannel::readMemory(const GvcpCommand& command, Peer from) {
  if (command.payload.size() < 8) return acknowledge(command, GvcpStatus::InvalidHeader);
  const bool exclusive = controller_ && (registers_.get(reg::kControlPrivilege) & reg::kPrivilegeExclusive) != 0;
  if (exclusive && !isController(from)) return acknowledge(command, GvcpStatus::AccessDenied);
  const std::size_t bytes = readBe16(command.payload, 6);
  if (bytes == 0 || bytes > kMaxMemoryBytes) return acknowledge(command, GvcpStatus::InvalidParameter);
  Bytes out(4 + bytes);
  std::copy_n(command.payload.begin(), 4, out.begin());
  const GvcpStatus status = registers_.read(readBe32(command.payload, 0), std::span(out).subspan(4));
  return acknowledge(command, status, out);
}

Bytes ControlChannel::writeMemory(const GvcpCommand& command, Peer from, Time now, std::vector<ControlEvent>& events) {
  if (command.payload.size() < 8 || command.payload.size() - 4 > kMaxMemoryBytes)
    return acknowledge(command, GvcpStatus::InvalidHeader);
  const GvcpStatus status = write(readBe32(command.payload, 0), command.payload.subspan(4), from, now, events);
  std::uint8_t count[4] = {};
  putBe16(count + 2, static_cast<std::uint16_t>(command.payload.size() - 4));
  return acknowledge(command, status, count);
}

GvcpStatus ControlChannel::write(reg::Address address, ByteView data, Peer from, Time now,
                                 std::vector<ControlEvent>& events) {
  if (address == reg::kControlPrivilege && data.size() == 4)
    return writePrivilege(readBe32(data, 0), from, now, events);
  if (!isController(from)) return GvcpStatus::AccessDenied;
  if (const GvcpStatus status = registers_.write(address, data, acquiring_); status != GvcpStatus::Success)
    return status;
  for (std::size_t at = 0; at < data.size(); at += 4) {
    const std::uint32_t value = readBe32(data, at);
    switch (address + static_cast<reg::Address>(at)) {
      case reg::kAcquisitionStart:
        if (value != 0) events.push_back({Kind::AcquisitionStart});
        break;
      case reg::kAcquisitionStop:
        if (value != 0) events.push_back({Kind::AcquisitionStop});
        break;
      case reg::kTriggerSoftware:
        if (value != 0) events.push_back({Kind::SoftwareTrigger});
        break;
      case reg::kPacketSize:
        if ((value & reg::kFireTestPacket) != 0) events.push_back({Kind::FireTestPacket});
        break;
      case reg::kStreamPort:
        if ((value & 0xffff) == 0) events.push_back({Kind::StreamClosed});
        break;
      case reg::kTimestampControl:
        if ((value & reg::kTimestampLatch) != 0) registers_.set64(reg::kTimestampHigh, live_(now).timestamp);
        if ((value & reg::kTimestampReset) != 0) events.push_back({Kind::TimestampReset});
        break;
      default:
        break;
    }
  }
  return GvcpStatus::Success;
}

GvcpStatus ControlChannel::writePrivilege(std::uint32_t value, Peer from, Time now, std::vector<ControlEvent>& events) {
  if (controller_ && !isController(from)) return GvcpStatus::AccessDenied;
  if ((value & (reg::kPrivilegeControl | reg::kPrivilegeExclusive)) == 0) {
    if (controller_) leave(events);
    return GvcpStatus::Success;
  }
  controller_ = from;
  lastHeard_ = now;
  registers_.set(reg::kControlPrivilege, value & (reg::kPrivilegeControl | reg::kPrivilegeExclusive));
  registers_.set(reg::kPrimaryPort, from.port);
  registers_.set(reg::kPrimaryAddress, from.address);
  return GvcpStatus::Success;
}

void ControlChannel::leave(std::vector<ControlEvent>& events) {
  controller_.reset();
  for (const reg::Address address :
       {reg::kControlPrivilege, reg::kPrimaryPort, reg::kPrimaryAddress, reg::kStreamPort, reg::kStreamAddress})
    registers_.set(address, 0);
  events.push_back({Kind::AcquisitionStop});
  events.push_back({Kind::StreamClosed});
}

}  // namespace vignole::gige_device
