#pragma once

#include "measurement/trials/trial_builder.h"

#include <vector>

namespace lacuna {

/// Leaves out the rows that another publisher or sensor wrote between those of a position or velocity
/// (second_stream.h), also of other sensors and of commands that are apart there, and says how many and which. More
/// than can be told from the channel's own are a problem. `lines`: of each sample in the file; `origin`: the file's
/// time at the first one.
void leave_out_second_streams(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                              FileReport& report);

/// Leaves out glitches of positions and velocities (glitches.h), and says how many and which. More than a tenth of the
/// readings are a problem; pulses of a velocity that rests in between are kept.
void leave_out_glitches(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                        FileReport& report);

}  // namespace lacuna
