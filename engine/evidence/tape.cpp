#include "engine/evidence/tape.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace vignole {

namespace {

constexpr std::size_t kBlock = 512, kMaxName = 99;
constexpr std::size_t kMaxSize = 077777777777;  ///< eleven octal digits

void put(std::string& header, std::size_t at, std::string_view text) { header.replace(at, text.size(), text); }

std::string octal(std::size_t number, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%0*zo", digits, number);
  return text.data();
}

std::string headerOf(std::string_view name, std::size_t size) {
  std::string header(kBlock, '\0');
  put(header, 0, name);
  put(header, 100, "0000644");
  put(header, 108, "0000000");
  put(header, 116, "0000000");
  put(header, 124, octal(size, 11));
  put(header, 136, "00000000000");
  put(header, 148, "        ");
  put(header, 156, "0");
  put(header, 257, std::string_view("ustar\0", 6));
  put(header, 263, "00");
  std::size_t sum = 0;
  for (const char c : header) sum += static_cast<unsigned char>(c);
  put(header, 148, octal(sum, 6));
  header[154] = '\0';
  return header;
}

std::size_t padded(std::size_t size) { return (size + kBlock - 1) / kBlock * kBlock; }

bool allZero(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) { return c == 0; });
}

}  // namespace

void TapeWriter::add(std::string_view name, std::string_view content) {
  bytes_ += headerOf(name, content.size());
  bytes_ += content;
  bytes_.resize(padded(bytes_.size()), '\0');
}

std::string TapeWriter::finish() {
  bytes_.append(2 * kBlock, '\0');
  return std::move(bytes_);
}

Expected<std::vector<TapeEntry>> readTape(std::string_view bytes) {
  std::vector<TapeEntry> entries;
  const auto refuse = [&](std::size_t at) {
    return inputError("byte " + std::to_string(at),
                      "is not as an evidence pack is written; the file is damaged or none");
  };
  std::size_t at = 0;
  for (;;) {
    if (bytes.size() - at < kBlock) return refuse(at);
    const std::string_view header = bytes.substr(at, kBlock);
    if (header[0] == '\0') {
      if (bytes.size() - at != 2 * kBlock || !allZero(bytes.substr(at))) return refuse(at);
      return entries;
    }
    TapeEntry entry;
    entry.at = at;
    entry.name = header.substr(0, std::min(header.find('\0'), kMaxName));
    if (entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_./-") != std::string::npos)
      return refuse(at);
    std::size_t size = 0;
    for (const char c : header.substr(124, 11)) {
      if (c < '0' || c > '7') return refuse(at + 124);
      size = 8 * size + static_cast<std::size_t>(c - '0');
    }
    if (size > kMaxSize || header != headerOf(entry.name, size)) return refuse(at);
    at += kBlock;
    if (size > bytes.size() - at || padded(size) > bytes.size() - at) return refuse(at);
    entry.content = bytes.substr(at, size);
    if (!allZero(bytes.substr(at + size, padded(size) - size))) return refuse(at + size);
    at += padded(size);
    entries.push_back(std::move(entry));
  }
}

}  // namespace vignole
