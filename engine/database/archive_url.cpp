#include "engine/database/archive_url.h"

#include <cctype>
#include <libpq-fe.h>
#include <map>
#include <memory>

namespace vignole {

namespace {

/// What we ask of a connection where the URL says nothing: a server that is gone is noticed in seconds, not minutes.
const std::map<std::string, std::string> kConnectionDefaults = {
    {"application_name", "vignole"}, {"connect_timeout", "5"},  {"keepalives_idle", "5"},
    {"keepalives_interval", "2"},    {"keepalives_count", "3"}, {"tcp_user_timeout", "10000"},
    {"client_encoding", "UTF8"}};

/// For a URL's query. The database library cuts its text at blanks, whatever quotes say.
std::string escaped(const std::string& value) {
  static constexpr char kDigits[] = "0123456789ABCDEF";
  std::string text;
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte) != 0)
      text += c;
    else
      (((text += '%') += kDigits[byte >> 4U]) += kDigits[byte & 15U]);
  }
  return text;
}

Expected<ArchiveUrl> parseServer(std::string_view url) {
  char* problem = nullptr;
  const std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)> options(
      PQconninfoParse(std::string(url).c_str(), &problem), &PQconninfoFree);
  const std::unique_ptr<char, decltype(&PQfreemem)> problemHeld(problem, &PQfreemem);
  // The library's own message quotes the URL, password and all.
  if (!options || url.find('\0') != std::string_view::npos)
    return inputError("postgresql://...",
                      "this URL cannot be read; write postgresql://USER@HOST:PORT/DATABASE, with %XX for what is "
                      "special in a name");
  std::map<std::string, std::string> given = kConnectionDefaults;
  for (const PQconninfoOption* o = options.get(); o->keyword != nullptr; ++o)
    if (o->val != nullptr) given[o->keyword] = o->val;
  ArchiveUrl parsed;
  parsed.kind = ArchiveKind::Postgresql;
  parsed.password = given["password"];
  for (const auto& [name, value] : given)
    if (!value.empty())
      parsed.connection += (parsed.connection.empty() ? "postgresql:///?" : "&") + name + "=" + escaped(value);
  // A forgotten @ makes a password a port.
  if (given["port"].find_first_not_of("0123456789") != std::string::npos)
    return inputError("postgresql://...", "the port is no number; write postgresql://USER@HOST:PORT/DATABASE");
  const std::string host = given["host"].empty() ? given["hostaddr"] : given["host"];
  parsed.display = "postgresql://" + host + (given["port"].empty() ? "" : ":" + given["port"]) + "/" + given["dbname"];
  return parsed;
}

}  // namespace

Expected<ArchiveUrl> parseArchiveUrl(std::string_view url) {
  for (const std::string_view scheme : {"postgresql://", "postgres://"})
    if (url.starts_with(scheme)) return parseServer(url);
  ArchiveUrl parsed;
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

std::string shown(const ArchiveUrl& url) { return url.kind == ArchiveKind::Sqlite ? url.file.string() : url.display; }

}  // namespace vignole
