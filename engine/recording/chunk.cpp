#include "engine/recording/chunk.h"

#include <algorithm>
#include <cstring>
#include <zstd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace vignole {

namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'V', 'g', 'R', 'c'};
constexpr std::size_t kIndexEntry = kChunkHeadSize + 8;

template <class Number>
void put(std::uint8_t* to, Number value) {
  for (std::size_t i = 0; i < sizeof value; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

template <class Number>
Number get(const std::uint8_t* from) {
  Number value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) value |= static_cast<Number>(static_cast<Number>(from[i]) << (8 * i));
  return value;
}

std::uint32_t checksumOfHead(const std::uint8_t* head) {
  return static_cast<std::uint32_t>(XXH3_64bits(head, kChunkHeadSize - 4));
}

template <class Value>
std::uint8_t* append(std::uint8_t* to, const Value& value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

}  // namespace

std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

ChunkHeadBytes written(const ChunkHead& head) {
  ChunkHeadBytes bytes{};
  std::copy(kMagic.begin(), kMagic.end(), bytes.begin());
  bytes[4] = static_cast<std::uint8_t>(head.kind);
  bytes[5] = head.camera;
  put(bytes.data() + 8, head.trigger);
  put(bytes.data() + 16, head.digest);
  put(bytes.data() + 24, static_cast<std::uint64_t>(head.timeUs));
  put(bytes.data() + 32, head.checksum);
  put(bytes.data() + 40, head.size);
  put(bytes.data() + 44, checksumOfHead(bytes.data()));
  return bytes;
}

std::optional<ChunkHead> readHead(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kChunkHeadSize || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) return {};
  if (get<std::uint32_t>(bytes.data() + 44) != checksumOfHead(bytes.data())) return {};
  ChunkHead head;
  head.kind = static_cast<ChunkKind>(bytes[4]);
  head.camera = bytes[5];
  head.trigger = get<std::uint64_t>(bytes.data() + 8);
  head.digest = get<std::uint64_t>(bytes.data() + 16);
  head.timeUs = static_cast<std::int64_t>(get<std::uint64_t>(bytes.data() + 24));
  head.checksum = get<std::uint64_t>(bytes.data() + 32);
  head.size = get<std::uint32_t>(bytes.data() + 40);
  return head;
}

std::uint64_t StripeDigest::of(const StripeResult& stripe) {
  // Value by value: a struct's padding is anybody's.
  constexpr std::size_t kPoint = 10 * sizeof(float) + 1, kLine = 9, kRest = 5 * sizeof(float) + 1;
  bytes_.resize(stripe.points.size() * kPoint + stripe.lines.size() * kLine + kRest);
  std::uint8_t* to = bytes_.data();
  for (const StripePoint& p : stripe.points) {
    for (const float value :
         {p.x, p.y, p.nx, p.ny, p.sigmaPx, p.strength, p.widthPx, p.shiftPx, p.ridgeSigmaPx, p.brightening})
      to = append(to, value);
    to = append(to, p.flags);
  }
  for (const StripeLine& line : stripe.lines) {
    to = append(to, line.first);
    to = append(to, line.count);
    to = append(to, static_cast<std::uint8_t>(line.rejection));
  }
  for (const float value :
       {stripe.noiseDn, stripe.backgroundDn, stripe.saturatedShare, stripe.correlatedPoints, stripe.smoothingPx})
    to = append(to, value);
  append(to, static_cast<std::uint8_t>(stripe.overloaded ? 1 : 0));
  return checksumOf(bytes_);
}

std::vector<std::uint8_t> packedIndex(std::span<const ChunkPlace> chunks) {
  std::vector<std::uint8_t> plain(chunks.size() * kIndexEntry);
  std::uint8_t* to = plain.data();
  for (const ChunkPlace& chunk : chunks) {
    const ChunkHeadBytes head = written(chunk.head);
    to = std::copy(head.begin(), head.end(), to);
    put(to, chunk.offset);
    to += 8;
  }
  std::vector<std::uint8_t> packed(ZSTD_compressBound(plain.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), 1);
  packed.resize(ZSTD_isError(size) != 0 ? 0 : size);
  return packed;
}

std::optional<std::vector<ChunkPlace>> unpackedIndex(std::span<const std::uint8_t> packed, std::uint64_t count) {
  std::vector<std::uint8_t> plain(static_cast<std::size_t>(count) * kIndexEntry);
  if (ZSTD_decompress(plain.data(), plain.size(), packed.data(), packed.size()) != plain.size()) return {};
  std::vector<ChunkPlace> chunks;
  chunks.reserve(static_cast<std::size_t>(count));
  for (std::size_t at = 0; at < plain.size(); at += kIndexEntry) {
    const auto head = readHead(std::span(plain).subspan(at, kChunkHeadSize));
    if (!head) return {};
    chunks.push_back({*head, get<std::uint64_t>(plain.data() + at + kChunkHeadSize)});
  }
  return chunks;
}

}  // namespace vignole
