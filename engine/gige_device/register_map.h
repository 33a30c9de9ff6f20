#pragma once
// What is in a camera's registers, which of them may be written and with what. No sockets, no clock, no privileges.

#include <cstdint>
#include <string>
#include <vector>

#include "engine/gige_device/gvcp.h"
#include "engine/gige_device/registers.h"

namespace vignole::gige_device {

/// What a camera says of itself.
struct CameraIdentity {
  std::string serial, userName;
  std::uint32_t address = 0;  ///< 127.0.0.11 is 0x7f00000b
  std::uint64_t mac = 0;      ///< 48 bits
  int widthPx = 1400, heightPx = 1024;
  double frameRateHz = 20;  ///< of TriggerMode Off, until somebody changes it
};

/// The registers that make a frame, as they are now.
struct StreamSettings {
  int width = 0, height = 0, offsetX = 0, offsetY = 0;
  reg::AcquisitionMode mode = reg::AcquisitionMode::Continuous;
  std::uint32_t frames = 1;  ///< of MultiFrame
  double frameRateHz = 20, exposureUs = 10000;
  bool triggerOn = false;
  reg::TriggerSource source = reg::TriggerSource::Line1;
  reg::TimestampCounter timestampCounter = reg::TimestampCounter::InternalClock;
  bool extendedIds = false;
  std::vector<std::size_t> chunks;  ///< indices into kChunks, without the image; empty if the mode is off
  bool chunkMode = false;
  std::uint32_t address = 0;  ///< where the stream goes
  std::uint16_t port = 0;     ///< 0: nowhere
  int packetBytes = 1500;     ///< with IP and UDP
  double packetDelayS = 0;
};

class RegisterMap {
 public:
  explicit RegisterMap(const CameraIdentity& identity);
  /// Power off and on: every register at its default.
  void reset();

  /// All words are read or none.
  [[nodiscard]] GvcpStatus read(reg::Address address, std::span<std::uint8_t> out) const;
  /// All words are written or none. `acquiring` locks what makes a frame.
  [[nodiscard]] GvcpStatus write(reg::Address address, ByteView data, bool acquiring);

  [[nodiscard]] std::uint32_t get(reg::Address address) const { return readBe32(memory_, address); }
  void set(reg::Address address, std::uint32_t value) { putBe32(&memory_[address], value); }
  void set64(reg::Address address, std::uint64_t value) { putBe64(&memory_[address], value); }
  [[nodiscard]] ByteView discovery() const { return ByteView(memory_).first(reg::kDiscoveryBytes); }
  [[nodiscard]] StreamSettings streamSettings() const;

 private:
  [[nodiscard]] float real(reg::Address address) const;
  void setReal(reg::Address address, float value);
  void setText(reg::Address address, std::size_t bytes, std::string_view text);
  [[nodiscard]] GvcpStatus check(reg::Address address, std::uint32_t value, bool acquiring) const;
  void store(reg::Address address, std::uint32_t value);
  void updatePayloadSize();

  CameraIdentity identity_;
  std::string description_;
  Bytes memory_;  ///< up to kFeaturesEnd
};

}  // namespace vignole::gige_device
