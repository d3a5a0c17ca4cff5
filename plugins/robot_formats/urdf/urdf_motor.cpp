#include "urdf_motor.h"

#include "xml_writing.h"

namespace lacuna::urdf {
namespace {

// Defaults for a servo without gains: its full effort for this error, and a time constant of this size.
constexpr double kUsualEffort = 10.0;  ///< N·m or N
constexpr double kUsualError = 0.1;    ///< rad or m
constexpr double kUsualTime = 0.1;     ///< kd over kp, s

void guess(std::vector<RobotRemark>& remarks, int line, std::string text) {
  remarks.push_back({RobotRemarkKind::guessed, line, std::move(text), {}});
}

void take_servo(const Joint& joint, bool is_position, ActuatorSpec& motor, std::vector<RobotRemark>& remarks) {
  using robot_files::number_text;
  const double kp = (joint.effort > 0.0 ? joint.effort : kUsualEffort) / kUsualError;
  motor.kind = is_position ? ActuatorKind::position_servo : ActuatorKind::velocity_servo;
  motor.kp = is_position ? kp : 0.0;
  motor.kd = kp * kUsualTime;
  const std::string address = "actuator." + joint.name;
  const std::string start = "joint " + joint.name + " is commanded in ";
  guess(remarks, joint.commands->line,
        is_position ? start + "position, but a URDF has no gains: kp = " + number_text(motor.kp) + " and kd = " +
                          number_text(motor.kd) + " are used; free " + address + ".kp and " + address + ".kd"
                    : start + "velocity, but a URDF has no gains: kd = " + number_text(motor.kd) + " is used; free " +
                          address + ".kd");
}

}  // namespace

std::optional<ActuatorSpec> motor_of(const Joint& joint, bool says_commands, std::vector<RobotRemark>& remarks) {
  ActuatorSpec motor;
  motor.name = motor.joint = joint.name;
  if (joint.effort > 0.0) motor.force_limit = joint.effort;
  if (!says_commands) return motor;
  if (!joint.commands || joint.commands->interfaces.empty()) {
    guess(remarks, joint.line, "joint " + joint.name + " has no command interface, so it has no drive");
    return std::nullopt;
  }
  motor.transmission.ratio = joint.commands->reduction;
  const std::set<Interface>& known = joint.commands->interfaces;
  if (!known.contains(Interface::effort))
    take_servo(joint, known.contains(Interface::position), motor, remarks);
  else if (known.size() > 1)
    guess(remarks, joint.commands->line, "joint " + joint.name + " has several command interfaces; effort is used");
  return motor;
}

}  // namespace lacuna::urdf
