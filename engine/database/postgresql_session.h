#pragma once
// Connecting to a PostgreSQL server for Database, and its failures in words. For this room alone.

#include <memory>

#include "engine/database/database.h"

namespace soci {
class session;
class soci_error;
}  // namespace soci

namespace vignole {

/// Throws DatabaseFailure: Input where the server refuses us, World where it cannot be reached.
[[nodiscard]] std::unique_ptr<soci::session> connectPostgresql(const ArchiveUrl& url);
[[nodiscard]] Error postgresqlErrorOf(const soci::soci_error& failure, const ArchiveUrl& url);
[[nodiscard]] bool connectionLost(soci::session& session);

/// Bytes as a bytea column takes and gives them in text.
[[nodiscard]] std::string byteaText(const Bytes& bytes);
[[nodiscard]] Bytes bytesOfBytea(const std::string& text);

}  // namespace vignole
