#pragma once
// Alarms as people read them, in the language of the screen.

#include <QDateTime>
#include <QString>

#include "engine/alarms/alarm_book.h"

namespace vignole {

/// "Rail V1-0007 out of tolerance: WT and HW", "A camera does not answer while a rail passes: camera 3"; no period.
[[nodiscard]] QString alarmTitle(const AlarmRule& rule, const std::string& source,
                                 const std::vector<std::string>& details = {});
/// Cause, consequence or action of a rule. Rules are written in English; translations go by the text itself.
[[nodiscard]] QString ruleWords(const std::string& english);
/// Details and value where there are any, else the rule's cause.
[[nodiscard]] QString causeWords(const AlarmRule& rule, const Alarm& alarm);
/// A name, or the operator who has none, or an en dash for nobody.
[[nodiscard]] QString personWord(const std::string& who);
[[nodiscard]] QDateTime localTime(AlarmTime time);

}  // namespace vignole
