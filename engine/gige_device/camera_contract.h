#pragma once
// What a client may rely on: the names, chunks and counts by which the simulated cameras of the rig are driven and
// their frames are told apart. Everything else is found in the GenICam description that each camera carries.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace vignole::gige_device {

/// Every GigE Vision device listens here.
inline constexpr std::uint16_t kControlPort = 3956;

// The cameras say that they are:
inline constexpr const char* kVendorName = "DALSA";
inline constexpr const char* kModelName = "Genie HM1400";

// Names of features, as in the description. Enumerations with their entries.
namespace feature {
inline constexpr const char* kSerialNumber = "DeviceSerialNumber";         ///< also GevSerialNumber, DeviceID
inline constexpr const char* kUserName = "DeviceUserID";                   ///< 15 characters
inline constexpr const char* kExposureTimeUs = "ExposureTime";             ///< float; a trigger within it is ignored
inline constexpr const char* kGain = "Gain";                               ///< float, dB; changes no picture
inline constexpr const char* kTriggerSelector = "TriggerSelector";         ///< FrameStart
inline constexpr const char* kTriggerMode = "TriggerMode";                 ///< Off, On
inline constexpr const char* kTriggerSource = "TriggerSource";             ///< Line1, Line2, Software
inline constexpr const char* kTriggerActivation = "TriggerActivation";     ///< RisingEdge, FallingEdge
inline constexpr const char* kTriggerSoftware = "TriggerSoftware";         ///< command
inline constexpr const char* kFrameRateHz = "AcquisitionFrameRate";        ///< float; with TriggerMode Off
inline constexpr const char* kTimestampCounter = "TimestampCounter";       ///< InternalClock, Line1
inline constexpr const char* kTimestampReset = "TimestampReset";           ///< command; also GevTimestampControlReset
inline constexpr const char* kHeartbeatTimeoutMs = "GevHeartbeatTimeout";  ///< 500 to 65000
inline constexpr const char* kPacketSize = "GevSCPSPacketSize";            ///< 576 to 9000, step 4
inline constexpr const char* kPacketDelay = "GevSCPD";                     ///< ticks of 1 ns between packets
inline constexpr const char* kExtendedIds = "GevGVSPExtendedIDMode";       ///< Off, On: 64-bit frame ids
inline constexpr const char* kChunkModeActive = "ChunkModeActive";         ///< bool
inline constexpr const char* kChunkSelector = "ChunkSelector";             ///< Image, and those of ChunkId below
inline constexpr const char* kChunkEnable = "ChunkEnable";                 ///< bool, of the selected chunk
inline constexpr const char* kLineStatusAll = "LineStatusAll";             ///< integer: the bits of LineStatus, now
inline constexpr const char* kEncoderCount = "EncoderTriggerCount";        ///< integer: triggers issued so far
}  // namespace feature

/// Ids of the chunks (arv_buffer_get_chunk_data takes them), each with its name in ChunkSelector and the node that
/// reads it. All numbers are big-endian, as everything else on the wire.
enum class ChunkId : std::uint32_t {
  Image = 0x1,               ///< "Image"
  EncoderCount = 0x1001,     ///< "CounterValue",  ChunkCounterValue:  u64, the encoder's count of this trigger
  EncoderPosition = 0x1002,  ///< "EncoderValue",  ChunkEncoderValue:  i64, micrometres that the encoder has travelled
  LineStatus = 0x1003,       ///< "LineStatusAll", ChunkLineStatusAll: u32, bits of LineStatus at the exposure
  Clock = 0x1004,            ///< "Timestamp",     ChunkTimestamp:     u64, ns of the camera's own clock
};

/// Lines of a camera. Line1 is the encoder's trigger pulse, Line2 is high while a rail is in the rig.
enum LineStatus : std::uint32_t { kLine1Encoder = 1u << 0, kLine2RailPresent = 1u << 1 };

// Counts.
//  * The encoder is at rest until every camera that takes part is acquiring with TriggerMode On and TriggerSource
//    Line1 (or Line2). Then it ticks: trigger 0 comes first and is common to all. It starts again at 0 when the last
//    camera has been stopped, left or given up by its client; a camera that dies or is stopped alone changes nothing.
//  * The chunk EncoderCount carries that count, the same in all cameras, whatever a camera missed, and after a camera
//    has died and come back.
//  * With TimestampCounter=Line1 the timestamp of a frame is the number of encoder pulses between the last
//    TimestampReset and its own (the first pulse after a reset is 0). The counter belongs to the camera: one that dies
//    and comes back begins at 0 again, with all its features at their defaults. The tick frequency stays 1 GHz, so the
//    count arrives as so many nanoseconds.
//  * With TimestampCounter=InternalClock the timestamp is ns since power-on or reset, at the start of the exposure.
//  * Frame ids count the frames that a camera took, from 1, and go on over a restart unless a fault says otherwise. A
//    trigger that a camera missed leaves no gap in them; a frame that was lost on its way does.

/// A chunk's number; nothing if it has another size.
[[nodiscard]] inline std::optional<std::uint64_t> chunkNumber(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != 4 && bytes.size() != 8) return {};
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

}  // namespace vignole::gige_device
