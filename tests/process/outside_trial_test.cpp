#include "process/outside_trial.h"

#include "process/json_message.h"
#include "process/quoted_text.h"
#include "process/trial_messages.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>

namespace lacuna {
namespace {

CommandSeries ramp(Hold hold) {
  return {{{{"motor", "N*m"}}, Eigen::Vector4d(0.0, 1.0, 2.0, 3.0), Eigen::Vector4d(0.0, 10.0, 20.0, 30.0)}, hold};
}

TEST(CommandsUntil, EndWithTheTest) {
  const CommandSeries held = until(ramp(Hold::zero_order), 1.5);
  EXPECT_EQ(held.series.times, Eigen::Vector2d(0.0, 1.0)) << "the last one is held";
  EXPECT_EQ(held.series.samples.col(0), Eigen::Vector2d(0.0, 10.0));
  const CommandSeries line = until(ramp(Hold::first_order), 1.5);
  EXPECT_EQ(line.series.times, Eigen::Vector3d(0.0, 1.0, 1.5)) << "on its way to the next one";
  EXPECT_EQ(line.series.samples.col(0), Eigen::Vector3d(0.0, 10.0, 15.0));
}

TEST(CommandsUntil, ThatEndBeforeStayAsTheyAre) {
  for (const Hold hold : {Hold::zero_order, Hold::first_order}) {
    EXPECT_EQ(until(ramp(hold), 3.0).series.times.size(), 4);
    EXPECT_EQ(until(ramp(hold), 7.0).series.times.size(), 4);
    EXPECT_EQ(until(ramp(hold), 2.0).series.times, Eigen::Vector3d(0.0, 1.0, 2.0));
  }
}

TEST(Limits, AreNotLeftByGoingToSIAndBack) {
  Hello hello;
  for (int limit = 1; limit <= 360; ++limit) {
    const std::string stated = std::to_string(limit);
    std::string text = R"({"type": "hello", "protocol": "lacuna-process/2", "name": "servo", "modes": ["exchange"],)"
                       R"("sensors": [], "actuators": [{"name": "servo", "unit": "deg", "lower": -)";
    text += stated;
    text += ", \"upper\": ";
    text += stated;
    text += "}]}";
    hello = read_hello(text);
    for (const double command : {hello.actuators[0].lower, hello.actuators[0].upper}) {
      const auto sent = nlohmann::json::parse(commands_message(hello, std::array{command}));
      EXPECT_LE(std::abs(sent["commands"][0].get<double>()), limit);
    }
  }
}

TEST(PlainText, KeepsWhatCanBePrinted) {
  EXPECT_EQ(plain_text("zu heiß, 20 µm"), "zu heiß, 20 µm");
  EXPECT_EQ(plain_text("\x1b[2Jgone\r\n\xc2\x9b"
                       "2J"),
            ".[2Jgone...2J");
  EXPECT_EQ(plain_text("heiß", 4), "hei...") << "no half characters";
  EXPECT_EQ(plain_text("heiß", 5), "heiß");
}

TEST(PlainText, IsWhatAHelloKeepsOfNames) {
  const Hello hello =
      read_hello(R"({"type": "hello", "protocol": "lacuna-process/2", "name": "rig\u001b[2J", "modes": ["series"],)"
                 R"("sensors": [{"name": "ang\u0007le", "unit": "rad"}], "actuators": []})");
  EXPECT_EQ(hello.name, "rig.[2J");
  EXPECT_EQ(hello.sensors[0].name, "ang.le");
}

TEST(JsonMessage, ThatNestsTooDeepIsRefusedWithASentence) {
  std::string line = R"({"type": "hello", "name": )";
  line += std::string(80'000, '[') + std::string(80'000, ']') + "}";
  try {
    const JsonMessage message(line, "hello");
    FAIL() << "was read";
  } catch (const Error& wrong) {
    EXPECT_THAT(wrong.what(), testing::HasSubstr("nests arrays and objects more than"));
  }
}

}  // namespace
}  // namespace lacuna
