#include "dirty/toml_text.h"
#include "dirty/write_dirty_case.h"

#include <fmt/format.h>

namespace hidden_effects::dirty {
namespace {

std::string body_table(const PlantBody& body, const InPlane& origin) {
  const std::string inertia = toml_number(body.inertia);
  return fmt::format(
      "[body.{}]\nat = {}\nmass = {}\ncom = {}\ninertia = [{}, {}, {}]\ninertia_scales_with_mass = false\n\n",
      body.name, toml_vector(origin), toml_number(body.mass), toml_vector(body.com), inertia, inertia, inertia);
}

std::string joint_table(const PlantSpec& spec, std::size_t j) {
  const PlantJoint& joint = spec.joints[j];
  std::string text =
      fmt::format("[joint.{}]\nkind = \"{}\"\nparent = \"{}\"\nchild = \"{}\"\n", joint.name,
                  joint.slides ? "slider" : "hinge", j == 0 ? "world" : spec.bodies[j - 1].name, spec.bodies[j].name);
  text += joint.slides ? fmt::format("axis = {}\n", toml_vector(joint.axis)) : "axis = \"y\"\n";
  if (joint.damping > 0.0) text += fmt::format("damping = {}\n", toml_number(joint.damping));
  if (joint.stiffness > 0.0)
    text += fmt::format("stiffness = {}\nrest = {}\n", toml_number(joint.stiffness), toml_number(joint.rest));
  return text + "\n";
}

std::string drive_table(const DirtyRig& rig, const PlantDrive& drive) {
  const std::string joint = rig.stated.joints[static_cast<std::size_t>(drive.joint)].name;
  const bool by_voltage = drive.resistance > 0.0;
  const char* kind = rig.driving == Driving::imposed ? "motion"
                     : drive.servo                   ? "position_servo"
                     : by_voltage                    ? "voltage"
                                                     : "force";
  std::string text = fmt::format("[actuator.{}]\njoint = \"{}\"\nkind = \"{}\"\n", drive.name, joint, kind);
  if (drive.servo) text += fmt::format("kp = {}\nkd = {}\n", toml_number(drive.kp), toml_number(drive.kd));
  if (by_voltage)
    text += fmt::format("\n[actuator.{}.motor]\ntorque_constant = {}\nresistance = {}\n", drive.name,
                        toml_number(drive.torque_constant), toml_number(drive.resistance));
  if (drive.rotor_inertia > 0.0)
    text +=
        fmt::format("\n[actuator.{}.transmission]\nrotor_inertia = {}\n", drive.name, toml_number(drive.rotor_inertia));
  return text + "\n";
}

std::string sensor_table(const DirtyCase& made, std::size_t s) {
  const PlantSensor& sensor = made.rig.stated.sensors[s];
  const bool is_force = made.rig.driving == Driving::imposed && s == 1;
  std::string text = fmt::format("[sensor.{}]\nkind = \"{}\"\njoint = \"{}\"\n", sensor.name,
                                 is_force          ? "drive_force"
                                 : sensor.velocity ? "joint_velocity"
                                                   : "joint_position",
                                 made.rig.stated.joints[static_cast<std::size_t>(sensor.joint)].name);
  if (made.recording.declares_quantum) text += fmt::format("quantum = {}\n", toml_number(made.recording.quantum[s]));
  return text + "\n";
}

}  // namespace

std::string toml_number(double value) {
  const std::string text = fmt::format("{:.6g}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string toml_vector(const InPlane& at) {
  return fmt::format("[{}, 0.0, {}]", toml_number(at.x()), toml_number(at.y()));
}

std::string robot_text(const DirtyCase& made) {
  const PlantSpec& spec = made.rig.stated;
  std::string text = fmt::format("[robot]\nname = \"{}\"\n\n", made.rig.family);
  InPlane origin = InPlane::Zero();
  for (std::size_t j = 0; j < spec.joints.size(); ++j) {
    origin += spec.joints[j].anchor;
    text += body_table(spec.bodies[j], origin) + joint_table(spec, j);
  }
  for (const PlantDrive& drive : spec.drives) text += drive_table(made.rig, drive);
  for (std::size_t s = 0; s < spec.sensors.size(); ++s) text += sensor_table(made, s);
  return text;
}

}  // namespace hidden_effects::dirty
