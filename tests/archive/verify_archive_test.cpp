#include "engine/archive/verify_archive.h"

#include <fstream>
#include <gtest/gtest.h>

#include "engine/database/database.h"
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

}  // namespace
}  // namespace vignole
