#pragma once
// What the window keeps of the engine's reports. The engine's last stage writes, the window's thread reads; one lock,
// held for microseconds.

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>

#include "gui/bridge/latest_value.h"
#include "gui/bridge/line.h"

namespace vignole {

/// An observer of the inspection that can be asked from another thread.
class RailWatch {
 public:
  using Clock = std::chrono::steady_clock;
  /// So many triggers or profiles on end without a camera or a dimension are no accident: about a tenth of a second.
  static constexpr std::uint64_t kSustained = 7;

  RailWatch(const Recipe& recipe, std::string calibrationId)
      : recipe_(recipe), calibrationId_(std::move(calibrationId)) {}

  /// Its functions refer to this object: it outlives the inspection.
  [[nodiscard]] InspectionObserver observer();
  /// Brings what is told by profiles up to date; `detail` Everything copies the rail's summary as well.
  void fill(LineSnapshot& snapshot, PullDetail detail, Clock::time_point now);
  /// True between the begin and the end of a rail.
  [[nodiscard]] bool railUnderWay() const;
  /// Set once the engine has ended; empty text: all went well.
  [[nodiscard]] std::optional<std::string> ended() const;
  /// Before another inspection; keeps the rails that passed. Empty: the calibration is the same.
  void restart(const std::string& calibrationId = {});
  void forget();  ///< what was measured last: the recipe is another. Between two inspections

 private:
  struct Absence {
    std::uint64_t run = 0;
    double fromM = 0;
    std::string reason;
    void note(bool absent, double positionM, const std::string& why);
  };
  void began(const RailBegin& rail);
  void measured(const ProfileResult& result);
  void railEnded(const RailBegin& rail, const TriggerLedger& ledger);

  const Recipe& recipe_;
  std::string calibrationId_;
  LatestValue<ProfileResult> mailbox_;

  mutable std::mutex mutex_;
  std::unique_ptr<RailSummariser> summariser_;
  TriggerLedger ledger_;  ///< of the rail under way, as far as profiles tell
  bool underWay_ = false;
  std::array<Absence, kCameraCount> cameras_;
  PerDimension<Absence> dimensions_;
  std::deque<PassedRail> passed_;
  std::uint64_t railsPassed_ = 0, railsGood_ = 0, profiles_ = 0;
  std::optional<std::string> ended_;

  // Window's thread only.
  std::deque<std::pair<Clock::time_point, std::uint64_t>> rate_;
  std::optional<Clock::time_point> lastArrival_;
};

}  // namespace vignole
