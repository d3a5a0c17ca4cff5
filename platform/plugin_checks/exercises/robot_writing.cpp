#include "plugin_checks/exercises/robot_writing.h"

#include "loading/effect_trial.h"

namespace lacuna {
namespace {

using Numbers = std::vector<double>;

void put(Numbers& numbers, const Eigen::Vector3d& vector) {
  numbers.insert(numbers.end(), vector.begin(), vector.end());
}
void put(Numbers& numbers, const Eigen::Quaterniond& turn) {
  numbers.insert(numbers.end(), {turn.w(), turn.x(), turn.y(), turn.z()});
}

}  // namespace

void write_down_robot(const char* call, const RobotSpec& robot, Transcript& transcript) {
  Numbers numbers = numbers_of(robot);
  for (const BodySpec& body : robot.bodies) {
    transcript.add_text(call, body.name);
    put(numbers, body.position);
    put(numbers, body.orientation);
    for (const ShapeSpec& shape : body.shapes) {
      put(numbers, shape.size);
      put(numbers, shape.position);
      put(numbers, shape.orientation);
    }
  }
  for (const JointSpec& joint : robot.joints) {
    transcript.add_text(call, joint.name + " " + joint.parent + " " + joint.child);
    put(numbers, joint.anchor);
    put(numbers, joint.axis);
    put(numbers, joint.axis2);
  }
  for (const ActuatorSpec& actuator : robot.actuators) transcript.add_text(call, actuator.name + " " + actuator.joint);
  for (const SensorSpec& sensor : robot.sensors) {
    transcript.add_text(call, sensor.name + " " + sensor.element);
    put(numbers, sensor.beacon);
    put(numbers, sensor.at);
  }
  for (const CouplingSpec& coupling : robot.couplings) numbers.insert(numbers.end(), {coupling.ratio, coupling.offset});
  transcript.add(call, numbers, Transcript::May::be_infinite);
}

}  // namespace lacuna
