#include "engine/archive/verify_archive.h"

#include <fstream>
#include <gtest/gtest.h>
#include <random>

#include "engine/archive/audit_trail.h"
#include "engine/archive/rail_rows.h"
#include "engine/database/database.h"
#include "engine/database/digest.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

class VerifyArchiveTest : public ::testing::Test {
 protected:
  static void fill(const std::string& url) {
    GeneratedRails g;
    g.rails = 4;
    g.lengthM = 1.5;
    g.failingShare = 1;
    const auto made = generateRails(url, testing::recipe(), g);
    ASSERT_TRUE(made) << made.error().message();
  }
  void SetUp() override { fill(folder.url()); }
  std::vector<ArchiveFinding> findings() const {
    const auto check = verifyArchive(testing::openArchive(folder.url(), Archive::Missing::Refuse));
    if (!check) return {{"archive", check.error().message()}};
    return check->findings;
  }
  void change(const std::string& sql) const { testing::openArchive(folder.url()).database()->run(sql); }
  testing::ArchiveFolder folder;
};

TEST_F(VerifyArchiveTest, FindsNothingInAWholeOne) { EXPECT_TRUE(findings().empty()); }

constexpr const char* kEmptyBlock = "update profile_block set content = :a where rail = 2";

TEST_F(VerifyArchiveTest, FindsEveryKindOfChangeAndNamesTheRail) {
  for (const char* sql :
       {"update rail set verdict = 0 where id = 2", "update rail set heat = 'H9' where id = 2",
        "update rail_dimension set mean_mm = mean_mm + 1e-9 where rail = 2 and dimension = 4",
        "delete from rail_dimension where rail = 2 and dimension = 1", "delete from rail_exception where rail = 2",
        kEmptyBlock, "delete from profile_block where rail = 2", "update rail set profiles = profiles + 1 where id = 2",
        "update rail set digest = null where id = 2"}) {
    const testing::ArchiveFolder other;
    fill(other.url());
    const Archive copy = testing::openArchive(other.url());
    if (sql == kEmptyBlock)
      copy.database()->run(sql, {Bytes(100, 0)});
    else
      copy.database()->run(sql);
    const auto check = verifyArchive(copy);
    ASSERT_TRUE(check);
    ASSERT_FALSE(check->findings.empty()) << sql;
    EXPECT_EQ(check->findings.front().where, "rail G100001 (2)") << sql;
  }
}

TEST_F(VerifyArchiveTest, FindsChangedRecipes) {
  change("update recipe set content = content || ' '");
  ASSERT_EQ(findings().size(), 1U);
  EXPECT_EQ(findings().front().where, "recipe 60E1 X/A");
}

TEST_F(VerifyArchiveTest, FindsBytesThatTheDiskLost) {
  if (testing::PostgresqlServer::wished()) GTEST_SKIP() << "the server's files are its own";
  std::fstream file(folder.file(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(0, std::ios::end);
  const auto size = static_cast<long>(file.tellg());
  ASSERT_GT(size, 100000);
  // A page in the middle of the file, and one near its end.
  for (const long at : {size / 2 / 4096 * 4096, size - 4 * 4096}) {
    file.seekp(at);
    file << std::string(4096, '\0');
  }
  file.close();
  EXPECT_FALSE(findings().empty());
}

std::string contentsOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Everything that verify vouches for, as one text: rails, texts of recipes and calibrations, the audit trail.
std::string everything(const std::string& file) {
  const Archive archive = testing::openArchive(file, Archive::Missing::Refuse);
  Database& database = *archive.database();
  Digest digest;
  for (std::int64_t rail = 1; rail <= 4; ++rail) digest.add(railDigest(database, rail));
  for (const char* sql : {"select content from recipe", "select content from calibration"})
    database.query(sql, {}, "t", [&](const Row& row) { digest.add(row); });
  database.query("select number, by_user, action, subject, reason, details, digest from audit order by number", {},
                 "itttttt", [&](const Row& row) { digest.add(row); });
  return digest.finish();
}

TEST_F(VerifyArchiveTest, FindsAnyBitThatFlippedUnlessNothingReadsIt) {
  if (testing::PostgresqlServer::wished()) GTEST_SKIP() << "the server's files are its own";
  ASSERT_TRUE(AuditTrail(testing::openArchive(folder.file())).add("Ann", "limit changed", "60E1", "why", "0.5 -> 0.4"));
  ASSERT_TRUE(testing::openArchive(folder.file()).backUpTo(folder.file("whole.db")));  // one file, no log beside it
  const std::string whole = contentsOf(folder.file("whole.db"));
  const std::string before = everything(folder.file("whole.db"));
  std::mt19937 random(7);
  int found = 0, harmless = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string file = folder.file("flipped.db");
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(file + suffix);
    std::string flipped = whole;
    std::size_t at = random() % whole.size();
    while (whole[at] == 0) at = random() % whole.size();  // half of the file is room for more
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (random() % 8)));
    std::ofstream(file, std::ios::binary) << flipped;
    const auto archive = Archive::open(file);
    const bool told = !archive || !verifyArchive(*archive)->findings.empty();
    if (told) {
      ++found;
      continue;
    }
    ++harmless;  // in space that nothing uses, or in an index's spare bytes
    EXPECT_EQ(everything(file), before) << "bit flipped at " << at;
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(found, harmless);
}

}  // namespace
}  // namespace vignole
