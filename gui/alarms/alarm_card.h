#pragma once
// One alarm, or in a flood the alarms of one rule, with cause, consequence, action and what may be done.

#include <QFrame>

#include "engine/alarms/alarm_book.h"
#include "gui/theme/theme.h"

class QGridLayout;

namespace vignole {

class AlarmCard : public QFrame {
  Q_OBJECT

 public:
  AlarmCard(const Theme& theme, const AlarmRule& rule, const Alarm& alarm, bool mayAcknowledge);
  AlarmCard(const Theme& theme, const AlarmRule& rule, const AlarmGroup& group, bool mayAcknowledge);

 signals:
  void acknowledged(const std::vector<std::uint64_t>& alarms);

 private:
  QGridLayout* frame(AlarmPriority priority, bool open, const QString& title, const QString& right);
  void words(QGridLayout& grid, const QString& cause, const AlarmRule& rule);
  void button(QGridLayout& grid, const QString& title, const std::vector<std::uint64_t>& alarms, bool mayAcknowledge);

  const Theme& theme_;
};

/// The sign of a priority as a picture of so many pixels.
[[nodiscard]] QPixmap priorityPixmap(AlarmPriority priority, const Palette& palette, int pixels);

}  // namespace vignole
