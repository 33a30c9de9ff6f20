#pragma once
// The one alarm that matters most, with its action; a grey sentence when there is none.

#include <QDateTime>
#include <QWidget>
#include <functional>
#include <optional>

#include "gui/monitor/judgement.h"
#include "gui/theme/theme.h"

namespace vignole {

class AlarmLine : public QWidget {
  Q_OBJECT

 public:
  AlarmLine(const Theme& theme, std::function<QDateTime()> clock, QWidget* parent = nullptr);
  void show(const LineSnapshot& line);
  [[nodiscard]] const std::optional<AlarmSentence>& alarm() const { return alarm_; }
  [[nodiscard]] const QString& quiet() const { return quiet_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  std::function<QDateTime()> clock_;
  std::optional<AlarmSentence> alarm_;
  QDateTime since_;
  QString quiet_;
};

}  // namespace vignole
