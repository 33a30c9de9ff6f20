#include "engine/alarms/alarm_rule.h"

#include <cmath>
#include <cstdio>
#include <set>

#include "engine/files/toml_reader.h"

namespace vignole {

namespace {

constexpr double kLongestS = 3600;
constexpr double kFarthest = 1e6;

AlarmRule state(std::string id, AlarmPriority priority, std::string cause, std::string consequence, std::string action,
                double onDelayS, double offDelayS) {
  AlarmRule r;
  r.id = std::move(id);
  r.priority = priority;
  r.cause = std::move(cause);
  r.consequence = std::move(consequence);
  r.action = std::move(action);
  r.onDelayS = onDelayS;
  r.offDelayS = offDelayS;
  return r;
}

AlarmRule limited(AlarmRule rule, AlarmCondition condition, std::string unit, double limit, double deadband,
                  double filterS) {
  rule.condition = condition;
  rule.unit = std::move(unit);
  rule.limit = limit;
  rule.deadband = deadband;
  rule.filterS = filterS;
  return rule;
}

std::vector<AlarmRule> makeStandardRules() {
  using enum AlarmPriority;
  using enum AlarmCondition;
  return {
      state("camera.lost", Invalid, "A camera does not answer while a rail passes.",
            "Its quarter of the profile is missing; rails pass unmeasured.",
            "Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.", 1,
            5),
      limited(state("profiles.incomplete", Invalid, "Too many triggers give no complete profile.",
                    "Stretches of the rail are not measured.",
                    "See Diagnostics for the camera that loses frames; check network load and trigger.", 2, 10),
              Above, "%", 5, 2, 1),
      limited(
          state("registration.failed", Invalid, "Too many profiles do not fit the section of the recipe.",
                "The dimensions of this rail are not to be trusted.",
                "Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.", 1, 5),
          Above, "%", 20, 5, 1),
      state("measurement.stopped", Invalid, "The measurement has stopped while a rail passes.",
            "Rails pass unmeasured.", "Start the measurement; if it stops again, save a support bundle in Diagnostics.",
            0.5, 2),
      state("dimension.not-measured", Invalid, "A toleranced dimension is not measured while a rail passes.",
            "The rail cannot be judged by it.",
            "Clean windows and check lasers; see Stripes for where the line is missing.", 1, 5),
      state("rail.out-of-tolerance", OutOfTolerance, "A rail has a stretch out of tolerance.",
            "The rail must not be delivered as it is.",
            "Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.", 0, 0),
      state("rail.wrong-section", OutOfTolerance, "The rail looks like another section than that of the recipe.",
            "It is judged by the wrong tolerances.", "Choose the recipe of the rail that is rolled.", 0, 0),
      state("calibration.invalid", OutOfTolerance, "The calibration in force is refused, missing or out of date.",
            "Uncertainties are not what the reports state.", "Calibrate, or bring back an earlier calibration.", 0, 0),
      limited(state("calibration.drift", Degraded, "The seam between two cameras has moved in normal production.",
                    "Dimensions across the seam are biased by about as much.",
                    "Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.",
                    60, 60),
              Above, "mm", 0.05, 0.01, 30),
      limited(state("camera.frame-loss", Degraded, "A camera loses frames.", "Profiles are incomplete now and then.",
                    "Check cable, switch and packet size of the camera.", 10, 30),
              Above, "%", 1, 0.5, 10),
      limited(state("stripe.saturated", Degraded, "Much of a laser line is saturated.",
                    "Points on bright patches are less certain.",
                    "Shorten the exposure of the camera or clean the window.", 10, 30),
              Above, "%", 10, 3, 10),
      limited(state("stripe.weak", Degraded, "A laser line is faint.", "Points are missing or uncertain.",
                    "Clean the windows, check the laser, lengthen the exposure.", 10, 30),
              Below, "DN", 20, 5, 10),
      limited(
          state("rig.temperature", Degraded, "The rig is warmer than its calibration allows.",
                "Positions of cameras and lasers move.", "Check cooling and air; calibrate if it stays so.", 60, 60),
          Above, "degC", 45, 2, 10),
      limited(state("disk.low", Degraded, "The disk is nearly full.", "Records of rails cannot be kept.",
                    "Prune the archive or enlarge the disk.", 10, 10),
              Below, "GB", 10, 2, 0),
      state("archive.unreachable", Degraded, "The archive does not answer.",
            "Rails are measured; their records wait on this machine's disk.",
            "Check database and network; records are sent when it is back.", 10, 5),
      limited(state("pipeline.late", Degraded, "The queues of the measurement fill up.", "Profiles will be dropped.",
                    "Close what else runs on this machine; lower the trigger rate.", 5, 10),
              Above, "%", 80, 20, 1),
      limited(state("window.slow", Degraded, "The window answers slowly.",
                    "What it shows is late; the measurement goes on.",
                    "Close what else runs on this machine; see Diagnostics.", 10, 30),
              Above, "ms", 200, 100, 5),
  };
}

Expected<void> checkRule(const AlarmRule& r) {
  const std::string where = "alarm " + r.id;
  if (r.id.empty()) return inputError("alarms", "a rule has no id");
  if (r.cause.empty() || r.consequence.empty() || r.action.empty())
    return inputError(where, "an alarm has a cause, a consequence and an action; anything else is an event");
  for (const double seconds : {r.filterS, r.onDelayS, r.offDelayS})
    if (!(seconds >= 0 && seconds <= kLongestS)) return inputError(where, "filter and delays lie between 0 and 3600 s");
  if (!(r.deadband >= 0 && r.deadband <= kFarthest)) return inputError(where, "the deadband must be 0 or more");
  if (!std::isfinite(r.limit)) return inputError(where, "the limit must be a number");
  return {};
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace

const std::vector<AlarmRule>& standardAlarmRules() {
  static const std::vector<AlarmRule> rules = makeStandardRules();
  return rules;
}

Expected<void> checkAlarmRules(const std::vector<AlarmRule>& rules) {
  std::set<std::string> ids;
  for (const AlarmRule& r : rules) {
    if (auto fine = checkRule(r); !fine) return fine;
    if (!ids.insert(r.id).second) return inputError("alarm " + r.id, "stands there twice");
  }
  return {};
}

namespace {

Expected<std::vector<AlarmRule>> read(TomlReader reader, std::vector<AlarmRule> rules) {
  for (AlarmRule& r : rules) {
    const std::string at = "alarm." + r.id + ".";
    r.priority = static_cast<AlarmPriority>(reader.integer(at + "priority", 1, 3, static_cast<int>(r.priority)));
    r.onDelayS = reader.number(at + "on_delay_s", 0, kLongestS, r.onDelayS);
    r.offDelayS = reader.number(at + "off_delay_s", 0, kLongestS, r.offDelayS);
    if (r.condition == AlarmCondition::State) continue;
    r.limit = reader.number(at + "limit", -kFarthest, kFarthest, r.limit);
    r.deadband = reader.number(at + "deadband", 0, kFarthest, r.deadband);
    r.filterS = reader.number(at + "filter_s", 0, kLongestS, r.filterS);
  }
  if (auto done = reader.finish(); !done) return tl::unexpected(done.error());
  return rules;
}

}  // namespace

Expected<std::vector<AlarmRule>> loadAlarmRules(const std::filesystem::path& file, std::vector<AlarmRule> rules) {
  auto reader = TomlReader::load(file);
  if (!reader) return tl::unexpected(reader.error());
  return read(std::move(*reader), std::move(rules));
}

Expected<std::vector<AlarmRule>> parseAlarmRules(std::string_view text, const std::string& nameInErrors,
                                                 std::vector<AlarmRule> rules) {
  auto reader = TomlReader::parse(text, nameInErrors);
  if (!reader) return tl::unexpected(reader.error());
  return read(std::move(*reader), std::move(rules));
}

std::string toToml(const std::vector<AlarmRule>& rules) {
  std::string text = "format = 1\n";
  for (const AlarmRule& r : rules) {
    text += "\n# " + r.cause + "\n[alarm." + r.id + "]\n";
    text += "priority = " + std::to_string(static_cast<int>(r.priority)) + "\n";
    if (r.condition != AlarmCondition::State) {
      text += "limit = " + number(r.limit) + "  # " + r.unit +
              (r.condition == AlarmCondition::Above ? ", above\n" : ", below\n");
      text += "deadband = " + number(r.deadband) + "\nfilter_s = " + number(r.filterS) + "\n";
    }
    text += "on_delay_s = " + number(r.onDelayS) + "\noff_delay_s = " + number(r.offDelayS) + "\n";
  }
  return text;
}

}  // namespace vignole
