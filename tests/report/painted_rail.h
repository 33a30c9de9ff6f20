#pragma once
// A 60E1 made by hand for the drawings: points on the outline with a smooth deviation and noise, placed in the world by
// a pose, with the registration and the dimensions that belong to it.

#include <QImage>
#include <functional>
#include <string>

#include "engine/inspection/rail_summary.h"
#include "report/profile_drawing.h"
#include "report/rail_report.h"

namespace vignole::test {

struct PaintedRail {
  Recipe recipe;
  ProfileResult result;
  RailSummary summary;
};

/// Right everywhere unless told otherwise; `missingCamera` 0..3, or -1 for none.
PaintedRail paintedRail(int missingCamera = -1);
/// Gives a dimension a value that its verdict fits.
void setValue(PaintedRail& rail, Dimension dimension, double deviationMm);

/// The drawing of the rail on its ground, in the mock-up's size unless told otherwise.
QImage drawn(const PaintedRail& rail, const Palette& palette, const std::function<void(ProfileDrawing&)>& change = {},
             QSize size = {816, 616});

/// Where VIGNOLE_KEEP_PICTURES names a folder, the picture is left there to be looked at.
void keep(const QImage& image, const std::string& name);
/// Pixels that differ between two pictures of the same size.
int differentPixels(const QImage& a, const QImage& b);
/// Pixels near a colour (each channel within 24).
int pixelsOf(const QImage& image, const QColor& colour);

}  // namespace vignole::test
