#pragma once

#include <lacuna/test.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Commands of a test as a table: a column of time and one per actuator, each with its unit in its name.

/// "t [s],motor [N*m]" and one row per sample; numbers read back to the same bits.
std::string command_csv(const CommandSeries& commands);

/// Reads such a table. The column of time is `t` or `time`, the others have the names of the actuators; other columns
/// are left out, and an actuator without a column gets no command. Units are those of the names, or of a row of units;
/// without any they are SI. Commands are held. Throws `BadInput` with every problem: no column of an actuator, units of
/// another dimension, gaps, times that do not increase.
CommandSeries read_command_file(const std::filesystem::path& file, const std::vector<Channel>& actuators);

}  // namespace lacuna
