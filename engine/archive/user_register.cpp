#include "engine/archive/user_register.h"

#include <algorithm>

#include "engine/archive/audit_rows.h"

namespace vignole {

namespace {

constexpr TimeUs kDayUs = 86'400'000'000;
constexpr std::size_t kMaxNameLength = 64;

struct AccountRow {
  UserAccount account;
  std::string hash;
};

std::int64_t number(Role role) { return static_cast<std::int64_t>(role); }

constexpr const char* kColumns =
    "name, role, password, created_us, disabled, must_change, failures, locked_until_us, last_sign_in_us";
constexpr const char* kKinds = "titiiiiii";

AccountRow accountFrom(const Row& row) {
  AccountRow a;
  a.account.name = row.text(0);
  a.account.role = static_cast<Role>(std::clamp<std::int64_t>(row.integer(1), 0, number(Role::Administrator)));
  a.hash = row.text(2);
  a.account.createdUs = row.integer(3);
  a.account.disabled = row.integer(4) != 0;
  a.account.mustChangePassword = row.integer(5) != 0;
  a.account.failures = static_cast<int>(row.integer(6));
  a.account.lockedUntilUs = row.integer(7);
  a.account.lastSignInUs = row.integerOrNone(8);
  return a;
}

std::optional<AccountRow> find(Database& database, const std::string& name) {
  const auto row = database.first(std::string("select ") + kColumns + " from account where name = :a", {name}, kKinds);
  return row ? std::optional(accountFrom(*row)) : std::nullopt;
}

AccountRow findOrThrow(Database& database, const std::string& name) {
  auto found = find(database, name);
  if (!found) throw DatabaseFailure({name, "is no user here", ErrorKind::Input});
  return std::move(*found);
}

}  // namespace

UserRegister::UserRegister(const Archive& archive, UserSettings settings, std::function<TimeUs()> clock)
    : database_(archive.database()), settings_(settings), clock_(std::move(clock)) {}

std::string UserRegister::hashed(const std::string& password) const {
  if (password.size() < settings_.minPasswordLength)
    throw DatabaseFailure({"password", "is shorter than " + std::to_string(settings_.minPasswordLength) + " characters",
                           ErrorKind::Input});
  if (password.size() > 1024) throw DatabaseFailure({"password", "is longer than 1024 bytes", ErrorKind::Input});
  return orThrow(hashPassword(password, settings_.cost));
}

Expected<std::vector<UserAccount>> UserRegister::accounts() const {
  return guarded([&] {
    std::vector<UserAccount> all;
    database_->query(std::string("select ") + kColumns + " from account order by name", {}, kKinds,
                     [&](const Row& row) { all.push_back(accountFrom(row).account); });
    return all;
  });
}

Expected<void> UserRegister::add(const std::string& name, Role role, const std::string& password, const std::string& by,
                                 const std::string& reason) {
  return guarded([&] {
    if (name.empty() || name.size() > kMaxNameLength)
      throw DatabaseFailure({"user", "a name has 1 to 64 characters", ErrorKind::Input});
    const std::string hash = hashed(password);
    Transaction transaction(*database_);
    const bool first = database_->first("select count(*) from account", {}, "i")->integer(0) == 0;
    if (first && role != Role::Administrator)
      throw DatabaseFailure({name, "the first user must be an administrator", ErrorKind::Input});
    if (find(*database_, name)) throw DatabaseFailure({name, "is a user already", ErrorKind::Input});
    const TimeUs now = clock_();
    database_->run(
        "insert into account (name, role, password, created_us, disabled, must_change, failures, locked_until_us) "
        "values (:a, :b, :c, :d, 0, :e, 0, 0)",
        {name, number(role), hash, now, static_cast<std::int64_t>(by == name ? 0 : 1)});
    appendAudit(*database_, now, {by, "user added", name, reason, std::string(vignole::name(role))});
    transaction.commit();
  });
}

void UserRegister::noteFailure(const UserAccount& account, TimeUs now) {
  Transaction transaction(*database_);
  const int failures = findOrThrow(*database_, account.name).account.failures + 1;
  const int locks = settings_.failuresBeforeLock > 0 ? failures / settings_.failuresBeforeLock : 0;
  const bool lock = locks > 0 && failures % settings_.failuresBeforeLock == 0;
  TimeUs until = 0;
  if (lock) {
    until = static_cast<TimeUs>(settings_.lockS * 1e6);
    for (int i = 1; i < locks && until < kDayUs; ++i) until *= 2;
    until = now + std::min(until, kDayUs);
    appendAudit(*database_, now,
                {account.name, "user locked", account.name, std::to_string(failures) + " wrong passwords in a row",
                 "until " + isoTime(until)});
  }
  database_->run("update account set failures = :a, locked_until_us = :b where name = :c",
                 {static_cast<std::int64_t>(failures), until, account.name});
  transaction.commit();
}

Expected<SignIn> UserRegister::signIn(const std::string& name, const std::string& password) {
  return guarded([&]() -> SignIn {
    const TimeUs now = clock_();
    const auto found = find(*database_, name);
    if (!found) {
      const auto held = database_->lock();
      if (nobodysHash_.empty()) nobodysHash_ = orThrow(hashPassword("nobody's", settings_.cost));
      (void)passwordFits(password, nobodysHash_);
      return {};
    }
    SignIn answer;
    if (found->account.lockedUntilUs > now) {  // also for who knows the password: else a guess would tell
      answer.result = SignInResult::Locked;
      answer.account.lockedUntilUs = found->account.lockedUntilUs;
      return answer;
    }
    if (!passwordFits(password, found->hash)) {
      noteFailure(found->account, now);
      return answer;
    }
    if (found->account.disabled) {
      answer.result = SignInResult::Disabled;
      return answer;
    }
    const std::string hash =
        isOfOtherCost(found->hash, settings_.cost) ? orThrow(hashPassword(password, settings_.cost)) : found->hash;
    database_->run(
        "update account set failures = 0, locked_until_us = 0, last_sign_in_us = :a, password = :b where name = :c",
        {now, hash, name});
    answer.result = SignInResult::Welcome;
    answer.account = findOrThrow(*database_, name).account;
    return answer;
  });
}

Expected<void> UserRegister::changePassword(const std::string& name, const std::string& old,
                                            const std::string& password) {
  const auto known = signIn(name, old);  // counts a wrong one as it counts there
  if (!known) return tl::unexpected(known.error());
  if (known->result != SignInResult::Welcome)
    return inputError("password", known->result == SignInResult::Locked
                                      ? "too many wrong ones; locked until " + isoTime(known->account.lockedUntilUs)
                                      : "the old one is wrong");
  return guarded([&] {
    const std::string hash = hashed(password);
    Transaction transaction(*database_);
    database_->run("update account set password = :a, must_change = 0 where name = :b", {hash, name});
    appendAudit(*database_, clock_(), {name, "password changed", name, "by the user", ""});
    transaction.commit();
  });
}

Expected<void> UserRegister::resetPassword(const std::string& name, const std::string& password, const std::string& by,
                                           const std::string& reason) {
  return guarded([&] {
    const std::string hash = hashed(password);
    Transaction transaction(*database_);
    (void)findOrThrow(*database_, name);
    database_->run(
        "update account set password = :a, must_change = 1, failures = 0, locked_until_us = 0 where name = :b",
        {hash, name});
    appendAudit(*database_, clock_(), {by, "password reset", name, reason, ""});
    transaction.commit();
  });
}

void UserRegister::refuseIfLastAdministrator(const UserAccount& account) const {
  if (account.role != Role::Administrator || account.disabled) return;
  const auto others = database_->first("select count(*) from account where role = :a and disabled = 0 and name <> :b",
                                       {number(Role::Administrator), account.name}, "i");
  if (others->integer(0) == 0)
    throw DatabaseFailure({account.name, "is the last administrator; make another one first", ErrorKind::Input});
}

Expected<void> UserRegister::setRole(const std::string& name, Role role, const std::string& by,
                                     const std::string& reason) {
  return guarded([&] {
    Transaction transaction(*database_);
    const UserAccount account = findOrThrow(*database_, name).account;
    if (role != Role::Administrator) refuseIfLastAdministrator(account);
    database_->run("update account set role = :a where name = :b", {number(role), name});
    appendAudit(*database_, clock_(),
                {by, "role changed", name, reason,
                 std::string(vignole::name(account.role)) + " -> " + std::string(vignole::name(role))});
    transaction.commit();
  });
}

Expected<void> UserRegister::setDisabled(const std::string& name, bool disabled, const std::string& by,
                                         const std::string& reason) {
  return guarded([&] {
    Transaction transaction(*database_);
    const UserAccount account = findOrThrow(*database_, name).account;
    if (disabled) refuseIfLastAdministrator(account);
    database_->run("update account set disabled = :a where name = :b",
                   {static_cast<std::int64_t>(disabled ? 1 : 0), name});
    appendAudit(*database_, clock_(), {by, disabled ? "user disabled" : "user enabled", name, reason, ""});
    transaction.commit();
  });
}

}  // namespace vignole
