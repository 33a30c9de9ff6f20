#pragma once
// Where an archive is.

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/geometry/expected.h"

namespace vignole {

/// The database that keeps it.
enum class ArchiveKind { Sqlite, Postgresql };

struct ArchiveUrl {
  ArchiveKind kind = ArchiveKind::Sqlite;
  std::filesystem::path file;  ///< Sqlite
  std::string connection;      ///< Postgresql: for the library, may hold a password: never to be shown
  std::string password;        ///< Postgresql: to be kept out of messages; empty: none was given here
  std::string display;         ///< Postgresql: server and database
};

/// FILE, sqlite:FILE, sqlite:///FILE, postgresql://[USER@]HOST[:PORT]/DATABASE[?passfile=FILE&sslmode=require...]. A
/// password is better in a file that only its owner reads (~/.pgpass, PGPASSFILE or passfile=) than in the URL.
[[nodiscard]] Expected<ArchiveUrl> parseArchiveUrl(std::string_view url);
/// For people: without user and password.
[[nodiscard]] std::string shown(const ArchiveUrl& url);

}  // namespace vignole
