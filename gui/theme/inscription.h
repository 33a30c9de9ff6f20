#pragma once
// Sentences with names of dimensions in them, and short numbers beside bars and clocks. Values themselves are written
// by report/dimension_text.h, the same on screen and on paper.

#include <QPainter>
#include <QString>

#include "engine/rail/dimension.h"

namespace vignole {

/// "RAS_l": an underscore lowers the one letter that follows it. Used for names of dimensions inside sentences.
[[nodiscard]] double inscriptionWidth(const QFont& font, const QString& text);
/// From `left` on the baseline, in the painter's pen; longer than `maxWidth` (> 0) ends with an ellipsis at a word.
/// Returns the width that was used.
double paintInscription(QPainter& painter, double left, double baseline, const QFont& font, const QString& text,
                        double maxWidth = 0);

/// Without trailing zeros: limits beside a bar.
[[nodiscard]] QString shortSigned(double value, int decimals = 3);
/// Thousands parted by a thin gap.
[[nodiscard]] QString count(std::uint64_t value);
/// "1.2 s", "2 min 14 s", "3 h 5 min": units that need no translation.
[[nodiscard]] QString age(double seconds);
/// "FT_r" as people and screen readers say it: "FT r".
[[nodiscard]] QString spoken(Dimension dimension);
/// "FT_r", for inscriptions.
[[nodiscard]] QString inscribed(Dimension dimension);

}  // namespace vignole
