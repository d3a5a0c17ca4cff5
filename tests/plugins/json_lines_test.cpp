#include "plugins/recording_files.h"

#include <limits>

namespace lacuna {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsNan;

class JsonLines : public testing::Test {
 protected:
  std::string file(const std::string& text) const { return folder_.write("run.jsonl", text).string(); }
  const TestFolder folder_;
  const FormatUnderTest format_{"json_lines"};
};

TEST_F(JsonLines, HaveTheirNumbersByPath) {
  const std::string run = file(R"({"t": 0.5, "arm": {"q": [1, -2.5e-1], "on": true}, "note": "x"}
{"t": 1.0, "arm": {"q": [3, 4], "on": false}, "late": 7}
)");
  EXPECT_THAT(format_.columns(run), ElementsAre("t", "arm.q[0]", "arm.q[1]", "arm.on", "late"));
  EXPECT_THAT(format_.column(run, "arm.q[1]"), ElementsAre(-0.25, 4.0));
  EXPECT_THAT(format_.column(run, "arm.on"), ElementsAre(1.0, 0.0));
  EXPECT_THAT(format_.column(run, "late"), ElementsAre(IsNan(), 7.0));
  EXPECT_THAT(format_.read(run, {{"", {"t"}}}).tables.at(0).lines, ElementsAre(1, 2));
}

/// Two publishers of joint states name their joints in another order.
TEST_F(JsonLines, CallJointsByTheirNames) {
  const std::string run = file(R"({"name": ["a", "b"], "position": [1, 2], "velocity": [], "effort": [5]}
{"position": [4, 3], "name": ["b", "a"]}
{"joint_names": ["a"], "actual": {"positions": [9]}}
)");
  EXPECT_THAT(format_.columns(run), ElementsAre("position[a]", "position[b]", "effort[0]", "actual.positions[a]"));
  EXPECT_THAT(format_.column(run, "position[a]"), ElementsAre(1.0, 3.0, IsNan()));
}

TEST_F(JsonLines, KeepTheDigitsOfTimes) {
  const std::string run =
      file(R"({"stamp": {"sec": 1700000000, "nanosec": 250000001}, "t": 1700000000.0000001, "n": 1700000000123456789}
{"stamp": {"sec": 1700000001, "nanosec": 0}, "t": 1700000001.5, "n": 1700000000123456790}
)");
  const ReadRows read = format_.read(run, {{"", {"stamp", "t", "n"}}});
  const RecordedRows& rows = read.tables.at(0);
  EXPECT_THAT(rows.origins, ElementsAre(1.7e9, 1.7e9, 1700000000123456789.0));
  EXPECT_THAT(rows.columns[0], ElementsAre(0.250000001, 1.0));
  EXPECT_THAT(rows.columns[1], ElementsAre(1e-7, 1.5));
  EXPECT_THAT(rows.columns[2], ElementsAre(0.0, 1.0));
}

TEST_F(JsonLines, TakeNullAndNanForMissing) {
  const std::string run = file("{\"q\": 1}\n\n{\"q\": null}\r\n{\"q\": NaN}\n{\"q\": -Infinity}\n");
  EXPECT_THAT(format_.column(run, "q"), ElementsAre(1.0, IsNan(), IsNan(), -std::numeric_limits<double>::infinity()));
}

TEST_F(JsonLines, HaveNoColumnWithoutAName) {
  EXPECT_THAT(format_.columns(file("{\"\": 1, \"q\": 2, \"a\": {\"\": 3}}\n")), ElementsAre("q", "a."));
}

TEST_F(JsonLines, ReadNamesWithEscapes) {
  EXPECT_THAT(format_.columns(file(R"({"a\"b\u00e9\ud83d\ude00\\": 1})"
                                   "\n")),
              ElementsAre("a\"bé😀\\"));
}

TEST_F(JsonLines, LeaveOutALastLineThatBreaksOff) {
  const std::string run = file("{\"q\": 1}\n{\"q\": 2}\n{\"q\": 3");
  const ReadRows read = format_.read(run, {{"", {"q"}}});
  EXPECT_THAT(read.tables.at(0).columns.at(0), ElementsAre(1.0, 2.0));
  EXPECT_THAT(FormatUnderTest::texts(read.doubts),
              ElementsAre(HasSubstr("3: the file ends in the middle of its last line")));
}

TEST_F(JsonLines, AreRefusedWithTheLine) {
  EXPECT_THAT(format_.problems(file("{\"q\": 1}\n{\"q\": }\nq\n")),
              ElementsAre(HasSubstr("2: the line is not JSON: a value is missing at character 7"), HasSubstr("3: ")));
  EXPECT_THAT(format_.problems(file("{\"q\": 01}\n\n")), ElementsAre(HasSubstr("begins with 0")));
  EXPECT_THAT(format_.problems(file("{\"q\": 1} {\"q\": 2}\n")), ElementsAre(HasSubstr("text follows its end")));
  EXPECT_THAT(format_.problems(file("5\n")), ElementsAre(HasSubstr("1: the line is a single value")));
  EXPECT_THAT(format_.problems(file(std::string("{\"q\": 1}\n\0\0\n", 12))), ElementsAre(HasSubstr("zero bytes")));
  EXPECT_THAT(format_.problems(file(std::string(100, '[') + "\n")), ElementsAre(HasSubstr("nested too deeply")));
  EXPECT_THAT(format_.problems((folder_ / "none.jsonl").string()), ElementsAre(HasSubstr("cannot be opened")));
}

TEST_F(JsonLines, HoldNoLineOfMoreThan16MiB) {
  EXPECT_THAT(format_.problems(file("{\"q\": 1}\n{\"text\": \"" + std::string(17 << 20, 'x') + "\"}\n")),
              ElementsAre(HasSubstr("line 2 is longer than 16 MiB")));
}

TEST_F(JsonLines, DoNotMakeColumnsOfLongLists) {
  std::string list = "0";
  for (int i = 1; i < 300; ++i) list += "," + std::to_string(i);
  const std::string run = file("{\"q\": 1, \"scan\": [" + list + "]}\n");
  EXPECT_THAT(format_.columns(run), ElementsAre("q"));
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(run).remarks), ElementsAre(HasSubstr("`scan`")));
}

TEST_F(JsonLines, AreReadOrRefusedHoweverTheyAreDamaged) {
  const std::string text = R"({"t": 0.5, "a": {"name": ["x", "y"], "position": [1, -2.5e-1]}, "n": "\u0041"}
{"t": 1700000000.125, "a": null, "b": [true, {"sec": 1, "nanosec": 2}]}
)";
  EXPECT_GT(read_damaged(format_, text, "run.jsonl"), 20);
}

}  // namespace
}  // namespace lacuna
