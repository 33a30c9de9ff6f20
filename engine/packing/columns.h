#pragma once
// Columns of whole numbers made small: differences of the order that fits, split into bytes of equal weight, each
// packed by zstd where that pays. A digest (BLAKE2b, 128 bit) at the end finds any changed byte.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

using Bytes = std::vector<std::uint8_t>;

/// Columns come out in the order in which they went in; what they mean and how long they are is the reader's to know.
class ColumnPacker {
 public:
  /// `kind`: one byte that says what is in there, checked by the reader.
  explicit ColumnPacker(std::uint8_t kind);
  void add(std::span<const std::int64_t> values);
  void addNumber(std::uint64_t value);
  void addText(const std::string& text);
  [[nodiscard]] Bytes finish();

 private:
  void addPlane(std::span<const std::uint8_t> plane);
  Bytes bytes_;
  std::vector<std::uint64_t> residuals_, best_;  ///< reused from column to column
  Bytes plane_, packed_;
};

/// Never reads beyond what is there: after the first error everything is empty or 0, and error() tells.
class ColumnReader {
 public:
  ColumnReader(std::span<const std::uint8_t> bytes, std::uint8_t kind);
  /// `count` values, at most kMaxColumn.
  [[nodiscard]] std::vector<std::int64_t> column(std::size_t count);
  [[nodiscard]] std::uint64_t number();
  [[nodiscard]] std::string text();
  [[nodiscard]] bool good() const { return error_.empty(); }
  [[nodiscard]] const std::string& error() const { return error_; }
  void refuse(const std::string& why);

 private:
  [[nodiscard]] std::uint8_t byte();
  [[nodiscard]] bool plane(std::span<std::uint8_t> into);
  std::span<const std::uint8_t> rest_;
  std::string error_;
};

inline constexpr std::size_t kMaxColumn = 1U << 22U;

}  // namespace vignole
