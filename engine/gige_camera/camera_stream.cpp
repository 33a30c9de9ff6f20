#include "engine/gige_camera/camera_stream.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <netinet/in.h>
#include <sys/socket.h>
#include <utility>

#include "engine/acquisition/frame_memory.h"

namespace vignole::gige {

namespace {

const char* wordFor(ArvBufferStatus status) {
  switch (status) {
    case ARV_BUFFER_STATUS_SUCCESS:
      return "success";
    case ARV_BUFFER_STATUS_CLEARED:
      return "cleared";
    case ARV_BUFFER_STATUS_TIMEOUT:
      return "timeout";
    case ARV_BUFFER_STATUS_MISSING_PACKETS:
      return "missing packets";
    case ARV_BUFFER_STATUS_WRONG_PACKET_ID:
      return "wrong packet id";
    case ARV_BUFFER_STATUS_SIZE_MISMATCH:
      return "size mismatch";
    case ARV_BUFFER_STATUS_FILLING:
      return "filling";
    case ARV_BUFFER_STATUS_ABORTED:
      return "aborted";
    default:
      return "unknown";
  }
}

/// Aravis turns the count into ns by truncating.
std::uint64_t countFromNs(std::uint64_t ns, std::uint64_t tickHz) {
  constexpr std::uint64_t kNsPerS = 1'000'000'000;
  const std::uint64_t s = ns / kNsPerS, rest = ns % kNsPerS;
  return s * tickHz + (rest * tickHz + kNsPerS - 1) / kNsPerS;
}

constexpr int kRetentionAtFirstMs = 100;  // until the rate of the triggers is known

/// Aravis enlarges the socket's buffer when the first frame has begun, which can be too late for that frame.
void enlargeSocketBuffer(ArvStream* stream, int bytes) {
  const guint16 port = arv_gv_stream_get_port(ARV_GV_STREAM(stream));
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", failed)) {
    const int descriptor = std::atoi(entry.path().filename().c_str());
    sockaddr_in own{};
    socklen_t size = sizeof own;
    if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&own), &size) != 0 || own.sin_family != AF_INET ||
        ntohs(own.sin_port) != port)
      continue;
    int type = 0;
    socklen_t typeSize = sizeof type;
    if (getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &typeSize) == 0 && type == SOCK_DGRAM)
      setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
  }
}

void freeMemory(void* memory) { FrameMemoryFree{}(static_cast<std::uint8_t*>(memory)); }

}  // namespace

CameraStream::CameraStream(const GigeCameraSettings& camera, StreamSettings settings,
                           std::shared_ptr<CameraInbox> inbox)
    : camera_(camera), settings_(std::move(settings)), inbox_(std::move(inbox)) {}

CameraStream::~CameraStream() { close(); }

void CameraStream::close() {
  if (closed_ || !stream_) return;
  closed_ = true;
  arv_stream_stop_thread(stream_.get(), FALSE);
}

Expected<std::shared_ptr<CameraStream>> CameraStream::open(ArvCamera* camera, const GigeCameraSettings& how,
                                                           StreamSettings settings,
                                                           std::shared_ptr<CameraInbox> inbox) {
  std::shared_ptr<CameraStream> self(new CameraStream(how, std::move(settings), std::move(inbox)));
  const std::string& where = self->settings_.where;
  Failure failure;
  const guint payload = arv_camera_get_payload(camera, failure);
  if (failure.any()) return worldError(where, "does not tell its payload (" + failure.message() + ")");
  if (self->settings_.count == CountSource::Chunk || self->settings_.railLineFromChunk)
    self->chunks_.reset(arv_camera_create_chunk_parser(camera));
  // The callback is given no buffer before acquisition starts, so stream_ is set by then.
  self->stream_.reset(arv_camera_create_stream(camera, &CameraStream::called, self.get(), failure));
  if (failure.any() || !self->stream_) {
    self->stream_.reset();
    return worldError(where, "gives no stream (" + failure.message() + ")");
  }
  g_object_set(self->stream_.get(), "socket-buffer", ARV_GV_STREAM_SOCKET_BUFFER_FIXED, "socket-buffer-size",
               how.socketBufferBytes, "packet-resend",
               how.resend ? ARV_GV_STREAM_PACKET_RESEND_ALWAYS : ARV_GV_STREAM_PACKET_RESEND_NEVER, nullptr);
  enlargeSocketBuffer(self->stream_.get(), how.socketBufferBytes);
  self->setRetention(std::max(how.frameRetentionMs, kRetentionAtFirstMs));
  for (int i = 0; i < how.buffers; ++i) {
    std::uint8_t* memory = makeFrameMemory(payload).release();
    arv_stream_push_buffer(self->stream_.get(), arv_buffer_new_full(payload, memory, memory, freeMemory));
  }
  return self;
}

void CameraStream::setRetention(int ms) {
  g_object_set(stream_.get(), "frame-retention", static_cast<guint>(1000 * ms), nullptr);
}

void CameraStream::called(void* self, ArvStreamCallbackType type, ArvBuffer* /*buffer*/) {
  if (type == ARV_STREAM_CALLBACK_TYPE_BUFFER_DONE) static_cast<CameraStream*>(self)->done();
}

