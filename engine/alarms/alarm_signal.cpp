#include "engine/alarms/alarm_signal.h"

#include <cmath>

namespace vignole {

namespace {

AlarmDuration duration(double seconds) { return AlarmDuration(std::llround(seconds * 1000)); }

}  // namespace

void AlarmSignal::observe(double value, AlarmTime now) {
  if (!std::isfinite(value)) return;
  if (!filtered_ || !(rule_->filterS > 0)) {
    filtered_ = value;
  } else {
    const double seconds = std::chrono::duration<double>(std::max(AlarmDuration(0), now - lastValue_)).count();
    *filtered_ += (1 - std::exp(-seconds / rule_->filterS)) * (value - *filtered_);
  }
  lastValue_ = now;
  const double inside = raw_ ? rule_->deadband : 0;  // once on, it ends only where the value has come back that far
  switch (rule_->condition) {
    case AlarmCondition::Above:
      set(*filtered_ > rule_->limit - inside, now);
      break;
    case AlarmCondition::Below:
      set(*filtered_ < rule_->limit + inside, now);
      break;
    case AlarmCondition::State:
      set(value != 0, now);
      break;
  }
}

void AlarmSignal::set(bool on, AlarmTime now) {
  advance(now);  // what the old state has come to by now
  if (on != raw_) {
    raw_ = on;
    rawSince_ = now;
  }
  advance(now);
}

void AlarmSignal::advance(AlarmTime now) {
  if (raw_ == on_) return;
  const AlarmTime due = rawSince_ + duration(raw_ ? rule_->onDelayS : rule_->offDelayS);
  if (now < due) return;
  on_ = raw_;
  since_ = due;
}

}  // namespace vignole
