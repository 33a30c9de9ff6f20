#pragma once
// A section with its primitives named on it, as the paper's Table I; or the lines of a drawing that is none, with the
// first place where they do not meet.

#include <QWidget>
#include <optional>
#include <vector>

#include "engine/rail/outline.h"
#include "engine/rail/section.h"
#include "gui/theme/theme.h"

namespace vignole {

class SectionDrawing : public QWidget {
  Q_OBJECT

 public:
  explicit SectionDrawing(const Theme& theme, QWidget* parent = nullptr);
  void show(const Section& section);
  void showOpen(const std::vector<Piece>& pieces, const std::optional<OutlineGap>& gap);
  void showMessage(const QString& message);
  /// Drawn broad; empty: none.
  void setChosen(const QString& primitive);
  /// Where the names stand, for tests: none covers another.
  [[nodiscard]] const std::vector<QRectF>& labels() const { return labels_; }
  [[nodiscard]] const std::optional<OutlineGap>& gap() const { return gap_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Line {
    QString name;
    Primitive shape;
  };
  struct View {
    QPointF origin;
    double pxPerMm = 1;
    [[nodiscard]] QPointF map(const Point2& p) const { return origin + QPointF(p.x(), -p.y()) * pxPerMm; }
  };
  [[nodiscard]] View view() const;
  void paintNames(QPainter& painter, const View& view);
  void paintGap(QPainter& painter, const View& view) const;

  const Theme& theme_;
  std::vector<Line> lines_;
  bool closed_ = false;
  std::optional<OutlineGap> gap_;
  QString message_, chosen_;
  std::vector<QRectF> labels_;
};

}  // namespace vignole
