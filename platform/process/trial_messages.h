#pragma once

#include <lacuna/test.h>

#include "process/hello.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// What every test message says.
struct TestHeading {
  std::uint64_t id = 0;     ///< the how many-th test it is that this program is sent; its answers repeat it
  std::uint64_t trial = 0;  ///< its number
  std::uint64_t seed = 0;   ///< of whatever is random in a target that is simulated; below 2^53
  double duration = 0.0;    ///< s
  double period = 0.0;      ///< s, control period
  std::size_t periods = 0;  ///< whole ones in the duration
};

/// What a target says of a joint at the start of a trial: rad or m, rad/s or m/s.
struct JointStart {
  double position = 0.0;
  double velocity = 0.0;
};
using JointStarts = std::map<std::string, JointStart>;

/// A reading at the start of a control period, SI, in the order of the hello's sensors.
struct Readings {
  double time = 0.0;
  std::vector<double> sensors;  ///< NaN: not measured
  JointStarts start;            ///< only the first of a trial has any
};

/// What was measured, SI, in the order of the hello's sensors; NaN: not measured.
struct Samples {
  Eigen::VectorXd times;
  TimeSeries::Samples values;
  JointStarts start;
};

/// A test whose commands, SI, in the order of the hello's actuators, are given whole; the target's units are sent.
std::string series_message(const TestHeading& heading, const Hello& hello, const CommandSeries& commands);
/// A test whose commands follow, one message a control period.
std::string exchange_message(const TestHeading& heading);
/// The commands of a control period, SI, in the order of the hello's actuators; within what it takes where rounding
/// would leave that.
std::string commands_message(const Hello& hello, std::span<const double> commands);

/// Both throw `Error` with all that is wrong with the message, which continues "the program ...", and
/// `RefusedTest` where the target says that it cannot. `id`: of the test that is to be answered.
Readings read_readings(const std::string& line, const Hello& hello, std::uint64_t id);
Samples read_samples(const std::string& line, const Hello& hello, std::uint64_t id);

}  // namespace lacuna
