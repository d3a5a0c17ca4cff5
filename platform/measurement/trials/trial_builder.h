#pragma once

#include "foundation/processes/stop.h"
#include "measurement/clocks/clock_check.h"
#include "measurement/trials/column_plan.h"
#include "measurement/csv/csv_table.h"
#include "measurement/trials/recorded_controller.h"

namespace lacuna {

/// A column that shows when an actuator is off.
struct PlannedSwitch {
  std::size_t command = 0;  ///< index into the plan's commands
  std::string column;
};

/// Columns of a table in the order sensors, commands, references, switches.
struct RecordingPlan {
  std::vector<PlannedColumn> sensors;
  std::vector<PlannedColumn> commands;
  std::vector<PlannedColumn> references;  ///< one a law
  std::vector<PlannedSwitch> switches;
  std::vector<ControlLaw> laws;
  std::vector<std::size_t> actuator_of;  ///< by command: among all of the robot's
  double seconds_per_time_unit = 1.0;
  std::vector<InitialValue> initial;     ///< per joint coordinate
  std::vector<double> commanded_before;  ///< before the first sample, by command; NaN: not known
  Stop stop = {};                        ///< of the work that reads the recordings
};

/// Makes a trial of the clock's rows: SI units, masked readings NaN, missing commands filled in according to the hold
/// (the value before; the line between its neighbours), and NaN while the actuator is off. A command without a first
/// value is a problem.
Trial build_trial(const RecordingPlan& plan, const RecordingSource& source, const CsvTable& table,
                  const TrialClock& clock, FileReport& report);

/// A trial that begins in the middle of a table has earlier commands: those of a row, where it has them.
void take_commands_before(const RecordingPlan& plan, const CsvTable& table, std::size_t row, Trial& trial);

}  // namespace lacuna
