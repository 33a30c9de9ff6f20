#include "engine/files/atomic_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace vignole {

namespace fs = std::filesystem;

namespace {

std::string because() { return std::strerror(errno); }  // NOLINT(concurrency-mt-unsafe): glibc's is thread-safe

/// Where the bytes shall end: a link is followed, so that the link itself stays.
fs::path resolved(const fs::path& target) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(target, ignored);
  return real.empty() ? target : real;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// A device or a pipe (/dev/null, /dev/stdout) cannot be replaced by a file and is written straight away.
bool isStream(const fs::path& target) {
  struct stat s {};
  return ::stat(target.c_str(), &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode);
}

fs::path temporaryBeside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  return folderOf(target) / ("." + target.filename().string() + "." + std::to_string(::getpid()) + "." +
                             std::to_string(counter.fetch_add(1)) + ".tmp");
}

void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);  // some file systems refuse it on folders; the rename is done all the same
  ::close(descriptor);
}

/// A second name for what is at the target, so that there is a file under its own name at every moment.
bool keepAs(const fs::path& target, const fs::path& previous) {
  ::unlink(previous.c_str());
  if (::link(target.c_str(), previous.c_str()) == 0 || errno == ENOENT) return true;
  std::error_code failed;  // no hard links here (FAT, some network shares)
  fs::copy_file(target, previous, fs::copy_options::overwrite_existing, failed);
  return !failed;
}

}  // namespace

Expected<AtomicFile> AtomicFile::create(const fs::path& target) {
  std::error_code ignored;
  if (target.empty()) return inputError("output file", "has no name");
  if (fs::is_directory(target, ignored)) return inputError(target.string(), "is a folder; give a file's name");

  AtomicFile file;
  int descriptor = -1;
  if (isStream(target)) {
    file.target_ = target;
    descriptor = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    file.target_ = resolved(target);
    if (!fs::is_directory(folderOf(file.target_), ignored))
      return inputError(target.string(), "cannot be written: its folder does not exist; create it first");
    file.temporary_ = temporaryBeside(file.target_);
    descriptor = ::open(file.temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  }
  if (descriptor < 0) {
    file.temporary_.clear();
    return worldError(target.string(), "cannot be written: " + because());
  }
  file.file_ = ::fdopen(descriptor, "wb");
  if (file.file_ == nullptr) {
    ::close(descriptor);
    return worldError(target.string(), "cannot be written: " + because());
  }
  return file;
}

AtomicFile::~AtomicFile() { discard(); }

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : file_(std::exchange(other.file_, nullptr)),
      target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      failed_(other.failed_) {
  other.temporary_.clear();
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  file_ = std::exchange(other.file_, nullptr);
  target_ = std::move(other.target_);
  temporary_ = std::move(other.temporary_);
  other.temporary_.clear();
  failed_ = other.failed_;
  return *this;
}

void AtomicFile::discard() noexcept {
  if (file_ != nullptr) std::fclose(file_);
  file_ = nullptr;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

void AtomicFile::write(std::string_view text) {
  if (file_ == nullptr || failed_) return;
  failed_ = std::fwrite(text.data(), 1, text.size(), file_) != text.size();
}

Expected<void> AtomicFile::commit(bool keepPrevious) {
  if (file_ == nullptr) return worldError(target_.string(), "was committed before");
  const bool replaces = !temporary_.empty();
  bool good = !failed_ && std::fflush(file_) == 0 && (!replaces || ::fsync(::fileno(file_)) == 0);
  std::string reason = good ? std::string() : because();
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && good) {
    good = false;
    reason = because();
  }
  if (good && replaces) {
    if (keepPrevious && !keepAs(target_, target_.string() + "~")) {
      good = false;
      reason = "the previous version cannot be kept as " + target_.string() + "~";
    } else if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
      good = false;
      reason = because();
    }
  }
  if (!good) {
    discard();
    return worldError(target_.string(), "could not be written: " + reason);
  }
  temporary_.clear();
  if (replaces) syncFolder(folderOf(target_));
  return {};
}

Expected<void> writeFile(const fs::path& target, std::string_view text, bool keepPrevious) {
  auto file = AtomicFile::create(target);
  if (!file) return tl::unexpected(file.error());
  file->write(text);
  return file->commit(keepPrevious);
}

Expected<std::string> readFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return inputError(file.string(), "is a folder; give a file");
  std::FILE* stream = std::fopen(file.c_str(), "rb");
  if (stream == nullptr) {
    if (errno == ENOENT) return inputError(file.string(), "does not exist; check the name and the folder");
    return inputError(file.string(), "cannot be read: " + because());
  }
  std::string text;
  std::array<char, 65536> block{};
  std::size_t n = 0;
  while ((n = std::fread(block.data(), 1, block.size(), stream)) > 0) text.append(block.data(), n);
  const bool bad = std::ferror(stream) != 0;
  const std::string reason = bad ? because() : std::string();
  std::fclose(stream);
  if (bad) return worldError(file.string(), "cannot be read to its end: " + reason);
  return text;
}

}  // namespace vignole
