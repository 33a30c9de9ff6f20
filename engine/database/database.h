#pragma once
// The room's own way to its database: statements with bound parameters, rows, transactions. Hides SOCI (and with it
// SQLite or PostgreSQL). Inside the room failures travel as DatabaseFailure; guarded() turns them into Error at its
// door.

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/database/archive_url.h"
#include "engine/packing/columns.h"

namespace vignole {

class DatabaseFailure : public std::exception {
 public:
  explicit DatabaseFailure(Error error) : error_(std::move(error)) {}
  [[nodiscard]] const Error& error() const { return error_; }
  [[nodiscard]] const char* what() const noexcept override { return error_.what.c_str(); }

 private:
  Error error_;
};

/// NULL, number, text or bytes.
using SqlValue = std::variant<std::monostate, std::int64_t, double, std::string, Bytes>;
using SqlValues = std::vector<SqlValue>;

[[nodiscard]] inline SqlValue orNull(const std::optional<double>& value) {
  return value ? SqlValue(*value) : SqlValue();
}
[[nodiscard]] inline SqlValue orNull(const std::optional<std::int64_t>& value) {
  return value ? SqlValue(*value) : SqlValue();
}

/// For "limit".
[[nodiscard]] inline SqlValue atMost(std::size_t rows) {
  return static_cast<std::int64_t>(std::min<std::uint64_t>(rows, INT64_MAX));
}

/// One row of an answer. A NULL reads as 0, "" or no bytes.
class Row {
 public:
  explicit Row(std::size_t columns) : cells_(columns) {}
  [[nodiscard]] bool null(std::size_t i) const { return std::holds_alternative<std::monostate>(cells_[i]); }
  [[nodiscard]] std::int64_t integer(std::size_t i) const;
  [[nodiscard]] double real(std::size_t i) const;
  [[nodiscard]] std::optional<double> realOrNone(std::size_t i) const;
  [[nodiscard]] std::optional<std::int64_t> integerOrNone(std::size_t i) const;
  [[nodiscard]] const std::string& text(std::size_t i) const;
  [[nodiscard]] const Bytes& bytes(std::size_t i) const;
  [[nodiscard]] const SqlValue& value(std::size_t i) const { return cells_[i]; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  void set(std::size_t i, SqlValue value) { cells_[i] = std::move(value); }

 private:
  std::vector<SqlValue> cells_;
};

/// A text that every database stores: what is no UTF-8, and zero, replaced by U+FFFD.
[[nodiscard]] std::string storableText(std::string text);

/// One connection. Every call takes its mutex; who makes several calls that belong together holds lock(). A connection
/// to a server that was lost is made anew by the next call outside of a transaction.
class Database {
 public:
  enum class Missing { Refuse, Create };
  /// Throws DatabaseFailure.
  Database(const ArchiveUrl& url, Missing missing);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  [[nodiscard]] const ArchiveUrl& url() const;
  [[nodiscard]] std::unique_lock<std::recursive_mutex> lock();

  /// Parameters stand as :a, :b ... in the order of `parameters`; SQL never holds a value itself.
  void run(std::string_view sql, const SqlValues& parameters = {});
  /// Into a table whose key the database gives: the key.
  std::int64_t insert(std::string_view sql, const SqlValues& parameters);
  /// Number of rows that the last run() changed.
  [[nodiscard]] std::int64_t changedRows() const;
  /// `columns`: one letter a column of the answer, i(nteger) r(eal) t(ext) b(ytes).
  void query(std::string_view sql, const SqlValues& parameters, std::string_view columns,
             const std::function<void(const Row&)>& row);
  /// The first row, if there is one.
  [[nodiscard]] std::optional<Row> first(std::string_view sql, const SqlValues& parameters, std::string_view columns);

  [[nodiscard]] bool hasTable(const std::string& name);
  [[nodiscard]] bool empty();  ///< no table of anybody's

  void beginReading();  ///< everything as it is at this moment; ended by rollback()
  void begin();         ///< takes the right to write at once, so that no transaction fails half way for want of it
  void commit();
  void rollback() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Rolled back unless committed. One at a time on a connection; within one, a further one joins it.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  std::unique_lock<std::recursive_mutex> lock_;
  bool open_ = true;
};

/// Reading everything as it was at one moment. Nothing may be written meanwhile.
class Snapshot {
 public:
  explicit Snapshot(Database& database) : database_(database), lock_(database.lock()) { database_.beginReading(); }
  ~Snapshot() { database_.rollback(); }
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  Database& database_;
  std::unique_lock<std::recursive_mutex> lock_;
};

/// What `work` returns, or the failure that it met.
template <typename Work>
[[nodiscard]] auto guarded(Work&& work) -> Expected<decltype(work())> {
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      std::forward<Work>(work)();
      return {};
    } else {
      return std::forward<Work>(work)();
    }
  } catch (const DatabaseFailure& failure) {
    return tl::unexpected(failure.error());
  } catch (const std::exception& failure) {
    return worldError("archive", failure.what());
  }
}

/// Inside guarded(): the value, or its error thrown on.
template <typename T>
T orThrow(Expected<T> value) {
  if (!value) throw DatabaseFailure(value.error());
  if constexpr (!std::is_void_v<T>) return std::move(*value);
}

}  // namespace vignole
