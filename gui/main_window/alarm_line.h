#pragma once
// The one alarm that matters most of those that nobody has seen, with its action; a grey sentence when there is none.

#include <QWidget>
#include <optional>

#include "engine/alarms/alarm_book.h"
#include "gui/bridge/line.h"
#include "gui/theme/theme.h"

class QPushButton;

namespace vignole {

class AlarmLine : public QWidget {
  Q_OBJECT

 public:
  explicit AlarmLine(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line, const AlarmBook& book);
  [[nodiscard]] const std::optional<Alarm>& alarm() const { return alarm_; }
  [[nodiscard]] const QString& cause() const { return cause_; }
  [[nodiscard]] const QString& quiet() const { return quiet_; }

 signals:
  void acknowledged(std::uint64_t alarm);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void retranslate();

  const Theme& theme_;
  std::optional<Alarm> alarm_;
  QString cause_, action_, position_, quiet_;
  QPushButton* acknowledge_;
};

}  // namespace vignole
