#pragma once
// GVSP, the stream protocol of GigE Vision: how a frame is cut into packets. A frame is a leader (packet 0), the
// payload (packets 1 to n), a trailer (packet n + 1).

#include <cstdint>
#include <span>

#include "engine/gige_device/gvcp.h"

namespace vignole::gige_device {

enum class GvspContent : std::uint8_t { Leader = 1, Trailer = 2, Payload = 3 };
inline constexpr std::uint16_t kGvspOk = 0x0000, kGvspUnavailable = 0x800c;
inline constexpr std::uint16_t kImagePayload = 0x0001, kChunkFlag = 0x4000;

/// What IP and UDP add to a packet: GevSCPSPacketSize counts them.
inline constexpr int kIpUdpBytes = 28;
/// What Ethernet adds on the wire: preamble, header, check sum, gap.
inline constexpr int kEthernetBytes = 38;
[[nodiscard]] constexpr int gvspHeaderBytes(bool extendedIds) { return extendedIds ? 20 : 8; }
inline constexpr int kMaxGvspHeaderBytes = 20;

/// Frame ids count from 1 for ever; 16 bits of it go 65535 -> 1 on the wire.
[[nodiscard]] constexpr std::uint64_t idOnWire(std::uint64_t frameId, bool extendedIds) {
  return extendedIds ? frameId : (frameId - 1) % 65535 + 1;
}

/// Writes gvspHeaderBytes(extendedIds) bytes. `frameId` as on the wire.
void putGvspHeader(std::uint8_t* to, bool extendedIds, std::uint16_t status, std::uint64_t frameId,
                   std::uint32_t packet, GvspContent content);

struct ImageInfo {
  std::uint64_t timestamp = 0;
  std::uint32_t pixelFormat = 0, width = 0, height = 0, offsetX = 0, offsetY = 0;
  std::uint32_t chunkBytes = 0;  ///< 0: the frame carries no chunks
};
/// What follows the header of the leader, and of the trailer.
[[nodiscard]] Bytes leaderContent(const ImageInfo& info);
[[nodiscard]] Bytes trailerContent(const ImageInfo& info);

/// A chunk as it stands behind its data: id, then size. `data` may be sent before by others (the image).
void appendChunkTag(Bytes& to, std::uint32_t id, std::uint32_t dataBytes);

}  // namespace vignole::gige_device
