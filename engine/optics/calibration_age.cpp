#include "engine/optics/calibration_age.h"

namespace vignole {

namespace {

/// The digits of `text` from..from+count as a number; empty where one is no digit.
std::optional<int> digits(std::string_view text, std::size_t from, std::size_t count) {
  int value = 0;
  for (const char c : text.substr(from, count)) {
    if (c < '0' || c > '9') return {};
    value = 10 * value + (c - '0');
  }
  return value;
}

constexpr double kClockSlackDays = 1;  // clocks of two machines, time zones set wrongly

}  // namespace

std::optional<std::chrono::sys_seconds> secondsSinceEpoch(std::string_view isoUtc) {
  using namespace std::chrono;
  constexpr std::string_view kPattern = "dddd-dd-ddTdd:dd:ddZ";
  if (isoUtc.size() != kPattern.size()) return {};
  for (std::size_t i = 0; i < kPattern.size(); ++i)
    if (kPattern[i] != 'd' && kPattern[i] != isoUtc[i]) return {};
  const auto y = digits(isoUtc, 0, 4), m = digits(isoUtc, 5, 2), d = digits(isoUtc, 8, 2);
  const auto h = digits(isoUtc, 11, 2), min = digits(isoUtc, 14, 2), s = digits(isoUtc, 17, 2);
  if (!y || !m || !d || !h || !min || !s || *h > 23 || *min > 59 || *s > 60) return {};
  const year_month_day date(year(*y), month(static_cast<unsigned>(*m)), day(static_cast<unsigned>(*d)));
  if (!date.ok()) return {};
  return sys_days(date) + hours(*h) + minutes(*min) + seconds(*s);
}

CalibrationAge ageOf(const RigCalibration& calibration, std::chrono::sys_seconds now) {
  CalibrationAge age;
  const auto created = secondsSinceEpoch(calibration.created);
  if (!created) return age;
  age.days = std::chrono::duration<double, std::ratio<86400>>(now - *created).count();
  age.overdue = calibration.intervalDays > 0 && (*age.days > calibration.intervalDays || *age.days < -kClockSlackDays);
  return age;
}

std::string warningOf(const RigCalibration& calibration, const CalibrationAge& age) {
  if (!age.overdue || !age.days) return {};
  if (*age.days < 0) return "from " + calibration.created + ", which this computer's clock has not reached";
  return std::to_string(static_cast<long>(*age.days)) + " days old, its interval is " +
         std::to_string(calibration.intervalDays) + " days";
}

}  // namespace vignole
