#pragma once
// The table of the thirteen dimensions: fixed order, one row may be chosen by mouse or keyboard.

#include <QTableView>
#include <optional>

#include "gui/monitor/dimension_cells.h"
#include "gui/monitor/dimension_model.h"

namespace vignole {

class DimensionTable : public QTableView {
  Q_OBJECT

 public:
  explicit DimensionTable(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line);
  void setUnit(LengthUnit unit);
  void retranslate();
  void choose(std::optional<Dimension> dimension);
  [[nodiscard]] std::optional<Dimension> chosen() const;
  [[nodiscard]] const DimensionModel& rows() const { return *model_; }
  [[nodiscard]] QSize sizeHint() const override { return {1053, 630}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {560, 30 + 13 * 26}; }

 signals:
  void chosenChanged(std::optional<Dimension> dimension);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  void layOutColumns();
  [[nodiscard]] int stateWidth() const;
  void spanReasons();

  const Theme& theme_;
  DimensionModel* model_;
};

}  // namespace vignole
