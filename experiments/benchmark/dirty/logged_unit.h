#pragma once

#include "dirty/dirty_case.h"

namespace hidden_effects::dirty {

/// How a column of the log is written: its unit and how many of it are one SI unit.
struct LoggedUnit {
  std::string name;
  double per_si = 1.0;
};

LoggedUnit unit_of_time(const Recording& recording);
LoggedUnit unit_of_sensor(const DirtyCase& made, std::size_t sensor);
/// Of what a drive's controller is to follow.
LoggedUnit unit_of_reference(const DirtyCase& made, std::size_t drive);
LoggedUnit unit_of_command(const DirtyCase& made, std::size_t drive);

/// "angle_deg": the column of a channel.
std::string column_name(const std::string& channel, const LoggedUnit& unit);

}  // namespace hidden_effects::dirty
