#pragma once
// The verdict of the rail, readable from two metres, and beside it whether the gauge can be trusted.

#include <QWidget>

#include "gui/monitor/judgement.h"
#include "gui/theme/theme.h"

namespace vignole {

class VerdictPanel : public QWidget {
  Q_OBJECT

 public:
  explicit VerdictPanel(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line, LengthUnit unit = LengthUnit::Millimetre);
  [[nodiscard]] const VerdictText& verdict() const { return verdict_; }
  [[nodiscard]] const GaugeTrust& trust() const { return trust_; }
  [[nodiscard]] QSize sizeHint() const override { return {1055, 120}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {640, 88}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintTrust(QPainter& painter, double left) const;

  const Theme& theme_;
  VerdictText verdict_;
  GaugeTrust trust_;
  bool simulation_ = false;
};

}  // namespace vignole
