#pragma once

#include "measurement/trials/read_tables.h"

namespace lacuna {

/// Where a sensor's column is x of a tracked point, it becomes the angle (rad) or the distance (m) that the point is
/// seen at from its pivot. The columns of y stand behind all that a plan has otherwise, in the order of the sensors;
/// they are taken off. A file that has only one of the two is a problem.
void make_angles_of_tracks(const RecordingPlan& plan, ReadTable& read);

}  // namespace lacuna
