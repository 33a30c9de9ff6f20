#include "engine/recording/sparse_frame.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <zstd.h>

#include "engine/recording/block_set.h"
#include "engine/stripe/block_kernels.h"
#include "engine/stripe/block_scan.h"

namespace vignole {

namespace {

// Byte by byte: kind, width, height (16 bit each), then for a sparse frame the median difference (16 bit), then
// sections. A section is two numbers, its bytes and its bytes when packed, and the bytes; the same numbers twice: not
// packed. Sections of a sparse frame: bits of the blocks with light; values of the runs of blocks left out that have
// the same sum, each against the one before; lengths of these runs; the pixels of the blocks with light, of those next
// to them, of those one further, of those that the picture's edge cuts, block by block, each row by row. Of a whole
// frame: the pixels. Numbers of several bytes have the least first.
constexpr int kLevel = 1;  // of zstd: noise does not get smaller for more work
constexpr int kRings = 4;
constexpr std::uint8_t kLeftOut = 0xFF, kCut = 3;
constexpr int kLeastRadius = 2;      // scanRadius(1)
constexpr int kSummed = kBlock * 4;  // pixels of a block that its sum is of: every second row
constexpr double kMostKept = 0.34;
constexpr std::size_t kHeadSize = 5;

struct ZstdFree {
  void operator()(ZSTD_CCtx* c) const { ZSTD_freeCCtx(c); }
  void operator()(ZSTD_DCtx* c) const { ZSTD_freeDCtx(c); }
};

void put16(PackedBytes& out, unsigned value) {
  out.push_back(static_cast<std::uint8_t>(value));
  out.push_back(static_cast<std::uint8_t>(value >> 8U));
}

void putNumber(PackedBytes& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7U) out.push_back(static_cast<std::uint8_t>(value | 0x80U));
  out.push_back(static_cast<std::uint8_t>(value));
}

/// Takes numbers off the front; nothing once they do not fit.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}
  [[nodiscard]] std::optional<std::uint64_t> number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 63 && !rest_.empty(); shift += 7) {
      const std::uint8_t byte = rest_.front();
      rest_ = rest_.subspan(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80) return value;
    }
    return {};
  }
  [[nodiscard]] std::optional<std::span<const std::uint8_t>> bytes(std::uint64_t count) {
    if (count > rest_.size()) return {};
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  [[nodiscard]] bool empty() const { return rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
};

int blocksOf(int px) { return (px + kBlock - 1) / kBlock; }

/// Which blocks are kept, and how far from the light: 0 with light, 1, 2 around it, kCut at the edge of a picture whose
/// sides are no multiple of a block. What both sides know from the blocks with light.
class KeptBlocks {
 public:
  void set(const BlockSet& light, int width, int height) {
    near_.widen(light);
    far_.widen(near_);
    const int columns = light.columns(), rows = light.rows();
    ring_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kLeftOut);
    count_ = {};
    std::uint8_t* ring = ring_.data();
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c, ++ring) {
        const bool cut = (c + 1) * kBlock > width || (r + 1) * kBlock > height;
        if (!cut && !far_.has(c, r)) continue;
        *ring = cut ? kCut : light.has(c, r) ? 0 : near_.has(c, r) ? 1 : 2;
        ++count_[*ring];
      }
  }
  [[nodiscard]] const std::vector<std::uint8_t>& ring() const { return ring_; }
  [[nodiscard]] std::size_t count(std::size_t ring) const { return count_.at(ring); }
  [[nodiscard]] std::size_t kept() const { return count_[0] + count_[1] + count_[2] + count_[kCut]; }

 private:
  BlockSet near_, far_;
  std::vector<std::uint8_t> ring_;
  std::array<std::size_t, kRings> count_{};
};

/// The pixels of a block, cut at the picture's edge.
template <class Row>
void eachRow(int column, int row, int width, int height, const Row& work) {
  const int x = column * kBlock, pixels = std::min(kBlock, width - x);
  for (int y = row * kBlock; y < std::min(height, (row + 1) * kBlock); ++y) work(x, y, pixels);
}

