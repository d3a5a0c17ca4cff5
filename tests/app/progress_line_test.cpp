#include "app/terminal/progress_line.h"

#include "app/runs/run_display.h"
#include "app/terminal/json_messages.h"
#include "fitting/numerics/progress_meter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

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

/// Set for one test.
class MessageForm {
 public:
  explicit MessageForm(const char* form) { setenv("LACUNA_MESSAGES", form, 1); }
  ~MessageForm() { unsetenv("LACUNA_MESSAGES"); }
  MessageForm(const MessageForm&) = delete;
  MessageForm& operator=(const MessageForm&) = delete;
};

TEST(JsonMessages, AreTextUnlessTheVariableSaysJson) {
  EXPECT_FALSE(messages_are_json());
  const MessageForm unknown("xml");
  try {
    messages_are_json();
    FAIL() << "an unknown form was taken";
  } catch (const BadInput& bad) {
    EXPECT_THAT(bad.what(), testing::HasSubstr("set it to json or text"));
  }
}

TEST(JsonMessages, ShowProgressAsJson) {
  const MessageForm json("json");
  testing::internal::CaptureStderr();
  {
    LinePacer never(1h), always(0s);
    ProgressLine line(false, never, always);
    line.show({"screening", 0.25});
    ProgressLine(true, never, always).show({"not shown", 0.5});
    line.show({"refits of \"candidates\"", 0.5, 75.5});
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            R"({"progress":{"phase":"screening","fraction":0.25,"seconds_left":null}})"
            "\n"
            R"({"progress":{"phase":"refits of \"candidates\"","fraction":0.5,"seconds_left":75.5}})"
            "\n");
}

TEST(JsonMessages, GiveEachProblemALineWithItsPlace) {
  ProblemList problems;
  problems.add_of_key({"rig.toml", 7, 3}, "engine.step", "must be above 0");
  problems.add({}, "a sentence\nof two lines");
  const BadInput bad(problems.all());
  EXPECT_EQ(
      problem_messages(bad),
      R"({"problem":{"file":"rig.toml","line":7,"column":3,"key":"engine.step","message":"engine.step: must be above 0"}})"
      "\n"
      R"({"problem":{"file":"","line":0,"column":0,"key":"","message":"a sentence\nof two lines"}})"
      "\n");
  EXPECT_EQ(failure_message("the disk is full"), "{\"failure\":\"the disk is full\"}\n");
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
