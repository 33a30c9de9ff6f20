#pragma once
// Where an archive is.

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/geometry/expected.h"

namespace vignole {

/// The database that keeps it. Only SQLite is part of this version.
enum class ArchiveKind { Sqlite, Postgresql };

struct ArchiveUrl {
  ArchiveKind kind = ArchiveKind::Sqlite;
  std::filesystem::path file;  ///< Sqlite
  std::string connection;      ///< Postgresql: the URL, which may hold a password: never to be shown
};

/// FILE, sqlite:FILE, sqlite:///FILE, postgresql://USER@HOST/DATABASE.
[[nodiscard]] Expected<ArchiveUrl> parseArchiveUrl(std::string_view url);
/// For people: without user and password.
[[nodiscard]] std::string shown(const ArchiveUrl& url);

}  // namespace vignole
