#include "cli/interruption.h"

#include <pthread.h>
#include <utility>

namespace vignole::cli {

namespace {
// Wakes the watcher when nothing more is to be watched.
constexpr int kRelease = SIGUSR1;
}  // namespace

Interruption::Interruption(std::function<void()> act) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int s : {SIGINT, SIGTERM, kRelease}) sigaddset(&signals, s);
  pthread_sigmask(SIG_BLOCK, &signals, &previous_);
  watcher_ = std::jthread([signals, act = std::move(act)](const std::stop_token& stop) {
    for (int received = 0; sigwait(&signals, &received) == 0 && !stop.stop_requested();)
      if (received != kRelease) act();
  });
}

Interruption::~Interruption() {
  watcher_.request_stop();
  pthread_kill(watcher_.native_handle(), kRelease);
  watcher_.join();
  pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
}

}  // namespace vignole::cli
