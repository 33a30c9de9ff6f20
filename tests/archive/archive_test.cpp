#include "engine/archive/archive.h"

#include <atomic>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "engine/archive/rail_archive.h"
#include "engine/archive/schema.h"
#include "engine/archive/verify_archive.h"
#include "engine/database/archive_url.h"
#include "engine/database/copied_rows.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

using testing::ArchiveFolder;

TEST(ArchiveUrl, NamesAFileOrAServer) {
  EXPECT_EQ(parseArchiveUrl("a b.db")->file, "a b.db");
  EXPECT_EQ(parseArchiveUrl("sqlite:rails.db")->file, "rails.db");
  EXPECT_EQ(parseArchiveUrl("sqlite:///var/rails.db")->file, "/var/rails.db");
  const auto server = parseArchiveUrl("postgresql://vignole:secret@mill:5433/rails?sslmode=require");
  ASSERT_TRUE(server);
  EXPECT_EQ(server->kind, ArchiveKind::Postgresql);
  EXPECT_EQ(shown(*server), "postgresql://mill:5433/rails");
  EXPECT_FALSE(parseArchiveUrl(""));
  EXPECT_FALSE(parseArchiveUrl("sqlite:"));
  EXPECT_FALSE(parseArchiveUrl("mysql://host/rails"));
}

TEST(ArchiveUrl, ShowsNoPasswordWhereverItStands) {
  for (const char* url : {"postgresql://ann:secret@mill/rails", "postgresql://mill/rails?user=ann&password=secret",
                          "postgresql://mill/rails?password=a%40secret", "postgres://ann:se%2Fcret%3Fsecret@mill/rails",
                          "postgresql://ann:sec%ret%secret@mill/rails", "postgresql://ann:secret/x",
                          "postgresql://ann:secret@[::1/rails", "postgresql://ann:secret@mill/rails?nonsense=1"}) {
    const auto parsed = parseArchiveUrl(url);
    const std::string words = parsed ? shown(*parsed) : parsed.error().message();
    EXPECT_EQ(words.find("secret"), std::string::npos) << words;
    const auto opened = Archive::open(url);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().message().find("secret"), std::string::npos) << opened.error().message();
    EXPECT_EQ(opened.error().message().find('\n'), std::string::npos);
  }
}

TEST(ArchiveServer, RefusesAWrongPasswordAndNeverTellsIt) {
  if (!testing::PostgresqlServer::wished()) GTEST_SKIP() << "needs PostgreSQL";
  auto& server = testing::PostgresqlServer::ofThisProgram();
  const auto wrong = Archive::open(server.urlWithPassword("wrongwrong"), Archive::Missing::Create);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().kind, ErrorKind::Input);
  EXPECT_EQ(wrong.error().message().find("wrongwrong"), std::string::npos) << wrong.error().message();
}

TEST(ArchiveServer, ThatIsAwayIsTheWorldsFaultAndAConnectionIsMadeAnew) {
  if (!testing::PostgresqlServer::wished()) GTEST_SKIP() << "needs PostgreSQL";
  const ArchiveFolder folder;
  testing::PostgresqlServer server;
  Archive archive = testing::openArchive(server.url("a"));
  Database& database = *archive.database();
  const std::string event = "insert into event (time_us, source, content, by_user) values (1, 'a', 'b', 'c')";
  database.run(event);
  server.stop();
  const auto away = guarded([&] { database.run(event); });
  ASSERT_FALSE(away);
  EXPECT_EQ(away.error().kind, ErrorKind::World);
  EXPECT_EQ(away.error().message().find(testing::PostgresqlServer::kPassword), std::string::npos);
  server.start();
  database.run(event);
  EXPECT_EQ(database.first("select count(*) from event", {}, "i")->integer(0), 2);
  // Cut off unnoticed: what is read is asked for again, what is written is begun again.
  server.stop();
  server.start();
  EXPECT_EQ(database.first("select count(*) from event", {}, "i")->integer(0), 2);
  server.stop();
  server.start();
  database.run(event);
  EXPECT_EQ(database.first("select count(*) from event", {}, "i")->integer(0), 3);
  // In the middle of a transaction nothing of it stays.
  {
    Transaction transaction(database);
    database.run(event);
    server.stop();
    server.start();
    EXPECT_THROW(database.run(event), DatabaseFailure);
  }
  EXPECT_EQ(database.first("select count(*) from event", {}, "i")->integer(0), 3);
}

