#include "foundation/text/csv_cell.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(CsvCell, IsQuotedWhereTheTableWouldBreak) {
  EXPECT_EQ(csv_cell("sine 1.csv"), "sine 1.csv");
  EXPECT_EQ(csv_cell(""), "");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("6\" arm"), "\"6\"\" arm\"");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_cell("end\r"), "\"end\r\"");
}

}  // namespace
}  // namespace lacuna
