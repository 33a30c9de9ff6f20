#include "engine/stripe/block_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "engine/stripe/block_kernels.h"

namespace vignole {
namespace {

constexpr std::uint16_t kNothing = 0xFFFF;  // neutral for a minimum
constexpr int kNoiseSampling = 8;           // every so many block rows
constexpr float kPixels = kBlock * kBlock;
constexpr float kRoundingDn = 0.2887F;  // 1 / sqrt(12)

/// A block of which only `width` x `height` pixels lie in the picture.
std::uint16_t cutBlockSum(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int height) {
  unsigned sum = 0;
  for (int y = 0; y < height; ++y, pixels += stride)
    for (int x = 0; x < width; ++x) sum += pixels[x];
  return static_cast<std::uint16_t>(sum * kBlock * kBlock / static_cast<unsigned>(width * height));
}

/// The value that half of them do not exceed, by counting (all below `limit`).
std::uint16_t medianByCounting(const std::vector<std::uint16_t>& values, std::size_t limit,
                               std::vector<std::uint32_t>& histogram) {
  std::fill_n(histogram.begin(), limit, 0U);
  for (const std::uint16_t v : values) ++histogram[v];
  std::size_t seen = 0, value = 0;
  while (value + 1 < limit && 2 * (seen += histogram[value]) < values.size()) ++value;
  return static_cast<std::uint16_t>(value);
}

/// Mean of the least of n standard normal numbers, negated (Blom's approximation to the normal order statistics).
double expectedMinimum(double n) {
  const double p = (1 - 0.375) / (n + 0.25);
  const double t = std::sqrt(-2 * std::log(p));  // Abramowitz & Stegun 26.2.22
  return t - (2.30753 + 0.27061 * t) / (1 + 0.99229 * t + 0.04481 * t * t);
}

}  // namespace

std::size_t BlockScan::offset(int row) const { return (static_cast<std::size_t>(row) + 1) * pitch_ + kGridMargin; }

float BlockScan::backgroundAt(int x, int y) const {
  return static_cast<float>(background_[offset(y / kBlock) + static_cast<std::size_t>(x / kBlock)]) / kPixels +
         minimumBiasDn_;
}

void BlockScan::resize(const ImageView& image) {
  if (image.width == width_ && image.height == height_) return;
  width_ = image.width;
  height_ = image.height;
  columns_ = (width_ + kBlock - 1) / kBlock;
  rows_ = (height_ + kBlock - 1) / kBlock;
  pitch_ = static_cast<std::size_t>(columns_) + 2 * kGridMargin;
  const std::size_t size = pitch_ * (static_cast<std::size_t>(rows_) + 2) + kGridMargin;
  sums_.assign(size, kNothing);
  for (Grid* grid : {&rowMinima_, &background_, &excess_}) grid->assign(size, 0);
  words_ = (static_cast<std::size_t>(columns_) + 63) / 64;
  marks_.assign(words_ * static_cast<std::size_t>(rows_), 0);
  histogram_.assign(1U << 14U, 0);
  const std::size_t blocks = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  differences_.reserve(blocks);
  sampled_.reserve(blocks);
  runs_.reserve(blocks / 2 + 1);
}

void BlockScan::sumBlocks(const ImageView& image) {
  differences_.clear();
  sampled_.clear();
  const int wholeColumns = width_ / kBlock, wholeRows = height_ / kBlock;
  const auto whole = static_cast<std::size_t>(wholeColumns);
  const int sampling = wholeRows >= 8 * kNoiseSampling ? kNoiseSampling : 1;
  for (int r = 0; r < rows_; ++r) {
    const std::uint8_t* pixels = image.row(r * kBlock);
    std::uint16_t* sums = at(sums_, r);
    const int height = std::min(kBlock, height_ - r * kBlock);
    if (r < wholeRows)
      sumBlockRow(pixels, image.stride, whole, sums);
    else
      for (std::ptrdiff_t c = 0; c < wholeColumns; ++c)
        sums[c] = cutBlockSum(pixels + c * kBlock, image.stride, kBlock, height);
    if (wholeColumns < columns_)
      sums[wholeColumns] = cutBlockSum(pixels + static_cast<std::ptrdiff_t>(wholeColumns) * kBlock, image.stride,
                                       width_ % kBlock, height);
    if (r < wholeRows && r % sampling == sampling / 2) {  // while these pixels are in the nearest cache
      differences_.resize(differences_.size() + whole);
      sumBlockDifferences(pixels, image.stride, whole, differences_.data() + differences_.size() - whole);
      sampled_.insert(sampled_.end(), sums, sums + whole);
    }
  }
}

void BlockScan::measureNoise() {
  // E|a - b| = 2 sigma / sqrt(pi) for two normal numbers; a median over blocks because the stripe is in few of them.
  const float meanDifference = static_cast<float>(medianByCounting(differences_, 32 * 255 + 1, histogram_)) / 32;
  noiseDn_ = std::max(kRoundingDn, meanDifference * std::sqrt(std::numbers::pi_v<float>) / 2);
  for (std::uint16_t& s : sampled_) s = static_cast<std::uint16_t>(s >> 3U);
  backgroundDn_ = static_cast<float>(medianByCounting(sampled_, 64 * 255 / 8 + 1, histogram_)) * 8 / kPixels;
}

void BlockScan::findBackground(int radius) {
  const auto count = static_cast<std::size_t>(columns_);
  for (int r = 0; r < rows_; ++r) minimumAlongRow(at(sums_, r), radius, count, at(rowMinima_, r));
  for (int r = 0; r < rows_; ++r) {
    const std::uint16_t* window[17];
    int used = 0;
    for (int k = std::max(0, r - radius); k <= std::min(rows_ - 1, r + radius); ++k) window[used++] = at(rowMinima_, k);
    backgroundAndExcess(window, used, at(sums_, r), count, at(background_, r), at(excess_, r));
    std::fill_n(at(excess_, r) + count, 8, std::uint16_t{0});  // what the last vector wrote into the margin
  }
}

void BlockScan::markCandidates(const BlockScanSettings& settings) {
  const double blockNoiseDn = noiseDn_ / kBlock;  // a mean of 64 pixels
  const double window = (2.0 * settings.radius + 1) * (2.0 * settings.radius + 1);
  minimumBiasDn_ = static_cast<float>(expectedMinimum(window) * blockNoiseDn);
  const double thresholdDn = minimumBiasDn_ + std::max(settings.leastContrast, settings.noiseFactor * blockNoiseDn);
  const auto floor = static_cast<std::uint16_t>(std::min(65535.0, thresholdDn * kPixels));
  const auto pitch = static_cast<std::ptrdiff_t>(pitch_);
  candidates_ = 0;
  for (int r = 0; r < rows_; ++r)
    markBlocks(at(excess_, r), pitch, floor, static_cast<std::size_t>(columns_),
               marks_.data() + static_cast<std::size_t>(r) * words_);
  for (const std::uint64_t word : marks_) candidates_ += static_cast<std::size_t>(std::popcount(word));
}

void BlockScan::capCandidates(std::size_t maxBlocks) {
  std::fill(histogram_.begin(), histogram_.end(), 0U);
  const auto each = [this](const auto& work) {
    for (std::size_t w = 0; w < marks_.size(); ++w)
      for (std::uint64_t left = marks_[w]; left != 0; left &= left - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(left));
        const std::size_t excess = at(excess_, static_cast<int>(w / words_))[w % words_ * 64 + bit];
        work(marks_[w], std::uint64_t{1} << bit, std::min<std::size_t>(excess, (1U << 14U) - 1));
      }
  };
  each([this](std::uint64_t, std::uint64_t, std::size_t excess) { ++histogram_[excess]; });
  std::size_t kept = 0, level = histogram_.size();
  while (level > 0 && kept + histogram_[level - 1] <= maxBlocks) kept += histogram_[--level];
  each([level](std::uint64_t& word, std::uint64_t bit, std::size_t excess) {
    if (excess < level) word &= ~bit;
  });
  candidates_ = kept;
}

