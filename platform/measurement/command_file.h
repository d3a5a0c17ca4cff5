#pragma once

#include <lacuna/test.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Commands of a test as a table: a column of time and one an actuator, each with its unit in its name.

/// "t [s],motor [N*m]" and a row a sample; numbers read back to the same bits.
std::string command_csv(const CommandSeries& commands);

/// Reads such a table. The column of time is `t` or `time`, the others are called like the actuators; those of other
/// names are left out, and an actuator without a column is not commanded. Units are those of the names, or of a row of
/// units; without any they are SI. Commands are held. Throws `BadInput` with every problem: no column of an actuator,
/// units of another dimension, gaps, times that do not grow.
CommandSeries read_command_file(const std::filesystem::path& file, const std::vector<Channel>& actuators);

}  // namespace lacuna
