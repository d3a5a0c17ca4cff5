#include "cases/write_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <stdexcept>

namespace hidden_effects {
namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string unit_of_position(const PlantJoint& joint) { return joint.slides ? "m" : "rad"; }
std::string unit_of_force(const PlantJoint& joint) { return joint.slides ? "N" : "N*m"; }

/// A number as TOML takes a float.
std::string number(double value) {
  const std::string text = fmt::format("{:.10g}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string vector(double x, double z) { return fmt::format("[{}, 0.0, {}]", number(x), number(z)); }

std::string body_text(const PlantBody& body, const InPlane& origin) {
  const std::string inertia = number(body.inertia);
  return fmt::format(
      "[body.{}]\nat = {}\nmass = {}\ncom = {}\ninertia = [{}, {}, {}]\ninertia_scales_with_mass = false\n\n",
      body.name, vector(origin.x(), origin.y()), number(body.mass), vector(body.com.x(), body.com.y()), inertia,
      inertia, inertia);
}

std::string joint_text(const PlantSpec& spec, std::size_t j) {
  const PlantJoint& joint = spec.joints[j];
  std::string text =
      fmt::format("[joint.{}]\nkind = \"{}\"\nparent = \"{}\"\nchild = \"{}\"\n", joint.name,
                  joint.slides ? "slider" : "hinge", j == 0 ? "world" : spec.bodies[j - 1].name, spec.bodies[j].name);
  text += joint.slides ? fmt::format("axis = {}\n", vector(joint.axis.x(), joint.axis.y())) : "axis = \"y\"\n";
  text += fmt::format("damping = {}\n", number(joint.damping));
  if (joint.stiffness > 0.0)
    text += fmt::format("stiffness = {}\nrest = {}\n", number(joint.stiffness), number(joint.rest));
  return text + "\n";
}

std::string drive_text(const PlantSpec& spec, const PlantDrive& drive) {
  std::string text =
      fmt::format("[actuator.{}]\njoint = \"{}\"\nkind = \"{}\"\n", drive.name,
                  spec.joints[static_cast<std::size_t>(drive.joint)].name, drive.servo ? "position_servo" : "force");
  if (drive.servo) text += fmt::format("kp = {}\nkd = {}\n", number(drive.kp), number(drive.kd));
  return text +
         fmt::format("\n[actuator.{}.transmission]\nrotor_inertia = {}\n\n", drive.name, number(drive.rotor_inertia));
}

std::string sensor_text(const PlantSpec& spec, std::size_t s, double quantum) {
  const PlantSensor& sensor = spec.sensors[s];
  std::string text = fmt::format("[sensor.{}]\nkind = \"{}\"\njoint = \"{}\"\n", sensor.name,
                                 sensor.velocity ? "joint_velocity" : "joint_position",
                                 spec.joints[static_cast<std::size_t>(sensor.joint)].name);
  if (quantum > 0.0) text += fmt::format("quantum = {}\n", number(quantum));
  return text + "\n";
}

std::string robot_text(const MadeCase& made) {
  const PlantSpec& spec = made.base.spec;
  std::string text = fmt::format("[robot]\nname = \"{}\"\n\n", made.plan.rig);
  InPlane origin = InPlane::Zero();
  for (std::size_t j = 0; j < spec.joints.size(); ++j) {
    origin += spec.joints[j].anchor;
    text += body_text(spec.bodies[j], origin) + joint_text(spec, j);
  }
  for (const PlantDrive& drive : spec.drives) text += drive_text(spec, drive);
  for (std::size_t s = 0; s < spec.sensors.size(); ++s) text += sensor_text(spec, s, made.noise.quantum[s]);
  return text;
}

std::string files_text(const MadeCase& made, bool held_out) {
  std::vector<std::string> names;
  for (const MadeTrial& trial : made.trials)
    if (trial.held_out == held_out) names.push_back(fmt::format("\"{}.csv\"", trial.name));
  return fmt::format("[{}]", fmt::join(names, ", "));
}

std::string columns_text(const PlantSpec& spec) {
  std::string text;
  for (const PlantSensor& sensor : spec.sensors) {
    const std::string unit = unit_of_position(spec.joints[static_cast<std::size_t>(sensor.joint)]);
    text += fmt::format("[target.sensors.{}]\ncolumn = \"{}\"\nunit = \"{}{}\"\n\n", sensor.name, sensor.name, unit,
                        sensor.velocity ? "/s" : "");
  }
  for (const PlantDrive& drive : spec.drives) {
    text += fmt::format("[target.commands.{}]\ncolumn = \"{}\"\nunit = \"{}\"\n\n", drive.name, drive.name,
                        unit_of_command(spec, drive));
  }
  return text;
}

std::string free_text(const MadeCase& made) {
  std::string text = "[model.free]\n";
  PlantSpec spec = made.base.spec;
  for (const FreeValue& value : made.base.free) {
    const double nominal = value.of(spec);
    text +=
        fmt::format("\"{}\" = [{}, {}]\n", value.address, number(value.lower * nominal), number(value.upper * nominal));
  }
  return text;
}

std::string rig_text(const MadeCase& made) {
  const double interval = made.trials.front().applied.interval;
  return fmt::format(
      "[experiment]\nname = \"{}\"\nseed = 1\n\n[target]\nkind = \"recorded\"\nfiles = {}\nholdout = {}\nhold = "
      "\"zero\"\n\n"
      "[target.time]\ncolumn = \"t\"\n\n{}[model]\nfile = \"robot.toml\"\neffects = []\n\n{}\n[engine]\nstep = {}\n",
      made.plan.name(), files_text(made, false), files_text(made, true), columns_text(made.base.spec), free_text(made),
      number(interval));
}

std::string recording_text(const MadeCase& made, const MadeTrial& trial) {
  std::string text = "t";
  for (const PlantDrive& drive : made.base.spec.drives) text += "," + drive.name;
  for (const PlantSensor& sensor : made.base.spec.sensors) text += "," + sensor.name;
  text += '\n';
  for (std::size_t k = 0; k < trial.applied.samples(); ++k) {
    text += fmt::format("{:.6g}", static_cast<double>(k) * trial.applied.interval);
    for (const auto& commands : trial.recorded_commands) text += fmt::format(",{:.9g}", commands[k]);
    for (const auto& readings : trial.readings) text += fmt::format(",{:.9g}", readings[k]);
    text += '\n';
  }
  return text;
}

}  // namespace

void write_case(const MadeCase& made, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_text(folder / "robot.toml", robot_text(made));
  write_text(folder / "rig.toml", rig_text(made));
  for (const MadeTrial& trial : made.trials) write_text(folder / (trial.name + ".csv"), recording_text(made, trial));
}

std::string unit_of_command(const PlantSpec& spec, const PlantDrive& drive) {
  const PlantJoint& joint = spec.joints[static_cast<std::size_t>(drive.joint)];
  return drive.servo ? unit_of_position(joint) : unit_of_force(joint);
}

std::string where_of(const LawKind& kind, int element, const PlantSpec& spec) {
  const auto of = [element](const auto& elements) {
    return element == kEverywhere ? "*" : elements[static_cast<std::size_t>(element)].name;
  };
  switch (kind.place) {
    case Place::joint: return "joint." + of(spec.joints);
    case Place::body: return "body." + of(spec.bodies);
    case Place::drive: return "actuator." + of(spec.drives);
    case Place::sensor: return "sensor." + of(spec.sensors);
    case Place::world: break;
  }
  return {};
}

}  // namespace hidden_effects
