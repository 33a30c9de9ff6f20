#include "engine/archive/archive.h"

#include <fcntl.h>
#include <sodium.h>
#include <unistd.h>

#include "engine/archive/schema.h"
#include "engine/database/copied_rows.h"
#include "engine/database/database.h"

namespace vignole {

namespace {

void syncToDisk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && ::fsync(descriptor) == 0;
  if (descriptor >= 0) ::close(descriptor);
  if (!done) throw DatabaseFailure({path.string(), "could not be brought on disk", ErrorKind::World});
}

}  // namespace

Archive::Archive(std::shared_ptr<Database> database) : database_(std::move(database)) {}
Archive::~Archive() = default;
Archive::Archive(Archive&&) noexcept = default;
Archive& Archive::operator=(Archive&&) noexcept = default;

Expected<Archive> Archive::open(std::string_view url, Missing missing) {
  if (sodium_init() < 0) return worldError("archive", "the system gives no random numbers");
  const auto parsed = parseArchiveUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  return guarded([&] {
    auto database = std::make_shared<Database>(
        *parsed, missing == Missing::Create ? Database::Missing::Create : Database::Missing::Refuse);
    if (missing == Missing::Refuse && database->empty())
      throw DatabaseFailure({shown(*parsed), "holds no archive; is the name right?", ErrorKind::Input});
    migrate(*database, migrations());
    return Archive(std::move(database));
  });
}

std::string Archive::url() const { return shown(database_->url()); }

int Archive::schemaVersion() const {
  return guarded([&] { return vignole::schemaVersion(*database_); }).value_or(0);
}

Expected<void> Archive::backUpTo(const std::string& file) {
  return guarded([&] {
    std::error_code error;
    if (std::filesystem::exists(file, error))
      throw DatabaseFailure({file, "is there already; a backup is a new file", ErrorKind::Input});
    const std::filesystem::path part = file + ".part";
    std::filesystem::remove(part, error);
    try {
      if (database_->url().kind == ArchiveKind::Sqlite)
        database_->run("vacuum into :a", {part.string()});
      else
        copyInto(part);
      std::filesystem::permissions(part, std::filesystem::perms::others_all, std::filesystem::perm_options::remove,
                                   error);
      syncToDisk(part);
      std::filesystem::rename(part, file, error);
      if (error) throw DatabaseFailure({file, error.message(), ErrorKind::World});
      syncToDisk(std::filesystem::absolute(file).parent_path());
    } catch (...) {
      for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(part.string() + suffix, error);
      throw;
    }
  });
}

void Archive::copyInto(const std::filesystem::path& file) {
  ArchiveUrl url;
  url.file = file;
  Database copy(url, Database::Missing::Create);
  migrate(copy, migrations());
  const Snapshot snapshot(*database_);  // as it was at one moment, whoever writes meanwhile
  Transaction transaction(copy);
  std::vector<std::int64_t> rails;
  database_->query("select id from rail order by id", {}, "i",
                   [&](const Row& row) { rails.push_back(row.integer(0)); });
  for (const std::string& table : tablesOf(copy)) {
    const TableColumns columns = columnsOf(copy, table);
    copy.run("delete from " + table);  // what a new archive begins with
    if (!columns.has("rail") || table == "alarm")
      copyRows(*database_, copy, columns, "", {});
    else
      for (const std::int64_t rail : rails) copyRows(*database_, copy, columns, "rail", rail);
  }
  transaction.commit();
  copy.run("pragma journal_mode = delete");  // one file
}

}  // namespace vignole
