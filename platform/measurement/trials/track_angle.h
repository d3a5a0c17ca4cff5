#pragma once

#include "measurement/trials/read_tables.h"

namespace lacuna {

/// Where a sensor's column is x of a tracked point, converts it to the angle (rad) or the distance (m) of the point
/// from its pivot. The columns of y come after all others of a plan, in the order of the sensors; they are removed. A
/// file that has only one of the two is a problem.
void make_angles_of_tracks(const RecordingPlan& plan, ReadTable& read);

}  // namespace lacuna