/// Pixels of a block left out: even rows add up to its sum, odd rows differ from the row above by the median
/// difference.
struct Fill {
  /// None if a pixel would have to be below 0 or above 255.
  static bool possible(unsigned sum, unsigned difference) {
    const unsigned least = sum / kSummed, most = (sum + kSummed - 1) / kSummed;
    const unsigned step = (difference + kSummed - 1) / kSummed;
    return most + step <= 255 || least >= step;
  }
  static std::array<std::uint8_t, kSummed> spread(unsigned total) {
    std::array<std::uint8_t, kSummed> even{};
    const unsigned each = total / kSummed, more = total % kSummed;
    for (unsigned i = 0; i < kSummed; ++i) even[i] = static_cast<std::uint8_t>(each + (i < more ? 1 : 0));
    return even;
  }
};

}  // namespace

// ---- packing

struct FramePacker::Impl {
  using Grid = std::vector<std::uint16_t>;
  std::unique_ptr<ZSTD_CCtx, ZstdFree> zstd{ZSTD_createCCtx()};
  BlockScan scan;
  BlockSet bright, around, light;
  KeptBlocks kept;
  int columns = 0, rows = 0;
  std::size_t pitch = 0;
  Grid least, rowMinima, leastWide, inverse, opened, scratch;
  PackedBytes section, bits, values, lengths, whole;
  std::array<PackedBytes, kRings> pixels;
  double share = 1;

  [[nodiscard]] std::uint16_t* at(Grid& grid, int row) const {
    return grid.data() + (static_cast<std::size_t>(row) + 1) * pitch + kGridMargin;
  }

  /// of[...] = least of in[...] within `radius`, both ways; beyond the edges there is nothing.
  void minima(Grid& in, int radius, Grid& of) {
    const auto count = static_cast<std::size_t>(columns);
    for (int r = 0; r < rows; ++r) minimumAlongRow(at(in, r), radius, count, at(rowMinima, r));
    for (int r = 0; r < rows; ++r) {
      std::array<const std::uint16_t*, 5> window{};
      int used = 0;
      for (int k = std::max(0, r - radius); k <= std::min(rows - 1, r + radius); ++k)
        window.at(static_cast<std::size_t>(used++)) = at(rowMinima, k);
      backgroundAndExcess(window.data(), used, at(in, r), count, at(of, r), at(scratch, 0));
    }
  }

  void prepare(const ImageView& image) {
    columns = blocksOf(image.width);
    rows = blocksOf(image.height);
    pitch = static_cast<std::size_t>(columns) + 2 * kGridMargin;
    const std::size_t size = pitch * (static_cast<std::size_t>(rows) + 2) + 2 * kGridMargin;
    for (Grid* grid : {&least, &inverse}) grid->assign(size, 0xFFFF);
    for (Grid* grid : {&rowMinima, &leastWide, &opened, &scratch}) grid->resize(size);
  }

  void findLight(const ImageView& image) {
    BlockScanSettings settings;
    settings.radius = kLeastRadius;
    settings.leastContrast = 0;
    scan.begin(image, settings);
    for (int r = 0; r < rows; ++r) scan.settle(r);
    for (int r = 0; r < rows; ++r) std::copy_n(scan.leastSumsOf(r), columns, at(least, r));
    minima(least, 1, leastWide);  // of the window one block wider
    BlockScanSettings wider = settings;
    wider.radius = scanRadius(kSparseMaxSigma);
    const unsigned floor = blockFloor(settings, scan.noiseDn()), widerFloor = blockFloor(wider, scan.noiseDn());
    bright.reset(columns, rows);
    for (int r = 0; r < rows; ++r) {
      const std::uint16_t *sums = scan.sumsOf(r), *narrow = at(least, r), *wide = at(leastWide, r);
      for (int c = 0; c < columns; ++c)
        if (sums[c] > narrow[c] + floor || sums[c] > wide[c] + widerFloor) bright.add(c, r);
    }
    light.reset(columns, rows);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        if (bright.has(c, r) && neighboured(c, r)) light.add(c, r);
  }

