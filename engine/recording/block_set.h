#pragma once
// Blocks of a frame, one bit each.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vignole {

class BlockSet {
 public:
  /// Empty, for so many blocks; buffers stay.
  void reset(int columns, int rows);
  void add(int column, int row) { bits_[at(column, row)] |= std::uint64_t{1} << (static_cast<unsigned>(column) % 64U); }
  [[nodiscard]] bool has(int column, int row) const {
    return (bits_[at(column, row)] >> (static_cast<unsigned>(column) % 64U) & 1U) != 0;
  }
  /// `of` and all blocks around each of it.
  void widen(const BlockSet& of);
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  /// Row by row, wordsOfRow() words each.
  [[nodiscard]] std::span<std::uint64_t> words() { return bits_; }
  [[nodiscard]] std::span<const std::uint64_t> words() const { return bits_; }
  [[nodiscard]] std::size_t wordsOfRow() const { return words_; }
  /// Takes away what lies beyond the last column.
  void trim();

 private:
  [[nodiscard]] std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * words_ + static_cast<std::size_t>(column) / 64;
  }
  int columns_ = 0, rows_ = 0;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_, beside_;
};

}  // namespace vignole
