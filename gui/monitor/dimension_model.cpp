#include "gui/monitor/dimension_model.h"

#include "gui/theme/inscription.h"
#include "report/dimension_text.h"
#include "report/engine_words.h"

namespace vignole {

namespace {

void fillLatest(DimensionRow& row, const LineSnapshot& line) {
  const DimensionResult& r = line.latest->measurement.dimensions[index(row.dimension)];
  row.waiting = false;
  row.held = line.held();
  row.valueMm = r.valueMm;
  row.nominalMm = r.nominalMm;
  row.expandedUMm = 2 * r.uMm;
  row.lowerMm = r.lowerMm;
  row.upperMm = r.upperMm;
  row.positionM = line.latest->profile.positionMm / 1000;
  row.reason = inWords(r.reason);
  row.symbol = symbolOf(r.verdict);
  row.word = r.verdict == Verdict::NotMeasured ? DimensionModel::tr("Not meas.") : wordOf(r.verdict);
  if (row.held && r.valueMm) {
    row.symbol = StateSymbol::Held;
    row.word = DimensionModel::tr("Held");
  }
}

void fillTrack(DimensionRow& row, const RailSummary& rail) {
  const DimensionSummary& summary = rail.dimensions[index(row.dimension)];
  row.lengthM = rail.rail.lengthMm > 0 ? rail.rail.lengthMm / 1000 : rail.lengthM;
  for (const TrackBin& bin : summary.track)
    if (bin.count > 0) row.track.append({bin.positionM, bin.meanMm});
  for (const DimensionException& e : summary.exceptions) row.outside.append({e.fromM, e.toM});
}

}  // namespace

QString limitBesideBar(double limitMm, const DimensionRow& row) {
  return shortSigned(inUnit(limitMm - row.nominalMm, row.unit), decimalsIn(row.unit, 3));
}

DimensionModel::DimensionModel(QObject* parent) : QAbstractTableModel(parent), rows_(kDimensionCount) {
  for (const Dimension d : kDimensions) rows_[vignole::index(d)].dimension = d;
}

void DimensionModel::show(const LineSnapshot& line) {
  for (DimensionRow& row : rows_) {
    DimensionRow fresh;
    fresh.dimension = row.dimension;
    fresh.word = QStringLiteral("–");
    fresh.unit = unit_;
    if (line.latest) fillLatest(fresh, line);
    if (line.rail) fillTrack(fresh, *line.rail);
    row = std::move(fresh);
  }
  emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

QStringList DimensionModel::stateWords() {
  QStringList words{tr("Not meas."), tr("Held")};
  for (const Verdict v : {Verdict::Pass, Verdict::Near, Verdict::Fail, Verdict::NoLimit}) words << wordOf(v);
  return words;
}

void DimensionModel::setUnit(LengthUnit unit) {
  unit_ = unit;
  for (DimensionRow& row : rows_) row.unit = unit;
  retranslate();
}

void DimensionModel::retranslate() {
  emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
  emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int DimensionModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int DimensionModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString DimensionModel::text(const DimensionRow& row, int column) const {
  const int places = decimalsOf(row.dimension);
  const QString none = QStringLiteral("–");
  switch (column) {
    case State:
      return row.word;
    case Name:
      return spoken(row.dimension);
    case Value:
      if (row.notMeasured())
        return row.reason.isEmpty() ? tr("Not measured") : tr("Not measured, because %1").arg(row.reason);
      return row.valueMm ? lengthText(*row.valueMm, places, row.unit) : none;
    case Deviation:
      return row.valueMm ? deviationText(inUnit(*row.valueMm - row.nominalMm, row.unit), decimalsIn(row.unit, places))
                         : none;
    case Uncertainty:
      return row.valueMm ? QChar(0x00B1) + lengthText(row.expandedUMm, places, row.unit) : none;
    case Bar:
      if (!row.lowerMm && !row.upperMm) return tr("no limit");
      return tr("limits %1 to %2")
          .arg(row.lowerMm ? limitBesideBar(*row.lowerMm, row) : none,
               row.upperMm ? limitBesideBar(*row.upperMm, row) : none);
    case Track:
      return row.outside.isEmpty()
                 ? QString()
                 : tr("%n stretch(es) out of tolerance", nullptr, static_cast<int>(row.outside.size()));
    default:
      return {};
  }
}

QString DimensionModel::sentence(const DimensionRow& row) const {
  QString words = QStringLiteral("%1, %2: ").arg(spoken(row.dimension), titleOf(row.dimension));
  if (row.waiting) return words + tr("waiting for a profile");
  if (row.notMeasured()) return words + text(row, Value);
  return words + tr("%1, %2 %3, deviation %4, U %5, %6")
                     .arg(row.word, text(row, Value), QString::fromLatin1(unitName(row.unit)), text(row, Deviation),
                          text(row, Uncertainty), text(row, Bar));
}

QVariant DimensionModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const DimensionRow& r = row(index.row());
  if (role == Qt::DisplayRole) return text(r, index.column());
  if (role == Qt::AccessibleTextRole) return index.column() == State ? sentence(r) : text(r, index.column());
  if (role == Qt::ToolTipRole && r.notMeasured()) return text(r, Value);
  if (role == Qt::ToolTipRole && index.column() == Name) return sentence(r);
  return {};
}

QVariant DimensionModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return spoken(row(section).dimension);
  switch (section) {
    case State:
      return tr("State");
    case Name:
      return tr("Dimension");
    case Value:
      return QString::fromLatin1(unitName(unit_));
    case Deviation:
      return tr("Deviation");
    case Uncertainty:
      return tr("U (k = 2)");
    case Bar:
      return tr("Tolerance and guard band");
    case Track:
      return tr("Along the rail");
    default:
      return {};
  }
}

}  // namespace vignole
