#include "report/drawing_frame.h"

#include <algorithm>
#include <cmath>

namespace vignole {

namespace {
constexpr double kRowPx = 4;
constexpr double kMarginPx = 16;    // to the sides of the area
constexpr double kGapPx = 8;        // to the rail and to other texts
constexpr double kFarthestPx = 24;  // from the widest part of the rail
constexpr double kStepPx = 6;       // of the search
}  // namespace

FreeSpace::FreeSpace(const QRectF& area)
    : area_(area), rows_(static_cast<std::size_t>(std::max(1.0, std::ceil(area.height() / kRowPx)))) {}

std::size_t FreeSpace::row(double y) const {
  const double r = std::clamp((y - area_.top()) / kRowPx, 0.0, static_cast<double>(rows_.size() - 1));
  return static_cast<std::size_t>(r);
}

void FreeSpace::occupy(const QPointF& point) {
  if (point.y() < area_.top() || point.y() > area_.bottom()) return;
  Span& span = rows_[row(point.y())];
  span.left = std::min(span.left, point.x());
  span.right = std::max(span.right, point.x());
  widest_.left = std::min(widest_.left, point.x());
  widest_.right = std::max(widest_.right, point.x());
}

void FreeSpace::occupy(const QRectF& rect) { taken_.push_back(rect.adjusted(-kGapPx, -kGapPx, kGapPx, kGapPx)); }

bool FreeSpace::free(const QRectF& rect) const {
  if (!area_.contains(rect)) return false;
  for (std::size_t r = row(rect.top() - kGapPx); r <= row(rect.bottom() + kGapPx); ++r)
    if (rect.right() + kGapPx > rows_[r].left && rect.left() - kGapPx < rows_[r].right) return false;
  return std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return other.intersects(rect); });
}

QRectF FreeSpace::find(const QSizeF& size, bool leftSide, double wishedMiddleY) const {
  const auto candidate = [&](double middleY) {
    // In a wide area the texts stay beside the rail.
    const double x = leftSide ? std::max(area_.left() + kMarginPx, widest_.left - kFarthestPx - size.width())
                              : std::min(area_.right() - kMarginPx - size.width(), widest_.right + kFarthestPx);
    return QRectF(QPointF(x, middleY - size.height() / 2), size);
  };
  for (double distance = 0; distance < area_.height(); distance += kStepPx)
    for (const double sign : {-1.0, 1.0}) {
      const QRectF rect = candidate(wishedMiddleY + sign * distance);
      if (free(rect)) return rect;
    }
  const double top = area_.top() + size.height() / 2 + kGapPx, bottom = area_.bottom() - size.height() / 2 - kGapPx;
  return candidate(std::clamp(wishedMiddleY, std::min(top, bottom), std::max(top, bottom)));
}

}  // namespace vignole
