#include "engine/gige_device/gvsp.h"

namespace vignole::gige_device {

namespace {

std::uint16_t payloadType(const ImageInfo& info) {
  return static_cast<std::uint16_t>(info.chunkBytes > 0 ? kImagePayload | kChunkFlag : kImagePayload);
}

}  // namespace

void putGvspHeader(std::uint8_t* to, bool extendedIds, std::uint16_t status, std::uint64_t frameId,
                   std::uint32_t packet, GvspContent content) {
  putBe16(to, status);
  const std::uint32_t kind = static_cast<std::uint32_t>(content) << 24;
  if (extendedIds) {
    putBe16(to + 2, 0);
    putBe32(to + 4, 0x80000000u | kind);
    putBe64(to + 8, frameId);
    putBe32(to + 16, packet);
  } else {
    putBe16(to + 2, static_cast<std::uint16_t>(frameId));
    putBe32(to + 4, kind | (packet & 0xffffff));
  }
}

Bytes leaderContent(const ImageInfo& info) {
  Bytes out(36);
  putBe16(&out[2], payloadType(info));
  putBe64(&out[4], info.timestamp);
  putBe32(&out[12], info.pixelFormat);
  putBe32(&out[16], info.width);
  putBe32(&out[20], info.height);
  putBe32(&out[24], info.offsetX);
  putBe32(&out[28], info.offsetY);
  return out;  // no padding at the ends of rows and of the image
}

Bytes trailerContent(const ImageInfo& info) {
  Bytes out(info.chunkBytes > 0 ? 16 : 8);
  putBe16(&out[2], payloadType(info));
  putBe32(&out[4], info.height);
  // Where chunks follow the image: how long all of it is, and a number for their layout.
  if (info.chunkBytes > 0) {
    putBe32(&out[8], info.width * info.height + info.chunkBytes);
    putBe32(&out[12], info.chunkBytes);
  }
  return out;
}

void appendChunkTag(Bytes& to, std::uint32_t id, std::uint32_t dataBytes) {
  to.resize(to.size() + 8);
  putBe32(&to[to.size() - 8], id);
  putBe32(&to[to.size() - 4], dataBytes);
}

}  // namespace vignole::gige_device
