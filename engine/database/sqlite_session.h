#pragma once
// Opening a SQLite file for Database, and its failures in words. For this room alone.

#include <memory>

#include "engine/database/database.h"

namespace soci {
class session;
class soci_error;
}  // namespace soci

namespace vignole {

/// Throws DatabaseFailure and soci_error.
[[nodiscard]] std::unique_ptr<soci::session> openSqlite(const ArchiveUrl& url, Database::Missing missing);
[[nodiscard]] Error sqliteErrorOf(const soci::soci_error& failure, const std::string& where);

}  // namespace vignole
