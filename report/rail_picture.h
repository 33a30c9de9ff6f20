#pragma once
// A rail on one picture: drawing, verdict, table, the two charts that matter most.

#include <QImage>

#include "report/palette.h"
#include "report/rail_report.h"

namespace vignole {

/// 1600 x 1024 px.
[[nodiscard]] QImage railPicture(const RailReport& report, const Palette& palette);

}  // namespace vignole
