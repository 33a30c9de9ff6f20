#include "engine/database/database.h"

#include <deque>
#include <soci/soci.h>

#include "engine/database/postgresql_session.h"
#include "engine/database/sqlite_session.h"

namespace vignole {

namespace {

template <typename T>
const T& orEmpty(const SqlValue& value) {
  static const T empty{};
  const T* held = std::get_if<T>(&value);
  return held != nullptr ? *held : empty;
}

/// Where a column of the answer is fetched to, or a parameter is taken from. PostgreSQL's bytes travel as text (`bytes`
/// would be one of its large objects).
struct Cell {
  char kind = 't';
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
      return cell.bytes ? contentsOf(*cell.bytes) : bytesOfBytea(cell.text);
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

std::string storableText(std::string text) {
  const auto continues = [&](std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;
  };
  std::string good;
  good.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto c = static_cast<unsigned char>(text[at]);
    const auto next = static_cast<unsigned char>(at + 1 < text.size() ? text[at + 1] : 0);
    std::size_t length = 0;
    if (c > 0 && c < 0x80) length = 1;
    if (c >= 0xc2 && c < 0xe0) length = 2;
    if (c >= 0xe0 && c < 0xf0 && !(c == 0xe0 && next < 0xa0) && !(c == 0xed && next >= 0xa0)) length = 3;
    if (c >= 0xf0 && c < 0xf5 && !(c == 0xf0 && next < 0x90) && !(c == 0xf4 && next >= 0x90)) length = 4;
    for (std::size_t i = 1; i < length; ++i)
      if (!continues(at + i)) length = 0;
    good += length > 0 ? text.substr(at, length) : "\xef\xbf\xbd";
    at += std::max<std::size_t>(length, 1);
  }
  return good;
}

struct Database::Impl {
  ArchiveUrl url;
  std::recursive_mutex mutex;
  std::unique_ptr<soci::session> session;
  bool lost = false;  ///< the connection to the server
  int depth = 0;      ///< of transactions that joined
  bool failed = false;
  std::int64_t changed = 0;

  [[nodiscard]] bool server() const { return url.kind == ArchiveKind::Postgresql; }

  /// The parameters of a statement and the columns of its answer, alive as long as it is.
  struct Exchanged {
    std::deque<Cell> cells, columns;
  };

  void bind(Exchanged& bound, soci::statement& statement, const SqlValues& parameters) {
    for (const SqlValue& value : parameters) {
      Cell& cell = bound.cells.emplace_back();
      if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        cell.integer = *integer;
        statement.exchange(soci::use(cell.integer, cell.indicator));
        continue;
      }
      if (const auto* real = std::get_if<double>(&value)) {
        cell.real = *real;
        statement.exchange(soci::use(cell.real, cell.indicator));
        continue;
      }
      if (const auto* bytes = std::get_if<Bytes>(&value); bytes != nullptr && !server()) {
        cell.bytes = std::make_unique<soci::blob>(*session);
        cell.bytes->append(reinterpret_cast<const char*>(bytes->data()), bytes->size());
        statement.exchange(soci::use(*cell.bytes, cell.indicator));
        continue;
      }
      if (std::holds_alternative<std::monostate>(value)) cell.indicator = soci::i_null;
      if (const auto* bytes = std::get_if<Bytes>(&value)) cell.text = byteaText(*bytes);
      if (const auto* text = std::get_if<std::string>(&value)) cell.text = server() ? storableText(*text) : *text;
      statement.exchange(soci::use(cell.text, cell.indicator));
    }
  }

  void fetchInto(Exchanged& bound, soci::statement& statement, std::string_view columns) {
    for (const char kind : columns) {
      Cell& cell = bound.columns.emplace_back();
      cell.kind = kind;
      if (kind == 'i') {
        statement.exchange(soci::into(cell.integer, cell.indicator));
      } else if (kind == 'r') {
        statement.exchange(soci::into(cell.real, cell.indicator));
      } else if (kind == 'b' && !server()) {
        cell.bytes = std::make_unique<soci::blob>(*session);
        statement.exchange(soci::into(*cell.bytes, cell.indicator));
      } else {
        statement.exchange(soci::into(cell.text, cell.indicator));
      }
    }
  }

  void prepare(soci::statement& statement, std::string_view sql) const {
    statement.alloc();
    statement.prepare(std::string(sql),
                      server() ? soci::details::st_one_time_query : soci::details::st_repeatable_query);
    statement.define_and_bind();
  }

  void run(std::string_view sql, const SqlValues& parameters) {
    Exchanged bound;
    soci::statement statement(*session);
    bind(bound, statement, parameters);
    prepare(statement, sql);
    statement.execute(true);
    changed = statement.get_affected_rows();
  }

