#pragma once
// The running time of one stage (the paper's Table VII), written by its thread, read by anyone.

#include <chrono>
#include <mutex>

#include "engine/quality/running_statistics.h"

namespace vignole {

/// CPU time of the calling thread, ms.
[[nodiscard]] double threadCpuMs();

class StageMeter {
 public:
  /// One item that took `ms`; called by the stage's own thread, whose CPU time is noted too.
  void add(double ms) {
    const double cpu = threadCpuMs();
    const std::scoped_lock lock(mutex_);
    busyMs_.add(ms);
    cpuMs_ = cpu;
  }
  struct Reading {
    RunningStatistics busyMs;
    double cpuMs = 0;
  };
  [[nodiscard]] Reading read() const {
    const std::scoped_lock lock(mutex_);
    return {busyMs_, cpuMs_};
  }

 private:
  mutable std::mutex mutex_;
  RunningStatistics busyMs_;
  double cpuMs_ = 0;
};

/// Time since construction.
class StopWatch {
 public:
  [[nodiscard]] double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vignole
