#include "simulation/ode/robot_step.h"

#include "simulation/ode/articulation.h"
#include "simulation/ode/lone_joint.h"

#include <algorithm>

namespace lacuna::ode {
namespace {

bool hinge_or_slider(const JointSpec& joint) {
  return joint.kind == JointKind::hinge || joint.kind == JointKind::slider;
}

bool has_shape(const BodySpec& body) { return !body.shapes.empty(); }

/// Whether a robot is nothing but hinges and sliders that hold all its bodies, and touches nothing.
bool hangs_free(const RobotSpec& robot) {
  if (robot.joints.empty() || robot.bodies.size() != robot.joints.size()) return false;
  if (!std::all_of(robot.joints.begin(), robot.joints.end(), hinge_or_slider)) return false;
  return !robot.contact.ground || std::none_of(robot.bodies.begin(), robot.bodies.end(), has_shape);
}

}  // namespace

std::unique_ptr<RobotStep> make_robot_step(const RobotSpec& robot, const simulation::JointTree& tree,
                                           const Bodies& bodies, dWorldID world, double step, std::size_t laws) {
  if (!hangs_free(robot)) return nullptr;
  if (robot.joints.size() == 1) {
    const SteppedBody body(bodies.id(0), bodies.pose(0), robot.bodies.front());
    return std::make_unique<LoneJoint>(robot, world, body, step);
  }
  if (!Articulation::fits(robot, bodies, dWorldGetCFM(world) / step)) return nullptr;
  return std::make_unique<Articulation>(robot, tree, bodies, world, step, laws);
}

}  // namespace lacuna::ode
