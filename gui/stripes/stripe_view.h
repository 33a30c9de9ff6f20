#pragma once
// One camera: its picture, the line that was extracted, its figures; the wheel zooms to pixels, a drag moves.

#include <QWidget>
#include <memory>

#include "gui/stripes/stripe_watch.h"
#include "gui/theme/theme.h"

namespace vignole {

class StripeView : public QWidget {
  Q_OBJECT

 public:
  StripeView(const Theme& theme, int camera, QWidget* parent = nullptr);
  void show(std::shared_ptr<const StripePicture> picture, bool trial);
  /// Grey, with the words over it: lost, stopped, frozen. Empty: live.
  void setState(const QString& words, bool stale);
  void setChosen(bool chosen);
  void zoom(double factor);
  void fit();
  [[nodiscard]] const std::shared_ptr<const StripePicture>& picture() const { return picture_; }
  [[nodiscard]] double scale() const { return zoom_; }  ///< 1: the whole picture
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 180}; }

 signals:
  void pressed(int camera);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  [[nodiscard]] QRectF pictureArea() const;
  void paintFigures(QPainter& painter, const QRectF& area) const;
  void paintLine(QPainter& painter, const ExtractedLine& line, const QColor& colour, double pxPerPx) const;
  void paintBrightness(QPainter& painter, const QRectF& area) const;

  const Theme& theme_;
  int camera_;
  std::shared_ptr<const StripePicture> picture_;
  bool trial_ = false, stale_ = false, chosen_ = false;
  QString state_;
  double zoom_ = 1;
  QPointF centre_{-1, -1};  ///< px of the picture in the middle; < 0: its own
  QPointF dragFrom_;
};

}  // namespace vignole
