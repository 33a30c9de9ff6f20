#include "gui/monitor/dimension_table.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

QString cell(const DimensionTable& table, Dimension d, int column, int role = Qt::DisplayRole) {
  return table.rows().data(table.rows().index(static_cast<int>(index(d)), column), role).toString();
}

class DimensionTableTest : public ::testing::Test {
 protected:
  Theme theme;
  DimensionTable table{theme};
  void SetUp() override {
    table.resize(1053, 628);
    table.QWidget::show();
  }
};

TEST_F(DimensionTableTest, ThirteenRowsInTheOrderOfTableTwo) {
  table.show(makeSnapshot({.deviationMm = {{Dimension::FC, 0.29}}}));
  ASSERT_EQ(table.rows().rowCount(), 13);
  for (const Dimension d : kDimensions) EXPECT_EQ(table.rows().row(static_cast<int>(index(d))).dimension, d);
}

TEST_F(DimensionTableTest, WaitingRowsShowDashes) {
  table.show(emptySnapshot());
  EXPECT_EQ(cell(table, Dimension::RH, DimensionModel::Value), QStringLiteral("–"));
  EXPECT_EQ(cell(table, Dimension::RH, DimensionModel::Deviation), QStringLiteral("–"));
}

TEST_F(DimensionTableTest, ValuesDeviationsAndExpandedUncertainty) {
  table.show(makeSnapshot({.deviationMm = {{Dimension::WT, 1.032}, {Dimension::RASr, -0.68}, {Dimension::HR, -1.4}}}));
  EXPECT_EQ(cell(table, Dimension::WT, DimensionModel::Value), QStringLiteral("17.532"));
  EXPECT_EQ(cell(table, Dimension::WT, DimensionModel::Deviation), QStringLiteral("+1.032"));
  EXPECT_EQ(cell(table, Dimension::WT, DimensionModel::Uncertainty), QString(QChar(0xB1)) + "0.024");
  EXPECT_EQ(cell(table, Dimension::WT, DimensionModel::State), QStringLiteral("Out"));
  EXPECT_EQ(cell(table, Dimension::RASr, DimensionModel::Deviation), QString(QChar(0x2212)) + "0.680");
  EXPECT_EQ(cell(table, Dimension::HR, DimensionModel::Value), QStringLiteral("298.6"));
  EXPECT_EQ(cell(table, Dimension::HR, DimensionModel::State), QStringLiteral("No limit"));
}

TEST_F(DimensionTableTest, NotMeasuredSpansTheRowWithItsReason) {
  table.show(
      makeSnapshot({.missing = {{Dimension::RFH, "no points on SHBR (camera 3: camera gone)"}}, .lostCamera = 2}));
  EXPECT_EQ(cell(table, Dimension::RFH, DimensionModel::Value),
            QStringLiteral("Not measured, because no points on SHBR (camera 3: camera gone)"));
  const int row = static_cast<int>(index(Dimension::RFH));
  EXPECT_GT(table.columnSpan(row, DimensionModel::Value), 1);
  table.show(makeSnapshot());
  EXPECT_EQ(table.columnSpan(row, DimensionModel::Value), 1);
}

TEST_F(DimensionTableTest, HeldRowsSayHeld) {
  table.show(heldSnapshot(20, {.deviationMm = {{Dimension::WT, 1.4}}}));
  EXPECT_EQ(cell(table, Dimension::RH, DimensionModel::State), QStringLiteral("Held"));
  EXPECT_EQ(cell(table, Dimension::WT, DimensionModel::State), QStringLiteral("Held"));
  EXPECT_TRUE(table.rows().row(0).held);
}

TEST_F(DimensionTableTest, EveryRowIsASentenceForAScreenReader) {
  table.show(makeSnapshot({.deviationMm = {{Dimension::FTl, 0.148}}}));
  const QString words = cell(table, Dimension::FTl, DimensionModel::State, Qt::AccessibleTextRole);
  EXPECT_TRUE(words.startsWith("FT l, ")) << words.toStdString();
  EXPECT_TRUE(words.contains("Good")) << words.toStdString();
  EXPECT_TRUE(words.contains("+0.148")) << words.toStdString();
}

TEST_F(DimensionTableTest, AClickChoosesAndASecondLetsGo) {
  table.show(makeSnapshot());
  const QSignalSpy spy(&table, &DimensionTable::chosenChanged);
  const QPoint at = table.visualRect(table.rows().index(4, 2)).center();
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
  EXPECT_EQ(table.chosen(), Dimension::HW);
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
  EXPECT_FALSE(table.chosen());
  EXPECT_EQ(spy.count(), 2);
}

TEST_F(DimensionTableTest, ArrowKeysChoose) {
  table.show(makeSnapshot());
  table.choose(Dimension::RH);
  table.setCurrentIndex(table.rows().index(0, 0));
  QTest::keyClick(&table, Qt::Key_Down);
  EXPECT_EQ(table.chosen(), Dimension::RFH);
  QTest::keyClick(&table, Qt::Key_Down);
  EXPECT_EQ(table.chosen(), Dimension::FW);
}

TEST_F(DimensionTableTest, TheChoiceOutlivesFreshValues) {
  table.show(makeSnapshot());
  table.choose(Dimension::WT);
  for (int i = 0; i < 5; ++i) table.show(makeSnapshot());
  EXPECT_EQ(table.chosen(), Dimension::WT);
}

TEST_F(DimensionTableTest, RowsFillTheHeightAndColumnsLeaveInTheirOrder) {
  const auto filled = [&] { return table.rowViewportPosition(12) + table.rowHeight(12) == table.viewport()->height(); };
  EXPECT_TRUE(filled());
  EXPECT_FALSE(table.isColumnHidden(DimensionModel::Track));
  table.resize(760, 460);
  EXPECT_TRUE(filled());
  EXPECT_TRUE(table.isColumnHidden(DimensionModel::Track));
  EXPECT_FALSE(table.isColumnHidden(DimensionModel::Uncertainty));
  table.resize(680, 460);
  EXPECT_TRUE(table.isColumnHidden(DimensionModel::Uncertainty));
}

}  // namespace
}  // namespace vignole
