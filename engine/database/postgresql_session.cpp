#include "engine/database/postgresql_session.h"

#include <algorithm>
#include <array>
#include <soci/postgresql/soci-postgresql.h>
#include <soci/soci.h>

namespace vignole {

namespace {

/// The library does not export the type that a dynamic_cast needs; every session here is one of ours.
PGconn* connectionOf(soci::session& session) {
  auto* backend = static_cast<soci::postgresql_session_backend*>(session.get_backend());
  return backend != nullptr ? backend->conn_ : nullptr;
}

/// The library's message in one line, without a password.
std::string inOneLine(std::string text, const std::string& password) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (char& c : text)
    if (c == '\n' || c == '\t') c = ' ';
  if (!password.empty())
    for (std::size_t at = text.find(password); at != std::string::npos; at = text.find(password, at + 3))
      text.replace(at, password.size(), "***");
  return text;
}

/// A server that answers and says no, as against one that is away or just coming up.
bool isRefusal(const std::string& message) {
  if (message.find("no password supplied") != std::string::npos) return true;
  if (message.find("FATAL") == std::string::npos) return false;
  constexpr std::array<const char*, 6> kPassing = {"starting up",    "shutting down", "recovery",
                                                   "not yet accept", "too many",      "remaining connection slots"};
  return std::none_of(kPassing.begin(), kPassing.end(),
                      [&](const char* words) { return message.find(words) != std::string::npos; });
}

}  // namespace

std::unique_ptr<soci::session> connectPostgresql(const ArchiveUrl& url) {
  std::unique_ptr<soci::session> session;
  try {
    session = std::make_unique<soci::session>(soci::postgresql, url.connection);
  } catch (const soci::soci_error& failure) {
    const std::string why = inOneLine(failure.get_error_message(), url.password);
    if (isRefusal(why))
      throw DatabaseFailure(
          {shown(url), "the server refuses (" + why + "); look at user, password and database", ErrorKind::Input});
    throw DatabaseFailure({shown(url), "the server cannot be reached (" + why + "); is it running?", ErrorKind::World});
  }
  PQsetNoticeProcessor(
      connectionOf(*session), [](void*, const char*) {}, nullptr);
  // A lock is waited for as long as SQLite's; who vanishes within a transaction does not hold the others up for ever.
  for (const char* setting :
       {"set lock_timeout = '10s'", "set idle_in_transaction_session_timeout = '60s'", "set synchronous_commit = on",
        "set bytea_output = hex", "set jit = off", "set tcp_keepalives_idle = 10", "set tcp_keepalives_interval = 5",
        "set tcp_keepalives_count = 3"})
    *session << setting;
  return session;
}

Error postgresqlErrorOf(const soci::soci_error& failure, const ArchiveUrl& url) {
  const std::string why = inOneLine(failure.get_error_message(), url.password);
  const auto* known = dynamic_cast<const soci::postgresql_soci_error*>(&failure);
  const std::string state = known != nullptr ? known->sqlstate() : "";
  if (state == "55P03" || state == "40P01")
    return {shown(url), "is held by another program; try again when it has finished", ErrorKind::World};
  if (state == "53100")
    return {shown(url), "the server's disk is full; make room, the archive itself is whole", ErrorKind::World};
  if (state == "42501") return {shown(url), "this user may not do that (" + why + "); grant it", ErrorKind::World};
  if (state.starts_with("08") || state.starts_with("57P"))
    return {shown(url), "the server has gone (" + why + ")", ErrorKind::World};
  return {shown(url), why, ErrorKind::World};
}

bool connectionLost(soci::session& session) {
  PGconn* connection = connectionOf(session);
  return connection != nullptr && PQstatus(connection) == CONNECTION_BAD;
}

std::string byteaText(const Bytes& bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text(2 + 2 * bytes.size(), '\\');
  text[1] = 'x';
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    text[2 + 2 * i] = kDigits[bytes[i] >> 4U];
    text[3 + 2 * i] = kDigits[bytes[i] & 15U];
  }
  return text;
}

Bytes bytesOfBytea(const std::string& text) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
  Bytes bytes;
  if (!text.starts_with("\\x")) return bytes;
  bytes.reserve(text.size() / 2);
  for (std::size_t i = 2; i + 1 < text.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(16 * digit(text[i]) + digit(text[i + 1])));
  return bytes;
}

}  // namespace vignole
