#include "engine/database/sqlite_session.h"

#include <fcntl.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sqlite3.h>
#include <unistd.h>

namespace vignole {

namespace {

/// A new archive holds password hashes: not for the world to read. SQLite gives its side files the same rights.
void createPrivately(const std::filesystem::path& file) {
  const int made = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0640);
  if (made >= 0) ::close(made);
}

std::string nameOf(const ArchiveUrl& url, Database::Missing missing) {
  const std::string where = shown(url);
  std::error_code error;
  if (std::filesystem::is_directory(url.file, error))
    throw DatabaseFailure({where, "is a folder; name a file in it", ErrorKind::Input});
  if (!std::filesystem::exists(url.file, error)) {
    if (missing == Database::Missing::Refuse)
      throw DatabaseFailure({where, "there is no archive; is the name right?", ErrorKind::Input});
    createPrivately(url.file);
  }
  // SOCI takes a text without "db=" as the name itself; made absolute, none begins with that.
  return std::filesystem::absolute(url.file).string();
}

}  // namespace

std::unique_ptr<soci::session> openSqlite(const ArchiveUrl& url, Database::Missing missing) {
  auto session = std::make_unique<soci::session>(soci::sqlite3, nameOf(url, missing));
  // In WAL readers never wait for the writer nor it for them. FULL: what is committed outlives a power cut.
  for (const char* pragma : {"pragma busy_timeout = 10000", "pragma journal_mode = wal", "pragma synchronous = full",
                             "pragma foreign_keys = on", "pragma cache_size = -16000"})
    *session << pragma;
  return session;
}

/// One line in words that tell what to do.
Error sqliteErrorOf(const soci::soci_error& failure, const std::string& where) {
  std::string what = failure.get_error_message();
  for (char& c : what)
    if (c == '\n') c = ' ';
  if (const auto* sqlite = dynamic_cast<const soci::sqlite3_soci_error*>(&failure)) {
    switch (sqlite->result() & 0xff) {
      case SQLITE_FULL:
        return {where, "the disk is full; make room, the archive itself is whole", ErrorKind::World};
      case SQLITE_NOTADB:
        return {where, "is no archive of this program; name another file", ErrorKind::Input};
      case SQLITE_CORRUPT:
        return {where, "is damaged (" + what + "); look with archive verify, and go back to the last backup",
                ErrorKind::World};
      case SQLITE_BUSY:
      case SQLITE_LOCKED:
        return {where, "is held by another program; try again when it has finished", ErrorKind::World};
      case SQLITE_READONLY:
        return {where, "may not be written; look at the rights of the file and its folder", ErrorKind::World};
      case SQLITE_CANTOPEN:
        return {where, "cannot be opened; look at the rights of the file and its folder", ErrorKind::World};
      case SQLITE_IOERR:
        return {where, "the disk failed (" + what + ")", ErrorKind::World};
      default:
        break;
    }
  }
  return {where, what, ErrorKind::World};
}

}  // namespace vignole