void BlockScan::collectRuns() {
  runs_.clear();
  for (std::size_t w = 0; w < marks_.size(); ++w) {
    const auto row = static_cast<std::uint16_t>(w / words_);
    std::uint64_t left = marks_[w];
    for (std::size_t bit = 0; left != 0;) {
      const auto gap = static_cast<std::size_t>(std::countr_zero(left));
      left >>= gap;
      const auto length = static_cast<std::size_t>(std::countr_one(left));
      const auto first = static_cast<std::uint16_t>(w % words_ * 64 + bit + gap);
      if (!runs_.empty() && runs_.back().row == row && runs_.back().first + runs_.back().count == first)
        runs_.back().count = static_cast<std::uint16_t>(runs_.back().count + length);  // on from the word before
      else
        runs_.push_back({row, first, static_cast<std::uint16_t>(length)});
      left = length == 64 ? 0 : left >> length;
      bit += gap + length;
    }
  }
}

void BlockScan::scan(const ImageView& image, const BlockScanSettings& settings) {
  resize(image);
  sumBlocks(image);
  measureNoise();
  findBackground(settings.radius);
  markCandidates(settings);
  overloaded_ = candidates_ > static_cast<std::size_t>(settings.maxBlocks);
  if (overloaded_) capCandidates(static_cast<std::size_t>(settings.maxBlocks));
  collectRuns();
}

}  // namespace vignole
