#pragma once
// The thirteen dimensions in their fixed order as rows of a table, each with all that its row draws and says.

#include <QAbstractTableModel>
#include <QPointF>
#include <QStringList>
#include <QVector>
#include <optional>
#include <vector>

#include "gui/bridge/line.h"
#include "report/length_unit.h"
#include "report/state_symbol.h"

namespace vignole {

struct DimensionRow {
  Dimension dimension = Dimension::RH;
  StateSymbol symbol = StateSymbol::NoLimit;
  QString word;         ///< of the state
  bool waiting = true;  ///< no profile yet
  bool held = false;
  QString reason;  ///< not measured, because ...
  std::optional<double> valueMm;
  double nominalMm = 0;
  double expandedUMm = 0;                  ///< U, k = 2
  std::optional<double> lowerMm, upperMm;  ///< limits as values
  QVector<QPointF> track;                  ///< m, mm along the rail
  QVector<QPair<double, double>> outside;  ///< stretches out of tolerance, m
  double lengthM = 0, positionM = 0;
  LengthUnit unit = LengthUnit::Millimetre;  ///< in which lengths are written

  [[nodiscard]] bool notMeasured() const { return !waiting && !valueMm; }
};

/// "+0.6": a limit as deviation, in the row's unit.
[[nodiscard]] QString limitBesideBar(double limitMm, const DimensionRow& row);

class DimensionModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { State, Name, Value, Deviation, Uncertainty, Bar, Track, ColumnCount };

  explicit DimensionModel(QObject* parent = nullptr);
  void show(const LineSnapshot& line);
  void setUnit(LengthUnit unit);
  void retranslate();
  /// All words that State may show.
  [[nodiscard]] static QStringList stateWords();
  [[nodiscard]] const DimensionRow& row(int row) const { return rows_[static_cast<std::size_t>(row)]; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  /// DisplayRole: the cell's text; AccessibleTextRole of the first column: the whole row in words.
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] QString text(const DimensionRow& row, int column) const;
  [[nodiscard]] QString sentence(const DimensionRow& row) const;

  std::vector<DimensionRow> rows_;
  LengthUnit unit_ = LengthUnit::Millimetre;
};

}  // namespace vignole
