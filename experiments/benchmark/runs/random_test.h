#pragma once

#include "cases/make_case.h"
#include "plant/draw.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// The commands that a drive has had.
struct CommandRange {
  std::string drive, unit;  ///< "motor", "N*m"
  double lower = 0.0, upper = 0.0;
};

/// By drive: the smallest and the largest recorded command of the fit trials.
std::vector<CommandRange> command_ranges(const MadeCase& made);

/// A random test of `duration` s as `lacuna trial --test` takes it: "steps motor 0.3 N*m around -0.04 N*m 0.7 Hz 5 s
/// seed 99", a part for each drive. Drawn as the program draws its own random tests: any shape, any amplitude about a
/// centre (at rest every second time, else up to a quarter of half the range off it), frequencies evenly on a
/// logarithmic scale from one period a test to 5 Hz. Commands stay within the ranges.
std::string random_test(const std::vector<CommandRange>& ranges, double duration, Draw& draw);

/// s, of the test that a line says; throws `std::runtime_error` where it says none.
double duration_of_test(const std::string& line);

/// The line with other seeds; the same where its shapes have none.
std::string reseeded_test(const std::string& line, Draw& draw);

}  // namespace hidden_effects
