#include "measurement/command_file.h"

#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::vector<Channel> kActuators = {{"hip", "rad"}, {"motor", "N*m"}};

class CommandFileTest : public testing::Test {
 protected:
  CommandSeries read(const std::string& text) {
    return read_command_file(folder_.write("commands.csv", text), kActuators);
  }
  void expect_refused(const std::string& text, const std::string& words) {
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<Error>(HasSubstr(words)));
  }
  TestFolder folder_;
};

TEST_F(CommandFileTest, ReadsBackWhatItWrites) {
  CommandSeries commands;
  commands.series.channels = kActuators;
  commands.series.times = Eigen::VectorXd::LinSpaced(4, 0.0, 0.3);
  commands.series.samples = TimeSeries::Samples::Random(4, 2);
  const CommandSeries back = read(command_csv(commands));
  EXPECT_EQ(back.series.channels, kActuators);
  EXPECT_EQ(back.series.times, commands.series.times);
  EXPECT_EQ(back.series.samples, commands.series.samples);
  EXPECT_EQ(back.hold, Hold::zero_order);
}

TEST_F(CommandFileTest, TakesUnitsAndTimesAsTheyAreWritten) {
  const CommandSeries commands = read("time_ms;other;motor [mNm]\n100;7;20\n110;7;30\n");
  ASSERT_EQ(commands.series.channels.size(), 1U);
  EXPECT_EQ(commands.series.channels[0].name, "motor");
  EXPECT_DOUBLE_EQ(commands.series.times(1), 0.01) << "times begin at 0";
  EXPECT_DOUBLE_EQ(commands.series.samples(1, 0), 0.03);
}

TEST_F(CommandFileTest, SaysWhatIsWrong) {
  expect_refused("t [s],torque [N*m]\n0,1\n1,2\n", "hip [rad]");
  expect_refused("motor [N*m],hip [deg]\n0,1\n1,2\n", "no column of time");
  expect_refused("t [s],motor [deg]\n0,1\n1,2\n", "motor takes N*m");
  expect_refused("t [s],motor [N*m]\n0,1\n0,2\n", "must increase");
  expect_refused("t [s],motor [N*m]\n0,1\n1,\n", "motor");
  expect_refused("t [s],motor [N*m]\n0,1\n", "two rows");
}

}  // namespace
}  // namespace lacuna
