#pragma once
// The plate as it must lie, seen from the cameras' side; and, dashed, as it lies.

#include <QWidget>
#include <optional>

#include "gui/calibration_rig/plate_stand.h"
#include "gui/theme/theme.h"

namespace vignole {

class PlateDrawing : public QWidget {
  Q_OBJECT

 public:
  explicit PlateDrawing(const Theme& theme, QWidget* parent = nullptr);
  void show(const PinPlate& plate, const PlatePose& wanted, const std::optional<PlatePose>& seen);
  [[nodiscard]] QSize minimumSizeHint() const override { return {150, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  PinPlate plate_;
  PlatePose wanted_;
  std::optional<PlatePose> seen_;
};

}  // namespace vignole
