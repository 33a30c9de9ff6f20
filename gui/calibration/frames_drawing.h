#pragma once
// The frames that a calibration ties together (the paper's Fig. 6): world on the light plane, camera, image.

#include <QWidget>

#include "gui/theme/theme.h"

namespace vignole {

class FramesDrawing : public QWidget {
  Q_OBJECT

 public:
  explicit FramesDrawing(const Theme& theme, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override { return {300, 200}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }  ///< gives way to words

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void retranslate();
  const Theme& theme_;
};

}  // namespace vignole
