#include "report/file_name.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(FileName, HasADashForWhatTroublesAShell) { EXPECT_EQ(file_name("a b/c+d_1.svg"), "a-b-c-d_1.svg"); }

TEST(FileNames, DifferWhereTextsDiffer) {
  FileNames names;
  EXPECT_EQ(names.next("a b.csv-angle.svg"), "a-b.csv-angle.svg");
  EXPECT_EQ(names.next("a-b.csv-angle.svg"), "a-b.csv-angle-2.svg");
  EXPECT_EQ(names.next("a+b.csv-angle.svg"), "a-b.csv-angle-3.svg");
  EXPECT_EQ(names.next("a+b.csv-angle-2.svg"), "a-b.csv-angle-2-2.svg");
  EXPECT_EQ(names.next("a b.csv-predictions.csv"), "a-b.csv-predictions.csv");
}

}  // namespace
}  // namespace lacuna
