#include "gui/calibration_records/worth_table.h"

#include <QHeaderView>
#include <QPainter>
#include <algorithm>

#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {
enum Column { kName, kInForce, kNew, kAllowed, kLargest, kColumns };
constexpr std::array<double, kColumns> kShares = {0.20, 0.15, 0.15, 0.16, 0.34};
constexpr std::array<int, kColumns> kLeast = {86, 68, 74, 70, 0};
}  // namespace

QString lengthText(const std::optional<double>& mm, const Units& units, int decimalsOfMm) {
  return mm ? numberText(units.shown(*mm), units.decimals(decimalsOfMm)) : QStringLiteral("–");
}

WorthTable::WorthTable(const Theme& theme, const Units& units, QWidget* parent)
    : QTableWidget(0, kColumns, parent), theme_(theme), units_(units) {
  styleTable(*this);
  setIconSize({16, 16});
  setSelectionMode(QAbstractItemView::NoSelection);
  verticalHeader()->setMinimumSectionSize(22);
  verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  connect(&theme_, &Theme::changed, this, &WorthTable::fill);
  connect(&units_, &Units::changed, this, &WorthTable::fill);
  retranslate();
}

void WorthTable::retranslate() {
  setHorizontalHeaderLabels({tr("Dimension"), tr("In force"), tr("New"), tr("Allowed"), tr("Largest part")});
  for (const int column : {kInForce, kNew, kAllowed})
    horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setAccessibleName(tr("What the calibration is worth for each dimension"));
  fill();
}

void WorthTable::show(std::vector<DimensionWorth> worth) {
  worth_ = std::move(worth);
  fill();
}

void WorthTable::fill() {
  setRowCount(static_cast<int>(worth_.size()));
  const Palette& p = theme_.palette();
  for (int row = 0; row < rowCount(); ++row) {
    const DimensionWorth& w = worth_[static_cast<std::size_t>(row)];
    const bool bad = w.tooLarge();
    const auto put = [&](int column, const QString& text, Qt::Alignment alignment) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment(alignment | Qt::AlignVCenter);
      item->setToolTip(text);
      if (bad) item->setBackground(p.nearSoft);
      setItem(row, column, item);
      return item;
    };
    auto* name = put(kName, spoken(w.dimension), Qt::AlignLeft);
    name->setIcon(stateIcon(!w.allowedMm ? StateSymbol::NoLimit : bad ? StateSymbol::Near : StateSymbol::Good, p));
    if (bad) name->setToolTip(tr("More than the tolerance allows"));
    put(kInForce, lengthText(w.inForceMm, units_), Qt::AlignRight);
    put(kNew, lengthText(w.newMm, units_), Qt::AlignRight)->setFont(uiFont(16, 700));
    put(kAllowed, lengthText(w.allowedMm, units_), Qt::AlignRight);
    put(kLargest, bad ? tr("too much: %1").arg(QString::fromStdString(w.largest)) : QString::fromStdString(w.largest),
        Qt::AlignLeft);
  }
}

void WorthTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  for (int column = 0; column + 1 < kColumns; ++column)
    setColumnWidth(column, std::max(kLeast[static_cast<std::size_t>(column)],
                                    static_cast<int>(viewport()->width() * kShares[static_cast<std::size_t>(column)])));
}

QTableWidget* makeFigureTable(int columns, QWidget* parent) {
  auto* table = new QTableWidget(0, columns, parent);
  styleTable(*table);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setIconSize({16, 16});
  table->verticalHeader()->setDefaultSectionSize(30);
  return table;
}

}  // namespace vignole
