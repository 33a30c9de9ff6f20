#pragma once
// The A4 pages of a rail: verdict with drawing and table; tolerance charts; exceptions and ledger.

#include <QByteArray>

#include "report/rail_report.h"

namespace vignole {

/// A whole PDF; empty if the printer could not be started. Units inside: half a point, so that the sizes of the
/// mock-ups in px become 7 to 12 pt.
[[nodiscard]] QByteArray railPdf(const RailReport& report);

}  // namespace vignole
