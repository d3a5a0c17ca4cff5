#include "app/workspace/draft_text.h"
#include "app/workspace/rig_draft.h"
#include "config/schema/blank.h"
#include "config/toml/toml_node.h"
#include "foundation/text/plain_text.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

std::string body_text(const GuessedJoint& joint, bool is_first) {
  std::string text = fmt::format("\n[body.{}]\n", joint.body());
  text += with_comment("mass = " + blank("kg"), "everything that moves with this joint");
  if (joint.slides) {
    text += with_comment("inertia = [1.0, 1.0, 1.0]", "kg*m^2; without effect, because nothing turns");
    return text;
  }
  if (!is_first)
    text += with_comment(fmt::format("at = [0.0, 0.0, {}]", blank("m")), "where the joint is, all joints at zero");
  text += with_comment(fmt::format("com = [0.0, 0.0, {}]", blank("m")),
                       "centre of mass, seen from the joint; negative: hanging");
  const std::string moment = blank("kg*m^2");
  text += with_comment(fmt::format("inertia = [{}, {}, {}]", moment, moment, moment),
                       "about the centre of mass, along x, y, z; a slim rod: m*L^2/12 across, almost 0 along");
  return text;
}

std::string joint_text(const GuessedJoint& joint, const std::string& body_before) {
  std::string text = fmt::format("\n[joint.{}]\n", joint.name);
  text += with_comment(joint.slides ? "kind = \"slider\"" : "kind = \"hinge\"", "guessed: from the columns' units");
  if (!body_before.empty())
    text += with_comment("parent = " + toml_text(std::string(kBlank) + " world or " + body_before),
                         "the body that carries this joint");
  text += "child = " + toml_text(joint.body()) + "\n";
  text += joint.slides
              ? with_comment("axis = \"x\"", "guessed: horizontal, so that gravity has no effect")
              : with_comment("axis = \"y\"", "guessed: horizontal; at angle 0 the arm points from the axis to com");
  return text;
}

std::string motor_text(const GuessedJoint& joint) {
  std::string text = fmt::format("\n[actuator.{}]\njoint = {}\n", joint.motor(), toml_text(joint.name));
  const std::string force = joint.slides ? "N" : "N*m";
  if (joint.actuator == ActuatorKind::position_servo) {
    text += with_comment("kind = \"position_servo\"", "guessed: the command is a position");
    text += with_comment("kp = " + blank(force + "/" + position_unit(joint)), "stiffness of the servo");
    text += with_comment("kd = " + blank(force + "*s/" + position_unit(joint)), "damping of the servo");
  } else if (joint.actuator == ActuatorKind::velocity_servo) {
    text += with_comment("kind = \"velocity_servo\"", "guessed: the command is a velocity");
    text += with_comment("kd = " + blank(force + "*s/" + position_unit(joint)), "gain of the servo");
  } else if (joint.actuator == ActuatorKind::voltage) {
    text += with_comment("kind = \"voltage\"",
                         fmt::format("guessed: the voltage of a motor; if a drive makes a {0} of it, kind = \"force\" "
                                     "here and a gain in {1}/V in the experiment",
                                     joint.slides ? "force" : "torque", force));
    text += fmt::format("\n[actuator.{}.motor]\n", joint.motor());
    text += with_comment("torque_constant = " + blank(force + "/A"), "at the joint");
    text += with_comment("resistance = " + blank("Ohm"), "of the winding and its driver");
  } else {
    text += with_comment("kind = \"force\"", "the command is a " + std::string(joint.slides ? "force" : "torque"));
  }
  return text;
}

std::string sensor_text(const GuessedJoint& joint) {
  const auto sensor = [&](const std::string& name, const char* kind) {
    return fmt::format("\n[sensor.{}]\nkind = \"{}\"\njoint = {}\n", name, kind, toml_text(joint.name));
  };
  std::string text;
  if (joint.position) text += sensor(joint.position_sensor(), "joint_position");
  if (joint.velocity) text += sensor(joint.velocity_sensor(), "joint_velocity");
  return text;
}

}  // namespace

std::string robot_text(const RigDraft& draft) {
  const std::string name = rig_name(draft.experiment);
  std::string text = fmt::format(
      "# The robot of {}: one body per joint. Put values where it says {}; SI units, z up.\n"
      "# Values that are not written here (friction, springs, rotor inertia) are zero.\n\n[robot]\nname = {}\n",
      plain_text(draft.experiment.filename().string()), kBlank, toml_text(name));
  const std::vector<GuessedJoint>& joints = draft.guess.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) text += body_text(joints[i], i == 0);
  for (std::size_t i = 0; i < joints.size(); ++i) text += joint_text(joints[i], i > 0 ? joints[i - 1].body() : "");
  for (const GuessedJoint& joint : joints)
    if (joint.command) text += motor_text(joint);
  for (const GuessedJoint& joint : joints) text += sensor_text(joint);
  return text;
}

RobotSpec placeholder_robot(const RigGuess& guess) {
  RobotSpec robot;
  for (const GuessedJoint& joint : guess.joints) {
    BodySpec body;
    body.name = joint.body();
    robot.bodies.push_back(body);
    JointSpec spec;
    spec.name = joint.name;
    spec.kind = joint.slides ? JointKind::slider : JointKind::hinge;
    spec.child = joint.body();
    robot.joints.push_back(spec);
    if (joint.command) {
      ActuatorSpec motor;
      motor.name = joint.motor();
      motor.joint = joint.name;
      motor.kind = joint.actuator;
      robot.actuators.push_back(motor);
    }
    const auto add_sensor = [&](const std::string& name, SensorKind kind) {
      SensorSpec sensor;
      sensor.name = name;
      sensor.kind = kind;
      sensor.element = joint.name;
      robot.sensors.push_back(sensor);
    };
    if (joint.position) add_sensor(joint.position_sensor(), SensorKind::joint_position);
    if (joint.velocity) add_sensor(joint.velocity_sensor(), SensorKind::joint_velocity);
  }
  return robot;
}

}  // namespace lacuna
