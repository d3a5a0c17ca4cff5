#pragma once

#include "foundation/text/problem.h"
#include "foundation/recording_source.h"

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A column and its conversion to a channel: SI value = column × factor + offset.
struct PlannedColumn {
  Channel channel;
  const ColumnMapping* mapping = nullptr;  ///< into the source
  double factor = 1.0;
};

/// Matches mappings with the robot's channels, in the robot's order, and checks units: the column's unit times the
/// gain's must have the channel's dimension. `what` ("sensor channel", "actuator") is used in messages. Mappings to
/// unknown channels, duplicates and wrong units are problems.
std::vector<PlannedColumn> plan_columns(const std::vector<ColumnMapping>& mappings,
                                        const std::vector<Channel>& channels, std::string_view what,
                                        ProblemList& problems);

/// Seconds per unit of the time column; a unit that is not one of time is a problem.
double seconds_per_time_unit(const RecordingSource& source, ProblemList& problems);

}  // namespace lacuna
