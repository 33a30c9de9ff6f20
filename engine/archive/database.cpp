#include "engine/archive/database.h"

#include <array>
#include <deque>
#include <fcntl.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sqlite3.h>
#include <unistd.h>

namespace vignole {

namespace {

template <typename T>
const T& orEmpty(const SqlValue& value) {
  static const T empty{};
  const T* held = std::get_if<T>(&value);
  return held != nullptr ? *held : empty;
}

/// One line in words that tell what to do.
Error errorOf(const soci::soci_error& failure, const std::string& where) {
  std::string what = failure.get_error_message();
  for (char& c : what)
    if (c == '\n') c = ' ';
  if (const auto* sqlite = dynamic_cast<const soci::sqlite3_soci_error*>(&failure)) {
    switch (sqlite->result() & 0xff) {
      case SQLITE_FULL:
        return {where, "the disk is full; make room, the archive itself is whole", ErrorKind::World};
      case SQLITE_NOTADB:
        return {where, "is no archive of this program; name another file", ErrorKind::Input};
      case SQLITE_CORRUPT:
        return {where, "is damaged (" + what + "); look with archive verify, and go back to the last backup",
                ErrorKind::World};
      case SQLITE_BUSY:
      case SQLITE_LOCKED:
        return {where, "is held by another program; try again when it has finished", ErrorKind::World};
      case SQLITE_READONLY:
        return {where, "may not be written; look at the rights of the file and its folder", ErrorKind::World};
      case SQLITE_CANTOPEN:
        return {where, "cannot be opened; look at the rights of the file and its folder", ErrorKind::World};
      case SQLITE_IOERR:
        return {where, "the disk failed (" + what + ")", ErrorKind::World};
      default:
        break;
    }
  }
  return {where, what, ErrorKind::World};
}

/// A new archive holds password hashes: not for the world to read. SQLite gives its side files the same rights.
void createPrivately(const std::filesystem::path& file) {
  const int made = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0640);
  if (made >= 0) ::close(made);
}

std::string connectionString(const ArchiveUrl& url, Database::Missing missing) {
  const std::string where = shown(url);
  if (url.kind == ArchiveKind::Postgresql)
    throw DatabaseFailure({where, "this version keeps archives in SQLite alone; name a file", ErrorKind::Input});
  std::error_code error;
  if (std::filesystem::is_directory(url.file, error))
    throw DatabaseFailure({where, "is a folder; name a file in it", ErrorKind::Input});
  if (!std::filesystem::exists(url.file, error)) {
    if (missing == Database::Missing::Refuse)
      throw DatabaseFailure({where, "there is no archive; is the name right?", ErrorKind::Input});
    createPrivately(url.file);
  }
  // SOCI takes a text without "db=" as the name itself; made absolute, none begins with that.
  return std::filesystem::absolute(url.file).string();
}

/// Where a column of the answer is fetched to.
struct Cell {
  char kind;
  long long integer = 0;
  double real = 0;
  std::string text;
  std::unique_ptr<soci::blob> bytes;
  soci::indicator indicator = soci::i_ok;
};

Bytes contentsOf(soci::blob& blob) {
  Bytes bytes(blob.get_len());
  if (!bytes.empty()) blob.read(0, reinterpret_cast<char*>(bytes.data()), bytes.size());
  return bytes;
}

SqlValue valueOf(Cell& cell) {
  if (cell.indicator == soci::i_null) return {};
  switch (cell.kind) {
    case 'i':
      return static_cast<std::int64_t>(cell.integer);
    case 'r':
      return cell.real;
    case 'b':
      return contentsOf(*cell.bytes);
    default:
      return cell.text;
  }
}

}  // namespace

std::int64_t Row::integer(std::size_t i) const { return orEmpty<std::int64_t>(cells_[i]); }
double Row::real(std::size_t i) const { return orEmpty<double>(cells_[i]); }
const std::string& Row::text(std::size_t i) const { return orEmpty<std::string>(cells_[i]); }
const Bytes& Row::bytes(std::size_t i) const { return orEmpty<Bytes>(cells_[i]); }
std::optional<double> Row::realOrNone(std::size_t i) const { return null(i) ? std::nullopt : std::optional(real(i)); }
std::optional<std::int64_t> Row::integerOrNone(std::size_t i) const {
  return null(i) ? std::nullopt : std::optional(integer(i));
}

struct Database::Impl {
  ArchiveUrl url;
  std::recursive_mutex mutex;
  std::unique_ptr<soci::session> session;
  int depth = 0;  ///< of transactions that joined
  bool failed = false;
  std::int64_t changed = 0;

  /// The parameters of a statement, alive as long as it is.
  struct Bound {
    std::deque<Cell> cells;

