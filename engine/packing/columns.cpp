#include "engine/packing/columns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <sodium.h>
#include <zstd.h>

namespace vignole {

namespace {

constexpr std::uint8_t kMagic = 0xB7;
constexpr std::size_t kDigestBytes = crypto_generichash_BYTES_MIN;
constexpr int kMaxOrder = 2;

enum PlaneCoding : std::uint8_t { kRaw = 0, kConstant = 1, kZstd = 2 };

std::uint64_t zigzag(std::uint64_t difference) { return (difference << 1U) ^ (0 - (difference >> 63U)); }
std::uint64_t unzigzag(std::uint64_t coded) { return (coded >> 1U) ^ (0 - (coded & 1U)); }

std::array<std::uint8_t, kDigestBytes> digestOf(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, kDigestBytes> digest{};
  crypto_generichash(digest.data(), digest.size(), bytes.data(), bytes.size(), nullptr, 0);
  return digest;
}

/// Differences of the given order, modulo 2^64, so that any numbers come back; order 0 is over `base`.
void residualsOf(std::span<const std::int64_t> values, int order, std::uint64_t base,
                 std::vector<std::uint64_t>& residuals) {
  residuals.resize(values.size());
  std::uint64_t last = base, lastDifference = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = static_cast<std::uint64_t>(values[i]);
    if (order == 0) {
      residuals[i] = value - base;
      continue;
    }
    const std::uint64_t difference = value - last;
    residuals[i] = zigzag(order == 1 ? difference : difference - lastDifference);
    last = value;
    lastDifference = difference;
  }
}

/// What the residuals will need, about: the sum of their bits.
std::uint64_t bitsOf(const std::vector<std::uint64_t>& residuals) {
  std::uint64_t bits = 0;
  for (const std::uint64_t r : residuals) bits += static_cast<std::uint64_t>(std::bit_width(r));
  return bits;
}

struct FreeCompressor {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

std::size_t compress(std::span<const std::uint8_t> from, Bytes& into) {
  thread_local const std::unique_ptr<ZSTD_CCtx, FreeCompressor> context(ZSTD_createCCtx());
  into.resize(ZSTD_compressBound(from.size()));
  return ZSTD_compressCCtx(context.get(), into.data(), into.size(), from.data(), from.size(), 1);
}

}  // namespace

ColumnPacker::ColumnPacker(std::uint8_t kind) : bytes_{kMagic, kind} {}

void ColumnPacker::addNumber(std::uint64_t value) {
  while (value >= 0x80) {
    bytes_.push_back(static_cast<std::uint8_t>(value | 0x80U));
    value >>= 7U;
  }
  bytes_.push_back(static_cast<std::uint8_t>(value));
}

void ColumnPacker::addText(const std::string& text) {
  addNumber(text.size());
  bytes_.insert(bytes_.end(), text.begin(), text.end());
}

void ColumnPacker::add(std::span<const std::int64_t> values) {
  if (values.empty()) return;
  const auto least = static_cast<std::uint64_t>(*std::min_element(values.begin(), values.end()));
  int bestOrder = 0;
  std::uint64_t bestBits = 0, bestBase = 0;
  for (int order = 0; order <= kMaxOrder; ++order) {
    const std::uint64_t base = order == 0 ? least : static_cast<std::uint64_t>(values.front());
    residualsOf(values, order, base, residuals_);
    const std::uint64_t bits = bitsOf(residuals_);
    if (order > 0 && bits >= bestBits) continue;
    bestBits = bits;
    bestOrder = order;
    bestBase = base;
    std::swap(best_, residuals_);
  }
  const auto bits = static_cast<int>(std::bit_width(*std::max_element(best_.begin(), best_.end())));
  const int width = (bits + 7) / 8;
  bytes_.push_back(static_cast<std::uint8_t>(bestOrder * 16 + width));
  addNumber(zigzag(bestBase));
  plane_.resize(values.size());
  for (int b = 0; b < width; ++b) {
    for (std::size_t i = 0; i < best_.size(); ++i)
      plane_[i] = static_cast<std::uint8_t>(best_[i] >> static_cast<unsigned>(8 * b));
    addPlane(plane_);
  }
}

void ColumnPacker::addPlane(std::span<const std::uint8_t> plane) {
  if (std::all_of(plane.begin(), plane.end(), [&](std::uint8_t b) { return b == plane.front(); })) {
    bytes_.push_back(kConstant);
    bytes_.push_back(plane.front());
    return;
  }
  const std::size_t size = plane.size() < 32 ? plane.size() : compress(plane, packed_);
  if (ZSTD_isError(size) != 0 || size >= plane.size()) {
    bytes_.push_back(kRaw);
    bytes_.insert(bytes_.end(), plane.begin(), plane.end());
    return;
  }
  bytes_.push_back(kZstd);
  addNumber(size);
  bytes_.insert(bytes_.end(), packed_.begin(), packed_.begin() + static_cast<std::ptrdiff_t>(size));
}

Bytes ColumnPacker::finish() {
  const auto digest = digestOf(bytes_);
  bytes_.insert(bytes_.end(), digest.begin(), digest.end());
  return std::move(bytes_);
}

ColumnReader::ColumnReader(std::span<const std::uint8_t> bytes, std::uint8_t kind) {
  if (bytes.size() < 2 + kDigestBytes) {
    refuse("cut short");
    return;
  }
  const auto content = bytes.first(bytes.size() - kDigestBytes);
  const auto digest = digestOf(content);
  if (!std::equal(digest.begin(), digest.end(), bytes.end() - static_cast<std::ptrdiff_t>(kDigestBytes))) {
    refuse("damaged: its digest does not fit");
    return;
  }
  if (content[0] != kMagic || content[1] != kind) {
    refuse("not what is expected here, or of a later version");
    return;
  }
  rest_ = content.subspan(2);
}

void ColumnReader::refuse(const std::string& why) {
  if (error_.empty()) error_ = why;
  rest_ = {};
}

std::uint8_t ColumnReader::byte() {
  if (rest_.empty()) {
    refuse("ends too early");
    return 0;
  }
  const std::uint8_t b = rest_.front();
  rest_ = rest_.subspan(1);
  return b;
}

std::uint64_t ColumnReader::number() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    const std::uint8_t b = byte();
    value |= static_cast<std::uint64_t>(b & 0x7FU) << shift;
    if ((b & 0x80U) == 0) return good() ? value : 0;
  }
  refuse("a number is too long");
  return 0;
}

