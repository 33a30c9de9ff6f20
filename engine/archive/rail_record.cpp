#include "engine/archive/rail_record.h"

#include <array>
#include <chrono>
#include <cstdio>

namespace vignole {

namespace {

using Days = std::chrono::sys_days;
using Micros = std::chrono::microseconds;

}  // namespace

TimeUs systemTimeUs() {
  return std::chrono::duration_cast<Micros>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string isoTime(TimeUs time) {
  const std::chrono::sys_time<Micros> instant{Micros(time)};
  const auto day = std::chrono::floor<std::chrono::days>(instant);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(instant - day);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02lld:%02lld:%02lld.%06lldZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<long long>(clock.hours().count()), static_cast<long long>(clock.minutes().count()),
                static_cast<long long>(clock.seconds().count()), static_cast<long long>(clock.subseconds().count()));
  return text.data();
}

Expected<TimeUs> timeFromIso(std::string_view text) {
  const std::string whole(text);
  int year = 0, hour = 0, minute = 0, used = 0;
  unsigned month = 0, day = 0;
  double second = 0;
  const auto bad = [&] {
    return inputError(whole, "is no date and time; write 2025-03-07 or 2025-03-07T14:05:09, UTC");
  };
  if (std::sscanf(whole.c_str(), "%4d-%2u-%2u%n", &year, &month, &day, &used) != 3) return bad();
  if (static_cast<std::size_t>(used) < whole.size()) {
    int more = 0;
    const char* rest = whole.c_str() + used;
    if ((rest[0] != 'T' && rest[0] != ' ') ||
        std::sscanf(rest + 1, "%2d:%2d:%9lf%n", &hour, &minute, &second, &more) != 3)
      return bad();
    const std::string_view tail = rest + 1 + more;
    if (!tail.empty() && tail != "Z") return bad();
  }
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  if (!date.ok() || hour < 0 || hour > 23 || minute < 0 || minute > 59 || !(second >= 0 && second < 61)) return bad();
  const auto days = Days(date).time_since_epoch();
  return std::chrono::duration_cast<Micros>(days).count() + (hour * 3600LL + minute * 60LL) * 1'000'000 +
         static_cast<TimeUs>(second * 1e6 + 0.5);
}

std::string_view name(RailState state) {
  switch (state) {
    case RailState::Running:
      return "running";
    case RailState::Finished:
      return "finished";
    case RailState::Interrupted:
      break;
  }
  return "interrupted";
}

}  // namespace vignole