TEST(Archive, IsMadeOnlyWhereItIsAskedForAndNotForTheWorldToRead) {
  const ArchiveFolder folder;
  const auto missing = Archive::open(folder.file());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::Input);
  EXPECT_FALSE(std::filesystem::exists(folder.file()));
  const auto made = Archive::open(folder.file(), Archive::Missing::Create);
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_EQ(made->schemaVersion(), migrations().back().version);
  const auto rights = std::filesystem::status(folder.file()).permissions();
  EXPECT_EQ(rights & std::filesystem::perms::others_all, std::filesystem::perms::none);
  EXPECT_TRUE(Archive::open("sqlite:" + folder.file()));
}

TEST(Archive, RefusesFilesThatAreNone) {
  const ArchiveFolder folder;
  std::ofstream(folder.file("text")) << std::string(5000, 'x');
  const auto text = Archive::open(folder.file("text"));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().kind, ErrorKind::Input);
  EXPECT_FALSE(Archive::open(std::filesystem::path(folder.file()).parent_path().string()));
  {
    Database other(*parseArchiveUrl(folder.url("other.db")), Database::Missing::Create);
    other.run("create table customers (name text)");
  }
  const auto other = Archive::open(folder.url("other.db"));
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().what.find("another program"), std::string::npos) << other.error().message();
}

TEST(Archive, OfALaterVersionIsRefused) {
  const ArchiveFolder folder;
  {
    const Archive archive = testing::openArchive(folder.url());
    archive.database()->run("update archive set version = 99");
  }
  const auto later = Archive::open(folder.url());
  ASSERT_FALSE(later);
  EXPECT_NE(later.error().what.find("later version"), std::string::npos) << later.error().message();
}

TEST(Schema, OlderArchivesAreBroughtForwardStepByStepOrNotAtAll) {
  const ArchiveFolder folder;
  Database database(*parseArchiveUrl(folder.url()), Database::Missing::Create);
  std::vector<Migration> steps = {{1, {"create table a (x bigint)", "insert into a (x) values (5)"}}};
  migrate(database, steps);
  EXPECT_EQ(schemaVersion(database), 1);
  steps.push_back({2, {"alter table a add column y bigint", "update a set y = x + 1"}});
  steps.push_back({3, {"create table b (z bigint)", "insert into nowhere values (1)"}});
  EXPECT_THROW(migrate(database, steps), DatabaseFailure);
  EXPECT_EQ(schemaVersion(database), 1);
  EXPECT_FALSE(database.hasTable("b"));
  steps.back().statements.back() = "insert into b (z) select y from a";
  migrate(database, steps);
  EXPECT_EQ(schemaVersion(database), 3);
  EXPECT_EQ(database.first("select z from b", {}, "i")->integer(0), 6);
}

/// Archives of every version that there was, as they were written then.
class OfEveryOlderVersion : public ::testing::TestWithParam<int> {
 protected:
  static void load(const std::string& file, int version) {
    Database database(*parseArchiveUrl(file), Database::Missing::Create);
    database.run("pragma foreign_keys = off");  // its tables come in another order
    std::ifstream sql(std::string(VIGNOLE_SOURCE_DIR) + "/tests/data/archive/version_" + std::to_string(version) +
                      ".sql");
    ASSERT_TRUE(sql) << "an archive of version " << version << " belongs into tests/data/archive";
    std::string statement;
    for (std::string line; std::getline(sql, line);) {
      statement += line + "\n";
      if (!line.ends_with(";")) continue;
      if (!statement.starts_with("BEGIN") && !statement.starts_with("COMMIT")) database.run(statement);
      statement.clear();
    }
    ASSERT_EQ(schemaVersion(database), version);
  }
};

