#include "engine/archive/password.h"

#include <array>
#include <sodium.h>

namespace vignole {

Expected<std::string> hashPassword(std::string_view password, const PasswordCost& cost) {
  std::array<char, crypto_pwhash_STRBYTES> text{};
  if (crypto_pwhash_str_alg(text.data(), password.data(), password.size(), cost.operations, cost.memoryBytes,
                            crypto_pwhash_ALG_ARGON2ID13) != 0)
    return worldError("password", "there is not enough memory to hash it; close other programs");
  return std::string(text.data());
}

bool passwordFits(std::string_view password, const std::string& hash) {
  return crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

bool isOfOtherCost(const std::string& hash, const PasswordCost& cost) {
  return crypto_pwhash_str_needs_rehash(hash.c_str(), cost.operations, cost.memoryBytes) != 0;
}

}  // namespace vignole
