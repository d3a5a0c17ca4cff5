#pragma once

#include <lacuna/test_encoding.h>

#include <limits>
#include <string>
#include <vector>

namespace lacuna {

/// The protocol, as messages name it.
inline constexpr const char* kProcessProtocol = "lacuna-process/2";

/// What no sensor of a robot reads more than, in any SI unit.
inline constexpr double kLargestReading = 1e12;

/// A sensor's channel of a target outside, as it says it of itself.
struct TargetSensor {
  std::string name;
  std::string unit;                                          ///< that it sends
  double to_si = 1.0;                                        ///< SI = sent × this
  double noise = std::numeric_limits<double>::quiet_NaN();   ///< standard deviation, SI; NaN: not said
  double lower = -kLargestReading, upper = kLargestReading;  ///< that it can read, SI
};

struct TargetActuator {
  std::string name;
  std::string unit;                       ///< that it takes
  double to_si = 1.0;                     ///< SI = taken × this
  double lower = 0, upper = 0;            ///< of its commands, SI
  double sent_lower = 0, sent_upper = 0;  ///< the same in its unit, as it stated them
};

/// What a target outside says of itself.
struct Hello {
  std::string name;
  bool takes_series = false;  ///< a test's commands in one message
  bool exchanges = false;     ///< commands and readings every control period
  std::vector<TargetSensor> sensors;
  std::vector<TargetActuator> actuators;
};

/// What Lacuna begins with.
std::string hello_message();
/// The target's answer. Throws `Error` with all that is wrong with it, which continues "the program ...".
Hello read_hello(const std::string& line);

/// What of a target does not fit a model that reads and drives `space`: a sentence each. Names, units, and limits: what
/// the model may command is within what the target takes.
std::vector<std::string> misfits(const Hello& hello, const TestSpace& space);

}  // namespace lacuna
