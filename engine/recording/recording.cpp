#include "engine/recording/recording.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/acquisition/frame_memory.h"

namespace vignole {

namespace {

constexpr std::size_t kMostProblems = 20;
constexpr std::size_t kSearched = std::size_t{1} << 20U;  // bytes at once while looking for the next head

bool isText(ChunkKind kind) {
  return kind == ChunkKind::Setup || kind == ChunkKind::RailBegin || kind == ChunkKind::Lost ||
         kind == ChunkKind::SourceEnd;
}

bool ofCamera(const ChunkHead& head) { return head.camera < kCameraCount; }

std::string textOf(const PackedBytes& bytes) { return {bytes.begin(), bytes.end()}; }

std::string plural(std::uint64_t n, const std::string& word) {
  return std::to_string(n) + " " + word + (n == 1 ? "" : "s");
}

}  // namespace

Recording::~Recording() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Expected<std::shared_ptr<const Recording>> Recording::open(const std::filesystem::path& file) {
  std::shared_ptr<Recording> recording(new Recording(file));
  if (auto loaded = recording->load(); !loaded) return tl::unexpected(loaded.error());
  return recording;
}

void Recording::problem(std::string line) {
  if (problems_.size() < kMostProblems) problems_.push_back(std::move(line));
}

bool Recording::readAt(std::uint64_t offset, std::span<std::uint8_t> to) const {
  while (!to.empty()) {
    const ssize_t n = ::pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    offset += static_cast<std::uint64_t>(n);
    to = to.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

Expected<void> Recording::load() {
  const std::string name = file_.string();
  descriptor_ = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  const int reason = errno;
  struct stat status {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
    if (reason == ENOENT) return inputError(name, "does not exist; check the name and the folder");
    return inputError(name, std::string("cannot be read: ") + std::strerror(reason));  // NOLINT: glibc's is safe
  }
  if (!S_ISREG(status.st_mode)) return inputError(name, "is no file; give a recording");
  bytes_ = static_cast<std::uint64_t>(status.st_size);
  std::array<std::uint8_t, kRecordingSignature.size()> signature{};
  if (!readAt(0, signature) || std::memcmp(signature.data(), kRecordingSignature.data(), signature.size()) != 0)
    return inputError(name, "is no recording (or its beginning is damaged)");
  closed_ = loadIndex();
  if (!closed_) scan();
  interpret();
  if (chunks_.empty()) return inputError(name, "holds nothing that can be read; it was cut off at its beginning");
  return {};
}

bool Recording::loadIndex() {
  ChunkHeadBytes bytes{};
  if (bytes_ < kRecordingSignature.size() + 2 * kChunkHeadSize) return false;
  if (!readAt(bytes_ - kChunkHeadSize, bytes)) return false;
  const auto last = readHead(bytes);
  if (!last || last->kind != ChunkKind::Last || last->trigger > bytes_ - 2 * kChunkHeadSize) return false;
  ChunkPlace index;
  index.offset = last->trigger;
  if (!readAt(index.offset, bytes)) return false;
  const auto head = readHead(bytes);
  // No more chunks than heads would have room.
  if (!head || head->kind != ChunkKind::Index || head->trigger > index.offset / kChunkHeadSize) return false;
  index.head = *head;
  const auto packed = read(index);
  if (!packed) return false;
  auto chunks = unpackedIndex(*packed, head->trigger);
  if (!chunks) return false;
  std::uint64_t end = kRecordingSignature.size();
  for (const ChunkPlace& chunk : *chunks) {
    if (chunk.offset < end || chunk.offset > index.offset) return false;
    end = chunk.offset + kChunkHeadSize + chunk.head.size;
  }
  if (end > index.offset) return false;
  chunks_ = std::move(*chunks);
  return true;
}

// Head by head; where there is none, to the next one.
void Recording::scan() {
  std::vector<std::uint8_t> searched;
  std::uint64_t at = kRecordingSignature.size(), damagedFrom = 0;
  bool lost = false;
  const auto foundAgain = [&] {
    if (lost) {
      damagedBytes_ += at - damagedFrom;
      problem("bytes " + std::to_string(damagedFrom) + " to " + std::to_string(at) + " are damaged");
    }
    lost = false;
  };
  ChunkHeadBytes bytes{};
  while (at + kChunkHeadSize <= bytes_) {
    const auto head = readAt(at, bytes) ? readHead(bytes) : std::nullopt;
    const bool fits =
        head && head->size <= bytes_ - at - kChunkHeadSize && (!isText(head->kind) || head->size <= kLongestText);
    if (fits) {
      foundAgain();
      if (head->kind != ChunkKind::Index && head->kind != ChunkKind::Last) chunks_.push_back({*head, at});
      at += kChunkHeadSize + head->size;
      continue;
    }
    if (!lost) damagedFrom = at;
    lost = true;
    ++at;
    const std::size_t size = static_cast<std::size_t>(std::min<std::uint64_t>(kSearched, bytes_ - at));
    searched.resize(size);
    if (!readAt(at, searched)) break;
    constexpr std::string_view kMagic = "VgRc";
    const auto next = std::search(searched.begin(), searched.end(), kMagic.begin(), kMagic.end());
    // A magic word may lie across the end of what was searched.
    at += next != searched.end() ? static_cast<std::uint64_t>(next - searched.begin())
                                 : std::max<std::uint64_t>(size, kMagic.size()) - (kMagic.size() - 1);
    if (next == searched.end() && size < kSearched) break;
  }
  if (lost) {
    at = bytes_;
    foundAgain();
  } else if (at < bytes_) {
    damagedBytes_ += bytes_ - at;
    problem("the last " + plural(bytes_ - at, "byte") + " are the beginning of something that was cut off");
  }
  if (problems_.empty()) problem("was not closed: it has no index, and may lack its end");
}

Expected<PackedBytes> Recording::read(const ChunkPlace& chunk) const {
  PackedBytes bytes;
  if (chunk.offset > bytes_ || chunk.head.size > bytes_ - std::min(bytes_, chunk.offset + kChunkHeadSize))
    return inputError(file_.string(), "has a chunk that reaches beyond its end");
  bytes.resize(chunk.head.size);
  if (!readAt(chunk.offset + kChunkHeadSize, bytes))
    return worldError(file_.string(), "cannot be read at byte " + std::to_string(chunk.offset));
  if (checksumOf(bytes) != chunk.head.checksum)
    return inputError(file_.string(), "is damaged at byte " + std::to_string(chunk.offset));
  return bytes;
}

void Recording::interpretText(std::size_t chunk) {
  const ChunkPlace& place = chunks_[chunk];
  if (place.head.size > kLongestText) return problem("a text of " + plural(place.head.size, "byte") + " is none");
  const auto bytes = read(place);
  if (!bytes) return problem(bytes.error().what);
  const std::string text = textOf(*bytes);
  if (place.head.kind == ChunkKind::Setup) {
    if (setup_) {
      setupChanges_ = setupChanges_ || text != setupText_;
      return;
    }
    auto setup = parseSetup(text, file_.string());
    if (!setup) return problem(setup.error().message());
    setup_ = std::move(*setup);
    setupText_ = text;
  } else if (place.head.kind == ChunkKind::RailBegin && ofCamera(place.head)) {
    auto begin = parseRailBegin(text, file_.string());
    if (!begin) return problem(begin.error().what);
    std::size_t rail = 0;
    while (rail < rails_.size() && (rails_[rail].begin.rail.firstTrigger != begin->rail.firstTrigger ||
                                    rails_[rail].begin.rail.id != begin->rail.id))
      ++rail;
    events_[place.head.camera].push_back({RecordedEvent::Kind::RailBegin, begin->rail.firstTrigger, rail});
    if (rail == rails_.size()) rails_.push_back({std::move(*begin), {}});
  } else if (place.head.kind == ChunkKind::SourceEnd && ofCamera(place.head)) {
    endErrors_[place.head.camera] = text;
  }
}

void Recording::interpret() {
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const ChunkHead& head = chunks_[i].head;
    const auto event = [&](RecordedEvent::Kind kind) {
      if (ofCamera(head)) events_[head.camera].push_back({kind, head.trigger, i});
    };
    switch (head.kind) {
      case ChunkKind::Setup:
      case ChunkKind::RailBegin:
      case ChunkKind::SourceEnd:
        interpretText(i);
        break;
      case ChunkKind::Frame:
        event(RecordedEvent::Kind::Frame);
        ++frames_;
        break;
      case ChunkKind::Lost:
        event(RecordedEvent::Kind::Lost);
        break;
      case ChunkKind::Dropped:
        dropped_.insert(head.trigger);
        break;
      case ChunkKind::RailEnd:
        event(RecordedEvent::Kind::RailEnd);
        break;
      case ChunkKind::Index:
      case ChunkKind::Last:
        break;
    }
  }
  order();
}

std::size_t Recording::railOf(std::uint64_t trigger) const {
  std::size_t rail = rails_.size();
  for (std::size_t r = 0; r < rails_.size(); ++r)
    if (rails_[r].begin.rail.firstTrigger <= trigger &&
        (rail == rails_.size() || rails_[r].begin.rail.firstTrigger >= rails_[rail].begin.rail.firstTrigger))
      rail = r;
  return rail;
}

void Recording::order() {
  // Frames that no rail is told for: the rail's beginning is damaged.
  if (rails_.empty() && frames_ > 0) {
    std::uint64_t first = ~std::uint64_t{0};
    for (const auto& events : events_)
      for (const RecordedEvent& e : events)
        if (e.kind == RecordedEvent::Kind::Frame) first = std::min(first, e.trigger);
    RecordedRail rail;
    rail.begin.rail.id = "unknown";
    rail.begin.rail.firstTrigger = first;
    rails_.push_back(rail);
    for (auto& events : events_) events.push_back({RecordedEvent::Kind::RailBegin, first, 0});
    problem("no rail's beginning can be read; its frames are taken as one rail \"unknown\"");
  }
  std::set<std::uint64_t> counted;
  for (auto& events : events_) {
    for (const std::uint64_t trigger : dropped_) {
      std::erase_if(events, [trigger](const RecordedEvent& e) {
        return e.trigger == trigger && (e.kind == RecordedEvent::Kind::Frame || e.kind == RecordedEvent::Kind::Lost);
      });
      events.push_back({RecordedEvent::Kind::Dropped, trigger, 0});
    }
    std::stable_sort(events.begin(), events.end(), [](const RecordedEvent& a, const RecordedEvent& b) {
      return a.trigger != b.trigger ? a.trigger < b.trigger : a.kind < b.kind;
    });
    for (const RecordedEvent& e : events) {
      const std::size_t r = railOf(e.kind == RecordedEvent::Kind::RailEnd && e.trigger > 0 ? e.trigger - 1 : e.trigger);
      if (r == rails_.size()) continue;
      RecordedRail& rail = rails_[r];
      if (e.kind == RecordedEvent::Kind::RailEnd) rail.endTrigger = std::max(rail.endTrigger.value_or(0), e.trigger);
      if (e.kind == RecordedEvent::Kind::Lost) ++rail.lost;
      if (e.kind == RecordedEvent::Kind::Dropped && &events == &events_[0]) ++rail.dropped;
      if (e.kind != RecordedEvent::Kind::Frame) continue;
      ++rail.frames;
      rail.triggers += counted.insert(e.trigger).second ? 1 : 0;
    }
  }
  for (const ChunkPlace& chunk : chunks_) {
    if (chunk.head.kind != ChunkKind::Frame) continue;
    std::uint8_t kind = 0;
    if (chunk.head.size > 0 && readAt(chunk.offset + kChunkHeadSize, {&kind, 1}) &&
        kind == static_cast<std::uint8_t>(FrameKind::Sparse)) {
      sparse_ = true;
      break;
    }
  }
}

Expected<void> Recording::allows(const StripeSettings& settings) const {
  if (!sparse_ || settings.sigma <= kSparseMaxSigma) return {};
  return inputError(file_.string(), "was recorded sparsely, which is good for sigma up to 4 px, not for the recipe's " +
                                        std::to_string(settings.sigma) +
                                        "; use a recipe with less, or record whole frames (--record-full)");
}

Expected<Frame> Recording::frame(int camera, std::uint64_t trigger) const {
  const std::string who = "camera " + std::to_string(camera + 1) + " at trigger " + std::to_string(trigger);
  if (camera < 0 || camera >= kCameraCount) return inputError(file_.string(), "has no " + who);
  const auto& events = events_[static_cast<std::size_t>(camera)];
  auto found = std::lower_bound(events.begin(), events.end(), trigger,
                                [](const RecordedEvent& e, std::uint64_t t) { return e.trigger < t; });
  while (found != events.end() && found->trigger == trigger && found->kind != RecordedEvent::Kind::Frame) ++found;
  if (found == events.end() || found->trigger != trigger) return inputError(file_.string(), "has no frame of " + who);
  const auto packed = read(chunks_[found->chunk]);
  if (!packed) return tl::unexpected(packed.error());
  const auto size = packedSize(*packed);
  if (!size) return inputError(file_.string() + ", " + who, size.error().what);
  const std::size_t bytes = static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height);
  std::shared_ptr<std::uint8_t[]> pixels(makeFrameMemory(bytes).release(), FrameMemoryFree{});
  const MutableImageView image{pixels.get(), size->width, size->height, size->width};
  FrameUnpacker unpacker;
  if (auto done = unpacker.unpack(*packed, image); !done)
    return inputError(file_.string() + ", " + who, done.error().what);
  return Frame{camera, trigger, image, pixels};
}

}  // namespace vignole
