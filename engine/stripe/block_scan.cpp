#include "engine/stripe/block_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "engine/stripe/block_kernels.h"

namespace vignole {
namespace {

constexpr std::uint16_t kNothing = 0xFFFF;    // neutral for a minimum
constexpr int kNoiseSampling = 16;            // every so many block rows
constexpr int kSummed = kBlock * kBlock / 2;  // pixels of a block that are looked at: those of every second row
constexpr float kPixels = kSummed;
constexpr float kRoundingDn = 0.2887F;  // 1 / sqrt(12)

/// A block of which only `width` x `height` pixels lie in the picture.
std::uint16_t cutBlockSum(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int height) {
  unsigned sum = 0;
  for (int y = 0; y < height; y += 2, pixels += 2 * stride)
    for (int x = 0; x < width; ++x) sum += pixels[x];
  return static_cast<std::uint16_t>(sum * kSummed / static_cast<unsigned>(width * ((height + 1) / 2)));
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

int scanRadius(double sigma) { return std::clamp(static_cast<int>(std::ceil((4.5 * sigma + 4) / kBlock)), 2, 5); }

NoiseSampling noiseSampling(int wholeRows) {
  const int every = wholeRows >= 8 * kNoiseSampling ? kNoiseSampling : 1;
  return {every / 2, every};
}

double minimumBias(const BlockScanSettings& settings, float noiseDn) {
  const double side = 2.0 * settings.radius + 1;
  return expectedMinimum(side * side) * noiseDn / std::sqrt(static_cast<double>(kSummed));
}

std::uint16_t blockFloor(const BlockScanSettings& settings, float noiseDn) {
  const double blockNoiseDn = noiseDn / std::sqrt(static_cast<double>(kSummed));
  const double thresholdDn = static_cast<float>(minimumBias(settings, noiseDn)) +
                             std::max(settings.leastContrast, settings.noiseFactor * blockNoiseDn);
  return static_cast<std::uint16_t>(std::min(65535.0, thresholdDn * kPixels));
}

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
  pitch_ = static_cast<std::size_t>(columns_) + kGridMargin;  // the margin behind a row is that before the next
  const std::size_t size = pitch_ * (static_cast<std::size_t>(rows_) + 2) + kGridMargin;
  sums_.assign(size, kNothing);
  for (Grid* grid : {&rowMinima_, &background_, &excess_}) grid->assign(size, 0);
  words_ = (static_cast<std::size_t>(columns_) + 63) / 64;
  marks_.assign(words_ * static_cast<std::size_t>(rows_), 0);
  bright_.assign(words_ * (static_cast<std::size_t>(rows_) + 2), 0);
  histogram_.assign(1U << 14U, 0);
  const std::size_t blocks = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  differences_.reserve(blocks);
  sampled_.reserve(blocks);
  runs_.reserve(blocks / 2 + 1);
  beginOfRow_.reserve(static_cast<std::size_t>(rows_) + 1);
}

void BlockScan::sumRow(int r) {
  const int wholeColumns = width_ / kBlock, wholeRows = height_ / kBlock;
  const std::uint8_t* pixels = image_.row(r * kBlock);
  std::uint16_t* sums = at(sums_, r);
  const int height = std::min(kBlock, height_ - r * kBlock);
  if (r < wholeRows)
    sumBlockRow(pixels, image_.stride, static_cast<std::size_t>(wholeColumns), sums);
  else
    for (std::ptrdiff_t c = 0; c < wholeColumns; ++c)
      sums[c] = cutBlockSum(pixels + c * kBlock, image_.stride, kBlock, height);
  if (wholeColumns < columns_)
    sums[wholeColumns] = cutBlockSum(pixels + static_cast<std::ptrdiff_t>(wholeColumns) * kBlock, image_.stride,
                                     width_ % kBlock, height);
}

void BlockScan::sample() {
  differences_.clear();
  sampled_.clear();
  sampledRow_.assign(static_cast<std::size_t>(rows_), 0);
  const int wholeRows = height_ / kBlock;
  const NoiseSampling sampling = noiseSampling(wholeRows);
  const auto whole = static_cast<std::size_t>(width_ / kBlock);
  for (int r = sampling.first; r < wholeRows; r += sampling.every) {
    sumRow(r);
    sampledRow_[static_cast<std::size_t>(r)] = 1;
    differences_.resize(differences_.size() + whole);
    sumBlockDifferences(image_.row(r * kBlock), image_.stride, whole,
                        differences_.data() + differences_.size() - whole);
    sampled_.insert(sampled_.end(), at(sums_, r), at(sums_, r) + whole);
  }
}

void BlockScan::measureNoise() {
  // E|a - b| = 2 sigma / sqrt(pi) for two normal numbers; a median over blocks because the stripe is in few of them.
  medianDifference_ = medianByCounting(differences_, 32 * 255 + 1, histogram_);
  const float meanDifference = static_cast<float>(medianDifference_) / 32;
  noiseDn_ = std::max(kRoundingDn, meanDifference * std::sqrt(std::numbers::pi_v<float>) / 2);
  for (std::uint16_t& s : sampled_) s = static_cast<std::uint16_t>(s >> 2U);
  medianSum_ = medianByCounting(sampled_, kSummed * 255 / 4 + 1, histogram_);
  backgroundDn_ = static_cast<float>(medianSum_) * 4 / kPixels;
}

void BlockScan::findBackground(int r) {
  const auto count = static_cast<std::size_t>(columns_);
  const int radius = settings_.radius;
  for (; summed_ <= std::min(rows_ - 1, r + radius); ++summed_) {
    if (sampledRow_[static_cast<std::size_t>(summed_)] == 0) sumRow(summed_);
    minimumAlongRow(at(sums_, summed_), radius, count, at(rowMinima_, summed_));
  }
  const std::uint16_t* window[17];
  int used = 0;
  for (int k = std::max(0, r - radius); k <= std::min(rows_ - 1, r + radius); ++k) window[used++] = at(rowMinima_, k);
  backgroundAndExcess(window, used, at(sums_, r), count, at(background_, r), at(excess_, r));
  std::fill_n(at(excess_, r) + count, 8, std::uint16_t{0});  // what the last vector wrote into the margin
}

void BlockScan::begin(const ImageView& image, const BlockScanSettings& settings) {
  image_ = image;
  settings_ = settings;
  resize(image);
  sample();
  measureNoise();
  minimumBiasDn_ = static_cast<float>(minimumBias(settings, noiseDn_));
  floor_ = blockFloor(settings, noiseDn_);
  candidates_ = 0;
  summed_ = bordered_ = lit_ = 0;
  runs_.clear();
  beginOfRow_.assign(1, 0);
}

void BlockScan::mark(int row) {
  for (; bordered_ <= std::min(rows_ - 1, row + 1); ++bordered_) findBackground(bordered_);
  markBlocks(at(excess_, row), static_cast<std::ptrdiff_t>(pitch_), floor_, static_cast<std::size_t>(columns_),
             bright_.data() + (static_cast<std::size_t>(row) + 1) * words_);
}

void BlockScan::dropLonely(int row) {
  const std::uint64_t* above = bright_.data() + static_cast<std::size_t>(row) * words_;
  const std::uint64_t *own = above + words_, *below = own + words_;
  std::uint64_t* marks = marks_.data() + static_cast<std::size_t>(row) * words_;
  for (std::size_t w = 0; w < words_; ++w) {
    const auto beside = [&](const std::uint64_t* bits) {
      const std::uint64_t before = w == 0 ? 0 : bits[w - 1], behind = w + 1 == words_ ? 0 : bits[w + 1];
      return bits[w] << 1U | before >> 63U | bits[w] >> 1U | behind << 63U;
    };
    marks[w] = own[w] & (beside(above) | above[w] | beside(own) | beside(below) | below[w]);
    candidates_ += static_cast<std::size_t>(std::popcount(marks[w]));
  }
}

void BlockScan::settle(int row) {
  for (; lit_ <= std::min(rows_ - 1, row + 1); ++lit_) mark(lit_);
  dropLonely(row);
  collectRuns(row);
  for (std::size_t i = beginOfRow_.back(); i < runs_.size(); ++i) askFor(runs_[i]);
  beginOfRow_.push_back(runs_.size());
}

// The rows that the sums left out, where there is light: the next stage will want them.
void BlockScan::askFor(const BlockRun& run) const {
  constexpr int kAround = 8, kLine = 64;
  const int left = std::max(0, run.first * kBlock - kAround);
  const int right = std::min(width_, (run.first + run.count) * kBlock + kAround);
  for (int y = run.row * kBlock + 1; y < std::min(height_, (run.row + 1) * kBlock); y += 2)
    for (int x = left; x < right + kLine - 1; x += kLine) __builtin_prefetch(image_.row(y) + std::min(x, right - 1));
}

void BlockScan::cap() {
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
  const auto most = static_cast<std::size_t>(settings_.maxBlocks);
  while (level > 0 && kept + histogram_[level - 1] <= most) kept += histogram_[--level];
  each([level](std::uint64_t& word, std::uint64_t bit, std::size_t excess) {
    if (excess < level) word &= ~bit;
  });
  runs_.clear();
  beginOfRow_.assign(1, 0);
  for (int row = 0; row < rows_; ++row) {
    collectRuns(row);
    beginOfRow_.push_back(runs_.size());
  }
}

void BlockScan::collectRuns(int row) {
  for (std::size_t w = 0; w < words_; ++w) {
    std::uint64_t left = marks_[static_cast<std::size_t>(row) * words_ + w];
    for (std::size_t bit = 0; left != 0;) {
      const auto gap = static_cast<std::size_t>(std::countr_zero(left));
      left >>= gap;
      const auto length = static_cast<std::size_t>(std::countr_one(left));
      const auto first = static_cast<std::uint16_t>(w * 64 + bit + gap);
      if (!runs_.empty() && runs_.back().row == row && runs_.back().first + runs_.back().count == first)
        runs_.back().count = static_cast<std::uint16_t>(runs_.back().count + length);  // on from the word before
      else
        runs_.push_back({static_cast<std::uint16_t>(row), first, static_cast<std::uint16_t>(length)});
      left = length == 64 ? 0 : left >> length;
      bit += gap + length;
    }
  }
}

}  // namespace vignole
