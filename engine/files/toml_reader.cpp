#include "engine/files/toml_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <toml++/toml.h>

#include "engine/files/atomic_file.h"

namespace vignole {

namespace {

constexpr std::int64_t kFormat = 1;

std::string printed(double value) {
  std::ostringstream s;
  s.precision(9);
  s << value;
  return s.str();
}

std::string_view kindOf(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  if (node.is_string()) return "text";
  if (node.is_boolean()) return "true or false";
  if (node.is_integer()) return "a whole number";
  if (node.is_floating_point()) return "a number";
  return "a date or time";
}

const toml::node* child(const toml::node& node, std::string_view step) {
  if (const toml::table* table = node.as_table()) return table->get(step);
  const toml::array* array = node.as_array();
  std::size_t i = 0;
  const auto [end, failed] = std::from_chars(step.data(), step.data() + step.size(), i);
  if (array == nullptr || failed != std::errc() || end != step.data() + step.size()) return nullptr;
  return array->get(i);
}

std::string_view parentOf(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

/// Levenshtein distance, for "did you mean".
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

}  // namespace

struct TomlReader::Impl {
  toml::table root;
  std::string name;
  std::optional<Error> first;
  std::set<std::string, std::less<>> asked;          // keys whose value was taken
  mutable std::set<std::string, std::less<>> named;  // keys that the caller knows of, for suggestions

  [[nodiscard]] const toml::node* find(std::string_view key) const {
    const toml::node* node = &root;
    while (node != nullptr && !key.empty()) {
      const std::size_t dot = key.find('.');
      node = child(*node, key.substr(0, dot));
      key = dot == std::string_view::npos ? std::string_view() : key.substr(dot + 1);
    }
    return node;
  }

  const toml::node* ask(std::string_view key) {
    asked.emplace(key);
    named.emplace(key);
    return find(key);
  }

  /// A missing key is told at the table that should hold it.
  void refuse(std::string_view key, std::string what) {
    if (first) return;
    const toml::node* node = find(key);
    for (std::string_view up = key; node == nullptr && !up.empty();) node = find(up = parentOf(up));
    const toml::source_position at = node == nullptr ? toml::source_position{} : node->source().begin;
    std::string where = name;
    if (at.line > 0) where += ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
    first = Error{where + ": " + std::string(key), std::move(what), ErrorKind::Input};
  }

  /// The node of `key`, unless it is missing without a fallback (which is refused) or an error was met before.
  const toml::node* value(std::string_view key, bool mayBeMissing, std::string_view wanted) {
    const toml::node* node = ask(key);
    if (node == nullptr && !mayBeMissing) refuse(key, "is missing; give " + std::string(wanted));
    return first ? nullptr : node;
  }

  void wrongKind(std::string_view key, const toml::node& node, std::string_view wanted) {
    refuse(key, "is " + std::string(kindOf(node)) + "; give " + std::string(wanted));
  }

  [[nodiscard]] std::string suggestion(std::string_view key) const {
    std::string best;
    std::size_t least = 4;  // further away is another word, not a slip
    for (const std::string& candidate : named) {
      const std::size_t d = editDistance(key, candidate);
      if (d < least && d < candidate.size() / 2) {
        least = d;
        best = candidate;
      }
    }
    return best.empty() ? "remove it" : "did you mean " + best + "?";
  }

