#pragma once
// Rows of one database into another, whatever kinds the two are. One of them must be SQLite: it tells which columns a
// table has. Names of tables and columns are those of our own schema, never anybody's input. All throw DatabaseFailure.

#include <map>
#include <string>
#include <vector>

#include "engine/database/database.h"

namespace vignole {

struct TableColumns {
  std::string table;
  std::vector<std::string> names;
  std::string kinds;  ///< as Database::query takes them
  [[nodiscard]] bool has(const std::string& column) const;
};

/// The columns of a table of a SQLite database.
[[nodiscard]] TableColumns columnsOf(Database& sqlite, const std::string& table);
/// The tables of a SQLite database, in the order in which they were made.
[[nodiscard]] std::vector<std::string> tablesOf(Database& sqlite);

/// Rows whose `column` is `value` (all where `column` is empty), with other values in the columns of `instead`; columns
/// in `without` are left to the database. Returns how many.
std::size_t copyRows(Database& from, Database& to, const TableColumns& columns, const std::string& column,
                     const SqlValue& value, const std::map<std::string, SqlValue>& instead = {},
                     const std::vector<std::string>& without = {});

}  // namespace vignole
