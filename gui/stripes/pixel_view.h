#pragma once
// A few pixels of a picture, large, with the line through them.

#include <QWidget>

#include "gui/stripes/stripe_picture.h"
#include "gui/theme/theme.h"

namespace vignole {

class PixelView : public QWidget {
  Q_OBJECT

 public:
  explicit PixelView(const Theme& theme, QWidget* parent = nullptr);
  /// `centre`: px of the picture; null: nothing to show, `instead` says why.
  void show(LatestFrames::Held taken, QPointF centre, const QString& instead);
  [[nodiscard]] const LatestFrames::Held& taken() const { return taken_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 44}; }
  [[nodiscard]] QSize sizeHint() const override { return {240, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  LatestFrames::Held taken_;
  QPointF centre_;
  QString instead_;
};

}  // namespace vignole
