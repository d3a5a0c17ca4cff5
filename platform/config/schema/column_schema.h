#pragma once

#include "config/schema/table.h"
#include "foundation/recording_source.h"

#include <string>
#include <vector>

namespace lacuna {

/// How columns of measured files are written in an experiment file.

Value<std::string> time_unit();
Value<Encoding> encoding();
/// Tables named like the robot's sensors, or its actuators.
Value<std::vector<ColumnMapping>> sensor_columns();
Value<std::vector<ColumnMapping>> command_columns();
Value<std::vector<ControllerMapping>> controllers();

}  // namespace lacuna
