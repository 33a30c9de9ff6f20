#include "gui/monitor/dimension_table.h"

#include <QFontMetricsF>
#include <QHeaderView>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {
// Below these widths the course along the rail goes first, then U.
constexpr int kWidthWithTrack = 900, kWidthWithUncertainty = 700;
}  // namespace

DimensionTable::DimensionTable(const Theme& theme, QWidget* parent)
    : QTableView(parent), theme_(theme), model_(new DimensionModel(this)) {
  setModel(model_);
  setItemDelegate(new DimensionCells(theme, this));
  setHorizontalHeader(new DimensionHeads(theme, this));
  verticalHeader()->hide();
  verticalHeader()->setMinimumSectionSize(20);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setFrameShape(NoFrame);
  setWordWrap(false);
  setTabKeyNavigation(false);  // Tab goes on to the next control
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  horizontalHeader()->setMinimumSectionSize(20);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { emit chosenChanged(chosen()); });
  connect(&theme_, &Theme::changed, this, [this] { viewport()->update(); });
  retranslate();
}

void DimensionTable::setUnit(LengthUnit unit) { model_->setUnit(unit); }

void DimensionTable::retranslate() {
  setAccessibleName(tr("Dimensions"));
  model_->retranslate();
  layOutColumns();
}

void DimensionTable::show(const LineSnapshot& line) {
  model_->show(line);
  spanReasons();
}

void DimensionTable::choose(std::optional<Dimension> dimension) {
  if (dimension)
    selectRow(static_cast<int>(vignole::index(*dimension)));
  else
    clearSelection();
}

std::optional<Dimension> DimensionTable::chosen() const {
  const QModelIndexList rows = selectionModel()->selectedRows();
  if (rows.isEmpty()) return {};
  return model_->row(rows.front().row()).dimension;
}

void DimensionTable::mousePressEvent(QMouseEvent* event) {
  const QModelIndex at = indexAt(event->pos());
  if (at.isValid() && selectionModel()->isRowSelected(at.row()))
    clearSelection();  // a second press on the chosen row lets go of it
  else
    QTableView::mousePressEvent(event);
}

void DimensionTable::focusInEvent(QFocusEvent* event) {
  QTableView::focusInEvent(event);
  // The ring shows where the arrow keys start; only they or Space choose.
  if (!currentIndex().isValid()) selectionModel()->setCurrentIndex(model_->index(0, 0), QItemSelectionModel::NoUpdate);
}

void DimensionTable::spanReasons() {
  constexpr int kFirst = DimensionModel::Value;
  for (int row = 0; row < model_->rowCount(); ++row) {
    const int wanted = model_->row(row).notMeasured() ? DimensionModel::ColumnCount - kFirst : 1;
    if (columnSpan(row, kFirst) != wanted) setSpan(row, kFirst, 1, wanted);
  }
}

void DimensionTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  layOutColumns();
}

int DimensionTable::stateWidth() const {
  const QFontMetricsF metrics(uiFont(16, 500));
  double widest = 0;
  for (const QString& word : DimensionModel::stateWords()) widest = std::max(widest, metrics.horizontalAdvance(word));
  return 16 + 34 + static_cast<int>(std::ceil(widest)) + 8;
}

void DimensionTable::layOutColumns() {
  const int width = viewport()->width();
  const bool track = width >= kWidthWithTrack, uncertainty = width >= kWidthWithUncertainty;
  setColumnHidden(DimensionModel::Track, !track);
  setColumnHidden(DimensionModel::Uncertainty, !uncertainty);
  // Shares of the mock-up's 1054 px; what is over goes to the bar and the course.
  const int state = std::max(140, stateWidth()), name = width < kWidthWithTrack ? 84 : 96;
  const int value = width < kWidthWithTrack ? 112 : 116, deviation = width < kWidthWithTrack ? 92 : 106;
  const int u = uncertainty ? 88 : 0;
  int rest = width - state - name - value - deviation - u;
  const int course = track ? std::max(190, rest * 2 / 5) : 0;
  setColumnWidth(DimensionModel::State, state);
  setColumnWidth(DimensionModel::Name, name);
  setColumnWidth(DimensionModel::Value, value);
  setColumnWidth(DimensionModel::Deviation, deviation);
  if (uncertainty) setColumnWidth(DimensionModel::Uncertainty, u);
  if (track) setColumnWidth(DimensionModel::Track, course);
  setColumnWidth(DimensionModel::Bar, rest - course);

  // Rows share the height to the last pixel: no strip without a row at the foot.
  const int rows = model_->rowCount(), height = viewport()->height();
  for (int row = 0; row < rows; ++row) setRowHeight(row, height * (row + 1) / rows - height * row / rows);
}

}  // namespace vignole
