#pragma once
// From the section frame (mm, y up) to the painter (px, y down), and the room that is left beside the rail.

#include <QPointF>
#include <QRectF>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole {

struct DrawingFrame {
  QRectF area;            ///< of the drawing proper, legend left out, px
  Point2 centreMm{0, 0};  ///< what lies in the middle of `area`
  double pxPerMm = 1;

  [[nodiscard]] QPointF map(const Point2& p) const {
    return area.center() + QPointF((p.x() - centreMm.x()) * pxPerMm, (centreMm.y() - p.y()) * pxPerMm);
  }
  [[nodiscard]] QPointF map(const Point2& p, const Point2& normal, double offsetMm) const {
    return map(Point2(p + offsetMm * normal));
  }
};

/// Where a text may stand without covering the rail or another text.
class FreeSpace {
 public:
  explicit FreeSpace(const QRectF& area);
  void occupy(const QPointF& point);  ///< part of the rail: everything between the leftmost and rightmost is taken
  void occupy(const QRectF& rect);
  /// A place of this size on one side of the rail, as near as possible to the wished height. Where there is none the
  /// wish is kept inside the area.
  [[nodiscard]] QRectF find(const QSizeF& size, bool leftSide, double wishedMiddleY) const;
  [[nodiscard]] bool free(const QRectF& rect) const;

 private:
  [[nodiscard]] std::size_t row(double y) const;
  struct Span {
    double left = 1e9, right = -1e9;
  };
  QRectF area_;
  std::vector<Span> rows_;
  Span widest_;
  std::vector<QRectF> taken_;
};

}  // namespace vignole
