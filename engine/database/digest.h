#pragma once
// Digests (BLAKE2b, 256 bit, as 64 hexadecimal digits) over values, each with its kind and length so that no two lists
// of values look the same.

#include <string>
#include <string_view>

#include "engine/database/database.h"

namespace vignole {

class Digest {
 public:
  Digest();
  void add(const SqlValue& value);
  void add(const Row& row);
  [[nodiscard]] std::string finish();

 private:
  struct alignas(64) State {
    unsigned char bytes[384];
  };
  void bytes(const void* data, std::size_t size);
  State state_;
};

[[nodiscard]] std::string digestOf(std::string_view text);
/// 32 random hexadecimal digits: the name of a thing in every archive.
[[nodiscard]] std::string newUid();

}  // namespace vignole
