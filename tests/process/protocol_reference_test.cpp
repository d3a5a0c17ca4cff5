#include "process/hello.h"
#include "process/json_message.h"
#include "process/trial_messages.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

/// The messages of docs/reference/process-target.md are those that are read and written.
namespace lacuna {
namespace {

using Json = nlohmann::json;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTolerance = 1e-12;

/// The line below each "```json NAME".
const std::map<std::string, std::string>& messages() {
  static const std::map<std::string, std::string> all = [] {
    std::map<std::string, std::string> found;
    std::ifstream document(LACUNA_SOURCE_DIRECTORY "/docs/reference/process-target.md");
    const std::string fence = "```json ";
    for (std::string line, name; std::getline(document, line); name = line)
      if (name.starts_with(fence)) found[name.substr(fence.size())] = line;
    return found;
  }();
  return all;
}

Hello pendulum() { return read_hello(messages().at("hello")); }

TEST(ProtocolReference, HasAMessageOfEachKind) { EXPECT_EQ(messages().size(), 8U); }

TEST(ProtocolReference, HelloIsSentAndReadAsItSays) {
  EXPECT_EQ(Json::parse(hello_message()), Json::parse(messages().at("lacuna")));
  const Hello hello = pendulum();
  EXPECT_EQ(hello.name, "pendulum");
  EXPECT_TRUE(hello.takes_series && hello.exchanges);
  ASSERT_EQ(hello.sensors.size(), 1U);
  EXPECT_NEAR(hello.sensors[0].noise, 0.02 * kDegree, kTolerance);
  ASSERT_EQ(hello.actuators.size(), 1U);
  EXPECT_NEAR(hello.actuators[0].upper, 0.6, kTolerance);
}

TEST(ProtocolReference, TestsAreSentAsItSays) {
  CommandSeries commands;
  commands.series.times = Eigen::Vector2d(0.0, 0.02);
  commands.series.samples = Eigen::Vector2d(0.25, -0.25);
  const TestHeading third{.id = 1, .trial = 3, .seed = 4027, .duration = 0.04, .period = 0.02, .periods = 2};
  EXPECT_EQ(Json::parse(series_message(third, pendulum(), commands)), Json::parse(messages().at("series")));
  const TestHeading fourth{.id = 2, .trial = 4, .seed = 911, .duration = 0.04, .period = 0.02, .periods = 2};
  EXPECT_EQ(Json::parse(exchange_message(fourth)), Json::parse(messages().at("exchange")));
  EXPECT_EQ(Json::parse(commands_message(pendulum(), std::array{0.25})), Json::parse(messages().at("commands")));
}

TEST(ProtocolReference, AnswersAreReadAsItSays) {
  const Samples samples = read_samples(messages().at("samples"), pendulum(), 1);
  ASSERT_EQ(samples.times.size(), 5);
  EXPECT_NEAR(samples.values(2, 0), 0.5 * kDegree, kTolerance);
  EXPECT_TRUE(std::isnan(samples.values(4, 0)));
  EXPECT_TRUE(samples.start.contains("hinge"));
  const Readings readings = read_readings(messages().at("readings"), pendulum(), 2);
  EXPECT_NEAR(readings.sensors.at(0), 0.5 * kDegree, kTolerance);
  EXPECT_TRUE(readings.start.contains("hinge"));
  EXPECT_THAT([] { read_samples(messages().at("error"), pendulum(), 2); },
              testing::ThrowsMessage<RefusedTest>(testing::HasSubstr("the arm is not at rest")));
}

}  // namespace
}  // namespace lacuna
