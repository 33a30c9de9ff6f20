#pragma once
// An archive: rails, alarms, users, audit trail, calibrations and recipes in one database. What it holds is reached
// through RailArchive, RailWriter, UserRegister, AuditTrail, AlarmHistory, CalibrationHistory, RecipeHistory.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "engine/geometry/expected.h"

namespace vignole {

class Database;

/// One connection; its classes may be used from several threads, one call at a time goes to the database. Who must not
/// wait for another's query opens an archive of its own: readers never wait for the writer.
class Archive {
 public:
  enum class Missing { Refuse, Create };
  /// `url`: FILE, sqlite:FILE or postgresql://... (archive_url.h). Brings the tables to the present version; refuses
  /// what is of a later version, damaged beyond reading, or of another program.
  [[nodiscard]] static Expected<Archive> open(std::string_view url, Missing missing = Missing::Refuse);
  ~Archive();
  Archive(Archive&&) noexcept;
  Archive& operator=(Archive&&) noexcept;

  [[nodiscard]] std::string url() const;  ///< for people: without a password
  [[nodiscard]] int schemaVersion() const;
  /// A whole copy into a new file, while others go on writing; of a server's archive too: the copy is in SQLite.
  [[nodiscard]] Expected<void> backUpTo(const std::string& file);

  /// For the classes of this room.
  [[nodiscard]] const std::shared_ptr<Database>& database() const { return database_; }

 private:
  explicit Archive(std::shared_ptr<Database> database);
  void copyInto(const std::filesystem::path& file);
  std::shared_ptr<Database> database_;
};

}  // namespace vignole