  [[nodiscard]] bool neighboured(int column, int row) const {
    int n = 0;
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c) n += bright.has(c, r) ? 1 : 0;
    return n > 1;
  }

  /// The largest, around each block, of the least sums around: the highest sums that change no least sum.
  void open() {
    for (int r = 0; r < rows; ++r) {
      const std::uint16_t* from = at(least, r);
      std::uint16_t* to = at(inverse, r);
      for (int c = 0; c < columns; ++c) to[c] = static_cast<std::uint16_t>(0xFFFF - from[c]);
    }
    minima(inverse, kLeastRadius, opened);
    for (int r = 0; r < rows; ++r) {
      std::uint16_t* to = at(opened, r);
      for (int c = 0; c < columns; ++c) to[c] = static_cast<std::uint16_t>(0xFFFF - to[c]);
    }
  }

  /// Sums for the blocks left out, in as few runs as fit. False if a picture cannot show one.
  bool chooseSums(const ImageView& image) {
    values.clear();
    lengths.clear();
    const NoiseSampling sampling = noiseSampling(image.height / kBlock);
    const unsigned median = scan.medianSum(), difference = scan.medianDifference();
    unsigned low = 0, high = 0xFFFF, before = 0;
    std::uint64_t length = 0;
    bool possible = true;
    const auto endRun = [&] {
      if (length == 0) return;
      // The nearest to the run before.
      const unsigned value = std::clamp(before, low, high);
      const auto change = static_cast<int>(value) - static_cast<int>(before);
      putNumber(values, change < 0 ? 2U * static_cast<unsigned>(-change) - 1 : 2U * static_cast<unsigned>(change));
      putNumber(lengths, length - 1);
      possible = possible && Fill::possible(value, difference);
      before = value;
      length = 0;
      low = 0;
      high = 0xFFFF;
    };
    const std::uint8_t* ring = kept.ring().data();
    for (int r = 0; r < rows; ++r) {
      const std::uint16_t *sums = scan.sumsOf(r), *leastOf = at(opened, r);
      const bool sampled = sampling.takes(r);
      for (int c = 0; c < columns; ++c) {
        if (*ring++ != kLeftOut) continue;
        unsigned fewest = leastOf[c];
        const unsigned most = sums[c];
        if (sampled && most >> 2U >= median)
          fewest = std::max(fewest, (median + (most >> 2U > median ? 1U : 0U)) << 2U);
        if (fewest > high || most < low) endRun();
        low = std::max(low, fewest);
        high = std::min(high, most);
        ++length;
      }
    }
    endRun();
    return possible;
  }

  void gather(const ImageView& image) {
    for (PackedBytes& p : pixels) p.clear();
    for (std::size_t k = 0; k < kRings; ++k) pixels[k].reserve(kept.count(k) * kBlock * kBlock);
    const std::uint8_t* ring = kept.ring().data();
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const std::uint8_t k = *ring++;
        if (k == kLeftOut) continue;
        PackedBytes& to = pixels[k];
        eachRow(c, r, image.width, image.height, [&](int x, int y, int count) {
          const std::uint8_t* from = image.row(y) + x;
          to.insert(to.end(), from, from + count);
        });
      }
  }

  void addSection(std::span<const std::uint8_t> bytes, PackedBytes& out) {
    section.resize(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compressCCtx(zstd.get(), section.data(), section.size(), bytes.data(), bytes.size(), kLevel);
    const bool smaller = ZSTD_isError(size) == 0 && size < bytes.size();
    putNumber(out, bytes.size());
    putNumber(out, smaller ? size : bytes.size());
    if (smaller)
      out.insert(out.end(), section.begin(), section.begin() + static_cast<std::ptrdiff_t>(size));
    else
      out.insert(out.end(), bytes.begin(), bytes.end());
  }

  void begin(const ImageView& image, FrameKind kind, PackedBytes& out) {
    out.clear();
    out.push_back(static_cast<std::uint8_t>(kind));
    put16(out, static_cast<unsigned>(image.width));
    put16(out, static_cast<unsigned>(image.height));
  }

  bool packSparse(const ImageView& image, PackedBytes& out) {
    prepare(image);
    findLight(image);
    kept.set(light, image.width, image.height);
    const double blocks = static_cast<double>(columns) * rows;
    if (static_cast<double>(kept.kept()) > kMostKept * blocks) return false;
    open();
    if (!chooseSums(image)) return false;
    gather(image);
    begin(image, FrameKind::Sparse, out);
    put16(out, scan.medianDifference());
    const std::span<const std::uint64_t> words = light.words();
    bits.resize(words.size_bytes());
    std::memcpy(bits.data(), words.data(), bits.size());
    for (const PackedBytes* part : {&bits, &values, &lengths}) addSection(*part, out);
    std::size_t bytes = 0;
    for (const PackedBytes& p : pixels) {
      addSection(p, out);
      bytes += p.size();
    }
    share = static_cast<double>(bytes) / (static_cast<double>(image.width) * image.height);
    return true;
  }

  void packWhole(const ImageView& image, PackedBytes& out) {
    begin(image, FrameKind::Whole, out);
    whole.clear();
    for (int y = 0; y < image.height; ++y) whole.insert(whole.end(), image.row(y), image.row(y) + image.width);
    addSection(whole, out);
    share = 1;
  }
};

