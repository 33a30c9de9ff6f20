#include "engine/database/copied_rows.h"

#include <algorithm>

namespace vignole {

namespace {

/// A name goes into a statement as it is: a file that somebody made up shall not write ours.
std::string plainName(const std::string& name, const Database& database) {
  if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
    throw DatabaseFailure(
        {shown(database.url()), "holds a table or column that is none of an archive", ErrorKind::Input});
  return name;
}

}  // namespace

bool TableColumns::has(const std::string& column) const {
  return std::find(names.begin(), names.end(), column) != names.end();
}

TableColumns columnsOf(Database& sqlite, const std::string& table) {
  TableColumns columns;
  columns.table = plainName(table, sqlite);
  sqlite.query("select name, type from pragma_table_info(:a)", {table}, "tt", [&](const Row& row) {
    const std::string type = row.text(1);
    columns.names.push_back(plainName(row.text(0), sqlite));
    columns.kinds += type == "text" || type == "TEXT"   ? 't'
                     : type == "real" || type == "REAL" ? 'r'
                     : type == "blob" || type == "BLOB" ? 'b'
                                                        : 'i';
  });
  return columns;
}

std::vector<std::string> tablesOf(Database& sqlite) {
  std::vector<std::string> tables;
  sqlite.query("select name from sqlite_master where type = 'table' and name not like 'sqlite%' order by rowid", {},
               "t", [&](const Row& row) { tables.push_back(plainName(row.text(0), sqlite)); });
  return tables;
}

std::size_t copyRows(Database& from, Database& to, const TableColumns& columns, const std::string& column,
                     const SqlValue& value, const std::map<std::string, SqlValue>& instead,
                     const std::vector<std::string>& without) {
  std::string names, parameters, kinds;
  std::vector<const SqlValue*> replaced;
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    const std::string& name = columns.names[i];
    if (std::find(without.begin(), without.end(), name) != without.end()) continue;
    names += (names.empty() ? "" : ", ") + name;
    parameters += (parameters.empty() ? ":p" : ", :p") + std::to_string(i);
    kinds += columns.kinds[i];
    const auto other = instead.find(name);
    replaced.push_back(other != instead.end() ? &other->second : nullptr);
  }
  const std::string insert = "insert into " + columns.table + " (" + names + ") values (" + parameters + ")";
  std::size_t copied = 0;
  from.query("select " + names + " from " + columns.table + (column.empty() ? "" : " where " + column + " = :a"),
             column.empty() ? SqlValues{} : SqlValues{value}, kinds, [&](const Row& row) {
               SqlValues values;
               for (std::size_t i = 0; i < row.size(); ++i)
                 values.push_back(replaced[i] != nullptr ? *replaced[i] : row.value(i));
               to.run(insert, values);
               ++copied;
             });
  return copied;
}

}  // namespace vignole
