// Tables of numbers, as instruments write them.

#include "base/csv.h"

#include <gmock/gmock.h>
#include <cmath>

namespace glisson {
namespace {

TEST(Csv, HeaderNamesColumnsAndPreambleIsSkipped) {
  const auto table = parse_csv("Hantek6074BE\r\nrate,1000\r\n\r\nt (s), CH1\r\n0,1.5\r\n0.001,-2e-3\r\n");
  ASSERT_TRUE(table);
  EXPECT_THAT(table->names, testing::ElementsAre("t (s)", "CH1"));
  EXPECT_THAT(table->columns[1], testing::ElementsAre(1.5, -2e-3));
  EXPECT_EQ(table->rows_without_numbers, 3u);
}

TEST(Csv, ByteOrderMarkSemicolonsTabsAndNoHeader) {
  for (const char* text : {"\xEF\xBB\xBF"
                           "1,2,3\n4,5,6\n",
                           "1;2;3\n4;5;6", "1\t2\t3\r\n4\t5\t6\r\n"}) {
    const auto table = parse_csv(text);
    ASSERT_TRUE(table) << text;
    EXPECT_THAT(table->names, testing::ElementsAre("1", "2", "3"));
    EXPECT_EQ(table->columns[0], (std::vector<double>{1, 4}));
    EXPECT_EQ(table->columns[2], (std::vector<double>{3, 6}));
  }
}

TEST(Csv, CellsWithoutNumbersAreNotNumbers) {
  const auto table = parse_csv("a,b,c\n1,x,3\n2,,inf\n3,4\n");
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows(), 3u);
  EXPECT_TRUE(std::isnan(table->columns[1][0]));
  EXPECT_TRUE(std::isnan(table->columns[2][2]));
  EXPECT_EQ(table->columns[1][2], 4);
}

TEST(Csv, ColumnsAreFoundByNameOrNumber) {
  const auto table = parse_csv("time,power\n1,2\n");
  EXPECT_EQ(*table->column("power"), 1u);
  EXPECT_EQ(*table->column("1"), 0u);
  EXPECT_FALSE(table->column("0"));
  EXPECT_FALSE(table->column("3"));
  EXPECT_THAT(table->column("watts").error().advice(), testing::HasSubstr("time, power"));
}

// A few megabytes of "1\n" behind one wide row would take gigabytes.
TEST(Csv, ATableOfHolesIsRefusedBeforeItFillsTheMemory) {
  std::string wide = "0";
  for (int c = 1; c < 256; ++c) wide += ",0";
  wide += '\n';
  std::string holes = wide;
  for (int row = 0; row < 20000; ++row) holes += "1\n";
  const auto refused = parse_csv(holes, "holes.csv");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "csv-ragged");
  EXPECT_EQ(refused.error().file, "holes.csv");
  std::string some = wide;
  for (int row = 0; row < 100; ++row) some += "1\n";
  EXPECT_TRUE(parse_csv(some).has_value()) << "a few short rows are nothing";
}

TEST(Csv, RowsWithNamesKeepTheirCellsAndLines) {
  const std::string text = "\xEF\xBB\xBFid, x_mm ,y_mm\r\n\r\n\"tumour 1\",\t1.5,\n\nhilum,nan,2e1x";
  const std::vector<CsvRow> rows = csv_rows(text);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0].cells, testing::ElementsAre("id", "x_mm", "y_mm"));
  EXPECT_EQ(rows[1].line, 3U);
  EXPECT_EQ(rows[1].cells[0], "tumour 1");
  EXPECT_EQ(rows[1].number(1), 1.5);
  EXPECT_EQ(rows[2].line, 5U);
  for (const std::size_t cell : {0, 1, 2, 3}) EXPECT_TRUE(std::isnan(rows[2].number(cell))) << cell;
  EXPECT_TRUE(csv_rows(" \n\r\n").empty());
}

TEST(Csv, WhatIsNoTableIsRefused) {
  EXPECT_EQ(parse_csv("").error().code, "csv-without-numbers");
  EXPECT_EQ(parse_csv("a,b\nc,d\n").error().code, "csv-without-numbers");
  std::string wide = "1";
  for (int i = 0; i < 300; ++i) wide += ",1";
  EXPECT_EQ(parse_csv(wide).error().code, "csv-too-wide");
  EXPECT_FALSE(read_csv("/nowhere/at/all.csv"));
}

}  // namespace
}  // namespace glisson
