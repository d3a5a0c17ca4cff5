#pragma once

#include <lacuna/trial.h>

#include "measurement/csv/csv_format.h"
#include "measurement/trials/trial_builder.h"

namespace lacuna {

/// Doubts about what a recording says. None of them is a problem: a robot may do odd things, and
/// each note gives the reason, so that the user can tell.

/// Units in column names or in a row of units that are not those the experiment reads, and angles
/// without any unit.
void check_units(const RecordingPlan& plan, const CsvFormat& format, FileReport& report);

/// Channels that never change, have no value at all, stay at their limit for a while after moving
/// fast (saturation), or whose size fits another unit (57.3, 1000); velocities that are not the slope of
/// any position, but a multiple of it. `line` is that of the trial's first sample.
void check_values(const Trial& trial, const RecordingPlan& plan, int line, FileReport& report);

}  // namespace lacuna
