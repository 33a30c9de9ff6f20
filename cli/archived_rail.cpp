#include "cli/archived_rail.h"

#include <charconv>

namespace vignole::cli {

Expected<std::int64_t> findRail(const RailArchive& rails, const std::string& idOrKey) {
  RailQuery query;
  query.railId = idOrKey;
  query.limit = 1000;
  const auto found = rails.search(query);
  if (!found) return tl::unexpected(found.error());
  for (const RailLine& line : *found)
    if (line.id == idOrKey) return line.key;
  std::int64_t key = 0;
  const char *begin = idOrKey.data(), *end = begin + idOrKey.size();
  if (const auto [stop, error] = std::from_chars(begin, end, key); error == std::errc() && stop == end) return key;
  return inputError(idOrKey, "no rail of that name is in the archive; look with vignole-cli archive list");
}

}  // namespace vignole::cli
