#pragma once
// Frames that are in memory already, shown as one or more rails: for benchmarks and tests of what comes behind.

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/acquisition/frame.h"

namespace vignole {

struct MemorySourceSettings {
  RailBegin rail;              ///< of every rail; firstTrigger is counted on from rail to rail
  std::uint64_t profiles = 1;  ///< triggers of each rail
  std::uint64_t rails = 1;
  double rateHz = 0;  ///< triggers per second; 0: as fast as they are taken
  bool live = false;  ///< what live() says
};

/// One picture of each of the four cameras.
using FrameSet = std::array<ImageView, 4>;

class MemorySource : public FrameSource {
 public:
  /// Trigger t shows sets[t % sets.size()]; at least one set. `owner` keeps the pixels alive.
  MemorySource(std::vector<FrameSet> sets, std::shared_ptr<const void> owner, MemorySourceSettings settings);

  [[nodiscard]] FrameMessage next(int camera, std::stop_token stop) override;
  [[nodiscard]] bool live() const override { return settings_.live; }

 private:
  struct Stream {
    std::uint64_t trigger = 0;
    std::uint64_t rail = 0;
    bool inRail = false;
  };
  [[nodiscard]] bool waitForTrigger(std::uint64_t trigger, const std::stop_token& stop);

  std::vector<FrameSet> sets_;
  std::shared_ptr<const void> owner_;
  MemorySourceSettings settings_;
  std::array<Stream, 4> streams_;  // each touched by its camera's thread only
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::chrono::steady_clock::time_point start_;
  std::once_flag started_;
};

}  // namespace vignole
