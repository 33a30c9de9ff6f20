#pragma once
// TOML read strictly: `format = 1`, every key known, every value in range. Errors name file, line, key and remedy.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// Ask for every key that may be there, then finish(): it returns the first thing that was wrong (missing key, wrong
/// type, out of range) or the first key that nobody asked for. Values asked for after an error are the fallback or 0.
class TomlReader {
 public:
  [[nodiscard]] static Expected<TomlReader> load(const std::filesystem::path& file);
  [[nodiscard]] static Expected<TomlReader> parse(std::string_view text, const std::string& nameInErrors);
  ~TomlReader();
  TomlReader(TomlReader&&) noexcept;
  TomlReader& operator=(TomlReader&&) noexcept;

  /// Keys are dotted paths from the root ("dimension.RH.lower_mm", "camera.0.focal_mm" for arrays of tables).
  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key, double min, double max, std::optional<double> fallback = {});
  [[nodiscard]] int integer(std::string_view key, int min, int max, std::optional<int> fallback = {});
  [[nodiscard]] bool boolean(std::string_view key, std::optional<bool> fallback = {});
  [[nodiscard]] std::string text(std::string_view key, std::optional<std::string> fallback = {});
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t count);
  [[nodiscard]] std::vector<std::string> texts(std::string_view key);
  /// Keys of a table (marks the table itself as known), or the number of tables in an array of tables.
  [[nodiscard]] std::vector<std::string> keys(std::string_view table);
  [[nodiscard]] std::size_t size(std::string_view array);
  /// Number of elements of a list of plain values, which are asked for one by one ("factor.0.levels.2").
  [[nodiscard]] std::size_t listSize(std::string_view list);
  /// Adds an error of the caller's at the line of `key`; the first error wins.
  void refuse(std::string_view key, std::string what);
  [[nodiscard]] Expected<void> finish();

 private:
  struct Impl;
  explicit TomlReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
