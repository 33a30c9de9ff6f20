#pragma once
// The blocks that the page and the picture of a rail share. Every one scales with the painter's font (16 px: scale 1).

#include <QPainter>
#include <QRectF>
#include <QString>
#include <variant>
#include <vector>

#include "report/palette.h"
#include "report/rail_report.h"

namespace vignole {

/// Running text in which names of dimensions keep their lowered index.
using TextRuns = std::vector<std::variant<QString, Dimension>>;
/// Draws on one line from the base line's left end; what passes `widthPx` is cut with an ellipsis. Returns the advance.
double drawRuns(QPainter& painter, const QPointF& baseLine, const TextRuns& runs, double widthPx);

struct Fact {
  QString label, value;
};
/// Who, what, when: rail, heat, section, recipe, calibration, length, profiles, temperature, times, program.
[[nodiscard]] std::vector<Fact> factsOf(const RailReport& report);
/// In columns, row by row.
void paintFacts(QPainter& painter, const QRectF& area, const std::vector<Fact>& facts, int columns,
                const Palette& palette);

/// "Good", "Near limit", "Out of tolerance", "Not valid".
[[nodiscard]] QString verdictHeadline(Verdict verdict);
/// "WT out of tolerance in 2 stretches, 37.0 to 41.4 m; RAS_l near its limit"
[[nodiscard]] TextRuns verdictReason(const RailSummary& summary);
void paintVerdict(QPainter& painter, const QRectF& area, const RailReport& report, const Palette& palette);
/// The word SIMULATION in a frame, its right end at `right`. Returns its width.
double paintSimulationMark(QPainter& painter, const QPointF& rightMiddle, const Palette& palette);

/// Least height of the table of dimensions, thirteen rows under a head; its rows share what it is given.
[[nodiscard]] double dimensionTableHeight(double scale);
void paintDimensionTable(QPainter& painter, const QRectF& area, const RailSummary& summary, const Palette& palette);

/// The worst dimensions first: out, not measured, near, then how much of the tolerance is used.
[[nodiscard]] std::vector<Dimension> worstFirst(const RailSummary& summary);

}  // namespace vignole
