#pragma once

#include <lacuna/test_encoding.h>

#include <string>

namespace lacuna {

/// A genome of the test encoding `command_series` (plugins/encodings/command_series) as one short line that a person
/// can type:
///
///     triangle motor 0.3 N*m 0.1 Hz 20 s
///     multisine motor 0.2 N*m 0.1-5 Hz 10 s seed 3
///     steps hip 0.4 rad around 0.1 rad 0.5 Hz 10 s, chirp knee 0.2 rad 0.1-3 Hz 10 s
///
/// that is, SHAPE ACTUATOR AMPLITUDE [around CENTRE] FREQUENCY DURATION [seed N], an actuator after the other. One that
/// is not named rests at the command nearest to 0. Numbers take any unit of the right dimension ("300 mN*m", "200 ms").

/// What a line says, SI.
struct TestLine {
  Genome genome;
  double duration = 0.0;  ///< s
};

/// The genome nearest to the given one that a line can express: three significant digits, an amplitude within the
/// limits, frequencies that duration and control period allow, and 0 for genes that its shape does not use.
Genome sayable(const TestSpace& space, const Genome& genome);

/// `genome` is one that a line can express; `space.duration` is that of the test. Parsing the line gives the same bits.
std::string test_line(const TestSpace& space, const Genome& genome);

/// The duration of `space` is not used. Throws `BadInput` with a sentence for each actuator of the line that is wrong:
/// unknown shapes and actuators, units of another dimension, commands beyond the limits (which may be infinite), too
/// fast for the control period, too short for one period.
TestLine parse_test_line(const TestSpace& space, const std::string& line);

}  // namespace lacuna
