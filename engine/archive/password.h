#pragma once
// Passwords: Argon2id by libsodium, never our own.

#include <string>
#include <string_view>

#include "engine/geometry/expected.h"

namespace vignole {

/// What one hash costs; the default is libsodium's for a person who waits (64 MiB, some 0.1 s).
struct PasswordCost {
  unsigned long long operations = 2;
  std::size_t memoryBytes = 64U << 20U;
};

/// Salted: the same password gives another text each time.
[[nodiscard]] Expected<std::string> hashPassword(std::string_view password, const PasswordCost& cost = {});
/// In a time that does not depend on where it is wrong.
[[nodiscard]] bool passwordFits(std::string_view password, const std::string& hash);
/// Made with another cost than this one.
[[nodiscard]] bool isOfOtherCost(const std::string& hash, const PasswordCost& cost);

}  // namespace vignole
