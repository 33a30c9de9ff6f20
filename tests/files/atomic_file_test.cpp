#include "engine/files/atomic_file.h"

#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace vignole {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("vignole_atomic_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] int filesInFolder() const {
    return static_cast<int>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(AtomicFileTest, IsSeenOnlyAfterCommit) {
  const fs::path target = folder_ / "a.txt";
  auto file = AtomicFile::create(target);
  ASSERT_TRUE(file);
  file->write("one ");
  file->write("two");
  EXPECT_FALSE(fs::exists(target));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(readFile(target).value(), "one two");
  EXPECT_EQ(filesInFolder(), 1);
  EXPECT_FALSE(file->commit()) << "twice";
}

TEST_F(AtomicFileTest, LeavesNothingBehindWithoutCommit) {
  const fs::path target = folder_ / "a.txt";
  ASSERT_TRUE(writeFile(target, "old"));
  {
    auto file = AtomicFile::create(target);
    ASSERT_TRUE(file);
    file->write("half of the ne");
    AtomicFile moved = std::move(*file);
    moved.write("w");
  }
  EXPECT_EQ(readFile(target).value(), "old");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFileTest, KeepsThePreviousVersion) {
  const fs::path target = folder_ / "a.txt";
  ASSERT_TRUE(writeFile(target, "1", true)) << "nothing to keep yet";
  ASSERT_TRUE(writeFile(target, "2", true));
  ASSERT_TRUE(writeFile(target, "3", true));
  EXPECT_EQ(readFile(target).value(), "3");
  EXPECT_EQ(readFile(target.string() + "~").value(), "2");
  EXPECT_EQ(filesInFolder(), 2);
}

TEST_F(AtomicFileTest, HasTheUsualPermissions) {
  const mode_t mask = ::umask(022);
  ASSERT_TRUE(writeFile(folder_ / "a.txt", "x"));
  ::umask(mask);
  struct stat s {};
  ASSERT_EQ(::stat((folder_ / "a.txt").c_str(), &s), 0);
  EXPECT_EQ(s.st_mode & 0777U, 0644U);
}

TEST_F(AtomicFileTest, FollowsALinkInsteadOfReplacingIt) {
  ASSERT_TRUE(writeFile(folder_ / "real.txt", "old"));
  fs::create_symlink("real.txt", folder_ / "link.txt");
  ASSERT_TRUE(writeFile(folder_ / "link.txt", "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(readFile(folder_ / "real.txt").value(), "new");
}

TEST_F(AtomicFileTest, WritesIntoADeviceWithoutReplacingIt) {
  ASSERT_TRUE(writeFile("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, FullDiskIsTheWorldsFault) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto written = writeFile("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::World);
}

TEST_F(AtomicFileTest, SaysWhatIsWrongWithTheTarget) {
  EXPECT_FALSE(AtomicFile::create(folder_));
  const auto lost = writeFile(folder_ / "no" / "such" / "a.txt", "x");
  ASSERT_FALSE(lost);
  EXPECT_NE(lost.error().message().find("folder"), std::string::npos);
  EXPECT_FALSE(AtomicFile::create(""));
}

TEST_F(AtomicFileTest, ReadFileSaysMissingOrFolder) {
  const auto missing = readFile(folder_ / "none.txt");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::Input);
  EXPECT_NE(missing.error().what.find("does not exist"), std::string::npos);
  EXPECT_NE(readFile(folder_).error().what.find("folder"), std::string::npos);
  const std::string binary("a\0b\r\n", 5);
  ASSERT_TRUE(writeFile(folder_ / "b", binary));
  EXPECT_EQ(readFile(folder_ / "b").value(), binary);
}

}  // namespace
}  // namespace vignole
