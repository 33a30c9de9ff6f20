#include "engine/recording/recording_writer.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

namespace vignole {

namespace fs = std::filesystem;

namespace {

constexpr int kMostParts = 1000;

std::string because() { return std::strerror(errno); }  // NOLINT(concurrency-mt-unsafe): glibc's is thread-safe

bool writeAll(int descriptor, std::span<const std::uint8_t> head, std::span<const std::uint8_t> bytes) {
  while (!head.empty() || !bytes.empty()) {
    std::array<iovec, 2> parts{};
    // writev does not change what it writes.
    parts[0] = {const_cast<std::uint8_t*>(head.data()), head.size()};
    parts[1] = {const_cast<std::uint8_t*>(bytes.data()), bytes.size()};
    const ssize_t n = ::writev(descriptor, parts.data(), 2);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    const auto done = static_cast<std::size_t>(n), ofHead = std::min(done, head.size());
    head = head.subspan(ofHead);
    bytes = bytes.subspan(done - ofHead);
  }
  return true;
}

void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

std::int64_t recordingTimeUs() {
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

Expected<std::shared_ptr<RecordingWriter>> RecordingWriter::create(const fs::path& file) {
  std::error_code ignored;
  if (file.filename().empty() || fs::is_directory(file, ignored))
    return inputError(file.string(), "is a folder; give a file's name");
  if (!fs::is_directory(folderOf(file), ignored))
    return inputError(file.string(), "cannot be written: its folder does not exist; create it first");
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
    return inputError(file.string(), "is no ordinary file; a recording needs one");
  std::shared_ptr<RecordingWriter> writer(new RecordingWriter);
  writer->target_ = file;
  for (int i = 1; i < kMostParts && writer->descriptor_ < 0; ++i) {
    writer->part_ = file.string() + ".part" + (i == 1 ? "" : std::to_string(i));
    writer->descriptor_ = ::open(writer->part_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (writer->descriptor_ < 0 && errno != EEXIST) break;
  }
  if (writer->descriptor_ < 0) return worldError(file.string(), "cannot be written: " + because());
  const std::span signature(reinterpret_cast<const std::uint8_t*>(kRecordingSignature.data()),
                            kRecordingSignature.size());
  if (!writeAll(writer->descriptor_, signature, {})) {
    const std::string reason = because();
    writer->discard();
    return worldError(file.string(), "cannot be written: " + reason);
  }
  writer->end_ = signature.size();
  syncFolder(folderOf(file));
  return writer;
}

RecordingWriter::~RecordingWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool RecordingWriter::append(ChunkHead head, std::span<const std::uint8_t> bytes) {
  if (!failure_.empty()) return false;
  head.size = static_cast<std::uint32_t>(bytes.size());
  head.checksum = checksumOf(bytes);
  if (head.timeUs == 0) head.timeUs = recordingTimeUs();
  const ChunkHeadBytes headBytes = written(head);
  if (!writeAll(descriptor_, headBytes, bytes)) {
    fail();
    return false;
  }
  chunks_.push_back({head, end_});
  end_ += kChunkHeadSize + bytes.size();
  return true;
}

bool RecordingWriter::append(ChunkHead head, std::string_view text) {
  return append(head, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void RecordingWriter::fail() {
  failure_ = because();
  // Nothing half-written stays behind.
  if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) failure_ += " (and the last chunk is cut off)";
}

void RecordingWriter::sync() const { (void)::fdatasync(descriptor_); }

Expected<void> RecordingWriter::commit() {
  const std::uint64_t count = chunks_.size(), at = end_;
  const std::vector<std::uint8_t> index = packedIndex(chunks_);
  ChunkHead indexHead{.kind = ChunkKind::Index, .trigger = count}, last{.kind = ChunkKind::Last, .trigger = at};
  if (!append(indexHead, index) || !append(last))
    return worldError(target_.string(),
                      "could not be written to its end: " + failure_ + "; what was recorded is in " + part_.string());
  if (::fsync(descriptor_) != 0 || std::rename(part_.c_str(), target_.c_str()) != 0)
    return worldError(target_.string(), "could not be closed: " + because() + "; it is in " + part_.string());
  syncFolder(folderOf(target_));
  return {};
}

void RecordingWriter::discard() { ::unlink(part_.c_str()); }

}  // namespace vignole
