#include "engine/recording/block_set.h"

#include <bit>

namespace vignole {

void BlockSet::reset(int columns, int rows) {
  columns_ = columns;
  rows_ = rows;
  words_ = (static_cast<std::size_t>(columns) + 63) / 64;
  bits_.assign(words_ * static_cast<std::size_t>(rows), 0);
}

void BlockSet::widen(const BlockSet& of) {
  reset(of.columns_, of.rows_);
  beside_.resize(bits_.size());
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    const std::size_t w = i % words_;
    const std::uint64_t own = of.bits_[i], before = w == 0 ? 0 : of.bits_[i - 1] >> 63U,
                        behind = w + 1 == words_ ? 0 : of.bits_[i + 1] << 63U;
    beside_[i] = own | own << 1U | own >> 1U | before | behind;
  }
  for (std::size_t i = 0; i < bits_.size(); ++i)
    bits_[i] =
        beside_[i] | (i < words_ ? 0 : beside_[i - words_]) | (i + words_ < bits_.size() ? beside_[i + words_] : 0);
  trim();
}

std::size_t BlockSet::count() const {
  std::size_t n = 0;
  for (const std::uint64_t word : bits_) n += static_cast<std::size_t>(std::popcount(word));
  return n;
}

void BlockSet::trim() {
  const auto rest = static_cast<unsigned>(columns_) % 64U;
  if (rest == 0) return;
  for (std::size_t i = words_ - 1; i < bits_.size(); i += words_) bits_[i] &= (std::uint64_t{1} << rest) - 1;
}

}  // namespace vignole
