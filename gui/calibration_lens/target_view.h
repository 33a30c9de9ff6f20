#pragma once
// One camera's picture of the target: points found, where to hold it next, and which parts of the picture have been
// seen by the pictures that were taken.

#include <QImage>
#include <QPixmap>
#include <QWidget>
#include <memory>
#include <vector>

#include "gui/calibration_lens/lens_stand.h"
#include "gui/theme/theme.h"

namespace vignole {

class TargetPicture : public QWidget {
  Q_OBJECT

 public:
  explicit TargetPicture(const Theme& theme, QWidget* parent = nullptr);
  /// `ghost`: outline of the target where it is to be held, px; empty: none.
  void show(std::shared_ptr<const LensSight> sight, std::vector<Point2> ghost);
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 230}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  const Theme& theme_;
  std::shared_ptr<const LensSight> sight_;
  std::vector<Point2> ghost_;
  QImage image_;
  QPixmap scaled_;
};

/// Cells of the picture by how many points they have.
class CoverageMap : public QWidget {
  Q_OBJECT

 public:
  explicit CoverageMap(const Theme& theme, QWidget* parent = nullptr);
  void show(const std::vector<TargetView>& taken, const std::vector<Point2>& ghost, int widthPx, int heightPx);
  [[nodiscard]] double share() const { return coverage_.share(); }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 130}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  Coverage coverage_;
  std::vector<Point2> points_, ghost_;
  int widthPx_ = 1, heightPx_ = 1;
};

}  // namespace vignole
