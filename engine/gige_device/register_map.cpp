#include "engine/gige_device/register_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <utility>

#include "engine/gige_device/feature_description.h"

namespace vignole::gige_device {

namespace {

using reg::Address;

constexpr Address kBootstrapEnd = 0x1000, kFeaturesBegin = 0xa000;
constexpr std::uint32_t kDefaultHeartbeatMs = 3000, kDefaultPacketSize = 1500, kTickHz = 1000000000;
constexpr std::uint32_t kMaxDelayTicks = 10000000;

bool isText(Address address) { return address >= reg::kUserName && address < reg::kUserName + 16; }

bool isCommand(Address address) {
  return address == reg::kAcquisitionStart || address == reg::kAcquisitionStop || address == reg::kTriggerSoftware ||
         address == reg::kTimestampControl;
}

/// Nothing that the length of a frame or its way depends on may change while frames are under way.
bool lockedWhileAcquiring(Address address) {
  switch (address) {
    case reg::kWidth:
    case reg::kHeight:
    case reg::kOffsetX:
    case reg::kOffsetY:
    case reg::kPixelFormat:
    case reg::kAcquisitionMode:
    case reg::kAcquisitionFrames:
    case reg::kChunkModeActive:
    case reg::kExtendedIds:
      return true;
    default:
      return address >= reg::kChunkEnable && address < reg::kChunkEnable + 4 * kChunks.size();
  }
}

}  // namespace

RegisterMap::RegisterMap(const CameraIdentity& identity)
    : identity_(identity),
      description_(featureDescription(identity.widthPx, identity.heightPx)),
      memory_(reg::kFeaturesEnd) {
  reset();
}

void RegisterMap::reset() {
  std::fill(memory_.begin(), memory_.end(), std::uint8_t{0});
  set(reg::kVersion, 2u << 16);
  set(reg::kDeviceMode, 0x80000001);  // big-endian, transmitter, UTF-8
  set(reg::kMacHigh, static_cast<std::uint32_t>(identity_.mac >> 32) & 0xffff);
  set(reg::kMacLow, static_cast<std::uint32_t>(identity_.mac));
  set(reg::kIpOptions, 0x5);
  set(reg::kIpConfiguration, 0x5);  // persistent address, else one of its own choice
  for (const Address address : {reg::kIpAddress, reg::kPersistentIp}) set(address, identity_.address);
  for (const Address address : {reg::kSubnetMask, reg::kPersistentMask}) set(address, 0xff000000);
  setText(reg::kVendor, 32, kVendorName);
  setText(reg::kModel, 32, kModelName);
  setText(reg::kDeviceVersion, 32, "Vignole simulation");
  setText(reg::kManufacturerInfo, 48, "simulated camera of Vignole's virtual rig");
  setText(reg::kSerial, 16, identity_.serial);
  setText(reg::kUserName, 16, identity_.userName);
  char url[64];
  std::snprintf(url, sizeof url, "Local:vignole_genie.xml;%x;%zx", reg::kDescription, description_.size());
  setText(reg::kFirstUrl, 512, url);
  set(reg::kInterfaces, 1);
  set(reg::kLinkSpeed, 1000);
  set(reg::kStreamChannels, 1);
  set(reg::kCapability, reg::kCapabilityConcatenation | reg::kCapabilityWriteMemory | reg::kCapabilityResend |
                            reg::kCapabilityLinkSpeed | reg::kCapabilitySerial | reg::kCapabilityUserName);
  set(reg::kHeartbeatTimeout, kDefaultHeartbeatMs);
  set(reg::kTickFrequencyLow, kTickHz);
  set(reg::kPacketSize, kDefaultPacketSize);

  set(reg::kWidth, static_cast<std::uint32_t>(identity_.widthPx));
  set(reg::kHeight, static_cast<std::uint32_t>(identity_.heightPx));
  set(reg::kSensorWidth, static_cast<std::uint32_t>(identity_.widthPx));
  set(reg::kSensorHeight, static_cast<std::uint32_t>(identity_.heightPx));
  set(reg::kPixelFormat, reg::kMono8);
  set(reg::kAcquisitionFrames, 1);
  setReal(reg::kFrameRate, static_cast<float>(identity_.frameRateHz));
  setReal(reg::kExposureTime, 10000);
  for (std::size_t i = 0; i < kChunks.size(); ++i)
    set(reg::kChunkEnable + static_cast<Address>(4 * i), kChunks[i].id == ChunkId::Image ? 1 : 0);
  updatePayloadSize();
}

GvcpStatus RegisterMap::read(Address address, std::span<std::uint8_t> out) const {
  if (address % 4 != 0 || out.size() % 4 != 0) return GvcpStatus::BadAlignment;
  const std::uint64_t end = std::uint64_t{address} + out.size();
  const auto copy = [&](const std::uint8_t* from) { std::copy_n(from, out.size(), out.begin()); };
  if (end <= kBootstrapEnd || (address >= kFeaturesBegin && end <= reg::kFeaturesEnd)) {
    copy(memory_.data() + address);
    return GvcpStatus::Success;
  }
  if (address >= reg::kDescription && end <= reg::kDescription + description_.size()) {
    copy(reinterpret_cast<const std::uint8_t*>(description_.data()) + (address - reg::kDescription));
    return GvcpStatus::Success;
  }
  return GvcpStatus::InvalidAddress;
}

GvcpStatus RegisterMap::write(Address address, ByteView data, bool acquiring) {
  if (address % 4 != 0 || data.size() % 4 != 0) return GvcpStatus::BadAlignment;
  // Each word is judged with those before it in force, and all are taken back if one is refused.
  std::vector<std::pair<Address, std::uint32_t>> before;
  for (std::size_t at = 0; at < data.size(); at += 4) {
    const std::uint64_t word = std::uint64_t{address} + at;
    const GvcpStatus status = word + 4 > reg::kFeaturesEnd
                                  ? GvcpStatus::InvalidAddress
                                  : check(static_cast<Address>(word), readBe32(data, at), acquiring);
    if (status != GvcpStatus::Success) {
      for (auto old = before.rbegin(); old != before.rend(); ++old) set(old->first, old->second);
      return status;
    }
    before.emplace_back(static_cast<Address>(word), get(static_cast<Address>(word)));
    store(static_cast<Address>(word), readBe32(data, at));
  }
  updatePayloadSize();
  return GvcpStatus::Success;
}

GvcpStatus RegisterMap::check(Address address, std::uint32_t value, bool acquiring) const {
  if (isText(address) || isCommand(address)) return GvcpStatus::Success;
  if (acquiring && lockedWhileAcquiring(address)) return GvcpStatus::Busy;
  const auto within = [&](bool allowed) { return allowed ? GvcpStatus::Success : GvcpStatus::InvalidParameter; };
  const auto region = [&](std::uint32_t least, Address other, int sensor) {
    return within(value >= least && value % kRegionStep == 0 &&
                  std::uint64_t{value} + get(other) <= static_cast<std::uint64_t>(sensor));
  };
  const auto realWithin = [&](double min, double max) {
    const double number = std::bit_cast<float>(value);
    return within(number >= min && number <= max);
  };
  switch (address) {
    case reg::kIpConfiguration:
    case reg::kPersistentIp:
    case reg::kPersistentMask:
    case reg::kPersistentGateway:
    case reg::kHeartbeatTimeout:
    case reg::kControlPrivilege:
    case reg::kStreamPort:
    case reg::kStreamAddress:
      return GvcpStatus::Success;
    case reg::kPacketSize: {
      const int bytes = static_cast<int>(value & 0xffff);
      return within(bytes >= kMinPacketSize && bytes <= kMaxPacketSize && bytes % 4 == 0);
    }
    case reg::kPacketDelay:
      return within(value <= kMaxDelayTicks);
    case reg::kWidth:
      return region(kRegionStep, reg::kOffsetX, identity_.widthPx);
    case reg::kHeight:
      return region(kRegionStep, reg::kOffsetY, identity_.heightPx);
    case reg::kOffsetX:
      return region(0, reg::kWidth, identity_.widthPx);
    case reg::kOffsetY:
      return region(0, reg::kHeight, identity_.heightPx);
    case reg::kPixelFormat:
      return within(value == reg::kMono8);
    case reg::kAcquisitionMode:
      return within(value <= 2);
    case reg::kAcquisitionFrames:
      return within(value >= 1 && value <= 65535);
    case reg::kFrameRate:
      return realWithin(kMinFrameRateHz, kMaxFrameRateHz);
    case reg::kExposureTime:
      return realWithin(kMinExposureUs, kMaxExposureUs);
    case reg::kGain:
      return realWithin(0, kMaxGainDb);
    case reg::kTriggerSelector:
      return within(value == 0);
    case reg::kTriggerSource:
      return within(value <= 2);
    case reg::kTriggerMode:
    case reg::kTriggerActivation:
    case reg::kTimestampCounter:
    case reg::kChunkModeActive:
    case reg::kExtendedIds:
      return within(value <= 1);
    case reg::kChunkSelector:
      return within(value < kChunks.size());
    default:
      break;
  }
  if (address >= reg::kChunkEnable && address < reg::kChunkEnable + 4 * kChunks.size()) return within(value <= 1);
  return address < kBootstrapEnd || address >= kFeaturesBegin ? GvcpStatus::WriteProtect : GvcpStatus::InvalidAddress;
}

void RegisterMap::store(Address address, std::uint32_t value) {
  if (isCommand(address)) return;
  if (address == reg::kHeartbeatTimeout)  // the nearest that the camera can do, as the standard has it
    value = std::clamp(value, static_cast<std::uint32_t>(kMinHeartbeatMs), static_cast<std::uint32_t>(kMaxHeartbeatMs));
  if (address == reg::kPacketSize) value &= ~reg::kFireTestPacket;
  if (address == reg::kChunkEnable) value = 1;  // the image itself; clients switch all chunks off before they choose
  set(address, value);
  if (address == reg::kUserName + 12) memory_[reg::kUserName + 15] = 0;
}

float RegisterMap::real(Address address) const { return std::bit_cast<float>(get(address)); }
void RegisterMap::setReal(Address address, float value) { set(address, std::bit_cast<std::uint32_t>(value)); }

void RegisterMap::setText(Address address, std::size_t bytes, std::string_view text) {
  std::fill_n(memory_.begin() + address, bytes, std::uint8_t{0});
  std::copy_n(text.begin(), std::min(text.size(), bytes - 1), memory_.begin() + address);
}

void RegisterMap::updatePayloadSize() {
  std::uint32_t bytes = get(reg::kWidth) * get(reg::kHeight);
  const StreamSettings settings = streamSettings();
  if (settings.chunkMode) bytes += 8;
  for (const std::size_t i : settings.chunks) bytes += kChunks[i].bytes + 8;
  set(reg::kPayloadSize, bytes);
}

StreamSettings RegisterMap::streamSettings() const {
  StreamSettings s;
  s.width = static_cast<int>(get(reg::kWidth));
  s.height = static_cast<int>(get(reg::kHeight));
  s.offsetX = static_cast<int>(get(reg::kOffsetX));
  s.offsetY = static_cast<int>(get(reg::kOffsetY));
  s.mode = static_cast<reg::AcquisitionMode>(get(reg::kAcquisitionMode));
  s.frames = get(reg::kAcquisitionFrames);
  s.frameRateHz = real(reg::kFrameRate);
  s.exposureUs = real(reg::kExposureTime);
  s.triggerOn = get(reg::kTriggerMode) != 0;
  s.source = static_cast<reg::TriggerSource>(get(reg::kTriggerSource));
  s.timestampCounter = static_cast<reg::TimestampCounter>(get(reg::kTimestampCounter));
  s.extendedIds = get(reg::kExtendedIds) != 0;
  s.chunkMode = get(reg::kChunkModeActive) != 0;
  if (s.chunkMode)
    for (std::size_t i = 0; i < kChunks.size(); ++i)
      if (kChunks[i].id != ChunkId::Image && get(reg::kChunkEnable + static_cast<Address>(4 * i)) != 0)
        s.chunks.push_back(i);
  s.address = get(reg::kStreamAddress);
  s.port = static_cast<std::uint16_t>(get(reg::kStreamPort));
  s.packetBytes = static_cast<int>(get(reg::kPacketSize) & 0xffff);
  s.packetDelayS = get(reg::kPacketDelay) / static_cast<double>(kTickHz);
  return s;
}

}  // namespace vignole::gige_device
