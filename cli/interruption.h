#pragma once
// Ctrl-C and a polite kill end what runs on instead of ending the program.

#include <csignal>
#include <functional>
#include <thread>

namespace vignole::cli {

/// While it lives, SIGINT and SIGTERM call `act` (on a thread of its own, maybe several times) and nothing else. Make
/// it before the threads that shall not be interrupted: they inherit the mask.
class Interruption {
 public:
  explicit Interruption(std::function<void()> act);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  sigset_t previous_{};
  std::jthread watcher_;
};

}  // namespace vignole::cli
