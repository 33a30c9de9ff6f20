#pragma once
// A GigE Vision client of a few socket calls, so that the cameras are judged by other code than their own.

#include <arpa/inet.h>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <netinet/in.h>
#include <optional>
#include <poll.h>
#include <set>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

#include "engine/gige_device/camera_contract.h"

namespace vignole::gige_device::raw {

using Octets = std::vector<std::uint8_t>;
constexpr std::chrono::milliseconds kPatience{4000};

inline std::uint32_t be32(const Octets& b, std::size_t at) {
  return static_cast<std::uint32_t>(b[at]) << 24 | static_cast<std::uint32_t>(b[at + 1]) << 16 |
         static_cast<std::uint32_t>(b[at + 2]) << 8 | b[at + 3];
}
inline std::uint16_t be16(const Octets& b, std::size_t at) {
  return static_cast<std::uint16_t>(b[at] << 8 | b[at + 1]);
}
inline std::uint64_t be64(const Octets& b, std::size_t at) {
  return static_cast<std::uint64_t>(be32(b, at)) << 32 | be32(b, at + 4);
}
inline void append32(Octets& b, std::uint32_t v) {
  for (const int shift : {24, 16, 8, 0}) b.push_back(static_cast<std::uint8_t>(v >> shift));
}
inline void append16(Octets& b, std::uint32_t v) {
  for (const int shift : {8, 0}) b.push_back(static_cast<std::uint8_t>(v >> shift));
}

/// An address of this process' own, so that tests run side by side: 127.x.y.11 and the three behind it.
inline std::string freeAddress() {
  const int pid = ::getpid();
  return "127." + std::to_string(16 + pid % 200) + "." + std::to_string(pid / 200 % 250) + ".11";
}
inline std::string addressPlus(const std::string& address, int n) {
  const std::size_t dot = address.rfind('.');
  return address.substr(0, dot + 1) + std::to_string(std::stoi(address.substr(dot + 1)) + n);
}

/// A UDP socket on 127.0.0.1.
class Socket {
 public:
  Socket() : fd_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::bind(fd_, reinterpret_cast<sockaddr*>(&own), sizeof own), 0);
    const int bytes = 4 << 20;
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
  }
  ~Socket() { ::close(fd_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  [[nodiscard]] std::uint16_t port() const {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(fd_, reinterpret_cast<sockaddr*>(&own), &size);
    return ntohs(own.sin_port);
  }
  void send(const std::string& address, const Octets& datagram) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(kControlPort);
    ::inet_pton(AF_INET, address.c_str(), &to.sin_addr);
    ::sendto(fd_, datagram.data(), datagram.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
  }
  [[nodiscard]] std::optional<Octets> receive(std::chrono::milliseconds patience = kPatience) const {
    pollfd in{fd_, POLLIN, 0};
    if (::poll(&in, 1, static_cast<int>(patience.count())) <= 0) return {};
    Octets datagram(10000);
    const ssize_t bytes = ::recv(fd_, datagram.data(), datagram.size(), 0);
    if (bytes < 0) return {};
    datagram.resize(static_cast<std::size_t>(bytes));
    return datagram;
  }

 private:
  int fd_;
};

/// A GVCP command of 8 bytes and its payload.
inline Octets gvcp(std::uint16_t command, const Octets& payload, std::uint16_t id, std::uint8_t flags = 1) {
  Octets out = {0x42, flags};
  append16(out, command);
  append16(out, static_cast<std::uint32_t>(payload.size()));
  append16(out, id);
  out.insert(out.end(), payload.begin(), payload.end());
  return out;
}

/// What came of one frame.
struct RawFrame {
  std::uint64_t id = 0, timestamp = 0;
  bool extended = false, leader = false, trailer = false, unavailable = false;
  std::uint16_t payloadType = 0;
  std::uint32_t width = 0, height = 0, offsetX = 0, offsetY = 0, trailerPacket = 0;
  std::map<std::uint32_t, Octets> packets;  ///< payload packets by number
  [[nodiscard]] bool complete() const { return leader && trailer && packets.size() + 1 == trailerPacket; }
  [[nodiscard]] Octets payload() const {
    Octets all;
    for (const auto& [number, bytes] : packets) all.insert(all.end(), bytes.begin(), bytes.end());
    return all;
  }
  [[nodiscard]] Octets pixels() const {
    Octets all = payload();
    all.resize(std::size_t{width} * height);
    return all;
  }
  /// Read from the end of the payload, as the standard has it.
  [[nodiscard]] std::optional<std::uint64_t> chunk(ChunkId id_) const {
    const Octets all = payload();
    for (std::size_t end = all.size(); end >= 8;) {
      const std::uint32_t chunkId = be32(all, end - 8), size = be32(all, end - 4);
      if (size > end - 8) return {};
      if (chunkId == static_cast<std::uint32_t>(id_)) return chunkNumber(std::span(all).subspan(end - 8 - size, size));
      end -= 8 + size;
    }
    return {};
  }
};

class Client {
 public:
  explicit Client(std::string address) : address_(std::move(address)) {}

  /// The answer, asked for again if it does not come.
  std::optional<Octets> ask(std::uint16_t command, const Octets& payload,
                            std::chrono::milliseconds patience = kPatience) {
    const Octets datagram = gvcp(command, payload, ++id_);
    control_.send(address_, datagram);
    const auto until = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < until) {
      auto answer = control_.receive(
          std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()));
      if (answer && answer->size() >= 8 && be16(*answer, 6) == id_) return answer;
    }
    return {};
  }
  [[nodiscard]] static std::uint16_t status(const std::optional<Octets>& answer) {
    return answer ? be16(*answer, 0) : std::uint16_t{0xffff};
  }
  std::optional<std::uint32_t> read(std::uint32_t address) {
    Octets payload;
    append32(payload, address);
    const auto answer = ask(0x0080, payload);
    if (!answer || be16(*answer, 0) != 0 || answer->size() < 12) return {};
    return be32(*answer, 8);
  }
  std::uint16_t write(std::uint32_t address, std::uint32_t value) {
    Octets payload;
    append32(payload, address);
    append32(payload, value);
    return status(ask(0x0082, payload));
  }
  [[nodiscard]] bool takeControl() { return write(0x0a00, 2) == 0; }
  /// The stream goes to this client's own socket.
  void openStream(std::uint32_t packetBytes = 1500) {
    EXPECT_EQ(write(0x0d04, packetBytes), 0);
    EXPECT_EQ(write(0x0d18, 0x7f000001), 0);
    EXPECT_EQ(write(0x0d00, stream_.port()), 0);
  }
  void requestResend(std::uint64_t frame, std::uint32_t first, std::uint32_t last, bool extended = false) {
    Octets payload;
    append16(payload, 0);
    append16(payload, extended ? 0 : static_cast<std::uint32_t>(frame));
    append32(payload, first);
    append32(payload, last);
    if (extended) {
      append32(payload, static_cast<std::uint32_t>(frame >> 32));
      append32(payload, static_cast<std::uint32_t>(frame));
    }
    stream_.send(address_, gvcp(0x0040, payload, ++id_, extended ? 0x10 : 0x00));
  }
  /// One packet of the stream, put into its frame. Null if none came.
  RawFrame* receivePacket(std::chrono::milliseconds patience = kPatience) {
    const auto datagram = stream_.receive(patience);
    if (!datagram || datagram->size() < 8) return nullptr;
    const Octets& d = *datagram;
    const bool extended = (d[4] & 0x80) != 0;
    const std::size_t header = extended ? 20 : 8;
    if (d.size() < header) return nullptr;
    const std::uint64_t id = extended ? be64(d, 8) : be16(d, 2);
    const std::uint32_t packet = extended ? be32(d, 16) : be32(d, 4) & 0xffffff;
    RawFrame& frame = frames[id];
    frame.id = id;
    frame.extended = extended;
    lastDatagramBytes = d.size();
    if (be16(d, 0) != 0) {
      frame.unavailable = true;
      return &frame;
    }
    switch (d[4] & 0x7f) {
      case 1:
        frame.leader = d.size() >= header + 36;
        if (!frame.leader) break;
        frame.payloadType = be16(d, header + 2);
        frame.timestamp = be64(d, header + 4);
        frame.width = be32(d, header + 16);
        frame.height = be32(d, header + 20);
        frame.offsetX = be32(d, header + 24);
        frame.offsetY = be32(d, header + 28);
        break;
      case 2:
        frame.trailer = true;
        frame.trailerPacket = packet;
        break;
      default:
        frame.packets[packet] = Octets(d.begin() + static_cast<std::ptrdiff_t>(header), d.end());
    }
    return &frame;
  }
  /// The next frame whose trailer comes; nothing if none does.
  std::optional<RawFrame> nextFrame(std::chrono::milliseconds patience = kPatience) {
    const auto until = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < until) {
      RawFrame* frame = receivePacket(
          std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()));
      if (frame != nullptr && frame->trailer) {
        RawFrame taken = *frame;
        frames.erase(taken.id);
        return taken;
      }
    }
    return {};
  }

  std::map<std::uint64_t, RawFrame> frames;  ///< unfinished
  std::size_t lastDatagramBytes = 0;
  [[nodiscard]] const Socket& stream() const { return stream_; }

 private:
  std::string address_;
  Socket control_, stream_;
  std::uint16_t id_ = 0;
};

}  // namespace vignole::gige_device::raw
