#include "contacts/contact_rig.h"
#include "plant/draw.h"

#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kBaseInterval = 0.01;  ///< s

constexpr const char* kBaseRobot = R"([robot]
name = "wheeled_base"

[body.chassis]
at = [0.0, 0.0, 0.1]
mass = 6.0
com = [-0.1, 0.0, -0.03]
inertia = [0.08, 0.1, 0.15]

[body.left_wheel]
at = [0.0, 0.18, 0.1]
mass = 0.5
shapes = [{ kind = "sphere", radius = 0.1 }]

[body.right_wheel]
at = [0.0, -0.18, 0.1]
mass = 0.5
shapes = [{ kind = "sphere", radius = 0.1 }]

[body.caster]
at = [-0.25, 0.0, 0.05]
mass = 0.2
shapes = [{ kind = "sphere", radius = 0.05 }]

[contact]
ground = true
friction = 0.6

[joint.left]
parent = "chassis"
child = "left_wheel"
damping = 0.01

[joint.right]
parent = "chassis"
child = "right_wheel"
damping = 0.01

[joint.caster]
kind = "ball"
parent = "chassis"
child = "caster"

[actuator.left_motor]
joint = "left"
kind = "velocity_servo"
kd = 0.25

[actuator.right_motor]
joint = "right"
kind = "velocity_servo"
kd = 0.25

[sensor.left_angle]
kind = "joint_position"
joint = "left"

[sensor.right_angle]
kind = "joint_position"
joint = "right"

[sensor.place]
kind = "body_position"
body = "chassis"
)";

/// Wheel speeds in rad/s, each pair held for 0.15 to 0.4 s: straight ahead, or, in two of three trials, with turns.
Samples drive_program(int samples, std::uint64_t seed) {
  Draw draw(seed, 1);
  const double turning = draw.uniform() < 1.0 / 3.0 ? 0.0 : 4.0;
  Samples speeds(2);
  double sign = 1.0;
  while (static_cast<int>(speeds[0].size()) < samples) {
    const auto held = static_cast<std::size_t>(draw.between(0.15, 0.4) / kBaseInterval);
    const double ahead = sign * draw.between(3.0, 12.0), turn = turning * draw.between(-1.0, 1.0);
    speeds[0].insert(speeds[0].end(), held, ahead - turn);
    speeds[1].insert(speeds[1].end(), held, ahead + turn);
    if (draw.uniform() < 0.7) sign = -sign;
  }
  for (std::vector<double>& wheel : speeds) wheel.resize(static_cast<std::size_t>(samples));
  return speeds;
}

}  // namespace

ContactRig wheeled_base() {
  ContactRig rig;
  rig.name = "wheeled_base";
  rig.robot = kBaseRobot;
  rig.starts = {{"left"}, {"right"}};
  rig.interval = rig.step = kBaseInterval;
  rig.substeps = 8;
  rig.duration = 0.8;
  rig.fit_trials = 12;
  rig.held_out_trials = 2;
  rig.free = "body.chassis.mass";
  rig.nominal = 6.0;
  rig.spread = 0.15;
  rig.believed = {3e4, 300.0};
  rig.real = {3.3e4, 340.0};
  rig.channels = {{"left_angle", "rad", 2e-3, 6e-3},
                  {"right_angle", "rad", 2e-3, 6e-3},
                  {"place.x", "m", 5e-4, 1e-3},
                  {"place.y", "m", 5e-4, 1e-3}};
  rig.drives = {{"left_motor", "rad/s", 0.07, 0.1}, {"right_motor", "rad/s", 0.07, 0.1}};
  rig.commands = drive_program;
  using enum SizeRule;
  rig.laws = {{"contact_friction", "contact_friction", "", "coefficient", yields, 0.2},
              {"wheel_slip", "wheel_slip", "", "creep", grows, 2e-3},
              {"rolling_resistance", "rolling_resistance", "", "lever", grows, 2e-3},
              {"slope", "slope", "", "angle", grows, 0.03},
              {"contact_compliance", "contact_compliance", "", "stiffness", yields, 2e3, "damping = 0.5"},
              {"viscous_friction", "viscous_friction", "joint.left", "damping", grows, 0.02},
              {"coulomb_friction", "coulomb_friction", "joint.right", "torque", grows, 0.1},
              {"payload", "payload", "body.chassis", "mass", grows, 0.6, "x = 0.15, y = 0.1, z = 0.05"},
              {"actuator_lag", "actuator_lag", "actuator.*", "time", grows, 0.01},
              {"command_delay", "command_delay", "actuator.*", "delay", grows, 0.01, "", 0.3},
              {"torque_gain", "torque_gain", "actuator.left_motor", "gain", fades, 0.1},
              {"sensor_offset", "sensor_offset", "sensor.right_angle", "offset", grows, 0.01},
              {"sensor_scale", "sensor_scale", "sensor.left_angle", "scale", fades, 0.02},
              {"jittered_delay", "command_delay", "actuator.*", "delay", grows, 0.01, "", 0.3},
              {"two_stage_lag", "actuator_lag", "actuator.*", "time", grows, 0.01}};
  return rig;
}

}  // namespace hidden_effects
