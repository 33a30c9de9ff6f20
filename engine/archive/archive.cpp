#include "engine/archive/archive.h"

#include <sodium.h>

#include "engine/archive/database.h"
#include "engine/archive/schema.h"

namespace vignole {

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
      database_->run("vacuum into :a", {part.string()});
    } catch (...) {
      std::filesystem::remove(part, error);
      throw;
    }
    std::filesystem::permissions(part, std::filesystem::perms::others_all, std::filesystem::perm_options::remove,
                                 error);
    std::filesystem::rename(part, file, error);
    if (error) throw DatabaseFailure({file, error.message(), ErrorKind::World});
  });
}

}  // namespace vignole
