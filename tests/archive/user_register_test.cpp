#include "engine/archive/user_register.h"

#include <gtest/gtest.h>

#include "engine/archive/audit_trail.h"
#include "engine/database/database.h"
#include "tests/archive/archive_folder.h"

namespace vignole {
namespace {

/// The cheapest hash that libsodium makes: these tests are about what is done with it.
UserSettings cheap() {
  UserSettings s;
  s.cost = {1, 8192};
  return s;
}

class UserRegisterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(users.add("root", Role::Administrator, "correct horse", "root", "first user"));
    ASSERT_TRUE(users.add("ann", Role::Technician, "battery staple", "root", "new colleague"));
  }
  SignInResult signIn(const std::string& name, const std::string& password) {
    const auto answer = users.signIn(name, password);
    EXPECT_TRUE(answer);
    return answer->result;
  }

  testing::ArchiveFolder folder;
  Archive archive = testing::openArchive(folder.url());
  TimeUs now = 1'000'000'000'000;
  UserRegister users{archive, cheap(), [this] { return now; }};
};

TEST(Password, IsArgon2idWithASaltOfItsOwn) {
  const auto a = hashPassword("correct horse", {1, 8192}), b = hashPassword("correct horse", {1, 8192});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->rfind("$argon2id$", 0), 0U);
  EXPECT_NE(*a, *b);
  EXPECT_TRUE(passwordFits("correct horse", *a));
  EXPECT_FALSE(passwordFits("correct horsf", *a));
  EXPECT_FALSE(passwordFits("correct horse", "nonsense"));
}

TEST_F(UserRegisterTest, SignsInWithRoleAndNothingElse) {
  const auto answer = users.signIn("ann", "battery staple");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->result, SignInResult::Welcome);
  EXPECT_EQ(answer->account.role, Role::Technician);
  EXPECT_TRUE(answer->account.mustChangePassword);
  EXPECT_EQ(signIn("ann", "battery stable"), SignInResult::WrongNameOrPassword);
  EXPECT_EQ(signIn("nobody", "battery staple"), SignInResult::WrongNameOrPassword);
  EXPECT_EQ(signIn("ann' or '1'='1", "x"), SignInResult::WrongNameOrPassword);
}

TEST_F(UserRegisterTest, NoPasswordIsInTheFile) {
  const auto row = archive.database()->first("select password from account where name = 'ann'", {}, "t");
  EXPECT_EQ(row->text(0).find("battery"), std::string::npos);
  EXPECT_EQ(row->text(0).rfind("$argon2id$", 0), 0U);
}

TEST_F(UserRegisterTest, WhoGuessesIsLockedOutLongerEachTime) {
  for (int i = 0; i < 5; ++i) EXPECT_EQ(signIn("ann", "guess"), SignInResult::WrongNameOrPassword);
  EXPECT_EQ(signIn("ann", "battery staple"), SignInResult::Locked);
  EXPECT_EQ(signIn("root", "correct horse"), SignInResult::Welcome);
  now += 299'000'000;
  EXPECT_EQ(signIn("ann", "battery staple"), SignInResult::Locked);
  now += 2'000'000;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(signIn("ann", "guess"), SignInResult::WrongNameOrPassword);
  now += 301'000'000;
  EXPECT_EQ(signIn("ann", "battery staple"), SignInResult::Locked);
  now += 300'000'000;
  EXPECT_EQ(signIn("ann", "battery staple"), SignInResult::Welcome);
  EXPECT_EQ(users.signIn("ann", "battery staple")->account.failures, 0);
  AuditQuery locks;
  locks.action = "user locked";
  EXPECT_EQ(AuditTrail(archive).entries(locks)->size(), 2U);
}

TEST_F(UserRegisterTest, TheLockOutlivesTheProgram) {
  for (int i = 0; i < 5; ++i) (void)signIn("ann", "guess");
  UserRegister again(archive, cheap(), [this] { return now; });
  EXPECT_EQ(again.signIn("ann", "battery staple")->result, SignInResult::Locked);
}

