#pragma once
// Draws the cells of the dimension table: symbol and word, value, tolerance bar with guard band, course along the rail.

#include <QHeaderView>
#include <QStyledItemDelegate>

#include "gui/monitor/dimension_model.h"
#include "gui/theme/theme.h"

namespace vignole {

class DimensionCells : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit DimensionCells(const Theme& theme, QObject* parent = nullptr);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintGround(QPainter& painter, const QRectF& box, const DimensionRow& row, const QModelIndex& index,
                   const QStyleOptionViewItem& option) const;
  void paintBar(QPainter& painter, const QRectF& box, const DimensionRow& row) const;
  void paintTrack(QPainter& painter, const QRectF& box, const DimensionRow& row) const;

  const Theme& theme_;
};

/// Column heads: small, grey, over the edge on which their column is aligned.
class DimensionHeads : public QHeaderView {
  Q_OBJECT

 public:
  explicit DimensionHeads(const Theme& theme, QWidget* parent = nullptr);

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int logicalIndex) const override;

 private:
  const Theme& theme_;
};

}  // namespace vignole
