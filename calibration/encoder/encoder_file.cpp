#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "calibration/encoder/encoder_calibration.h"
#include "engine/files/atomic_file.h"

namespace vignole {

namespace {

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view kBlank = " \t\r\"";
  const auto first = s.find_first_not_of(kBlank);
  return first == std::string_view::npos ? std::string_view() : s.substr(first, s.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

enum Column : std::size_t { kCount, kX, kY, kCount2 };
constexpr std::array<std::string_view, 4> kNames = {"count", "x_mm", "y_mm", "count2"};
constexpr std::size_t kAbsent = ~std::size_t{0};

/// Where each column stands in the file.
Expected<std::array<std::size_t, 4>> columnsOf(std::string_view header, const std::string& where) {
  std::array<std::size_t, 4> at{};
  at.fill(kAbsent);
  const auto fields = fieldsOf(header);
  for (std::size_t i = 0; i < fields.size(); ++i)
    for (std::size_t c = 0; c < kNames.size(); ++c)
      if (fields[i] == kNames[c]) at[c] = i;
  for (const Column c : {kCount, kX, kY})
    if (at[c] == kAbsent)
      return inputError(where, "has no column " + std::string(kNames[c]) +
                                   "; the first line must name count,x_mm,y_mm "
                                   "(and count2 of a second encoder)");
  return at;
}

Expected<double> numberAt(const std::vector<std::string_view>& fields, std::size_t at, std::string_view column,
                          const std::string& where) {
  const std::string named = where + ": " + std::string(column);
  if (at >= fields.size()) return inputError(named, "is missing; is the file truncated?");
  const std::string_view field = fields[at];
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || field.empty())
    return inputError(named, "is no number: '" + std::string(field.substr(0, 40)) + "'");
  if (!std::isfinite(value)) return inputError(named, "is " + std::string(field) + "; remove the row");
  return value;
}

Expected<EncoderReading> readingOf(std::string_view line, const std::array<std::size_t, 4>& at,
                                   const std::string& where) {
  const auto fields = fieldsOf(line);
  std::array<double, 4> values{};
  for (std::size_t c = 0; c < kNames.size(); ++c) {
    if (at[c] == kAbsent) continue;
    const auto value = numberAt(fields, at[c], kNames[c], where);
    if (!value) return tl::unexpected(value.error());
    if ((c == kCount || c == kCount2) && *value != std::round(*value))
      return inputError(where + ": " + std::string(kNames[c]), "is no whole number of pulses");
    values[c] = *value;
  }
  EncoderReading reading{values[kCount], values[kX], values[kY], {}};
  if (at[kCount2] != kAbsent) reading.count2 = values[kCount2];
  return reading;
}

}  // namespace

Expected<std::vector<EncoderReading>> loadEncoderReadings(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  std::string_view rest = *text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  std::vector<EncoderReading> readings;
  std::optional<std::array<std::size_t, 4>> columns;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty() || line.front() == '#') continue;
    const std::string where = file.string() + ":" + std::to_string(number);
    if (!columns) {
      auto found = columnsOf(line, where);
      if (!found) return tl::unexpected(found.error());
      columns = *found;
      continue;
    }
    auto reading = readingOf(line, *columns, where);
    if (!reading) return tl::unexpected(reading.error());
    readings.push_back(*reading);
  }
  if (!columns) return inputError(file.string(), "is empty; the first line must name count,x_mm,y_mm");
  return readings;
}

}  // namespace vignole