TEST_F(UserRegisterTest, PasswordsAreChangedByTheirUserAndResetByAnother) {
  EXPECT_FALSE(users.changePassword("ann", "wrong", "another password"));
  EXPECT_FALSE(users.changePassword("ann", "battery staple", "short"));
  ASSERT_TRUE(users.changePassword("ann", "battery staple", "another password"));
  EXPECT_EQ(signIn("ann", "battery staple"), SignInResult::WrongNameOrPassword);
  EXPECT_FALSE(users.signIn("ann", "another password")->account.mustChangePassword);
  EXPECT_FALSE(users.resetPassword("ann", "given password", "root", ""));
  ASSERT_TRUE(users.resetPassword("ann", "given password", "root", "forgotten"));
  EXPECT_TRUE(users.signIn("ann", "given password")->account.mustChangePassword);
}

TEST_F(UserRegisterTest, ACostlierHashReplacesTheOldOneAtTheNextSignIn) {
  UserSettings costlier = cheap();
  costlier.cost = {2, 16384};
  UserRegister later(archive, costlier, [this] { return now; });
  const auto hash = [&] {
    return archive.database()->first("select password from account where name = 'ann'", {}, "t")->text(0);
  };
  const std::string before = hash();
  EXPECT_EQ(later.signIn("ann", "battery staple")->result, SignInResult::Welcome);
  EXPECT_NE(hash(), before);
  EXPECT_FALSE(isOfOtherCost(hash(), costlier.cost));
  EXPECT_EQ(later.signIn("ann", "battery staple")->result, SignInResult::Welcome);
}

TEST_F(UserRegisterTest, TheLastAdministratorStays) {
  EXPECT_FALSE(users.setRole("root", Role::QA, "root", "tired"));
  EXPECT_FALSE(users.setDisabled("root", true, "root", "tired"));
  ASSERT_TRUE(users.setRole("ann", Role::Administrator, "root", "takes over"));
  EXPECT_TRUE(users.setDisabled("root", true, "ann", "left"));
  EXPECT_EQ(signIn("root", "correct horse"), SignInResult::Disabled);
  EXPECT_FALSE(users.setRole("ann", Role::QA, "ann", "tired"));
}

TEST_F(UserRegisterTest, EveryChangeIsAudited) {
  ASSERT_TRUE(users.setRole("ann", Role::QA, "root", "promoted"));
  const auto entries = AuditTrail(archive).entries();
  ASSERT_EQ(entries->size(), 3U);
  EXPECT_EQ(entries->front().details, "technician -> QA");
  EXPECT_EQ(entries->front().reason, "promoted");
  EXPECT_TRUE(AuditTrail(archive).verify()->empty());
  EXPECT_FALSE(users.setRole("ann", Role::Operator, "root", ""));
  EXPECT_EQ(users.accounts()->front().role, Role::QA);
}

TEST(UserRegisterFirst, IsAnAdministrator) {
  const testing::ArchiveFolder folder;
  const Archive archive = testing::openArchive(folder.url());
  UserRegister users(archive, cheap());
  EXPECT_FALSE(users.add("ann", Role::QA, "battery staple", "ann", "first"));
  EXPECT_TRUE(users.accounts()->empty());
}

TEST(Roles, TheirRightsGrowButQualityIsQAs) {
  EXPECT_TRUE(may(Role::Operator, Permission::AcknowledgeAlarms));
  EXPECT_FALSE(may(Role::Operator, Permission::Calibrate));
  EXPECT_TRUE(may(Role::Technician, Permission::Calibrate));
  EXPECT_FALSE(may(Role::Technician, Permission::ApproveRecipes));
  EXPECT_TRUE(may(Role::QA, Permission::ApproveRecipes));
  EXPECT_FALSE(may(Role::QA, Permission::ManageUsers));
  EXPECT_TRUE(may(Role::Administrator, Permission::ManageUsers));
  EXPECT_FALSE(may(Role::Administrator, Permission::ApproveRecipes));
  for (const Role r : {Role::Operator, Role::Technician, Role::QA, Role::Administrator})
    EXPECT_EQ(roleFromName(name(r)), r);
}

}  // namespace
}  // namespace vignole
