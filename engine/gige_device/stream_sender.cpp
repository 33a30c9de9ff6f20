#include "engine/gige_device/stream_sender.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <thread>
#include <unistd.h>

namespace vignole::gige_device {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kRingFrames = 8;
constexpr std::size_t kMaxBurst = 64;
constexpr double kBurstS = 1e-3;  // the pace is kept in steps of this: finer ones cost a waking each
constexpr int kSendBufferBytes = 1 << 20;

sockaddr_in addressOf(std::uint32_t address, std::uint16_t port) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = htonl(address);
  to.sin_port = htons(port);
  return to;
}

/// Messages of header, image part and chunk part, handed to the system together.
class Batch {
 public:
  explicit Batch(const sockaddr_in& to) : to_(to) {}
  [[nodiscard]] bool full() const { return used_ == kMaxBurst; }
  [[nodiscard]] std::size_t size() const { return used_; }
  /// Parts may be empty. The bytes must stay until flush().
  void add(ByteView header, ByteView image, ByteView chunks) {
    std::array<iovec, 3>& parts = parts_[used_];
    std::size_t count = 0;
    for (const ByteView part : {header, image, chunks})
      if (!part.empty()) parts[count++] = {const_cast<std::uint8_t*>(part.data()), part.size()};
    msghdr& message = messages_[used_].msg_hdr;
    message = {};
    message.msg_name = &to_;
    message.msg_namelen = sizeof to_;
    message.msg_iov = parts.data();
    message.msg_iovlen = count;
    ++used_;
  }
  void flush(int socket) {
    for (std::size_t done = 0; done < used_;) {
      const int sent = ::sendmmsg(socket, messages_.data() + done, static_cast<unsigned>(used_ - done), 0);
      if (sent > 0)
        done += static_cast<std::size_t>(sent);
      else if (errno != EINTR)
        ++done;  // this packet cannot leave: lost, as on a wire
    }
    used_ = 0;
  }

 private:
  sockaddr_in to_;
  std::array<mmsghdr, kMaxBurst> messages_{};
  std::array<std::array<iovec, 3>, kMaxBurst> parts_{};
  std::size_t used_ = 0;
};

}  // namespace

/// A frame cut into packets. Immutable but for the count of sendings.
struct StreamSender::Sent {
  explicit Sent(OutgoingFrame&& f) : frame(std::move(f)) {
    const int header = gvspHeaderBytes(frame.extendedIds);
    headerBytes = static_cast<std::size_t>(header);
    packetData = static_cast<std::size_t>(frame.packetBytes - kIpUdpBytes - header);
    const std::size_t width = frame.info.width, height = frame.info.height;
    if (frame.image.stride == static_cast<std::ptrdiff_t>(width)) {
      image = {frame.image.data, width * height};
    } else {  // a region narrower than the picture
      gathered.resize(width * height);
      for (std::size_t y = 0; y < height; ++y)
        std::memcpy(gathered.data() + y * width, frame.image.row(static_cast<int>(y)), width);
      image = gathered;
    }
    total = image.size() + frame.chunks.size();
    payloadPackets = static_cast<std::uint32_t>((total + packetData - 1) / packetData);
    headers.resize(packets() * headerBytes);
    const std::uint64_t id = idOnWire(frame.frameId, frame.extendedIds);
    for (std::uint32_t p = 0; p < packets(); ++p)
      putGvspHeader(&headers[p * headerBytes], frame.extendedIds, kGvspOk, id, p,
                    p == 0               ? GvspContent::Leader
                    : p == packets() - 1 ? GvspContent::Trailer
                                         : GvspContent::Payload);
    leader = leaderContent(frame.info);
    trailer = trailerContent(frame.info);
    attempts.resize(packets(), 1);
  }
  [[nodiscard]] std::uint32_t packets() const { return payloadPackets + 2; }
  /// What of the image and of the chunks is in a packet; leader and trailer count as chunks.
  [[nodiscard]] std::pair<ByteView, ByteView> content(std::uint32_t packet) const {
    if (packet == 0) return {{}, leader};
    if (packet == packets() - 1) return {{}, trailer};
    const std::size_t begin = (packet - 1) * packetData, end = std::min(begin + packetData, total);
    const std::size_t imageEnd = std::min(end, image.size());
    const ByteView first = begin < imageEnd ? image.subspan(begin, imageEnd - begin) : ByteView();
    const std::size_t chunkBegin = std::max(begin, image.size()) - image.size();
    const ByteView second =
        end > image.size() ? ByteView(frame.chunks).subspan(chunkBegin, end - image.size() - chunkBegin) : ByteView();
    return {first, second};
  }
  [[nodiscard]] ByteView header(std::uint32_t packet) const {
    return ByteView(headers).subspan(packet * headerBytes, headerBytes);
  }
  [[nodiscard]] std::size_t wireBytes(std::uint32_t packet) const {
    const auto [first, second] = content(packet);
    return static_cast<std::size_t>(kEthernetBytes + kIpUdpBytes) + headerBytes + first.size() + second.size();
  }

  OutgoingFrame frame;
  std::size_t headerBytes = 0, packetData = 0, total = 0;
  std::uint32_t payloadPackets = 0;
  Bytes gathered, headers, leader, trailer;
  ByteView image;
  std::vector<std::uint32_t> attempts;  ///< under the sender's mutex
};