FramePacker::FramePacker() : impl_(std::make_unique<Impl>()) {}
FramePacker::~FramePacker() = default;
double FramePacker::keptShare() const { return impl_->share; }

FrameKind FramePacker::pack(const ImageView& image, FrameKind wished, PackedBytes& out) {
  if (wished == FrameKind::Sparse && impl_->packSparse(image, out)) return FrameKind::Sparse;
  impl_->packWhole(image, out);
  return FrameKind::Whole;
}

// ---- unpacking

Expected<FrameSize> packedSize(std::span<const std::uint8_t> packed) {
  if (packed.size() < kHeadSize) return inputError("frame", "is cut off");
  FrameSize size;
  size.kind = static_cast<FrameKind>(packed[0]);
  size.width = packed[1] | packed[2] << 8U;
  size.height = packed[3] | packed[4] << 8U;
  const auto count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  if ((size.kind != FrameKind::Sparse && size.kind != FrameKind::Whole) || size.width < 32 || size.height < 32 ||
      count > kMostPixels)
    return inputError("frame", "is none that this version knows");
  return size;
}

struct FrameUnpacker::Impl {
  std::unique_ptr<ZSTD_DCtx, ZstdFree> zstd{ZSTD_createDCtx()};
  BlockSet light;
  KeptBlocks kept;
  PackedBytes values, lengths, pixels;
  std::vector<std::uint16_t> sums;

  /// Of `size` bytes, or of at most so many.
  bool section(ByteReader& from, std::size_t size, bool exact, PackedBytes& to) {
    const auto full = from.number(), packed = from.number();
    if (!full || !packed || (exact ? *full != size : *full > size)) return false;
    const auto bytes = from.bytes(*packed);
    if (!bytes) return false;
    to.resize(static_cast<std::size_t>(*full));
    if (*full == *packed) {
      std::copy(bytes->begin(), bytes->end(), to.begin());
      return true;
    }
    return ZSTD_decompressDCtx(zstd.get(), to.data(), to.size(), bytes->data(), bytes->size()) == to.size();
  }

  bool readSums(std::size_t leftOut) {
    ByteReader changes(values), counts(lengths);
    sums.clear();
    sums.reserve(leftOut);
    std::int64_t value = 0;
    while (sums.size() < leftOut) {
      const auto change = changes.number(), count = counts.number();
      if (!change || !count || *change > 0x20000 || *count >= leftOut - sums.size()) return false;
      value +=
          (*change & 1U) != 0 ? -static_cast<std::int64_t>(*change / 2) - 1 : static_cast<std::int64_t>(*change / 2);
      if (value < 0 || value > kSummed * 255) return false;
      sums.insert(sums.end(), static_cast<std::size_t>(*count) + 1, static_cast<std::uint16_t>(value));
    }
    return changes.empty() && counts.empty();
  }

  static void fillRows(std::uint8_t* pixels, std::ptrdiff_t stride, unsigned sum) {
    // As Fill::spread, eight pixels at once.
    const std::uint64_t ones = 0x0101010101010101U, each = ones * (sum / kSummed);
    for (unsigned y = 0, more = sum % kSummed; y < kBlock; y += 2, pixels += 2 * stride) {
      const unsigned here = std::min(more, 8U);
      more -= here;
      std::array<std::uint8_t, kBlock> row{};
      std::memcpy(row.data(), &each, kBlock);
      for (unsigned x = 0; x < here; ++x) row[x] = static_cast<std::uint8_t>(row[x] + 1);
      std::memcpy(pixels, row.data(), kBlock);
      std::memcpy(pixels + stride, row.data(), kBlock);
    }
  }

