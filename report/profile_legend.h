#pragma once
// The row below the profile: what each line is, and two scale bars, one of them magnified.

#include <QPainter>
#include <QRectF>

#include "report/palette.h"
#include "report/profile_drawing.h"

namespace vignole {

struct ProfileLegend {
  const ProfileDrawing& drawing;
  const Palette& palette;
  double scale;  ///< body text over 16 px
  double pxPerMm;
};

/// What does not fit beside the scale bars is left out from the right.
void paintProfileLegend(QPainter& painter, const QRectF& area, const ProfileLegend& legend);

}  // namespace vignole