StreamSender::StreamSender(int camera, int socket, std::uint16_t port, double gbps,
                           std::shared_ptr<const FaultPlan> faults)
    : camera_(camera), socket_(socket), port_(port), bytesPerS_(gbps * 1e9 / 8), faults_(std::move(faults)) {}

Expected<std::unique_ptr<StreamSender>> StreamSender::open(int camera, std::uint32_t address, double gbps,
                                                           std::shared_ptr<const FaultPlan> faults) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in own = addressOf(address, 0);
  socklen_t size = sizeof own;
  if (socket < 0 || ::bind(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0 ||
      ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size) != 0) {
    const std::string why = std::strerror(errno);
    if (socket >= 0) ::close(socket);
    return worldError("camera " + std::to_string(camera + 1), "no socket for the stream (" + why + ")");
  }
  ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kSendBufferBytes, sizeof kSendBufferBytes);
  return std::unique_ptr<StreamSender>(new StreamSender(camera, socket, ntohs(own.sin_port), gbps, std::move(faults)));
}

StreamSender::~StreamSender() { ::close(socket_); }

bool StreamSender::send(OutgoingFrame frame, const std::stop_token& stop) {
  const auto sent = std::make_shared<Sent>(std::move(frame));
  const OutgoingFrame& f = sent->frame;
  if (f.corruptLeader)
    for (std::size_t i = 0; i < sent->leader.size(); ++i)
      sent->leader[i] = static_cast<std::uint8_t>(sent->leader[i] ^ faults_->bits(camera_, f.trigger, i));
  const std::uint64_t aborts = aborts_;
  {
    const std::lock_guard lock(mutex_);
    ring_.push_back(sent);
    if (ring_.size() > kRingFrames) ring_.pop_front();
  }
  const double loss = faults_->packetLoss(camera_, f.trigger);
  const bool paced = bytesPerS_ > 0 || f.packetDelayS > 0;
  const Clock::time_point start = Clock::now();
  double wireS = 0, burstS = 0;
  Batch batch(addressOf(f.address, f.port));
  for (std::uint32_t p = 0; p < sent->packets(); ++p) {
    if (faults_->packetLost(loss, camera_, f.trigger, p, 0)) {
      ++counters_.packetsDropped;
    } else {
      const auto [first, second] = sent->content(p);
      batch.add(sent->header(p), first, second);
    }
    const double packetS = (bytesPerS_ > 0 ? static_cast<double>(sent->wireBytes(p)) / bytesPerS_ : 0) + f.packetDelayS;
    wireS += packetS;
    burstS += packetS;
    const bool last = p + 1 == sent->packets();
    if (!last && !batch.full() && !(paced && burstS >= kBurstS)) continue;
    // A burst leaves when the wire would have brought its last packet.
    if (paced)
      std::this_thread::sleep_until(start +
                                    std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wireS)));
    if (aborts_ != aborts || stop.stop_requested()) return false;
    counters_.packets += batch.size();
    batch.flush(socket_);
    burstS = 0;
  }
  return true;
}

void StreamSender::abort() {
  ++aborts_;
  const std::lock_guard lock(mutex_);
  ring_.clear();
}

void StreamSender::resend(const ResendRequest& request, bool extendedIds, std::uint32_t address, std::uint16_t port) {
  ++counters_.resendRequests;
  std::shared_ptr<Sent> found;
  std::vector<std::uint32_t> packets;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& sent : ring_)
      if (idOnWire(sent->frame.frameId, sent->frame.extendedIds) == request.frameId) found = sent;
    if (found) {
      const double loss = faults_->packetLoss(camera_, found->frame.trigger);
      const std::uint32_t last = std::min(request.lastPacket, found->packets() - 1);
      for (std::uint32_t p = request.firstPacket; p <= last; ++p) {
        if (faults_->packetLost(loss, camera_, found->frame.trigger, p, found->attempts[p]++))
          ++counters_.packetsDropped;
        else
          packets.push_back(p);
      }
    }
  }
  if (!found) {
    std::array<std::uint8_t, kMaxGvspHeaderBytes> header{};
    putGvspHeader(header.data(), extendedIds, kGvspUnavailable, request.frameId, request.firstPacket,
                  GvspContent::Payload);
    ++counters_.resendsRefused;
    Batch batch(addressOf(address, port));
    batch.add(ByteView(header).first(static_cast<std::size_t>(gvspHeaderBytes(extendedIds))), {}, {});
    batch.flush(socket_);
    return;
  }
  Batch batch(addressOf(found->frame.address, found->frame.port));
  counters_.packetsResent += packets.size();
  for (const std::uint32_t p : packets) {
    const auto [first, second] = found->content(p);
    batch.add(found->header(p), first, second);
    if (batch.full()) batch.flush(socket_);
  }
  batch.flush(socket_);
}

void StreamSender::sendTestPacket(std::uint32_t address, std::uint16_t port, int packetBytes) {
  const Bytes packet(static_cast<std::size_t>(std::max(packetBytes - kIpUdpBytes, gvspHeaderBytes(false))));
  Batch batch(addressOf(address, port));
  batch.add(packet, {}, {});
  batch.flush(socket_);
}

StreamCounters StreamSender::counters() const {
  return {counters_.packets, counters_.packetsDropped, counters_.resendRequests, counters_.packetsResent,
          counters_.resendsRefused};
}

}  // namespace vignole::gige_device
