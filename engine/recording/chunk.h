#pragma once
// The file of a recording: a signature, then chunks one after the other, each whole by itself.
//
//   signature   16 bytes "VignoleRecording"
//   chunk       48 bytes of head, then `size` bytes
//     0  "VgRc"                                 4  kind                       5  camera (0..3; 0xFF: none)
//     6  zero (2 bytes)                         8  trigger                   16  digest of the points (frames)
//    24  time, us since 1970 UTC               32  checksum of the bytes      40  size
//    44  checksum of bytes 0..43
//
// Numbers have their least byte first; checksums and digests are XXH3 (64 bits; that of the head its lower 32). Chunks
// are only ever appended, so a file that was cut off, or holds rubbish in between, is readable as far as its chunks are
// whole: who reads looks for the next head. Kinds and their bytes:
//   Setup     JSON: program, SIMD target, recipe and calibration as texts, section, cameras; of the rails behind it
//   RailBegin JSON; one a camera; trigger: the first that may have been recorded
//   Frame     sparse_frame.h
//   Lost      text, the reason: the camera or the pipeline lost this frame, as the ledger of the live run has it
//   Dropped   nothing: this trigger was measured, its recording was given up
//   RailEnd   nothing; one a camera; trigger: behind the last
//   SourceEnd text, the error or nothing; one a camera
//   Index     heads of all chunks before, each with its offset (8 bytes more), packed by zstd; trigger: how many
//   Last      nothing; trigger: offset of the index. The last chunk of a recording that was closed.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/stripe/stripe.h"

namespace vignole {

enum class ChunkKind : std::uint8_t {
  Setup = 1,
  RailBegin = 2,
  Frame = 3,
  Lost = 4,
  Dropped = 5,
  RailEnd = 6,
  SourceEnd = 7,
  Index = 8,
  Last = 9,
};

inline constexpr std::string_view kRecordingSignature = "VignoleRecording";
inline constexpr std::size_t kChunkHeadSize = 48;
inline constexpr std::uint8_t kNoCamera = 0xFF;
/// Texts are small; a longer one is no recipe.
inline constexpr std::uint32_t kLongestText = 1U << 25U;

struct ChunkHead {
  ChunkKind kind = ChunkKind::Dropped;
  std::uint8_t camera = kNoCamera;
  std::uint64_t trigger = 0;
  std::uint64_t digest = 0;
  std::int64_t timeUs = 0;
  std::uint64_t checksum = 0;  ///< of the bytes
  std::uint32_t size = 0;      ///< of the bytes
};

using ChunkHeadBytes = std::array<std::uint8_t, kChunkHeadSize>;
[[nodiscard]] ChunkHeadBytes written(const ChunkHead& head);
/// Empty: no head, or a damaged one.
[[nodiscard]] std::optional<ChunkHead> readHead(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::uint64_t checksumOf(std::span<const std::uint8_t> bytes);

/// Of all that extraction says: equal results have equal digests, on the same SIMD target.
class StripeDigest {
 public:
  [[nodiscard]] std::uint64_t of(const StripeResult& stripe);

 private:
  std::vector<std::uint8_t> bytes_;
};

/// A chunk with its place in the file.
struct ChunkPlace {
  ChunkHead head;
  std::uint64_t offset = 0;  ///< of the head
};

/// The bytes of an index; empty from bytes that are none, or not of `count` chunks.
[[nodiscard]] std::vector<std::uint8_t> packedIndex(std::span<const ChunkPlace> chunks);
[[nodiscard]] std::optional<std::vector<ChunkPlace>> unpackedIndex(std::span<const std::uint8_t> packed,
                                                                   std::uint64_t count);

}  // namespace vignole
