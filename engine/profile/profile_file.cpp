#include "engine/profile/profile_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "engine/files/atomic_file.h"

namespace vignole {
namespace {

constexpr double kFarthestMm = 20000;

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view kBlank = " \t\r\"";
  const auto first = s.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return s.substr(first, s.find_last_not_of(kBlank) - first + 1);
}

std::string lowered(std::string_view s) {
  std::string result(s);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

/// Fields of a line: at semicolons, else commas or tabs, else blanks.
std::vector<std::string> fields(std::string_view line) {
  const char separator = line.find(';') != line.npos    ? ';'
                         : line.find(',') != line.npos  ? ','
                         : line.find('\t') != line.npos ? '\t'
                                                        : ' ';
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    const std::string_view field = trimmed(line.substr(begin, end - begin));
    if (separator != ' ' || !field.empty()) result.emplace_back(field);
    begin = end + 1;
  }
  if (separator == ';')  // spreadsheets that use semicolons write decimal commas
    for (std::string& f : result) std::replace(f.begin(), f.end(), ',', '.');
  return result;
}

/// A number, "nan" and "inf" included: they are refused with a better reason than text.
std::optional<double> number(std::string_view field) {
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

/// Line by line, with the number of the line for errors.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
  }
  [[nodiscard]] std::string where() const { return file_ + ":" + std::to_string(number_); }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string_view rest_;
  std::string file_;
  int number_ = 0;
};

/// Turns the fields of one line into a point.
class PointReader {
 public:
  PointReader(std::size_t xColumn, std::size_t yColumn, double mmPerUnit, double sigmaMm)
      : columns_{xColumn, yColumn}, mmPerUnit_(mmPerUnit), sigmaMm_(sigmaMm) {}

  Expected<void> read(const std::vector<std::string>& row, const Lines& lines) {
    std::array<double, 2> value{};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t c = columns_[k];
      const std::string column = "column " + std::to_string(c + 1);
      if (c >= row.size())
        return inputError(lines.where(), column + " is missing: the line has " + std::to_string(row.size()) +
                                             (row.size() == 1 ? " column" : " columns") +
                                             "; two numbers are needed, is the file truncated?");
      const auto v = number(row[c]);
      if (!v) return inputError(lines.where(), column + " is not a number: '" + row[c].substr(0, 40) + "'");
      if (!std::isfinite(*v)) return inputError(lines.where(), column + " is " + row[c] + ": remove the point");
      value[k] = *v * mmPerUnit_;
      if (std::abs(value[k]) > kFarthestMm)
        return inputError(lines.where(), column + " lies " + std::to_string(std::lround(std::abs(value[k]) / 1000)) +
                                             " m from the origin; is --units right?");
    }
    ProfilePoint p;
    p.x = value[0];
    p.y = value[1];
    p.sigmaMm = static_cast<float>(sigmaMm_);
    points.push_back(p);
    return {};
  }
  std::vector<ProfilePoint> points;

 private:
  std::array<std::size_t, 2> columns_;
  double mmPerUnit_, sigmaMm_;
};

using Points = Expected<std::vector<ProfilePoint>>;

Points parseCsv(Lines lines, const ProfileFileOptions& options) {
  PointReader reader(0, 1, options.mmPerUnit, options.sigmaMm);
  std::string_view line;
  std::optional<std::size_t> columns;
  bool headerMayCome = true;
  while (lines.next(line)) {
    if (line.empty() || line.front() == '#') continue;
    const auto row = fields(line);
    const bool isHeader =
        headerMayCome && std::none_of(row.begin(), row.end(), [](const auto& f) { return number(f); });
    headerMayCome = false;
    if (isHeader) {
      if (row.size() < 2) return inputError(lines.where(), "one column; two numeric columns are needed");
      columns = row.size();
      continue;
    }
    if (columns && row.size() < std::min<std::size_t>(*columns, 2))
      return inputError(lines.where(), "has " + std::to_string(row.size()) + " of " + std::to_string(*columns) +
                                           " columns; is the file truncated?");
    if (auto ok = reader.read(row, lines); !ok) return tl::unexpected(ok.error());
  }
  if (reader.points.empty()) return inputError(lines.file(), "holds no points; two numeric columns are needed");
  return std::move(reader.points);
}

struct BanHeader {
  std::size_t x = 0, y = 1;
  std::optional<long> points;
};

