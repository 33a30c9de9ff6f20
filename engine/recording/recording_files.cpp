#include "engine/recording/recording_files.h"

#include <algorithm>
#include <cctype>
#include <ctime>
#include <fstream>
#include <utility>

namespace vignole {

namespace fs = std::filesystem;

namespace {

constexpr const char* kExtension = ".vgr";
constexpr std::uint64_t kMega = 1'000'000;
constexpr std::uint64_t kCamerasApart = 256;  // triggers: what belongs to an older file has come by then

/// A rail's name as part of a file's.
std::string fileWord(const std::string& id) {
  std::string word;
  for (const char c : id.substr(0, 64)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    word += plain ? c : '_';
  }
  return word.empty() ? "rail" : word;
}

std::string timeWord() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc)};
}

fs::path numbered(const fs::path& file, std::uint64_t number) {
  fs::path next = file;
  next.replace_filename(file.stem().string() + "-" + std::to_string(number) + file.extension().string());
  return next;
}

std::span<const std::uint8_t> asBytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

bool isRecording(const fs::path& file) {
  std::array<char, kRecordingSignature.size()> first{};
  std::ifstream in(file, std::ios::binary);
  return in.read(first.data(), first.size()) && std::string_view(first.data(), first.size()) == kRecordingSignature;
}

}  // namespace

void pruneRecordings(const fs::path& folder, std::uint64_t mostMb, const fs::path& latest) {
  struct Found {
    fs::file_time_type time;
    fs::path path;
    std::uint64_t bytes;
  };
  std::vector<Found> found;
  std::uint64_t sum = 0;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().extension() != kExtension || !entry.is_regular_file(failed) || !isRecording(entry.path()))
      continue;
    found.push_back({entry.last_write_time(failed), entry.path(), entry.file_size(failed)});
    sum += found.back().bytes;
  }
  std::sort(found.begin(), found.end(),
            [](const Found& a, const Found& b) { return a.time != b.time ? a.time < b.time : a.path < b.path; });
  for (const Found& oldest : found) {
    if (sum <= mostMb * kMega) return;
    if (oldest.path.filename() == latest.filename() || !fs::remove(oldest.path, failed)) continue;
    sum -= oldest.bytes;
  }
}

RecordingFiles::RecordingFiles(RecordingOrder order) : order_(std::move(order)) {
  std::error_code ignored;
  folder_ = fs::is_directory(order_.path, ignored);
}

Expected<std::unique_ptr<RecordingFiles>> RecordingFiles::open(RecordingOrder order, std::uint64_t fromTrigger) {
  std::unique_ptr<RecordingFiles> files(new RecordingFiles(std::move(order)));
  if (files->folder_) return files;
  if (!files->order_.keep.all)
    return inputError(files->order_.path.string(),
                      "is no folder; rails are kept or dropped one by one only in a folder that exists");
  File file;
  file.from = fromTrigger;
  file.keep = true;
  if (auto made = files->make(file, files->order_.path); !made) return tl::unexpected(made.error());
  files->files_.push_back(std::move(file));
  return files;
}

Expected<void> RecordingFiles::make(File& file, const fs::path& path) {
  auto writer = RecordingWriter::create(path);
  if (!writer) return tl::unexpected(writer.error());
  file.writer = std::move(*writer);
  if (!file.writer->append({.kind = ChunkKind::Setup}, toJson(order_.setup))) {
    const std::string reason = file.writer->failure();
    file.writer->discard();
    return worldError(path.string(), "cannot be written: " + reason);
  }
  bytes_ += file.writer->bytes();
  const std::scoped_lock lock(mutex_);
  writers_.push_back(file.writer);
  return {};
}

RecordingFiles::File* RecordingFiles::fileOf(std::uint64_t trigger) {
  const auto found =
      std::find_if(files_.rbegin(), files_.rend(), [trigger](const File& f) { return f.from <= trigger; });
  return found == files_.rend() ? nullptr : &*found;
}

RecordingFiles::File* RecordingFiles::fileOf(const RailBegin& rail) {
  const auto found = std::find_if(files_.rbegin(), files_.rend(), [&rail](const File& f) {
    return f.rail && f.rail->id == rail.id && f.rail->firstTrigger == rail.firstTrigger;
  });
  return found == files_.rend() ? nullptr : &*found;
}

bool RecordingFiles::wants(std::uint64_t trigger) const {
  const auto found =
      std::find_if(files_.rbegin(), files_.rend(), [trigger](const File& f) { return f.from <= trigger; });
  return found != files_.rend() && found->writer && found->writer->failure().empty();
}

fs::path RecordingFiles::nextPath() {
  if (!folder_) return numbered(order_.path, ++parts_);
  const RailBegin& rail = *files_.back().rail;
  const fs::path path = order_.path / (fileWord(rail.id) + "-" + timeWord() + kExtension);
  std::error_code ignored;
  for (std::uint64_t n = 1;; ++n) {
    const fs::path candidate = n == 1 ? path : numbered(path, n);
    fs::path part = candidate;
    part += ".part";
    if (!fs::exists(candidate, ignored) && !fs::exists(part, ignored)) return candidate;
  }
}

void RecordingFiles::makeForRail(const RailBegin& rail, std::uint64_t from) {
  const KeepPolicy& keep = order_.keep;
  File& file = files_.emplace_back();
  file.from = from;
  file.rail = rail;
  file.keep = keep.all || (keep.everyNth > 0 && rails_ % keep.everyNth == 0);
  ++rails_;
  // Whoever asks for it in the middle of the rail gets it from its beginning only if it is written all along.
  if (auto made = make(file, nextPath()); !made) fail(made.error());
}

