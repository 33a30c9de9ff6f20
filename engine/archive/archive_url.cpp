#include "engine/archive/archive_url.h"

namespace vignole {

Expected<ArchiveUrl> parseArchiveUrl(std::string_view url) {
  ArchiveUrl parsed;
  for (const std::string_view scheme : {"postgresql://", "postgres://"}) {
    if (!url.starts_with(scheme)) continue;
    parsed.kind = ArchiveKind::Postgresql;
    parsed.connection = url;
    return parsed;
  }
  std::string_view file = url;
  if (file.starts_with("sqlite:")) {
    file.remove_prefix(7);
    if (file.starts_with("//")) file.remove_prefix(2);
  } else if (const std::size_t colon = file.find("://"); colon != std::string_view::npos) {
    return inputError(std::string(file.substr(0, colon)),
                      "no kind of archive; use a file name, sqlite:FILE or postgresql://USER@HOST/DATABASE");
  }
  if (file.empty()) return inputError("archive", "no file is named; use FILE or sqlite:FILE");
  if (file.find('\0') != std::string_view::npos) return inputError("archive", "the name holds a zero byte");
  parsed.file = file;
  return parsed;
}

std::string shown(const ArchiveUrl& url) {
  if (url.kind == ArchiveKind::Sqlite) return url.file.string();
  const std::size_t host = url.connection.find("://") + 3, at = url.connection.rfind('@');
  const std::size_t from = at == std::string::npos ? host : at + 1;
  return "postgresql://" + url.connection.substr(from, url.connection.find('?', from) - from);
}

}  // namespace vignole
