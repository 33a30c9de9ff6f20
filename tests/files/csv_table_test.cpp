#include "engine/files/csv_table.h"

#include <gtest/gtest.h>
#include <random>

namespace vignole {
namespace {

std::string errorOf(const std::string& text, const std::string& column = "") {
  const auto table = CsvTable::parse(text, "t.csv");
  if (!table) return table.error().message();
  const auto numbers = table->numbers(column);
  return numbers ? "" : numbers.error().message();
}

TEST(CsvTable, ReadsColumnsByName) {
  const auto table = CsvTable::parse("\xEF\xBB\xBFpart,x\r\nA, 1.5\r\n\r\nB,-2e-3\r\n", "t.csv");
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_EQ(table->columns(), (std::vector<std::string>{"part", "x"}));
  EXPECT_EQ(table->numbers("x").value(), (std::vector<double>{1.5, -2e-3}));
  EXPECT_EQ(table->text(1, 0), "B");
  EXPECT_EQ(table->where(1), "t.csv:4") << "the empty line counts";
}

TEST(CsvTable, UnderstandsSemicolonsWithDecimalCommasAndTabs) {
  EXPECT_EQ(CsvTable::parse("a;x\n1;2,5\n", "t.csv")->numbers("x").value(), std::vector<double>{2.5});
  EXPECT_EQ(CsvTable::parse("a\tx\n1\t2.5\n", "t.csv")->numbers("x").value(), std::vector<double>{2.5});
}

TEST(CsvTable, UnderstandsQuotes) {
  const auto table = CsvTable::parse("name,x\n\"a, \"\"b\"\"\nc\",1\nd,2\n", "t.csv");
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_EQ(table->text(0, 0), "a, \"b\"\nc");
  EXPECT_EQ(table->where(1), "t.csv:4");
}

TEST(CsvTable, EmptyFieldsAreMissingNotZero) {
  const auto table = CsvTable::parse("a,x\n1,\n", "t.csv");
  ASSERT_TRUE(table);
  EXPECT_FALSE(table->optionalNumber(0, 1).value().has_value());
  EXPECT_NE(table->number(0, 1).error().message().find("t.csv:2"), std::string::npos);
}

TEST(CsvTable, SaysWhatIsWrongAndWhere) {
  EXPECT_NE(errorOf("").find("t.csv: is empty"), std::string::npos);
  EXPECT_NE(errorOf("a,b\n1\n").find("t.csv:2: has 1 field, the header has 2"), std::string::npos);
  EXPECT_NE(errorOf("a,b\n1,2,3\n").find("t.csv:2"), std::string::npos);
  EXPECT_NE(errorOf("a,a\n1,2\n").find("two columns named 'a'"), std::string::npos);
  EXPECT_NE(errorOf("a\n\"x\n", "a").find("t.csv:2: a quote"), std::string::npos);
  EXPECT_NE(errorOf("a,b\n1,2\n", "x").find("no column 'x'; its columns are a, b"), std::string::npos);
  EXPECT_NE(errorOf("x\n1\ntwo\n", "x").find("t.csv:3: column x is not a number: 'two'"), std::string::npos);
  EXPECT_NE(errorOf("x\nnan\n", "x").find("t.csv:2: column x is nan"), std::string::npos);
  EXPECT_NE(errorOf("x\n1e999\n", "x").find("t.csv:2"), std::string::npos);
  EXPECT_NE(errorOf("x\n", "x").find("no rows"), std::string::npos);
  EXPECT_FALSE(CsvTable::load("nowhere.csv"));
}

TEST(CsvTable, SurvivesAnything) {
  std::mt19937 random(1);
  constexpr std::string_view kBytes = "a1,;\t\n\r\" .-e\xEF\xBB\xBF";
  for (int t = 0; t < 20000; ++t) {
    std::string text;
    for (std::size_t i = 0; i < random() % 60; ++i) text += kBytes[random() % kBytes.size()];
    const auto table = CsvTable::parse(text, "t.csv");
    if (!table) continue;
    for (const std::string& column : table->columns()) static_cast<void>(table->numbers(column));
    for (std::size_t row = 0; row < table->rows(); ++row) EXPECT_FALSE(table->where(row).empty());
  }
}

}  // namespace
}  // namespace vignole