void RecordingFiles::begin(int camera, const RailBegin& rail, std::uint64_t from) {
  File* file = folder_ ? fileOf(rail) : fileOf(from);
  if (folder_ && file == nullptr) {
    makeForRail(rail, from);
    file = &files_.back();
  }
  if (file == nullptr || !file->writer) return;
  file->rail = rail;
  writeBegin(*file, camera, rail, std::max(from, file->from));
}

void RecordingFiles::writeBegin(File& file, int camera, const RailBegin& rail, std::uint64_t from) {
  RecordedRailBegin begin{rail, {}};
  if (order_.notes) begin.notes = order_.notes(rail);
  if (from > rail.firstTrigger) {  // a part of the rail: the head has passed
    begin.rail.beginsAtMm += static_cast<double>(from - rail.firstTrigger) * rail.spacingMm;
    begin.rail.firstTrigger = from;
  }
  const std::string text = toJson(begin);
  const ChunkHead head{
      .kind = ChunkKind::RailBegin, .camera = static_cast<std::uint8_t>(camera), .trigger = begin.rail.firstTrigger};
  if (file.writer->append(head, text))
    bytes_ += kChunkHeadSize + text.size();
  else
    fail({file.writer->part().string(), "cannot be written: " + file.writer->failure(), ErrorKind::World});
}

void RecordingFiles::add(const ChunkHead& head, std::span<const std::uint8_t> bytes) {
  const bool behind = head.kind == ChunkKind::RailEnd || head.kind == ChunkKind::SourceEnd;
  File* file = fileOf(behind && head.trigger > 0 ? head.trigger - 1 : head.trigger);
  if (file == nullptr || !file->writer) return;
  highest_ = std::max(highest_, head.trigger);
  if (!file->writer->append(head, bytes)) {
    fail({file->writer->part().string(), "cannot be written: " + file->writer->failure(), ErrorKind::World});
    return;
  }
  bytes_ += kChunkHeadSize + bytes.size();
  if (order_.mostMbOfFile == 0 || file != &files_.back()) return;
  if (file->rail && file->writer->bytes() >= order_.mostMbOfFile * kMega) growOver(*file);
  // The file before has got all that belongs to it.
  if (!folder_ && files_.size() > 1 && highest_ > files_[1].from + kCamerasApart) finish(files_.begin(), true);
}

void RecordingFiles::growOver(File& full) {
  File next;
  next.from = highest_ + 1;
  next.rail = full.rail;
  next.keep = full.keep;
  if (auto made = make(next, nextPath()); !made) {
    fail(made.error());
    return;
  }
  files_.push_back(std::move(next));
  File& file = files_.back();
  for (int camera = 0; camera < kCameraCount; ++camera) writeBegin(file, camera, *file.rail, file.from);
}

void RecordingFiles::passed(const RailBegin& rail, Verdict verdict) {
  if (!folder_) return;
  const bool rejected = verdict == Verdict::Fail || verdict == Verdict::NotMeasured;
  for (auto file = files_.begin(); file != files_.end();) {
    if (!file->rail || file->rail->id != rail.id || file->rail->firstTrigger != rail.firstTrigger) {
      ++file;
      continue;
    }
    const auto at = file - files_.begin();
    finish(file, file->keep || (order_.keep.rejected && rejected));
    file = files_.begin() + at;
  }
}

void RecordingFiles::keepLatest() {
  if (!files_.empty()) files_.back().keep = true;
}

void RecordingFiles::use(Recipe recipe, RigCalibration calibration) {
  order_.setup.recipe = std::move(recipe);
  order_.setup.calibration = std::move(calibration);
  // In the file for everything it holds for the rails behind.
  if (!folder_ && !files_.empty() && files_.back().writer)
    add({.kind = ChunkKind::Setup, .trigger = highest_}, asBytes(toJson(order_.setup)));
}

void RecordingFiles::finish(std::deque<File>::iterator file, bool keep) {
  const std::shared_ptr<RecordingWriter> writer = std::move(file->writer);
  files_.erase(file);
  if (!writer) return;
  {
    const std::scoped_lock lock(mutex_);
    std::erase(writers_, writer);
  }
  if (!keep) {
    writer->discard();
    ++discarded_;
    return;
  }
  fs::path closed = writer->part();
  if (auto done = writer->commit(); !done)
    fail(done.error());
  else
    ++kept_;
  if (folder_ && order_.mostMbOfFolder > 0)
    pruneRecordings(order_.path, order_.mostMbOfFolder, closed.replace_extension());
}

Expected<void> RecordingFiles::close() {
  while (!files_.empty()) finish(files_.begin(), true);
  return error_ ? Expected<void>(tl::unexpected(*error_)) : Expected<void>();
}

void RecordingFiles::sync() const {
  std::vector<std::shared_ptr<RecordingWriter>> now;
  {
    const std::scoped_lock lock(mutex_);
    now = writers_;
  }
  for (const auto& writer : now) writer->sync();
}

void RecordingFiles::fail(const Error& error) {
  if (error_) return;
  error_ = error;
  const std::scoped_lock lock(mutex_);
  failure_ = error.message();
}

std::string RecordingFiles::failure() const {
  const std::scoped_lock lock(mutex_);
  return failure_;
}

}  // namespace vignole
