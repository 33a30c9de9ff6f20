#pragma once
// Files that are written whole or not at all: temporary file beside the target, fsync, rename.

#include <cstdio>
#include <filesystem>
#include <string_view>

#include "engine/geometry/expected.h"

namespace vignole {

/// Written piece by piece; nothing is seen at `target` before commit(), and nothing is left behind without it.
class AtomicFile {
 public:
  [[nodiscard]] static Expected<AtomicFile> create(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;

  /// Errors are kept and told by commit().
  void write(std::string_view text);
  /// `keepPrevious`: what was at the target stays as TARGET~.
  [[nodiscard]] Expected<void> commit(bool keepPrevious = false);

 private:
  AtomicFile() = default;
  void discard() noexcept;
  std::FILE* file_ = nullptr;
  std::filesystem::path target_, temporary_;
  bool failed_ = false;
};

[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& target, std::string_view text,
                                       bool keepPrevious = false);
/// Whole file as text; the error says whether it is missing, a folder or unreadable.
[[nodiscard]] Expected<std::string> readFile(const std::filesystem::path& file);

}  // namespace vignole
