#pragma once

#include <lacuna/trial.h>

#include "measurement/csv/csv_format.h"
#include "measurement/trials/trial_builder.h"

namespace lacuna {

/// Doubts about a recording. None of them is a problem: a robot may do unusual things, and each note gives the reason,
/// so that the user can decide.

/// Units in column names or in a row of units that differ from the experiment's, and angles without any unit.
void check_units(const RecordingPlan& plan, const CsvFormat& format, FileReport& report);

/// Channels that never change, have no value at all, stay at their limit for a while after a fast motion (saturation),
/// or whose size fits another unit (57.3, 1000); velocities that are a multiple of a position's slope. `line` is that
/// of the trial's first sample.
void check_values(const Trial& trial, const RecordingPlan& plan, int line, FileReport& report);

}  // namespace lacuna
