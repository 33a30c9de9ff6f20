#pragma once
// What a long step of calibration tells whoever waits for it, and asks: every step runs in a thread of the caller's.

#include <functional>
#include <stop_token>
#include <string_view>

#include "engine/geometry/expected.h"

namespace vignole {

struct Job {
  /// share 0..1 of the step, and what is being done ("camera 2: lines"). From the thread that runs the step, often.
  std::function<void(double share, std::string_view doing)> progress;
  std::stop_token stop;

  void report(double share, std::string_view doing) const {
    if (progress) progress(share, doing);
  }
  [[nodiscard]] bool cancelled() const { return stop.stop_requested(); }
};

/// What a step that was cancelled returns; nothing is left behind.
[[nodiscard]] inline tl::unexpected<Error> cancelledError() { return inputError("", "cancelled"); }

}  // namespace vignole