void CameraStream::done() {
  // All that are there: Aravis lays some aside without a call, and those would be missing soon.
  while (ArvBuffer* buffer = arv_stream_try_pop_buffer(stream_.get())) {
    const ArvBufferStatus status = arv_buffer_get_status(buffer);
    if (status == ARV_BUFFER_STATUS_SUCCESS && arv_buffer_get_image_width(buffer) == camera_.widthPx &&
        arv_buffer_get_image_height(buffer) == camera_.heightPx &&
        arv_buffer_get_image_pixel_format(buffer) == ARV_PIXEL_FORMAT_MONO_8) {
      handOver(buffer);
      continue;
    }
    countFailure(status == ARV_BUFFER_STATUS_SUCCESS ? ARV_BUFFER_STATUS_SIZE_MISMATCH : status);
    if (status != ARV_BUFFER_STATUS_ABORTED) tagger_.addDamaged();
    arv_stream_push_buffer(stream_.get(), buffer);
  }
}

void CameraStream::countFailure(ArvBufferStatus status) {
  const std::scoped_lock lock(countersMutex_);
  ++counters_.failed[wordFor(status)];
}

std::optional<std::uint64_t> CameraStream::countOf(ArvBuffer* buffer) {
  switch (settings_.count) {
    case CountSource::Timestamp:
      return countFromNs(arv_buffer_get_timestamp(buffer), settings_.tickHz);
    case CountSource::Chunk: {
      Failure failure;
      const gint64 count =
          arv_chunk_parser_get_integer_value(chunks_.get(), buffer, camera_.features.countChunkValue.c_str(), failure);
      if (failure.any() || count < 0) return {};
      return static_cast<std::uint64_t>(count);
    }
    case CountSource::Auto:
    case CountSource::FrameId:
      break;
  }
  return {};
}

bool CameraStream::railLineOf(ArvBuffer* buffer) {
  if (!settings_.railLineFromChunk || !camera_.railLine) return false;
  Failure failure;
  const gint64 lines =
      arv_chunk_parser_get_integer_value(chunks_.get(), buffer, camera_.features.lineChunkValue.c_str(), failure);
  return !failure.any() && ((lines >> *camera_.railLine) & 1) != 0;
}

void CameraStream::handOver(ArvBuffer* buffer) {
  const auto count = countOf(buffer);
  Arrival arrival;
  arrival.epoch = settings_.epoch;
  if (settings_.count != CountSource::FrameId && !count) {
    arrival.tag.kind = FrameTag::Kind::Implausible;  // a chunk that cannot be read
  } else {
    arrival.tag = tagger_.add(arv_buffer_get_frame_id(buffer), count);
  }
  arrival.s = nowS();
  lastFrameS_.store(arrival.s, std::memory_order_relaxed);
  const FrameTag& tag = arrival.tag;
  const bool usable = tag.kind == FrameTag::Kind::Frame || tag.kind == FrameTag::Kind::Restarted;
  const bool place = usable && inbox_->hasPlace();
  {
    const std::scoped_lock lock(countersMutex_);
    counters_.framesOk += usable ? 1U : 0U;
    counters_.repeated += tag.kind == FrameTag::Kind::Repeated ? 1U : 0U;
    counters_.implausible += tag.kind == FrameTag::Kind::Implausible ? 1U : 0U;
    counters_.restarts += tag.kind == FrameTag::Kind::Restarted ? 1U : 0U;
    counters_.framesLost += tag.lost;
    counters_.missedTriggers += tag.missed;
    counters_.overflow += usable && !place ? 1U : 0U;
  }
  if (!usable) {
    arv_stream_push_buffer(stream_.get(), buffer);
    return;
  }
  if (place) {
    size_t bytes = 0;
    const auto* pixels = static_cast<const std::uint8_t*>(arv_buffer_get_image_data(buffer, &bytes));
    arrival.image = {pixels, camera_.widthPx, camera_.heightPx, camera_.widthPx};
    arrival.railLine = railLineOf(buffer);
    // The stream outlives every frame that is out, so a late lease gives its buffer back to a stream that is there.
    arrival.lease = std::shared_ptr<const void>(buffer, [self = shared_from_this()](const void* held) {
      arv_stream_push_buffer(self->stream_.get(), static_cast<ArvBuffer*>(const_cast<void*>(held)));
    });
  } else {
    arv_stream_push_buffer(stream_.get(), buffer);
  }
  inbox_->push(std::move(arrival));
}

void CameraStream::addTo(CameraCounters& counters) const {
  {
    const std::scoped_lock lock(countersMutex_);
    counters.framesOk += counters_.framesOk;
    for (const auto& [word, frames] : counters_.failed) counters.failed[word] += frames;
    counters.framesLost += counters_.framesLost;
    counters.missedTriggers += counters_.missedTriggers;
    counters.repeated += counters_.repeated;
    counters.implausible += counters_.implausible;
    counters.restarts += counters_.restarts;
    counters.overflow += counters_.overflow;
  }
  const auto info = [this](const char* what) { return arv_stream_get_info_uint64_by_name(stream_.get(), what); };
  counters.resendRequests += info("n_resend_requests");
  counters.resentPackets += info("n_resent_packets");
  counters.missingPackets += info("n_missing_packets");
  counters.underrunPackets += info("n_underruns");
}

}  // namespace vignole::gige
