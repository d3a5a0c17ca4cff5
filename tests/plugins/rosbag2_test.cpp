#include "plugins/mcap_bytes.h"
#include "plugins/recording_files.h"

#include <cmath>

namespace lacuna {
namespace {

using namespace std::string_literals;
using testing::AllOf;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<std::string> kBags = {"run_lz4.mcap", "run_zstd.mcap", "run.db3", "run_defined.db3"};

class Rosbag2 : public testing::Test {
 protected:
  std::string mcap(const std::string& bytes) const { return folder_.write("run.mcap", bytes).string(); }
  const TestFolder folder_;
  const FormatUnderTest format_{"rosbag2"};
};

TEST_F(Rosbag2, HasATableForEachTopicWithNumbers) {
  for (const std::string& bag : kBags) {
    const RecordingContents found = format_.contents(recorded_by_others(bag));
    ASSERT_THAT(FormatUnderTest::texts(found.problems), IsEmpty()) << bag;
    ASSERT_THAT(found.tables, SizeIs(2)) << bag;
    EXPECT_THAT(format_.columns(recorded_by_others(bag), "/joint_states"),
                ElementsAre("t", "log_time", "position[elbow]", "position[hinge]", "velocity[elbow]", "velocity[hinge]",
                            "effort[elbow]", "effort[hinge]"));
    EXPECT_THAT(format_.columns(recorded_by_others(bag), "/effort_controller/commands"),
                ElementsAre("t", "log_time", "data[0]"));
    EXPECT_THAT(FormatUnderTest::texts(found.remarks),
                ElementsAre(HasSubstr("/robot_description contains a robot description")));
  }
}

/// The torque at 0.01 s·i, as the generator of the bags has it.
double torque(int i) { return 0.5 * std::sin(0.03 * i) + 0.2 * std::sin(0.11 * i); }

TEST_F(Rosbag2, ReadsSeveralTopicsInOnePass) {
  for (const std::string& bag : kBags) {
    const ReadRows read = format_.read(
        recorded_by_others(bag),
        {{"/effort_controller/commands", {"t", "data[0]"}}, {"/joint_states", {"effort[hinge]", "t", "log_time"}}});
    ASSERT_THAT(FormatUnderTest::texts(read.problems), IsEmpty()) << bag;
    EXPECT_THAT(read.doubts, IsEmpty());
    const RecordedRows &commands = read.tables.at(0), &states = read.tables.at(1);
    ASSERT_GE(states.columns.at(0).size(), 40U);
    for (int i = 0; i < 40; ++i) {
      const auto row = static_cast<std::size_t>(i);
      EXPECT_EQ(states.columns[0][row], torque(i));
      EXPECT_NEAR(states.columns[1][row], 0.01 * i, 1e-12) << "its stamp";
      EXPECT_NEAR(states.columns[2][row], 0.01 * i + 0.002, 1e-12);
      if (i % 2 == 1) continue;
      EXPECT_EQ(commands.columns[1][row / 2], torque(i));
      EXPECT_NEAR(commands.columns[0][row / 2], 0.01 * i + 0.001, 1e-12) << "no stamp";
    }
    EXPECT_EQ(states.origins[1], 1.7e9);
    EXPECT_THAT(FormatUnderTest::texts(read.remarks),
                ElementsAre(HasSubstr("of /effort_controller/commands are the times of recording"),
                            AllOf(HasSubstr("of /joint_states are the stamps"), HasSubstr("log_time"))));
  }
}

TEST_F(Rosbag2, ReadsMessagesOfBothByteOrdersByTheirDefinition) {
  McapBytes bag;
  bag.schema(1, "robots/msg/Mixed", "ros2msg",
             "# all kinds\nuint8 A=3\nbool on\nint16 small 7\nstring<=5 name\nfloat32[2] pair\nuint64 big\n"
             "Part[<=3] parts\nNothing nothing\n===========\nMSG: robots/Part\nint8 x\nfloat64 y\n===========\n"
             "MSG: robots/Nothing\n");
  bag.channel(1, 1, "/mixed", "cdr");
  const std::string big_endian = "\0\0\0\0"s + "\1"s + "\0"s + "\xff\xfe"s + "\0\0\0\2a\0"s + "\0\0"s +
                                 "\x3f\x80\0\0\xc0\0\0\0"s + "\0\0\0\0"s + "\0\0\0\0\0\0\1\0"s + "\0\0\0\1"s + "\x05"s +
                                 "\0\0\0"s + "\x3f\xf8\0\0\0\0\0\0"s + "\0"s;
  bag.message(1, 1'000'000'000, big_endian);
  const std::string run = mcap(bag.whole());
  EXPECT_THAT(format_.columns(run, "/mixed"),
              ElementsAre("t", "log_time", "on", "small", "pair[0]", "pair[1]", "big", "parts[0].x", "parts[0].y"));
  EXPECT_THAT(format_.column(run, "small", "/mixed"), ElementsAre(-2.0));
  EXPECT_THAT(format_.column(run, "pair[1]", "/mixed"), ElementsAre(-2.0));
  EXPECT_THAT(format_.column(run, "big", "/mixed"), ElementsAre(256.0));
  EXPECT_THAT(format_.column(run, "parts[0].y", "/mixed"), ElementsAre(1.5));
}

TEST_F(Rosbag2, ReadsMessagesInJson) {
  McapBytes bag;
  bag.schema(1, "State", "jsonschema", "{}");
  bag.channel(1, 1, "state", "json");
  bag.message(1, 500'000'000, R"({"q": [1, 2]})");
  EXPECT_THAT(format_.column(mcap(bag.whole()), "q[1]", "state"), ElementsAre(2.0));
}

/// A recorder that is killed leaves no summary and half a record.
TEST_F(Rosbag2, ReadsWhatStandsBeforeABreak) {
  const std::string bytes = read_bytes(recorded_by_others("run_lz4.mcap"));
  const std::string run = mcap(bytes.substr(0, bytes.size() / 2));
  const ReadRows read = format_.read(run, {{"/joint_states", {"t"}}});
  EXPECT_THAT(FormatUnderTest::texts(read.doubts), ElementsAre(HasSubstr("the file ends at byte")));
  EXPECT_GT(read.tables.at(0).columns.at(0).size(), 20U);
}

TEST_F(Rosbag2, SortsRowsByTheirTimes) {
  McapBytes bag;
  bag.channel(1, 0, "a", "json");
  bag.message(1, 2'000'000'000, R"({"q": 2})");
  bag.message(1, 1'000'000'000, R"({"q": 1})");
  const ReadRows read = format_.read(mcap(bag.whole()), {{"a", {"q", "t"}}});
  EXPECT_THAT(read.tables.at(0).columns.at(0), ElementsAre(1.0, 2.0));
}

TEST_F(Rosbag2, LeavesOutTopicsThatItCannotRead) {
  McapBytes bag;
  bag.schema(1, "a/msg/B", "ros2msg", "c/Unknown x");
  bag.schema(2, "p.Message", "protobuf", "");
  bag.channel(1, 1, "/b", "cdr");
  bag.channel(2, 2, "/p", "protobuf");
  bag.channel(3, 0, "/q", "json");
  bag.message(1, 1, "");
  bag.message(2, 2, "");
  bag.message(3, 3, "{\"q\": 1}");
  const RecordingContents found = format_.contents(mcap(bag.whole()));
  EXPECT_THAT(found.tables, SizeIs(1));
  EXPECT_THAT(FormatUnderTest::texts(found.remarks),
              ElementsAre(AllOf(HasSubstr("/b: the definition of c/Unknown is not in the bag"),
                                HasSubstr("/p: its messages are in the encoding \"protobuf\""))));
}

TEST_F(Rosbag2, ReadsTheVersionsOfAControllersState) {
  // header, one joint "a", then points of positions [1] or none with a duration of 0 each
  const std::string head = "\0\1\0\0"s + "\1\0\0\0\0\0\0\0"s + "\1\0\0\0\0\0\0\0"s + "\1\0\0\0\2\0\0\0a\0\0\0"s;
  const std::string position = "\1\0\0\0"s + "\0\0\0\0\0\0\xf0\x3f"s;
  const std::string empty_rest(12 + 8, '\0');
  McapBytes bag;
  bag.schema(1, "control_msgs/msg/JointTrajectoryControllerState", "ros2msg", "");
  bag.channel(1, 1, "/state", "cdr");
  std::string message = head + position + empty_rest;
  message += position + empty_rest + std::string(16 + 8, '\0');
  bag.message(1, 1, message);
  EXPECT_THAT(format_.columns(mcap(bag.whole()), "/state"),
              AllOf(Contains("desired.positions[a]"), Contains("actual.positions[a]")));
}

TEST_F(Rosbag2, RefusesWithTheReason) {
  const auto problem = [&](const std::string& bytes) { return format_.problems(mcap(bytes)); };
  EXPECT_THAT(problem("t,q\n"), ElementsAre(HasSubstr("is not an MCAP file")));
  McapBytes unknown_channel;
  unknown_channel.message(7, 1, "{}");
  EXPECT_THAT(problem(unknown_channel.whole()),
              ElementsAre(AllOf(HasSubstr("at byte "), HasSubstr("channel 7, which is not defined before it"))));
  McapBytes short_message;
  short_message.schema(1, "std_msgs/msg/Float64", "ros2msg", "float64 data");
  short_message.channel(1, 1, "/x", "cdr");
  short_message.message(1, 1, "\0\1\0\0\0\0"s);
  EXPECT_THAT(problem(short_message.whole()),
              ElementsAre(HasSubstr("message 1 of topic /x (std_msgs/msg/Float64) is too short for its type")));
  McapBytes long_message;
  long_message.schema(1, "std_msgs/msg/Float64", "ros2msg", "float64 data");
  long_message.channel(1, 1, "/x", "cdr");
  long_message.message(1, 1, "\0\1\0\0"s + std::string(20, '\0'));
  EXPECT_THAT(problem(long_message.whole()), ElementsAre(HasSubstr("has 20 bytes, but its type needs 8")));
  McapBytes list;
  list.schema(1, "a/msg/List", "ros2msg", "float64[] data");
  list.channel(1, 1, "/x", "cdr");
  list.message(1, 1, "\0\1\0\0\xff\xff\xff\xff"s);
  EXPECT_THAT(problem(list.whole()), ElementsAre(HasSubstr("is too short for its type")));
  McapBytes chunk;
  chunk.chunk("lzma", 3, "abc");
  EXPECT_THAT(problem(chunk.whole()), ElementsAre(HasSubstr("compressed with \"lzma\"")));
  McapBytes liar;
  liar.chunk("", 4, "abc");
  EXPECT_THAT(problem(liar.whole()), ElementsAre(HasSubstr("unpacks to 3 bytes but states 4")));
  McapBytes damaged;
  damaged.chunk("zstd", 4, "\x28\xb5\x2f\xfd_abc");
  EXPECT_THAT(problem(damaged.whole()), ElementsAre(HasSubstr("compressed with zstd cannot be unpacked")));
  EXPECT_THAT(format_.problems(folder_.write("run.db3", "no database, and longer than nothing").string()),
              ElementsAre(HasSubstr("SQLite reports")));
}

TEST_F(Rosbag2, TypesThatContainThemselvesAreLeftOut) {
  McapBytes bag;
  bag.schema(1, "a/msg/B", "ros2msg", "B again");
  bag.channel(1, 1, "/b", "cdr");
  bag.message(1, 1, "\0\1\0\0"s);
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(mcap(bag.whole())).remarks),
              ElementsAre(HasSubstr("contains itself")));
}

TEST_F(Rosbag2, AreReadOrRefusedHoweverTheyAreDamaged) {
  McapBytes bag;
  bag.schema(1, "sensor_msgs/msg/JointState", "ros2msg", "");
  bag.channel(1, 1, "/joint_states", "cdr");
  bag.message(1, 1'000'000'000,
              "\0\1\0\0"s + "\1\0\0\0\2\0\0\0"s + "\1\0\0\0\0\0\0\0"s + "\1\0\0\0\2\0\0\0a\0\0\0"s + "\1\0\0\0"s +
                  "\0\0\0\0\0\0\xf0\x3f"s + std::string(8, '\0'));
  bag.channel(2, 0, "/json", "json");
  bag.message(2, 2'000'000'000, "{\"q\": 1}");
  EXPECT_GT(read_damaged(format_, bag.whole(), "run.mcap"), 100);
  const std::string database = read_bytes(recorded_by_others("run.db3")).substr(0, 3000);
  EXPECT_GE(read_damaged(format_, database, "run.db3"), 0);
}

}  // namespace
}  // namespace lacuna
