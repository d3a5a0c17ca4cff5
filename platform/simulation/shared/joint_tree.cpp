#include "simulation/shared/joint_tree.h"

#include "foundation/text/problem.h"
#include "simulation/shared/sensor_bank.h"

namespace lacuna::simulation {
namespace {

std::vector<std::string> body_names(const RobotSpec& robot) {
  std::vector<std::string> names{kWorld};
  for (const BodySpec& body : robot.bodies) names.push_back(body.name);
  return names;
}

void resolve_bodies(const RobotSpec& robot, JointTree& tree, ProblemList& problems) {
  for (const JointSpec& joint : robot.joints) {
    const int parent = joint.parent == kWorld ? kWorldIndex : index_of(robot.bodies, joint.parent);
    const int child = index_of(robot.bodies, joint.child);
    for (const auto& [role, name, known] : {std::tuple{"parent", joint.parent, parent >= 0 || joint.parent == kWorld},
                                            std::tuple{"child", joint.child, child >= 0}})
      if (!known)
        problems.add({}, "joint \"" + joint.name + "\": its " + role + " \"" + name + "\" is not a body of the robot" +
                             did_you_mean(name, body_names(robot)));
    tree.parent.push_back(parent);
    tree.child.push_back(child);
  }
}

/// The joint that holds each body, −1 where it floats.
std::vector<int> find_holders(const RobotSpec& robot, const JointTree& tree, ProblemList& problems) {
  std::vector<int> holder(robot.bodies.size(), -1);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    int& found = holder[static_cast<std::size_t>(tree.child[joint])];
    if (found >= 0)
      problems.add({}, "body \"" + robot.joints[joint].child + "\" is the child of two joints, \"" +
                           robot.joints[static_cast<std::size_t>(found)].name + "\" and \"" + robot.joints[joint].name +
                           "\"; a body can be the child of only one joint");
    found = static_cast<int>(joint);
  }
  return holder;
}

/// Orders the joints from the roots outward; joints of a cycle are never reached.
void order_outward(const RobotSpec& robot, const std::vector<int>& holder, JointTree& tree, ProblemList& problems) {
  const std::size_t count = robot.joints.size();
  std::vector<bool> placed(count, false);
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t joint = 0; joint < count; ++joint) {
      if (placed[joint]) continue;
      const int parent = tree.parent[joint];
      const int before = parent == kWorldIndex ? -1 : holder[static_cast<std::size_t>(parent)];
      if (before >= 0 && !placed[static_cast<std::size_t>(before)]) continue;
      tree.outward.push_back(static_cast<int>(joint));
      placed[joint] = progress = true;
    }
  }
  for (std::size_t joint = 0; joint < count; ++joint)
    if (!placed[joint])
      problems.add({}, "joint \"" + robot.joints[joint].name +
                           "\" is part of, or hangs on, a cycle of joints; joints must form trees");
}

}  // namespace

JointTree make_joint_tree(const RobotSpec& robot) {
  JointTree tree;
  ProblemList problems;
  resolve_bodies(robot, tree, problems);
  problems.throw_if_any();
  const std::vector<int> holder = find_holders(robot, tree, problems);
  order_outward(robot, holder, tree, problems);
  problems.throw_if_any();
  for (const JointSpec& joint : robot.joints) {
    tree.first_coordinate.push_back(tree.coordinates);
    tree.coordinates += coordinate_count(joint.kind);
  }
  return tree;
}

ElementCoordinates element_coordinates(const RobotSpec& robot, const JointTree& tree) {
  const auto of_joint = [&](const std::string& joint) {
    return tree.first_coordinate[static_cast<std::size_t>(index_of(robot.joints, joint))];
  };
  ElementCoordinates coordinates{.joints = tree.first_coordinate, .actuators = {}, .sensors = {}};
  for (const ActuatorSpec& actuator : robot.actuators) coordinates.actuators.push_back(of_joint(actuator.joint));
  for (const SensorSpec& sensor : robot.sensors)
    coordinates.sensors.push_back(reads_joint(sensor.kind) ? of_joint(sensor.element) : -1);
  return coordinates;
}

std::vector<Coordinate> name_coordinates(const RobotSpec& robot) {
  std::vector<Coordinate> coordinates;
  for (const JointSpec& joint : robot.joints) {
    const int count = coordinate_count(joint.kind);
    for (int i = 1; i <= count; ++i)
      coordinates.push_back(
          {"joint." + joint.name + (count > 1 ? "." + std::to_string(i) : ""),
           joint.kind == JointKind::slider || (joint.kind == JointKind::free && i <= 3) ? "m" : "rad"});
  }
  return coordinates;
}

}  // namespace lacuna::simulation
