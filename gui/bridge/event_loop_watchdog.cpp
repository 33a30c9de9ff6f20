#include "gui/bridge/event_loop_watchdog.h"

#include <algorithm>
#include <cmath>

namespace vignole {

EventLoopWatchdog::EventLoopWatchdog(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(kIntervalMs);
  QObject::connect(&timer_, &QTimer::timeout, this, [this] {
    const double elapsedMs = static_cast<double>(sinceLast_.nsecsElapsed()) * 1e-6;
    sinceLast_.restart();
    note(std::max(0.0, elapsedMs - kIntervalMs));
  });
}

void EventLoopWatchdog::start() {
  sinceLast_.start();
  timer_.start();
}

void EventLoopWatchdog::note(double lateMs) {
  const auto bin =
      static_cast<std::size_t>(std::clamp(lateMs / kStepMs, 0.0, static_cast<double>(histogram_.size() - 1)));
  ++histogram_[bin];
  ++turns_;
  maxMs_ = std::max(maxMs_, lateMs);
  worstMs_ = std::max(worstMs_, lateMs);
}

double EventLoopWatchdog::quantileMs(double q) const {
  const auto rank = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(turns_)));
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < histogram_.size(); ++bin) {
    sum += histogram_[bin];
    if (turns_ > 0 && sum >= std::max<std::uint64_t>(rank, 1))
      return std::min((static_cast<double>(bin) + 1) * kStepMs, maxMs_);  // upper edge: never flatters
  }
  return 0;
}

}  // namespace vignole
