#include "engine/database/digest.h"

#include <array>
#include <bit>
#include <sodium.h>

namespace vignole {

namespace {

crypto_generichash_state* stateOf(void* bytes) { return static_cast<crypto_generichash_state*>(bytes); }

template <std::size_t N>
std::string hexOf(const std::array<unsigned char, N>& bytes) {
  std::array<char, 2 * N + 1> text{};
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  return text.data();
}

}  // namespace

Digest::Digest() : state_{} {
  static_assert(sizeof(State) >= sizeof(crypto_generichash_state) &&
                alignof(State) >= alignof(crypto_generichash_state));
  crypto_generichash_init(stateOf(&state_), nullptr, 0, crypto_generichash_BYTES);
}

void Digest::bytes(const void* data, std::size_t size) {
  crypto_generichash_update(stateOf(&state_), static_cast<const unsigned char*>(data), size);
}

void Digest::add(const SqlValue& value) {
  const auto whole = [this](char kind, std::uint64_t number) {
    std::array<unsigned char, 9> all{static_cast<unsigned char>(kind)};
    for (std::size_t i = 0; i < 8; ++i) all[i + 1] = static_cast<unsigned char>(number >> (8 * i));
    bytes(all.data(), all.size());
  };
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    whole('i', static_cast<std::uint64_t>(*integer));
  } else if (const auto* real = std::get_if<double>(&value)) {
    whole('r', std::bit_cast<std::uint64_t>(*real));
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    whole('t', text->size());
    bytes(text->data(), text->size());
  } else if (const auto* content = std::get_if<Bytes>(&value)) {
    whole('b', content->size());
    bytes(content->data(), content->size());
  } else {
    whole('n', 0);
  }
}

void Digest::add(const Row& row) {
  for (std::size_t i = 0; i < row.size(); ++i) add(row.value(i));
}

std::string Digest::finish() {
  std::array<unsigned char, crypto_generichash_BYTES> digest{};
  crypto_generichash_final(stateOf(&state_), digest.data(), digest.size());
  return hexOf(digest);
}

std::string digestOf(std::string_view text) {
  Digest digest;
  digest.add(SqlValue(std::string(text)));
  return digest.finish();
}

std::string newUid() {
  std::array<unsigned char, 16> random{};
  randombytes_buf(random.data(), random.size());
  return hexOf(random);
}

}  // namespace vignole