  /// Refuses the first key below `node` that nobody asked for.
  void refuseUnknown(const toml::node& node, const std::string& path) {
    if (first) return;
    const auto descend = [&](std::string_view step, const toml::node& below) {
      refuseUnknown(below, path.empty() ? std::string(step) : path + "." + std::string(step));
    };
    const bool known = path.empty() || asked.contains(path);
    const auto next = named.lower_bound(path + ".");
    const bool holdsKnown = next != named.end() && next->starts_with(path + ".");
    if (!known && !holdsKnown) return refuse(path, "is not known here; " + suggestion(path));

    const toml::array* array = node.as_array();
    if (const toml::table* table = node.as_table()) {
      for (const auto& [step, below] : *table) descend(step.str(), below);
    } else if (array != nullptr && array->is_array_of_tables()) {
      for (std::size_t i = 0; i < array->size(); ++i) descend(std::to_string(i), *array->get(i));
    } else if (!known) {
      refuse(path, "is not known here; " + suggestion(path));
    }
  }
};

TomlReader::TomlReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TomlReader::~TomlReader() = default;
TomlReader::TomlReader(TomlReader&&) noexcept = default;
TomlReader& TomlReader::operator=(TomlReader&&) noexcept = default;

Expected<TomlReader> TomlReader::load(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parse(*text, file.string());
}

Expected<TomlReader> TomlReader::parse(std::string_view text, const std::string& nameInErrors) {
  auto impl = std::make_unique<Impl>();
  impl->name = nameInErrors;
  try {
    impl->root = toml::parse(text, std::string_view(nameInErrors));
  } catch (const toml::parse_error& e) {
    const toml::source_position at = e.source().begin;
    return inputError(nameInErrors + ":" + std::to_string(at.line) + ":" + std::to_string(at.column),
                      "is not TOML: " + std::string(e.description()));
  }
  const toml::node* format = impl->ask("format");
  if (format == nullptr)
    impl->refuse("format", "is missing; the first line of the file must be: format = 1");
  else if (format->value_exact<std::int64_t>() != kFormat)
    impl->refuse("format", "is not 1, the only format this version reads; is the file from a newer version?");
  if (impl->first) return tl::unexpected(*impl->first);
  return TomlReader(std::move(impl));
}

bool TomlReader::has(std::string_view key) const {
  impl_->named.emplace(key);
  return impl_->find(key) != nullptr;
}

double TomlReader::number(std::string_view key, double min, double max, std::optional<double> fallback) {
  const std::string wanted = "a number from " + printed(min) + " to " + printed(max);
  const double instead = fallback.value_or(0);
  const toml::node* node = impl_->value(key, fallback.has_value(), wanted);
  if (node == nullptr) return instead;
  if (!node->is_number()) {
    impl_->wrongKind(key, *node, wanted);
    return instead;
  }
  const double v = *node->value<double>();
  if (std::isfinite(v) && v >= min && v <= max) return v;
  impl_->refuse(key, "is " + printed(v) + "; give " + wanted);
  return instead;
}

int TomlReader::integer(std::string_view key, int min, int max, std::optional<int> fallback) {
  const std::string wanted = "a whole number from " + std::to_string(min) + " to " + std::to_string(max);
  const int instead = fallback.value_or(0);
  const toml::node* node = impl_->value(key, fallback.has_value(), wanted);
  if (node == nullptr) return instead;
  const auto v = node->value_exact<std::int64_t>();
  if (!v) {
    impl_->wrongKind(key, *node, wanted);
    return instead;
  }
  if (*v >= min && *v <= max) return static_cast<int>(*v);
  impl_->refuse(key, "is " + std::to_string(*v) + "; give " + wanted);
  return instead;
}

bool TomlReader::boolean(std::string_view key, std::optional<bool> fallback) {
  const toml::node* node = impl_->value(key, fallback.has_value(), "true or false");
  if (node == nullptr) return fallback.value_or(false);
  const auto v = node->value_exact<bool>();
  if (!v) impl_->wrongKind(key, *node, "true or false");
  return v.value_or(fallback.value_or(false));
}

std::string TomlReader::text(std::string_view key, std::optional<std::string> fallback) {
  const bool mayBeMissing = fallback.has_value();
  std::string instead = mayBeMissing ? std::move(*fallback) : std::string();
  const toml::node* node = impl_->value(key, mayBeMissing, "text in quotes");
  if (node == nullptr) return instead;
  auto v = node->value_exact<std::string>();
  if (!v) impl_->wrongKind(key, *node, "text in quotes");
  return v ? std::move(*v) : instead;
}

std::vector<double> TomlReader::numbers(std::string_view key, std::size_t count) {
  const std::string wanted = "a list of " + std::to_string(count) + " numbers";
  std::vector<double> values(count, 0.0);
  const toml::node* node = impl_->value(key, false, wanted);
  if (node == nullptr) return values;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() != count) {
    impl_->refuse(
        key, "is " + (array == nullptr ? std::string(kindOf(*node)) : "a list of " + std::to_string(array->size())) +
                 "; give " + wanted);
    return values;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const toml::node& element = *array->get(i);
    const auto v = element.is_number() ? element.value<double>() : std::nullopt;
    if (!v || !std::isfinite(*v)) {
      impl_->refuse(key, "has an element " + std::to_string(i + 1) + " that is not a finite number; give " + wanted);
      return std::vector<double>(count, 0.0);
    }
    values[i] = *v;
  }
  return values;
}

std::vector<std::string> TomlReader::texts(std::string_view key) {
  const std::string wanted = "a list of texts in quotes";
  const toml::node* node = impl_->value(key, false, wanted);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    impl_->wrongKind(key, *node, wanted);
    return {};
  }
  std::vector<std::string> values;
  for (const toml::node& element : *array) {
    auto text = element.value_exact<std::string>();
    if (!text) {
      impl_->refuse(key, "has an element " + std::to_string(values.size() + 1) + " that is no text; give " + wanted);
      return {};
    }
    values.push_back(std::move(*text));
  }
  return values;
}

std::vector<std::string> TomlReader::keys(std::string_view table) {
  std::vector<std::string> found;
  const toml::node* node = impl_->ask(table);
  if (node == nullptr || impl_->first) return found;
  const toml::table* asTable = node->as_table();
  if (asTable == nullptr) {
    impl_->wrongKind(table, *node, "a table");
    return found;
  }
  for (const auto& [key, value] : *asTable) found.emplace_back(key.str());
  return found;
}

std::size_t TomlReader::size(std::string_view array) {
  const toml::node* node = impl_->ask(array);
  if (node == nullptr || impl_->first) return 0;
  const toml::array* asArray = node->as_array();
  if (asArray == nullptr || !(asArray->empty() || asArray->is_array_of_tables())) {
    impl_->wrongKind(array, *node, "a list of tables");
    return 0;
  }
  return asArray->size();
}

std::size_t TomlReader::listSize(std::string_view list) {
  const std::string wanted = "a list in brackets";
  const toml::node* node = impl_->value(list, false, wanted);
  if (node == nullptr) return 0;
  if (!node->is_array()) impl_->wrongKind(list, *node, wanted);
  return node->is_array() ? node->as_array()->size() : 0;
}

void TomlReader::refuse(std::string_view key, std::string what) { impl_->refuse(key, std::move(what)); }

Expected<void> TomlReader::finish() {
  if (!impl_->first) impl_->refuseUnknown(impl_->root, "");
  if (impl_->first) return tl::unexpected(*impl_->first);
  return {};
}

}  // namespace vignole
