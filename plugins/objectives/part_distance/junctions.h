#pragma once

#include <lacuna/robot_spec.h>

#include <cstddef>
#include <vector>

namespace lacuna {

/// Which ends of a robot's cylinders and capsules meet. Numbers of places, two a body: its tail (2·i) and its head
/// (2·i + 1), the tail being where its shape's own −z points; equal numbers meet. Joints make ends meet, so a part that
/// hangs on its parent's head and one that hangs on the tail of a sibling there are attached alike. A joint that is at
/// no end of its parent makes a place of its own there.
std::vector<std::size_t> junctions(const RobotSpec& robot);

}  // namespace lacuna