  void query(std::string_view sql, const SqlValues& parameters, std::string_view columns,
             const std::function<void(const Row&)>& row) {
    Exchanged bound;
    soci::statement statement(*session);
    fetchInto(bound, statement, columns);
    bind(bound, statement, parameters);
    prepare(statement, sql);
    statement.execute(false);
    Row answer(columns.size());
    while (statement.fetch()) {
      for (std::size_t i = 0; i < bound.columns.size(); ++i) answer.set(i, valueOf(bound.columns[i]));
      row(answer);
    }
  }

  void plain(const char* sql) { *session << sql; }

  void beginNow() {
    if (!server()) return plain("begin immediate");
    plain("begin");
    try {
      plain("select pg_advisory_xact_lock(6224093431)");  // one writer at a time, as SQLite has it
    } catch (const soci::soci_error&) {
      if (!connectionLost(*session)) plain("rollback");
      throw;
    }
  }

  void connectAgain() {
    session.reset();
    session = connectPostgresql(url);
    lost = false;
  }

  /// What `work` returns; a failure of the library as ours. Where the connection was lost since it was last used, and
  /// `work` has not begun (`again`: or may be done twice), it is made anew.
  template <typename Work>
  auto telling(Work work, const bool& again = false) {
    if (lost && depth > 0)
      throw DatabaseFailure({shown(url), "the connection was lost in the middle of a transaction", ErrorKind::World});
    if (lost) connectAgain();
    try {
      return work();
    } catch (const soci::soci_error& failure) {
      if (!server()) throw DatabaseFailure(sqliteErrorOf(failure, shown(url)));
      lost = connectionLost(*session);
      if (!lost || !again || depth > 0) throw DatabaseFailure(postgresqlErrorOf(failure, url));
    }
    return telling(work);
  }
};

Database::Database(const ArchiveUrl& url, Missing missing) : impl_(std::make_unique<Impl>()) {
  impl_->url = url;
  if (url.kind == ArchiveKind::Postgresql)
    impl_->telling([&] { impl_->connectAgain(); });
  else
    impl_->telling([&] { impl_->session = openSqlite(url, missing); });
}

Database::~Database() = default;

const ArchiveUrl& Database::url() const { return impl_->url; }

std::unique_lock<std::recursive_mutex> Database::lock() { return std::unique_lock(impl_->mutex); }

void Database::run(std::string_view sql, const SqlValues& parameters) {
  const auto held = lock();
  if (impl_->server() && impl_->depth == 0) {
    Transaction transaction(*this);  // begins anew where the connection was lost
    impl_->telling([&] { impl_->run(sql, parameters); });
    transaction.commit();
  } else {
    impl_->telling([&] { impl_->run(sql, parameters); });
  }
}

std::int64_t Database::changedRows() const { return impl_->changed; }

std::int64_t Database::insert(std::string_view sql, const SqlValues& parameters) {
  const auto held = lock();
  if (impl_->server()) {
    std::int64_t given = 0;
    Transaction transaction(*this);
    query(std::string(sql) + " returning id", parameters, "i", [&](const Row& row) { given = row.integer(0); });
    transaction.commit();
    return given;
  }
  run(sql, parameters);
  long long key = 0;
  impl_->telling([&] { impl_->session->get_last_insert_id("", key); });
  return key;
}

void Database::query(std::string_view sql, const SqlValues& parameters, std::string_view columns,
                     const std::function<void(const Row&)>& row) {
  const auto held = lock();
  bool again = true;  // until there is an answer: its rows would come twice
  const auto telling = [&](const Row& answer) {
    again = false;
    row(answer);
  };
  impl_->telling([&] { impl_->query(sql, parameters, columns, telling); }, again);
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
    impl_->telling([&] { impl_->beginNow(); }, true);
  }
  ++impl_->depth;
}

void Database::beginReading() {
  const auto held = lock();
  if (impl_->depth == 0)
    impl_->telling([&] { impl_->plain(impl_->server() ? "begin isolation level repeatable read read only" : "begin"); },
                   true);
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
    if (impl_->server()) impl_->lost = impl_->lost || connectionLost(*impl_->session);
  }
}

Transaction::Transaction(Database& database) : database_(database), lock_(database.lock()) { database_.begin(); }

Transaction::~Transaction() {
  if (open_) database_.rollback();
}

bool Database::hasTable(const std::string& name) {
  const char* sql = impl_->server()
                        ? "select count(*) from information_schema.tables where table_schema = current_schema() and "
                          "table_name = :a"
                        : "select count(*) from sqlite_master where type = 'table' and name = :a";
  return first(sql, {name}, "i")->integer(0) > 0;
}

bool Database::empty() {
  const char* sql = impl_->server()
                        ? "select count(*) from information_schema.tables where table_schema = current_schema()"
                        : "select count(*) from sqlite_master where type = 'table' and name not like 'sqlite%'";
  return first(sql, {}, "i")->integer(0) == 0;
}

void Transaction::commit() {
  database_.commit();
  open_ = false;
}

}  // namespace vignole
