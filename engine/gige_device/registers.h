#pragma once
// Where the registers of a camera are: GigE Vision's bootstrap registers, and the features behind them in the
// manufacturer's space. 32 bits each, big-endian, unless a comment says otherwise. Shared by the register map that
// serves them and the GenICam description that names them.

#include <cstdint>

namespace vignole::gige_device::reg {

using Address = std::uint32_t;

// Bootstrap registers (GigE Vision 2.0, chapter 28).
inline constexpr Address kVersion = 0x0000, kDeviceMode = 0x0004, kMacHigh = 0x0008, kMacLow = 0x000c;
inline constexpr Address kIpOptions = 0x0010, kIpConfiguration = 0x0014, kIpAddress = 0x0024, kSubnetMask = 0x0034,
                         kGateway = 0x0044;
inline constexpr Address kVendor = 0x0048, kModel = 0x0068, kDeviceVersion = 0x0088, kManufacturerInfo = 0x00a8,
                         kSerial = 0x00d8, kUserName = 0x00e8;     // texts of 32, 32, 32, 48, 16, 16 bytes
inline constexpr Address kDiscoveryBytes = 0x00f8;                 // all before are what DISCOVERY answers
inline constexpr Address kFirstUrl = 0x0200, kSecondUrl = 0x0400;  // texts of 512 bytes
inline constexpr Address kInterfaces = 0x0600, kPersistentIp = 0x064c, kPersistentMask = 0x065c,
                         kPersistentGateway = 0x066c, kLinkSpeed = 0x0670;
inline constexpr Address kMessageChannels = 0x0900, kStreamChannels = 0x0904, kStreamCapability = 0x092c,
                         kCapability = 0x0934, kHeartbeatTimeout = 0x0938;
inline constexpr Address kTickFrequencyHigh = 0x093c, kTickFrequencyLow = 0x0940, kTimestampControl = 0x0944,
                         kTimestampHigh = 0x0948, kTimestampLow = 0x094c;
inline constexpr Address kControlPrivilege = 0x0a00, kPrimaryPort = 0x0a04, kPrimaryAddress = 0x0a14;
inline constexpr Address kStreamPort = 0x0d00, kPacketSize = 0x0d04, kPacketDelay = 0x0d08, kStreamAddress = 0x0d18,
                         kStreamSourcePort = 0x0d1c;

// Bits.
inline constexpr std::uint32_t kCapabilityConcatenation = 1u << 0, kCapabilityWriteMemory = 1u << 1,
                               kCapabilityResend = 1u << 2, kCapabilityLinkSpeed = 1u << 28,
                               kCapabilitySerial = 1u << 30, kCapabilityUserName = 1u << 31;
inline constexpr std::uint32_t kPrivilegeExclusive = 1u << 0, kPrivilegeControl = 1u << 1;
inline constexpr std::uint32_t kTimestampReset = 1u << 0, kTimestampLatch = 1u << 1;
inline constexpr std::uint32_t kFireTestPacket = 1u << 31, kDoNotFragment = 1u << 30;

// Features.
inline constexpr Address kWidth = 0xa000, kHeight = 0xa004, kOffsetX = 0xa008, kOffsetY = 0xa00c, kPixelFormat = 0xa010,
                         kSensorWidth = 0xa014, kSensorHeight = 0xa018, kPayloadSize = 0xa01c;
inline constexpr Address kAcquisitionMode = 0xa040, kAcquisitionStart = 0xa044, kAcquisitionStop = 0xa048,
                         kAcquisitionFrames = 0xa04c;
inline constexpr Address kFrameRate = 0xa050, kExposureTime = 0xa054, kGain = 0xa058;  // IEEE 754, 32 bits
inline constexpr Address kTriggerSelector = 0xa060, kTriggerMode = 0xa064, kTriggerSource = 0xa068,
                         kTriggerActivation = 0xa06c, kTriggerSoftware = 0xa070;
inline constexpr Address kTimestampCounter = 0xa080, kLineStatusAll = 0xa084;
inline constexpr Address kEncoderCount = 0xa088, kEncoderPosition = 0xa090;  // 64 bits
inline constexpr Address kChunkModeActive = 0xa0c0, kChunkSelector = 0xa0c4,
                         kChunkEnable = 0xa0d0;  // one for each chunk, in the order of kChunks
inline constexpr Address kExtendedIds = 0xa100;
inline constexpr Address kFeaturesEnd = 0xa200;

/// The description itself.
inline constexpr Address kDescription = 0x80000;

// Entries of the enumerations.
inline constexpr std::uint32_t kMono8 = 0x01080001;
enum class AcquisitionMode : std::uint32_t { Continuous, SingleFrame, MultiFrame };
enum class TriggerSource : std::uint32_t { Line1, Line2, Software };
enum class TriggerActivation : std::uint32_t { RisingEdge, FallingEdge };
enum class TimestampCounter : std::uint32_t { InternalClock, Line1 };

}  // namespace vignole::gige_device::reg
