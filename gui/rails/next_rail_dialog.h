#pragma once
// The papers of the next rail, entered by hand: id, heat, strand, order, temperature.

#include <QDialog>

#include "engine/acquisition/rail_announcement.h"
#include "gui/theme/theme.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace vignole {

class NextRailDialog : public QDialog {
  Q_OBJECT

 public:
  /// Both outlive it.
  NextRailDialog(const Theme& theme, RailAnnouncements& rails, QWidget* parent = nullptr);
  /// Says whether what was entered still waits; from time to time.
  void refresh();
  [[nodiscard]] QString message() const;

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void retranslate();
  void announce();

  RailAnnouncements& rails_;
  bool waited_ = false;
  QLabel *title_, *message_;
  std::array<QLabel*, 5> labels_;
  std::array<QLineEdit*, 5> fields_;
  QPushButton *announce_, *withdraw_, *close_;
};

}  // namespace vignole