  static bool fillSampled(std::uint8_t* pixels, std::ptrdiff_t stride, unsigned sum, unsigned difference) {
    if (!Fill::possible(sum, difference)) return false;
    const auto values = Fill::spread(sum), steps = Fill::spread(difference);
    const unsigned most = (sum + kSummed - 1) / kSummed + (difference + kSummed - 1) / kSummed;
    for (std::size_t i = 0; i < kSummed; ++i) {
      std::uint8_t* even = pixels + static_cast<std::ptrdiff_t>(2 * (i / kBlock)) * stride + i % kBlock;
      even[0] = values[i];
      even[stride] = static_cast<std::uint8_t>(most <= 255 ? values[i] + steps[i] : values[i] - steps[i]);
    }
    return true;
  }

  bool fill(const MutableImageView& image, unsigned difference) {
    const NoiseSampling sampling = noiseSampling(image.height / kBlock);
    const std::uint8_t* ring = kept.ring().data();
    std::size_t next = 0;
    for (int r = 0; r < light.rows(); ++r)
      for (int c = 0; c < light.columns(); ++c) {
        if (*ring++ != kLeftOut) continue;
        std::uint8_t* pixelsOf = image.row(r * kBlock) + static_cast<std::ptrdiff_t>(c) * kBlock;
        const unsigned sum = sums[next++];
        if (!sampling.takes(r))
          fillRows(pixelsOf, image.stride, sum);
        else if (!fillSampled(pixelsOf, image.stride, sum, difference))
          return false;
      }
    return true;
  }

  bool putPixels(ByteReader& from, const MutableImageView& image) {
    for (std::uint8_t k = 0; k < kRings; ++k) {
      // How many there are of blocks that the edge cuts shows only when they are put.
      if (!section(from, kept.count(k) * kBlock * kBlock, k != kCut, pixels)) return false;
      ByteReader left(pixels);
      const std::uint8_t* ring = kept.ring().data();
      bool enough = true;
      for (int r = 0; r < light.rows(); ++r)
        for (int c = 0; c < light.columns(); ++c) {
          if (*ring++ != k) continue;
          eachRow(c, r, image.width, image.height, [&](int x, int y, int count) {
            const auto bytes = left.bytes(static_cast<std::uint64_t>(count));
            enough = enough && bytes;
            if (bytes) std::copy(bytes->begin(), bytes->end(), image.row(y) + x);
          });
        }
      if (!enough || !left.empty()) return false;
    }
    return true;
  }

  bool unpackSparse(ByteReader& from, const MutableImageView& image) {
    const auto two = from.bytes(2);
    if (!two) return false;
    const unsigned difference = (*two)[0] | static_cast<unsigned>((*two)[1]) << 8U;
    light.reset(blocksOf(image.width), blocksOf(image.height));
    const std::size_t blocks = static_cast<std::size_t>(light.columns()) * static_cast<std::size_t>(light.rows());
    if (!section(from, light.words().size_bytes(), true, values)) return false;
    std::memcpy(light.words().data(), values.data(), values.size());
    light.trim();
    kept.set(light, image.width, image.height);
    constexpr std::size_t kNumber = 3;  // bytes that a value or a length takes at most
    if (!section(from, kNumber * blocks, false, values) || !section(from, kNumber * blocks, false, lengths))
      return false;
    return readSums(blocks - kept.kept()) && fill(image, difference) && putPixels(from, image) && from.empty();
  }

  bool unpackWhole(ByteReader& from, const MutableImageView& image) {
    const auto width = static_cast<std::size_t>(image.width);
    if (!section(from, width * static_cast<std::size_t>(image.height), true, pixels) || !from.empty()) return false;
    for (int y = 0; y < image.height; ++y)
      std::memcpy(image.row(y), pixels.data() + width * static_cast<std::size_t>(y), width);
    return true;
  }
};

FrameUnpacker::FrameUnpacker() : impl_(std::make_unique<Impl>()) {}
FrameUnpacker::~FrameUnpacker() = default;

Expected<void> FrameUnpacker::unpack(std::span<const std::uint8_t> packed, const MutableImageView& image) {
  const auto size = packedSize(packed);
  if (!size) return tl::unexpected(size.error());
  if (size->width != image.width || size->height != image.height)
    return inputError("frame", "is of another size than the picture that it should go into");
  ByteReader from(packed.subspan(kHeadSize));
  const bool good =
      size->kind == FrameKind::Sparse ? impl_->unpackSparse(from, image) : impl_->unpackWhole(from, image);
  if (!good) return inputError("frame", "is damaged: its parts do not fit each other");
  return {};
}

}  // namespace vignole
