#pragma once

#include "measurement/trials/trial_builder.h"

namespace lacuna {

/// Leaves out readings that were never taken, with a note each: constant values between counted events, repetitions of
/// a slow sensor, glitches and rows of another publisher among positions and velocities (mixed_rows.h). A column may
/// keep them. `lines`: of each sample in the file.
void leave_out_false_readings(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                              FileReport& report);

/// Doubts about commands: a column that is a copy of a reading, or has lost its sign. `line`: of the trial's first
/// sample.
void check_commands(const Trial& trial, const RecordingPlan& plan, int line, FileReport& report);

}  // namespace lacuna