std::string ColumnReader::text() {
  const std::uint64_t size = number();
  if (size > rest_.size()) {
    refuse("a text ends too early");
    return {};
  }
  const auto taken = rest_.first(static_cast<std::size_t>(size));
  rest_ = rest_.subspan(taken.size());
  return {taken.begin(), taken.end()};
}

bool ColumnReader::plane(std::span<std::uint8_t> into) {
  switch (byte()) {
    case kConstant:
      std::fill(into.begin(), into.end(), byte());
      return good();
    case kRaw:
      if (rest_.size() < into.size()) break;
      std::copy_n(rest_.begin(), into.size(), into.begin());
      rest_ = rest_.subspan(into.size());
      return true;
    case kZstd: {
      const std::uint64_t size = number();
      if (size > rest_.size()) break;
      const std::size_t given = ZSTD_decompress(into.data(), into.size(), rest_.data(), static_cast<std::size_t>(size));
      rest_ = rest_.subspan(static_cast<std::size_t>(size));
      if (ZSTD_isError(given) == 0 && given == into.size()) return true;
      break;
    }
    default:
      break;
  }
  refuse("a column cannot be unpacked");
  return false;
}

std::vector<std::int64_t> ColumnReader::column(std::size_t count) {
  if (count == 0 || !good()) return {};
  if (count > kMaxColumn) {
    refuse("a column is longer than any");
    return {};
  }
  const std::uint8_t head = byte();
  const int order = head / 16, width = head % 16;
  if (order > kMaxOrder || width > 8) refuse("a column is of no known kind");
  const std::uint64_t base = unzigzag(number());
  if (!good()) return {};
  std::vector<std::uint64_t> residuals(count, 0);
  Bytes plane(count);
  for (int b = 0; b < width; ++b) {
    if (!this->plane(plane)) return {};
    for (std::size_t i = 0; i < count; ++i)
      residuals[i] |= static_cast<std::uint64_t>(plane[i]) << static_cast<unsigned>(8 * b);
  }
  std::vector<std::int64_t> values(count);
  std::uint64_t last = base, lastDifference = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (order == 0) {
      values[i] = static_cast<std::int64_t>(base + residuals[i]);
      continue;
    }
    const std::uint64_t difference = unzigzag(residuals[i]) + (order == 2 ? lastDifference : 0);
    last += difference;
    lastDifference = difference;
    values[i] = static_cast<std::int64_t>(last);
  }
  return values;
}

}  // namespace vignole