TEST_P(OfEveryOlderVersion, IsBroughtForwardWholeAndGoesOnBeingWritten) {
  const ArchiveFolder folder;
  load(folder.file(), GetParam());
  {
    const Archive archive = testing::openArchive(folder.file(), Archive::Missing::Refuse);
    EXPECT_EQ(archive.schemaVersion(), migrations().back().version);
    const auto check = verifyArchive(archive);
    ASSERT_TRUE(check) << check.error().message();
    for (const ArchiveFinding& f : check->findings) ADD_FAILURE() << f.where << ": " << f.what;
    EXPECT_EQ(check->rails, 3U);
    EXPECT_EQ(check->profiles, 60U);
    EXPECT_EQ(RailArchive(archive).recordings(2)->size(), 1U);
    EXPECT_FALSE(*RailArchive(archive).hold(1));
  }
  GeneratedRails g;
  g.rails = 2;
  g.lengthM = 0.3;
  ASSERT_TRUE(generateRails(folder.file(), testing::recipe(), g));
  const Archive archive = testing::openArchive(folder.file(), Archive::Missing::Refuse);
  EXPECT_EQ(*RailArchive(archive).count(), 5U);
  EXPECT_TRUE(verifyArchive(archive)->findings.empty());
  // The same tables as those of a new one.
  const Archive fresh = testing::openArchive(folder.file("new.db"));
  std::vector<std::string> tables = tablesOf(*fresh.database());
  for (const std::string& table : tables) {
    const TableColumns is = columnsOf(*archive.database(), table), meant = columnsOf(*fresh.database(), table);
    EXPECT_EQ(is.names, meant.names) << table;
    EXPECT_EQ(is.kinds, meant.kinds) << table;
  }
}

INSTANTIATE_TEST_SUITE_P(Schema, OfEveryOlderVersion, ::testing::Range(1, migrations().back().version));

TEST(Database, ValuesComeBackToTheBit) {
  const ArchiveFolder folder;
  Database database(*parseArchiveUrl(folder.url("a=b \"c\".db")), Database::Missing::Create);
  database.run(std::string("create table t (i bigint, r double precision, t text, b ") +
               (database.url().kind == ArchiveKind::Sqlite ? "blob)" : "bytea)"));
  const SqlValues values = {std::int64_t{INT64_MIN + 1}, 0.1 + 0.2, std::string("O'Brien; drop table t -- \xc3\xa9"),
                            Bytes{0, 1, 0, 255}};
  database.run("insert into t values (:a, :b, :c, :d)", values);
  database.run("insert into t values (:a, :b, :c, :d)", {{}, {}, {}, {}});
  std::vector<Row> rows;
  database.query("select i, r, t, b from t order by i is null", {}, "irtb",
                 [&](const Row& row) { rows.push_back(row); });
  ASSERT_EQ(rows.size(), 2U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(rows[0].value(i), values[i]);
    EXPECT_TRUE(rows[1].null(i));
  }
}

TEST(Database, ATransactionThatIsLeftIsUndone) {
  const ArchiveFolder folder;
  Database database(*parseArchiveUrl(folder.url()), Database::Missing::Create);
  database.run("create table t (i bigint)");
  {
    Transaction outer(database);
    database.run("insert into t values (1)");
    {
      Transaction inner(database);
      database.run("insert into t values (2)");
      inner.commit();
    }
  }
  EXPECT_EQ(database.first("select count(*) from t", {}, "i")->integer(0), 0);
  Transaction outer(database);
  { const Transaction inner(database); }
  EXPECT_THROW(outer.commit(), DatabaseFailure);
}

