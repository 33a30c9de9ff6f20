#pragma once
// How late the window's event loop serves a timer: what a person feels as a window that does not answer.

#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <cstdint>
#include <utility>

namespace vignole {

/// Lateness of a 10 ms timer, in steps of 0.1 ms up to 1 s; constant memory. Window's thread only.
class EventLoopWatchdog : public QObject {
 public:
  explicit EventLoopWatchdog(QObject* parent = nullptr);
  void start();
  void note(double lateMs);
  [[nodiscard]] double quantileMs(double q) const;  ///< 0 without a turn
  [[nodiscard]] double maxMs() const { return maxMs_; }
  /// Of the turns since the last call.
  double takeWorstMs() { return std::exchange(worstMs_, 0); }
  [[nodiscard]] std::uint64_t turns() const { return turns_; }

 private:
  static constexpr int kIntervalMs = 10;
  static constexpr double kStepMs = 0.1;
  QTimer timer_;
  QElapsedTimer sinceLast_;
  std::array<std::uint32_t, 10001> histogram_{};
  std::uint64_t turns_ = 0;
  double maxMs_ = 0, worstMs_ = 0;
};

}  // namespace vignole
