#include "engine/files/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/files/atomic_file.h"

namespace vignole {

namespace {

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view kBlank = " \t\r";
  const auto first = s.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return s.substr(first, s.find_last_not_of(kBlank) - first + 1);
}

char separatorOf(std::string_view header) {
  for (const char c : {';', '\t'})
    if (header.find(c) != std::string_view::npos) return c;
  return ',';
}

/// Takes one record from the front of `rest`; a quoted field may hold separators, doubled quotes and line ends.
Expected<std::vector<std::string>> takeRecord(std::string_view& rest, char separator, std::size_t& lines) {
  std::vector<std::string> fields;
  std::string field;
  bool quoted = false, wasQuoted = false, done = false;
  std::size_t i = 0;
  const auto finish = [&] {
    fields.push_back(wasQuoted ? field : std::string(trimmed(field)));
    field.clear();
    wasQuoted = false;
  };
  for (; i < rest.size() && !done; ++i) {
    const char c = rest[i];
    if (c == '\n') ++lines;
    if (quoted) {
      if (c != '"')
        field += c;
      else if (i + 1 < rest.size() && rest[i + 1] == '"')
        field += rest[++i];
      else
        quoted = false;
    } else if (c == '"' && trimmed(field).empty() && !wasQuoted) {
      field.clear();
      quoted = wasQuoted = true;
    } else if (c == separator) {
      finish();
    } else if (c == '\n') {
      done = true;
    } else if (!wasQuoted || trimmed(std::string_view(&c, 1)).size() == 1) {
      field += c;
    }
  }
  if (quoted) return inputError("", "a quote is opened and never closed");
  if (!done) ++lines;
  finish();
  rest.remove_prefix(i);
  return fields;
}

std::optional<double> parsed(std::string field, char separator) {
  if (separator == ';') std::replace(field.begin(), field.end(), ',', '.');
  std::string_view digits = field;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return {};
  return value;
}

}  // namespace

Expected<CsvTable> CsvTable::load(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parse(*text, file.string());
}

Expected<CsvTable> CsvTable::parse(std::string_view text, const std::string& nameInErrors) {
  CsvTable table;
  table.file_ = nameInErrors;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (trimmed(text).empty())
    return inputError(nameInErrors, "is empty; a header line with the names of the columns is needed");
  table.separator_ = separatorOf(text.substr(0, text.find('\n')));
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t first = line + 1;
    const std::string where = nameInErrors + ":" + std::to_string(first);
    auto fields = takeRecord(text, table.separator_, line);
    if (!fields) return inputError(where, fields.error().what);
    if (fields->size() == 1 && fields->front().empty()) continue;
    if (table.columns_.empty()) {
      table.columns_ = std::move(*fields);
      continue;
    }
    if (fields->size() != table.columns_.size())
      return inputError(where, "has " + std::to_string(fields->size()) + (fields->size() == 1 ? " field" : " fields") +
                                   ", the header has " + std::to_string(table.columns_.size()));
    table.rows_.push_back(std::move(*fields));
    table.lines_.push_back(first);
  }
  for (std::size_t c = 0; c < table.columns_.size(); ++c)
    for (std::size_t d = 0; d < c; ++d)
      if (table.columns_[c] == table.columns_[d])
        return inputError(nameInErrors + ":1", "has two columns named '" + table.columns_[c] + "'");
  return table;
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return {};
  return static_cast<std::size_t>(found - columns_.begin());
}

Expected<std::size_t> CsvTable::column(std::string_view column) const {
  if (const auto found = find(column)) return *found;
  std::string known;
  for (const std::string& c : columns_) known += (known.empty() ? "" : ", ") + c.substr(0, 40);
  return inputError(file_ + ":1",
                    "has no column '" + std::string(column) + "'; its columns are " + known.substr(0, 300));
}

std::string CsvTable::where(std::size_t row) const { return file_ + ":" + std::to_string(lines_[row]); }

Expected<std::optional<double>> CsvTable::optionalNumber(std::size_t row, std::size_t column) const {
  const std::string& field = rows_[row][column];
  if (field.empty()) return std::optional<double>();
  const auto value = parsed(field, separator_);
  if (!value)
    return inputError(where(row), "column " + columns_[column] + " is not a number: '" + field.substr(0, 40) + "'");
  if (!std::isfinite(*value))
    return inputError(where(row), "column " + columns_[column] + " is " + field + "; leave out what was not measured");
  return value;
}

Expected<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const auto value = optionalNumber(row, column);
  if (!value) return tl::unexpected(value.error());
  if (!*value) return inputError(where(row), "column " + columns_[column] + " is empty; a number is needed");
  return **value;
}

Expected<std::vector<double>> CsvTable::numbers(std::string_view name) const {
  const auto c = column(name);
  if (!c) return tl::unexpected(c.error());
  std::vector<double> values;
  for (std::size_t row = 0; row < rows(); ++row) {
    const auto value = number(row, *c);
    if (!value) return tl::unexpected(value.error());
    values.push_back(*value);
  }
  if (values.empty()) return inputError(file_, "has a header but no rows");
  return values;
}

}  // namespace vignole
