// Whatever a target program answers, it is a message or refused. The first line answers the hello; each further one is
// read as the readings of a control period and as the samples of a whole test.

#include "fuzzing.h"
#include "process/hello.h"
#include "process/outside_trial.h"
#include "process/trial_messages.h"

#include <cmath>
#include <sstream>

namespace {

using lacuna::fuzz::is_done;
using lacuna::fuzz::require;

const lacuna::TestHeading kHeading{.id = 1, .trial = 1, .seed = 3, .duration = 0.2, .period = 0.1, .periods = 2};

lacuna::Hello small_hello() {
  lacuna::Hello hello{.name = "rig", .takes_series = true, .exchanges = true};
  hello.sensors = {{.name = "angle", .unit = "rad"}};
  hello.actuators = {
      {.name = "motor", .unit = "N*m", .lower = -1.0, .upper = 1.0, .sent_lower = -1.0, .sent_upper = 1.0}};
  return hello;
}

/// The model that fits the target.
lacuna::TestSpace space_of(const lacuna::Hello& hello) {
  lacuna::TestSpace space{.control_period = kHeading.period, .duration = kHeading.duration};
  for (const lacuna::TargetSensor& sensor : hello.sensors) space.sensors.push_back({sensor.name, sensor.unit});
  for (const lacuna::TargetActuator& actuator : hello.actuators) {
    space.actuators.push_back({actuator.name, actuator.unit});
    space.lower.push_back(actuator.lower);
    space.upper.push_back(actuator.upper);
  }
  return space;
}

lacuna::CommandSeries lowest_commands(const lacuna::TestSpace& space) {
  lacuna::CommandSeries commands;
  const auto count = static_cast<Eigen::Index>(space.lower.size());
  commands.series.channels = space.actuators;
  commands.series.times = Eigen::Vector2d(0.0, 0.1);
  commands.series.samples.resize(2, count);
  for (Eigen::Index a = 0; a < count; ++a)
    commands.series.samples.col(a).setConstant(space.lower[static_cast<std::size_t>(a)]);
  return commands;
}

void read_of_exchange(const std::string& line, const lacuna::Hello& hello, const lacuna::TestSpace& space) {
  const lacuna::Readings readings = lacuna::read_readings(line, hello, kHeading.id);
  require(std::isfinite(readings.time), "readings have a time");
  require(readings.sensors.size() == hello.sensors.size(), "there is a reading a sensor");
  lacuna::ChannelOrder(hello, space).check_readings(readings.time, readings.sensors);
  lacuna::initial_values(readings.start, {"joint.hinge"});
}

void read_of_series(const std::string& line, const lacuna::Hello& hello, const lacuna::TestSpace& space) {
  lacuna::Samples samples = lacuna::read_samples(line, hello, kHeading.id);
  require(samples.values.rows() == samples.times.size(), "there is a row a time");
  lacuna::check_extent(samples, kHeading);
  lacuna::TimeSeries measured = lacuna::ChannelOrder(hello, space).measured(samples.times, samples.values);
  lacuna::check_measured(measured);
  if (!samples.start.empty()) lacuna::begin_at_start(measured);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines(lacuna::fuzz::text_of(data, size));
  std::string line;
  std::getline(lines, line);
  lacuna::Hello hello = small_hello();
  is_done([&] { hello = lacuna::read_hello(line); });
  lacuna::misfits(hello, space_of(small_hello()));
  const lacuna::TestSpace space = space_of(hello);
  if (!lacuna::misfits(hello, space).empty()) return 0;
  is_done([&] {
    const lacuna::CommandSeries commands = lacuna::ChannelOrder(hello, space).of_target(lowest_commands(space));
    lacuna::check_limits(commands, hello);
    lacuna::series_message(kHeading, hello, commands);
  });
  while (std::getline(lines, line)) {
    is_done([&] { read_of_exchange(line, hello, space); });
    is_done([&] { read_of_series(line, hello, space); });
  }
  return 0;
}
