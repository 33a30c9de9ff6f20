#pragma once
// The people who may change something, with their roles. Passwords are hashed (password.h); who guesses is locked out;
// every change goes into the audit trail.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/password.h"
#include "engine/archive/rail_record.h"
#include "engine/archive/roles.h"

namespace vignole {

struct UserAccount {
  std::string name;
  Role role = Role::Operator;
  bool disabled = false;
  bool mustChangePassword = false;  ///< it was given by somebody else
  int failures = 0;                 ///< wrong passwords in a row
  TimeUs lockedUntilUs = 0;         ///< 0 or past: not locked
  TimeUs createdUs = 0;
  std::optional<TimeUs> lastSignInUs;
};

enum class SignInResult { Welcome, WrongNameOrPassword, Locked, Disabled };

struct SignIn {
  SignInResult result = SignInResult::WrongNameOrPassword;
  UserAccount account;  ///< where Welcome; of Locked the time alone
};

struct UserSettings {
  int failuresBeforeLock = 5;
  double lockS = 300;  ///< doubled with every further lock in a row, up to a day
  std::size_t minPasswordLength = 8;
  PasswordCost cost;
};

class UserRegister {
 public:
  /// `clock`: for tests.
  explicit UserRegister(const Archive& archive, UserSettings settings = {},
                        std::function<TimeUs()> clock = systemTimeUs);

  [[nodiscard]] Expected<std::vector<UserAccount>> accounts() const;
  /// The first account must be an administrator's; it is entered by itself.
  [[nodiscard]] Expected<void> add(const std::string& name, Role role, const std::string& password,
                                   const std::string& by, const std::string& reason);
  /// The same answer and the same time for a wrong name and a wrong password.
  [[nodiscard]] Expected<SignIn> signIn(const std::string& name, const std::string& password);
  /// By the user: the old one must fit.
  [[nodiscard]] Expected<void> changePassword(const std::string& name, const std::string& old,
                                              const std::string& password);
  /// By an administrator; unlocks, and must be changed at the next sign-in.
  [[nodiscard]] Expected<void> resetPassword(const std::string& name, const std::string& password,
                                             const std::string& by, const std::string& reason);
  /// Refused for the last administrator.
  [[nodiscard]] Expected<void> setRole(const std::string& name, Role role, const std::string& by,
                                       const std::string& reason);
  [[nodiscard]] Expected<void> setDisabled(const std::string& name, bool disabled, const std::string& by,
                                           const std::string& reason);

 private:
  [[nodiscard]] std::string hashed(const std::string& password) const;
  void refuseIfLastAdministrator(const UserAccount& account) const;
  void noteFailure(const UserAccount& account, TimeUs now);
  std::shared_ptr<Database> database_;
  UserSettings settings_;
  std::function<TimeUs()> clock_;
  std::string nobodysHash_;  ///< compared with where there is no such name
};

}  // namespace vignole
