#include "engine/gige_camera/control_probe.h"

#include <arpa/inet.h>
#include <array>
#include <cstdint>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace vignole::gige {

namespace {

constexpr std::uint16_t kControlPort = 3956;
constexpr std::uint8_t kKey = 0x42, kAnswerWanted = 0x01, kReadRegister = 0x80, kReadRegisterAnswer = 0x81;

class Socket {
 public:
  Socket() : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace

bool answers(const std::string& address, std::chrono::milliseconds patience) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(kControlPort);
  if (inet_pton(AF_INET, address.c_str(), &to.sin_addr) != 1) return false;
  const Socket probe;
  if (probe.descriptor() < 0) return false;
  const std::array<std::uint8_t, 12> question = {kKey, kAnswerWanted, 0, kReadRegister, 0, 4, 0, 1, 0, 0, 0, 0};
  if (sendto(probe.descriptor(), question.data(), question.size(), 0, reinterpret_cast<const sockaddr*>(&to),
             sizeof to) != static_cast<ssize_t>(question.size()))
    return false;
  pollfd waiting{probe.descriptor(), POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(patience.count())) <= 0) return false;
  std::array<std::uint8_t, 64> answer{};
  const ssize_t size = recv(probe.descriptor(), answer.data(), answer.size(), MSG_DONTWAIT);
  return size >= 8 && answer[3] == kReadRegisterAnswer;
}

}  // namespace vignole::gige