    void bind(soci::session& with, soci::statement& statement, const SqlValues& parameters) {
      for (const SqlValue& value : parameters) {
        Cell& cell = cells.emplace_back();
        if (const auto* integer = std::get_if<std::int64_t>(&value)) {
          cell.integer = *integer;
          statement.exchange(soci::use(cell.integer, cell.indicator));
        } else if (const auto* real = std::get_if<double>(&value)) {
          cell.real = *real;
          statement.exchange(soci::use(cell.real, cell.indicator));
        } else if (const auto* bytes = std::get_if<Bytes>(&value)) {
          cell.bytes = std::make_unique<soci::blob>(with);
          cell.bytes->append(reinterpret_cast<const char*>(bytes->data()), bytes->size());
          statement.exchange(soci::use(*cell.bytes, cell.indicator));
        } else {
          cell.text = orEmpty<std::string>(value);
          if (std::holds_alternative<std::monostate>(value)) cell.indicator = soci::i_null;
          statement.exchange(soci::use(cell.text, cell.indicator));
        }
      }
    }
  };

  void plain(const char* sql) { *session << sql; }

  template <typename Work>
  auto telling(Work work) {
    try {
      return work();
    } catch (const soci::soci_error& failure) {
      throw DatabaseFailure(errorOf(failure, shown(url)));
    }
  }
};

Database::Database(const ArchiveUrl& url, Missing missing) : impl_(std::make_unique<Impl>()) {
  impl_->url = url;
  const std::string connection = connectionString(url, missing);
  impl_->telling([&] {
    impl_->session = std::make_unique<soci::session>(soci::sqlite3, connection);
    // In WAL readers never wait for the writer nor it for them. FULL: what is committed outlives a power cut.
    for (const char* pragma : {"pragma busy_timeout = 10000", "pragma journal_mode = wal", "pragma synchronous = full",
                               "pragma foreign_keys = on", "pragma cache_size = -16000"})
      impl_->plain(pragma);
  });
}

Database::~Database() = default;

const ArchiveUrl& Database::url() const { return impl_->url; }

std::unique_lock<std::recursive_mutex> Database::lock() { return std::unique_lock(impl_->mutex); }

void Database::run(std::string_view sql, const SqlValues& parameters) {
  const auto held = lock();
  impl_->telling([&] {
    Impl::Bound bound;
    soci::statement statement(*impl_->session);
    bound.bind(*impl_->session, statement, parameters);
    statement.alloc();
    statement.prepare(std::string(sql));
    statement.define_and_bind();
    statement.execute(true);
    impl_->changed = statement.get_affected_rows();
  });
}

std::int64_t Database::changedRows() const { return impl_->changed; }

std::int64_t Database::insert(std::string_view sql, const SqlValues& parameters) {
  const auto held = lock();
  run(sql, parameters);
  long long key = 0;
  impl_->telling([&] { impl_->session->get_last_insert_id("", key); });
  return key;
}

void Database::query(std::string_view sql, const SqlValues& parameters, std::string_view columns,
                     const std::function<void(const Row&)>& row) {
  const auto held = lock();
  impl_->telling([&] {
    Impl::Bound bound;
    std::deque<Cell> cells;
    soci::statement statement(*impl_->session);
    for (const char kind : columns) {
      Cell& cell = cells.emplace_back();
      cell.kind = kind;
      if (kind == 'i') statement.exchange(soci::into(cell.integer, cell.indicator));
      if (kind == 'r') statement.exchange(soci::into(cell.real, cell.indicator));
      if (kind == 't') statement.exchange(soci::into(cell.text, cell.indicator));
      if (kind != 'b') continue;
      cell.bytes = std::make_unique<soci::blob>(*impl_->session);
      statement.exchange(soci::into(*cell.bytes, cell.indicator));
    }
    bound.bind(*impl_->session, statement, parameters);
    statement.alloc();
    statement.prepare(std::string(sql));
    statement.define_and_bind();
    statement.execute(false);
    Row answer(columns.size());
    while (statement.fetch()) {
      for (std::size_t i = 0; i < cells.size(); ++i) answer.set(i, valueOf(cells[i]));
      row(answer);
    }
  });
}

std::optional<Row> Database::first(std::string_view sql, const SqlValues& parameters, std::string_view columns) {
  std::optional<Row> found;
  query(sql, parameters, columns, [&](const Row& row) {
    if (!found) found = row;
  });
  return found;
}

void Database::begin() {
  const auto held = lock();
  if (impl_->depth == 0) {
    impl_->failed = false;
    impl_->telling([&] { impl_->plain("begin immediate"); });
  }
  ++impl_->depth;
}

void Database::commit() {
  const auto held = lock();
  if (impl_->depth == 1) {
    if (impl_->failed) throw DatabaseFailure({shown(impl_->url), "a part of the transaction failed", ErrorKind::World});
    impl_->telling([&] { impl_->plain("commit"); });
  }
  --impl_->depth;
}

void Database::rollback() noexcept {
  const auto held = lock();
  if (--impl_->depth > 0) {
    impl_->failed = true;
    return;
  }
  try {
    impl_->plain("rollback");
  } catch (const std::exception&) {  // SQLite has rolled back by itself after some failures
  }
}

Transaction::Transaction(Database& database) : database_(database), lock_(database.lock()) { database_.begin(); }

Transaction::~Transaction() {
  if (open_) database_.rollback();
}

void Transaction::commit() {
  database_.commit();
  open_ = false;
}

}  // namespace vignole
