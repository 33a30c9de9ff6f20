#pragma once
// A row per dimension: U of the calibration in force, of a new one, what the tolerances allow, and who is to blame.

#include <QTableWidget>
#include <vector>

#include "gui/bridge/units.h"
#include "gui/calibration_records/dimension_worth.h"
#include "gui/theme/theme.h"
#include "report/state_symbol.h"

namespace vignole {

class WorthTable : public QTableWidget {
  Q_OBJECT

 public:
  WorthTable(const Theme& theme, const Units& units, QWidget* parent = nullptr);
  void show(std::vector<DimensionWorth> worth);
  [[nodiscard]] const std::vector<DimensionWorth>& worth() const { return worth_; }
  void retranslate();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fill();

  const Theme& theme_;
  const Units& units_;
  std::vector<DimensionWorth> worth_;
};

/// A length, or an en dash.
[[nodiscard]] QString lengthText(const std::optional<double>& mm, const Units& units, int decimalsOfMm = 3);

/// A table of figures beside a wizard's step: small rows, nothing to choose.
[[nodiscard]] QTableWidget* makeFigureTable(int columns, QWidget* parent);

}  // namespace vignole
