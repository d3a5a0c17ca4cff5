#pragma once

#include "measurement/trials/trial_builder.h"

#include <vector>

namespace lacuna {

/// Leaves out the rows of another publisher or sensor among those of a position or velocity (second_stream.h), also for
/// other sensors and commands that differ there, and says how many and which. Too many rows to identify the channel's
/// own are a problem. `lines`: of each sample in the file; `origin`: the file's time at the first one.
void leave_out_second_streams(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                              FileReport& report);

/// Leaves out glitches of positions and velocities (glitches.h), and says how many and which. More than a tenth of the
/// readings are a problem; pulses of a velocity that rests in between are kept.
void leave_out_glitches(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                        FileReport& report);

}  // namespace lacuna
