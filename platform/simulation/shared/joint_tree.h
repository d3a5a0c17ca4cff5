#pragma once

#include <lacuna/robot_spec.h>

#include "foundation/address.h"
#include "simulation/compiled_model.h"

#include <vector>

namespace lacuna::simulation {

/// Stands for the world where a body's index is expected.
inline constexpr int kWorldIndex = -1;

/// Parents and children of a robot's bodies, and the numbering of its joint coordinates. Indices are those of the
/// spec's lists.
struct JointTree {
  std::vector<int> parent;            ///< per joint: body, or `kWorldIndex`
  std::vector<int> child;             ///< per joint: body
  std::vector<int> first_coordinate;  ///< per joint
  std::vector<int> outward;           ///< all joints, each after the one that holds its parent
  int coordinates = 0;
};

using lacuna::coordinate_count;

/// Throws `BadInput` where joints name unknown bodies, a body is the child of two joints, or
/// joints form a cycle.
JointTree make_joint_tree(const RobotSpec& robot);

/// Name and unit of each coordinate, in order.
std::vector<Coordinate> name_coordinates(const RobotSpec& robot);

/// The first joint coordinate of each element, as in a `StepView`.
struct ElementCoordinates {
  std::vector<int> joints;
  std::vector<int> actuators;
  std::vector<int> sensors;  ///< −1: reads no joint
};

ElementCoordinates element_coordinates(const RobotSpec& robot, const JointTree& tree);

/// Index of the element named `name`, or −1.
template <class Spec>
int index_of(const std::vector<Spec>& specs, const std::string& name) {
  for (std::size_t i = 0; i < specs.size(); ++i)
    if (specs[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace lacuna::simulation