Expected<void> readBanKey(std::string_view line, const Lines& lines, BanHeader& header) {
  const std::size_t equals = line.find('=');
  const std::string key = lowered(trimmed(line.substr(0, equals)));
  const std::string_view value = trimmed(line.substr(equals + 1));
  if (key == "xypoints") {
    const auto n = number(value);
    if (!n || *n < 0) return inputError(lines.where(), "XYPoints is not a number: '" + std::string(value) + "'");
    header.points = std::lround(*n);
  }
  if (key == "columndef" && !value.empty()) {
    std::optional<std::size_t> x, y;
    const auto names = fields(value);
    for (std::size_t c = 0; c < names.size(); ++c) {
      if (lowered(names[c]) == "x") x = c;
      if (lowered(names[c]) == "y") y = c;
    }
    if (!x || !y)
      return inputError(lines.where(),
                        "ColumnDef has no column " + std::string(x ? "Y" : "X") + ": '" + std::string(value) + "'");
    header.x = *x;
    header.y = *y;
  }
  return {};
}

Points parseBan(Lines lines, const ProfileFileOptions& options) {
  BanHeader header;
  std::optional<PointReader> reader;
  std::string_view line;
  while (lines.next(line)) {
    if (line.empty()) continue;
    if (!reader && line.find('=') != line.npos) {
      if (auto ok = readBanKey(line, lines, header); !ok) return tl::unexpected(ok.error());
      continue;
    }
    if (!reader) reader.emplace(header.x, header.y, options.mmPerUnit, options.sigmaMm);
    if (auto ok = reader->read(fields(line), lines); !ok) return tl::unexpected(ok.error());
  }
  const long found = reader ? static_cast<long>(reader->points.size()) : 0;
  if (found == 0) return inputError(lines.file(), "holds no points after its header");
  if (header.points && found < *header.points)
    return inputError(lines.where(), "ends after " + std::to_string(found) + " points, the header says XYPoints=" +
                                         std::to_string(*header.points) + "; is the file truncated?");
  return std::move(reader->points);
}

Points parsePrr(Lines lines, const ProfileFileOptions& options) {
  double unitsPerMetre = 1000;
  std::optional<PointReader> reader;
  std::string_view line;
  while (lines.next(line)) {
    line = trimmed(line.substr(0, line.find('!')));
    if (line.empty()) continue;
    const std::string key = lowered(trimmed(line.substr(0, line.find('='))));
    if (!reader && key == "units.len.f") {
      const auto value = number(trimmed(line.substr(line.find('=') + 1)));
      if (!value || !(*value > 0)) return inputError(lines.where(), "units.len.f is not a positive number");
      unitsPerMetre = *value;
    } else if (!reader && key == "point.begin") {
      reader.emplace(0, 1, 1000 / unitsPerMetre, options.sigmaMm);
    } else if (reader && key == "point.end") {
      if (reader->points.empty()) return inputError(lines.where(), "no points between point.begin and point.end");
      return std::move(reader->points);
    } else if (reader) {
      if (auto ok = reader->read(fields(line), lines); !ok) return tl::unexpected(ok.error());
    }
  }
  return inputError(lines.where(), reader ? "ends before point.end; is the file truncated?" : "has no point.begin");
}

}  // namespace

Expected<std::vector<ProfilePoint>> parseProfile(std::string_view text, const std::string& nameInErrors,
                                                 const ProfileFileOptions& options) {
  const std::string extension = lowered(std::filesystem::path(nameInErrors).extension().string());
  const Lines lines(text, nameInErrors);
  if (text.find('\0') != text.npos) return inputError(nameInErrors, "is not text; CSV, .ban and .prr are read");
  const bool looksSimpack = text.find("point.begin") != text.npos;
  const bool looksBan = text.find("ColumnDef=") != text.npos;
  const bool named = extension == ".ban" || extension == ".prr";
  if (options.format == ProfileFormat::Csv ||
      (options.format == ProfileFormat::Auto && !named && !looksSimpack && !looksBan))
    return parseCsv(lines, options);
  return extension == ".prr" || (extension != ".ban" && looksSimpack) ? parsePrr(lines, options)
                                                                      : parseBan(lines, options);
}

Expected<std::vector<ProfilePoint>> readProfile(const std::filesystem::path& file, const ProfileFileOptions& options) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parseProfile(*text, file.string(), options);
}

}  // namespace vignole