TEST(Archive, IsBackedUpWholeIntoANewFile) {
  const ArchiveFolder folder;
  Archive archive = testing::openArchive(folder.url());
  archive.database()->run("insert into event (time_us, source, content, by_user) values (1, 'a', 'b', 'c')");
  GeneratedRails g;
  g.rails = 3;
  g.lengthM = 0.3;
  g.failingShare = 1;
  ASSERT_TRUE(generateRails(folder.url(), testing::recipe(), g));
  const auto backedUp = archive.backUpTo(folder.file("copy.db"));
  ASSERT_TRUE(backedUp) << backedUp.error().message();
  EXPECT_FALSE(archive.backUpTo(folder.file("copy.db")));
  const Archive copy = testing::openArchive(folder.file("copy.db"), Archive::Missing::Refuse);
  EXPECT_EQ(copy.database()->first("select content from event", {}, "t")->text(0), "b");
  const auto check = verifyArchive(copy);
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->findings.empty());
  EXPECT_EQ(check->rails, 3U);
  EXPECT_EQ(check->profiles, 60U);
  const auto rights = std::filesystem::status(folder.file("copy.db")).permissions();
  EXPECT_EQ(rights & std::filesystem::perms::others_all, std::filesystem::perms::none);
}

TEST(Archive, IsBackedUpWhileItIsMeasuredInto) {
  const ArchiveFolder folder;
  Archive archive = testing::openArchive(folder.url());
  std::atomic<bool> failed = false;
  std::jthread measuring([&](const std::stop_token& stop) {
    for (GeneratedRails g; !stop.stop_requested(); ++g.seed) {
      g.rails = 3;
      g.lengthM = 0.3;
      if (!generateRails(folder.url(), testing::recipe(), g)) failed = true;
    }
  });
  std::uint64_t before = 0;
  for (int i = 0; i < 5; ++i) {
    const std::string file = folder.file("copy" + std::to_string(i) + ".db");
    const auto done = archive.backUpTo(file);
    ASSERT_TRUE(done) << done.error().message();
    const Archive copy = testing::openArchive(file, Archive::Missing::Refuse);
    const auto check = verifyArchive(copy);
    ASSERT_TRUE(check);
    for (const ArchiveFinding& f : check->findings) ADD_FAILURE() << f.where << ": " << f.what;
    EXPECT_EQ(check->rails % 3, 0U);  // whole transactions alone
    EXPECT_GE(check->rails, before);
    before = check->rails;
  }
  measuring.request_stop();
  measuring.join();
  EXPECT_FALSE(failed);
}

TEST(Database, TextsThatNoDatabaseTakesAreMadeStorable) {
  EXPECT_EQ(storableText("Böhler 轨 \xf0\x9f\x9b\xa4"), "Böhler 轨 \xf0\x9f\x9b\xa4");
  EXPECT_EQ(storableText(std::string("a\0b", 3)),
            "a\xef\xbf\xbd"
            "b");
  for (const char* bad : {"\xff", "\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"})
    EXPECT_TRUE(storableText(bad).starts_with("\xef\xbf\xbd")) << bad;
}

TEST(Time, IsWrittenAndReadInUtc) {
  EXPECT_EQ(isoTime(0), "1970-01-01T00:00:00.000000Z");
  EXPECT_EQ(isoTime(1'741'356'309'123'456), "2025-03-07T14:05:09.123456Z");
  EXPECT_EQ(*timeFromIso("2025-03-07T14:05:09.123456Z"), 1'741'356'309'123'456);
  EXPECT_EQ(*timeFromIso("2025-03-07 14:05:09"), 1'741'356'309'000'000);
  EXPECT_EQ(*timeFromIso("2024-02-29"), 1'709'164'800'000'000);
  for (const char* bad : {"", "2025-13-01", "2025-02-29", "7.3.2025", "2025-03-07T25:00:00", "2025-03-07Tx"})
    EXPECT_FALSE(timeFromIso(bad)) << bad;
}

}  // namespace
}  // namespace vignole
