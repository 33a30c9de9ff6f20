#pragma once
// One condition over time: filter, limit with deadband, delays.

#include <optional>

#include "engine/alarms/alarm_rule.h"

namespace vignole {

/// Says from when on the condition counts as an alarm. Times must not run backwards; a step back counts as no time.
class AlarmSignal {
 public:
  explicit AlarmSignal(const AlarmRule& rule) : rule_(&rule) {}

  /// A new value; one that is not finite is no value and changes nothing.
  void observe(double value, AlarmTime now);
  /// Switched by whoever knows.
  void set(bool on, AlarmTime now);
  /// Time has passed: delays may be over.
  void advance(AlarmTime now);

  /// After the delays.
  [[nodiscard]] bool on() const { return on_; }
  /// When `on` last changed: the moment at which the delay was over, not that at which somebody looked.
  [[nodiscard]] AlarmTime since() const { return since_; }
  /// Before the delays.
  [[nodiscard]] bool raw() const { return raw_; }
  /// After the filter; empty before the first.
  [[nodiscard]] std::optional<double> value() const { return filtered_; }

 private:
  const AlarmRule* rule_;
  std::optional<double> filtered_;
  AlarmTime lastValue_{};
  bool raw_ = false, on_ = false;
  AlarmTime rawSince_{}, since_{};
};

}  // namespace vignole
