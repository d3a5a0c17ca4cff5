#pragma once

#include <lacuna/robot_spec.h>

#include <cstddef>
#include <vector>

namespace lacuna {

/// Which ends of a robot's cylinders and capsules meet. Numbers of places, two per body: its tail (2·i) and its head
/// (2·i + 1), the tail being in the direction of its shape's −z; equal numbers meet. Joints make ends meet, so a part
/// attached to its parent's head and one attached to the tail of a sibling there count as equal. A joint that is at no
/// end of its parent makes a separate place.
std::vector<std::size_t> junctions(const RobotSpec& robot);

}  // namespace lacuna
