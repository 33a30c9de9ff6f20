#pragma once

#include <QPainter>

#include "engine/alarms/alarm_rule.h"
#include "report/palette.h"

namespace vignole {

/// The shapes of the states, filled, with the priority inside: 1 diamond, 2 square, 3 triangle.
void paintPriority(QPainter& painter, const QRectF& box, AlarmPriority priority, const Palette& palette);

}  // namespace vignole
