#pragma once
// Arrowed measures (the paper's Fig. 5) and the texts beside the drawing, placed so that nothing covers anything.

#include <QPainter>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "report/drawing_frame.h"
#include "report/palette.h"
#include "report/profile_drawing.h"
#include "report/state_symbol.h"

namespace vignole {

/// A text with a symbol, tied to a place of the drawing.
struct Callout {
  std::optional<StateSymbol> symbol;
  std::optional<Dimension> dimension;  ///< written before the title
  QString title, detail;
  QColor ink;
  std::optional<QColor> ground;   ///< none: text on the bare drawing
  std::optional<QPointF> target;  ///< px; a line leads there
  double wishedY = 0;             ///< px, middle
  bool leftSide = false;
};

class ProfileCallouts {
 public:
  /// `scale`: body text of the caller over 16 px. `space` knows what the rail covers.
  ProfileCallouts(QPainter& painter, const DrawingFrame& frame, const Palette& palette, double scale, FreeSpace& space);
  /// The dimensions that need a word, worst first, then the chosen one, with their measures.
  void paintDimensions(const ProfileDrawing& drawing);
  void paint(const Callout& callout);  ///< finds its place and draws its leader
  void finish();                       ///< draws the texts, over everything else

 private:
  void paintDimension(const ProfileDrawing& drawing, Dimension dimension);
  [[nodiscard]] QSizeF sizeOf(const Callout& callout) const;
  void paintBox(const Callout& callout, const QRectF& box);
  void pointAt(const Section& section, Dimension dimension, const std::vector<QPointF>& anchors, Callout& callout);
  void measureGap(const Section& section, QPointF a, QPointF b, Callout& callout);
  void measureAcross(QPointF a, QPointF b, Callout& callout);
  void measureUpright(const std::vector<QPointF>& anchors, Callout& callout);
  void leader(const QPointF& from, const QRectF& box, const QColor& ink);
  void arrow(const QPointF& tip, const QPointF& direction);
  void measureLine(const QPointF& a, const QPointF& b, bool outside, double tailPx);

  QPainter& painter_;
  const DrawingFrame& frame_;
  const Palette& palette_;
  double scale_;
  FreeSpace& space_;
  std::vector<std::pair<Callout, QRectF>> boxes_;
};

}  // namespace vignole
