#pragma once
// One camera: its picture with the line that is measured with, what is saturated, where it can see, five figures, the
// brightness along the line. The wheel zooms to pixels, a drag moves.

#include <QWidget>
#include <memory>

#include "gui/stripes/stripe_picture.h"
#include "gui/theme/theme.h"

namespace vignole {

class StripeView : public QWidget {
  Q_OBJECT

 public:
  StripeView(const Theme& theme, int camera, QWidget* parent = nullptr);
  void show(std::shared_ptr<const StripePicture> picture);
  /// Where the light plane can be seen, px of the picture.
  void setField(const QPolygonF& field);
  /// Lost, held, frozen, or why there is no picture. Empty: live. `stale`: greyed.
  void setState(const QString& words, bool stale);
  void setRate(double framesPerS);  ///< 0: not told
  void setChosen(bool chosen);
  void zoom(double factor);
  void fit();
  [[nodiscard]] const std::shared_ptr<const StripePicture>& picture() const { return picture_; }
  [[nodiscard]] bool stale() const { return stale_; }
  [[nodiscard]] double scale() const { return zoom_; }  ///< 1: the whole picture
  [[nodiscard]] QSize pictureSize() const;              ///< of the whole picture here, in the screen's own pixels
  [[nodiscard]] QSize minimumSizeHint() const override { return {300, 190}; }

 signals:
  void pressed(int camera);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void retranslate();
  [[nodiscard]] bool hasPixels() const { return picture_ && picture_->taken; }
  [[nodiscard]] QRectF pictureArea() const;
  [[nodiscard]] double baseScale() const;  ///< screen px per px of the picture at zoom 1
  void paintHead(QPainter& painter) const;
  void paintPicture(QPainter& painter, const QRectF& area) const;
  void paintMarks(QPainter& painter, double scale) const;
  void paintFigures(QPainter& painter, const QRectF& area) const;
  void paintBrightness(QPainter& painter, const QRectF& area) const;

  const Theme& theme_;
  int camera_;
  std::shared_ptr<const StripePicture> picture_;
  QPolygonF field_;
  bool stale_ = false, chosen_ = false;
  QString state_;
  double rate_ = 0, zoom_ = 1;
  QPointF centre_{-1, -1};  ///< px of the picture in the middle; < 0: its own
  QPointF dragFrom_;
};

}  // namespace vignole
