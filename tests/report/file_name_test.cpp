#include "report/figures/file_name.h"

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

TEST(FileNames, FitIntoAFileSystem) {
  const std::string recording(250, 'x');
  FileNames names;
  const std::string first = names.next(recording + ".csv-angle.svg"), second = names.next(recording + ".csv-rate.svg");
  EXPECT_LE(second.size(), 255U);
  EXPECT_NE(first, second);
  EXPECT_TRUE(first.ends_with("x.svg") && second.ends_with("x-2.svg")) << second;
}

}  // namespace
}  // namespace lacuna
