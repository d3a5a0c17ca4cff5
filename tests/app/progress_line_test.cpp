#include "app/progress_line.h"

#include "fitting/progress_meter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

TEST(FirstCharacters, CutsBetweenCharactersAndNotInThem) {
  EXPECT_EQ(first_characters("pass 1 · best", 8), "pass 1 ·");
  EXPECT_EQ(first_characters("pass 1 · best", 7), "pass 1 ");
  EXPECT_EQ(first_characters("short", 80), "short");
  EXPECT_EQ(first_characters("short", 5), "short");
  EXPECT_EQ(first_characters("short", 0), "");
}

TEST(ProgressText, HasNoTimeUntilOneIsKnown) {
  EXPECT_EQ(progress_text({"free runs", 0.0}), "free runs · 0 %");
  EXPECT_EQ(progress_text({"free runs", 0.4, 75.2}), "free runs · 40 % · 1 min 15 s left");
}

TEST(ProgressMeter, BeginsBehindWhatAnEarlierCallHasDone) {
  Progress last;
  const ProgressCallback keep = [&](const Progress& progress) { last = progress; };
  ProgressMeter meter(keep);
  meter.set_parts(8);
  meter.skip_parts(4);
  meter.begin_part("screening");
  EXPECT_DOUBLE_EQ(last.fraction, 0.5);
  EXPECT_TRUE(std::isnan(last.seconds_left));
  meter.end_part();
  meter.begin_part("refits");
  EXPECT_DOUBLE_EQ(last.fraction, 0.625);
  EXPECT_LE(last.seconds_left, 3.0 * meter.seconds());  // three parts as long as the one that this call has done
  EXPECT_GT(last.seconds_left, 0.0);
}

}  // namespace
}  // namespace lacuna
