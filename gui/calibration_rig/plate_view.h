#pragma once
// One camera's picture of the plate: what was found in it, what was refused and why, and where the plate is to lie.

#include <QImage>
#include <QPixmap>
#include <QWidget>
#include <memory>
#include <vector>

#include "gui/calibration_rig/plate_stand.h"
#include "gui/theme/theme.h"
#include "report/state_symbol.h"

namespace vignole {

class PlateView : public QWidget {
  Q_OBJECT

 public:
  PlateView(const Theme& theme, int camera, QWidget* parent = nullptr);
  /// `ghost`: outlines of the pins where the plate is to lie, px; empty: it lies there. Null sight: nothing yet.
  void show(std::shared_ptr<const PlateSight> sight, std::vector<std::vector<Point2>> ghost);
  /// Of the picture in a word or two, with its shape.
  [[nodiscard]] const QString& word() const { return word_; }
  [[nodiscard]] StateSymbol symbol() const { return symbol_; }
  void retranslate();
  [[nodiscard]] QSize minimumSizeHint() const override { return {230, 150}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void judge();
  void paintPicture(QPainter& painter);
  void paintArcs(QPainter& painter, const PinPicture& lines) const;
  void paintRefusal(QPainter& painter, const std::string& refusal) const;
  [[nodiscard]] QRectF pictureArea() const;
  [[nodiscard]] QPointF onScreen(const Point2& px) const;

  const Theme& theme_;
  int camera_;
  std::shared_ptr<const PlateSight> sight_;
  std::vector<std::vector<Point2>> ghost_;
  QImage image_;
  QPixmap scaled_;
  QString word_;
  StateSymbol symbol_ = StateSymbol::NotMeasured;
};

}  // namespace vignole
