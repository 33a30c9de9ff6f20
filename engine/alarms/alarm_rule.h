#pragma once
// What is an alarm: a rule with cause, consequence and action; anything else is an event and belongs in the event log.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// Wall-clock time, handed in by the caller: nothing in this room asks for the time itself.
using AlarmTime = std::chrono::sys_time<std::chrono::milliseconds>;
using AlarmDuration = std::chrono::milliseconds;

/// 1 measurement invalid while rails pass; 2 rail out of tolerance, calibration invalid; 3 drift, degraded sensor.
enum class AlarmPriority { Invalid = 1, OutOfTolerance = 2, Degraded = 3 };

/// What a value must do for the alarm to be on. State: the caller says so itself, on or off.
enum class AlarmCondition { State, Above, Below };

struct AlarmRule {
  std::string id;  ///< "rail.out-of-tolerance"; its texts are translated by it
  AlarmPriority priority = AlarmPriority::Degraded;
  std::string cause, consequence, action;  ///< English
  AlarmCondition condition = AlarmCondition::State;
  std::string unit;      ///< of value, limit and deadband
  double limit = 0;      ///< Above, Below
  double deadband = 0;   ///< the value must come back this far inside the limit before the condition ends
  double filterS = 0;    ///< time constant of the low-pass before the limit; 0: none
  double onDelayS = 0;   ///< the condition must last this long without a break before it is an alarm
  double offDelayS = 0;  ///< and be gone this long before the alarm is over
  bool needsAcknowledgement = true;
};

/// The rules of the program, by priority. Limits, delays and deadbands may be changed per site or recipe.
[[nodiscard]] const std::vector<AlarmRule>& standardAlarmRules();

/// Bounds, unique ids, no empty cause, consequence or action.
[[nodiscard]] Expected<void> checkAlarmRules(const std::vector<AlarmRule>& rules);

/// TOML: `format = 1`, per rule a table [alarm.ID] with what differs: priority, limit, deadband, filter_s,
/// on_delay_s, off_delay_s. Unknown rules, unknown keys and values out of range are refused with file, line and key.
[[nodiscard]] Expected<std::vector<AlarmRule>> loadAlarmRules(const std::filesystem::path& file,
                                                              std::vector<AlarmRule> rules = standardAlarmRules());
[[nodiscard]] Expected<std::vector<AlarmRule>> parseAlarmRules(std::string_view text, const std::string& nameInErrors,
                                                               std::vector<AlarmRule> rules = standardAlarmRules());
/// Everything that may be changed, readable back.
[[nodiscard]] std::string toToml(const std::vector<AlarmRule>& rules);

}  // namespace vignole
