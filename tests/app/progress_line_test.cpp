#include "app/terminal/progress_line.h"

#include "app/runs/run_display.h"
#include "fitting/progress_meter.h"

#include <gmock/gmock.h>
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

TEST(ProgressMeter, TellsTheTimeLeftByThePartsThatAreDone) {
  Progress last;
  const ProgressCallback keep = [&](const Progress& progress) { last = progress; };
  ProgressMeter meter(keep);
  meter.set_parts(4);
  meter.begin_part("look");
  EXPECT_DOUBLE_EQ(last.fraction, 0.0);
  EXPECT_TRUE(std::isnan(last.seconds_left));
  meter.end_part();
  meter.begin_part("fits");
  EXPECT_DOUBLE_EQ(last.fraction, 0.25);
  EXPECT_LE(last.seconds_left, 3.0 * meter.seconds());  // three parts as long as the one that is done
  EXPECT_GT(last.seconds_left, 0.0);
}

using namespace std::chrono_literals;

TEST(LinePacer, GivesALineAtMostEachIntervalAndTheFirstAfterOne) {
  const LinePacer::Clock::time_point begin{};
  LinePacer pacer(10s, begin);
  std::vector<int> lines;
  for (int second = 0; second <= 35; ++second)
    if (pacer.take(begin + std::chrono::seconds(second))) lines.push_back(second);
  EXPECT_EQ(lines, (std::vector{10, 20, 30}));
  EXPECT_TRUE(pacer.take(begin + 47s)) << "work without steps in between";
  EXPECT_FALSE(pacer.take(begin + 56s));
}

/// gtest's captured standard error is a file, no terminal.
std::string printed(bool quiet, LinePacer::Clock::duration interval) {
  testing::internal::CaptureStderr();
  {
    LinePacer pacer(interval);
    ProgressLine line(quiet, pacer);
    line.show({"screening", 0.25});
    line.show({"refits of candidates", 0.5, 75.2});
  }
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressLine, PrintsPlainLinesWhereStandardErrorIsNoTerminal) {
  EXPECT_EQ(printed(false, 0s), "screening · 25 %\nrefits of candidates · 50 % · 1 min 15 s left\n");
  EXPECT_EQ(printed(false, 1h), "");
  EXPECT_EQ(printed(true, 0s), "");
}

TEST(RunDisplay, PrintsPlainLinesWhereStandardErrorIsNoTerminal) {
  testing::internal::CaptureStderr();
  {
    LinePacer pacer(0s);
    RunDisplay display({PlannedReplicate{}}, false, nullptr, pacer);
    EeaProgress progress{};
    progress.pass = 2;
    progress.passes = 4;
    progress.phase = Phase::estimation;
    progress.generation = 3;
    progress.generations = 10;
    display.show(0, progress);
  }
  const std::string line = testing::internal::GetCapturedStderr();
  EXPECT_THAT(line, testing::StartsWith("pass 2/4 · estimation 3/10 · best "));
  EXPECT_THAT(line, testing::HasSubstr(" left · "));
  EXPECT_EQ(line.find_first_of("\r\033"), std::string::npos);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
}

}  // namespace
}  // namespace lacuna
