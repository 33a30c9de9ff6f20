#pragma once
// A CSV table by the names of its columns. Errors name file, line and column.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// One header line, then rows of as many fields; fields separated by commas, semicolons (then a decimal comma is
/// understood) or tabs, whichever the header has; quotes around a field as in RFC 4180; empty lines are skipped.
class CsvTable {
 public:
  [[nodiscard]] static Expected<CsvTable> load(const std::filesystem::path& file);
  [[nodiscard]] static Expected<CsvTable> parse(std::string_view text, const std::string& nameInErrors);

  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
  /// The error lists the columns that are there.
  [[nodiscard]] Expected<std::size_t> column(std::string_view column) const;
  [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  /// A finite number.
  [[nodiscard]] Expected<double> number(std::size_t row, std::size_t column) const;
  /// The same; empty where the field is empty.
  [[nodiscard]] Expected<std::optional<double>> optionalNumber(std::size_t row, std::size_t column) const;
  /// A whole column of finite numbers.
  [[nodiscard]] Expected<std::vector<double>> numbers(std::string_view column) const;
  /// "FILE:LINE" of a row, for errors of the caller's.
  [[nodiscard]] std::string where(std::size_t row) const;
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string file_;
  char separator_ = ',';
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;  ///< number of the line in which each row begins
};

}  // namespace vignole
