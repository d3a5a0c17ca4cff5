#include "contacts/hopper_plant.h"
#include "plant/draw.h"

#include <limits>

namespace hidden_effects {
namespace {

constexpr double kHopperInterval = 0.005;  ///< s

constexpr const char* kHopperRobot = R"([robot]
name = "hopper"

[body.trunk]
mass = 4.0
at = [0.0, 0.0, 0.5]
inertia = [0.01, 0.01, 0.01]

[body.foot]
mass = 0.6
at = [0.0, 0.0, 0.03]
inertia = [0.001, 0.001, 0.001]
shapes = [{ kind = "sphere", radius = 0.03 }]

[contact]
ground = true

[joint.rail]
kind = "slider"
child = "trunk"
axis = "z"

[joint.leg]
kind = "slider"
parent = "trunk"
child = "foot"
axis = [0.0, 0.0, -1.0]
stiffness = 2500.0
damping = 15.0

[actuator.motor]
joint = "leg"
kind = "force"

[sensor.length]
kind = "joint_position"
joint = "leg"

[sensor.ground]
kind = "touch"
body = "foot"
)";

/// Pushes of random strength, each held for a tenth of a second or two.
Samples pushes(int samples, std::uint64_t seed) {
  Draw draw(seed, 1);
  std::vector<double> force;
  while (static_cast<int>(force.size()) < samples) {
    const auto held = static_cast<std::size_t>(draw.between(0.1, 0.25) / kHopperInterval);
    force.insert(force.end(), held, draw.between(-60.0, 140.0));
  }
  force.resize(static_cast<std::size_t>(samples));
  return {force};
}

}  // namespace

ContactRig hopper() {
  ContactRig rig;
  rig.name = "hopper";
  rig.robot = kHopperRobot;
  rig.starts = {{"rail", kHopperDrop}, {"leg"}};
  rig.interval = kHopperInterval;
  rig.step = 1e-3;
  rig.substeps = 6;
  rig.duration = 0.6;
  rig.fit_trials = 12;
  rig.held_out_trials = 2;
  rig.free = "body.trunk.mass";
  rig.nominal = 4.0;
  rig.spread = 0.15;
  rig.believed = rig.real = {std::numeric_limits<double>::infinity(), 0.0};
  rig.channels = {{"length", "m", 2e-4, 5e-4}, {"ground", "1"}};
  rig.drives = {{"motor", "N", 0.7, 1.0}};
  rig.commands = pushes;
  using enum SizeRule;
  rig.laws = {{"restitution", "restitution", "", "coefficient", grows, 0.2, "", 0.9},
              {"contact_compliance", "contact_compliance", "", "stiffness", yields, 2e4, "damping = 0.5"},
              {"viscous_friction", "viscous_friction", "joint.leg", "damping", grows, 5.0},
              {"coulomb_friction", "coulomb_friction", "joint.leg", "torque", grows, 3.0},
              {"cubic_stiffness", "cubic_stiffness", "joint.leg", "stiffness", grows, 1e5},
              {"joint_offset_torque", "joint_offset_torque", "joint.leg", "torque", grows, 3.0},
              {"payload", "payload", "body.foot", "mass", grows, 0.1},
              {"actuator_lag", "actuator_lag", "actuator.motor", "time", grows, 5e-3},
              {"command_delay", "command_delay", "actuator.motor", "delay", grows, 5e-3, "", 0.3},
              {"torque_gain", "torque_gain", "actuator.motor", "gain", fades, 0.1},
              {"sensor_offset", "sensor_offset", "sensor.length", "offset", grows, 1e-3},
              {"sensor_scale", "sensor_scale", "sensor.length", "scale", fades, 0.05},
              {"sensor_delay", "sensor_delay", "sensor.length", "delay", grows, 3e-3, "", 0.2},
              {"falling_restitution", "restitution", "", "coefficient", grows, 0.3, "", 0.95},
              {"hertz_compliance", "contact_compliance", "", "stiffness", yields, 5e5},
              {"viscous_power", "viscous_friction", "joint.leg", "damping", grows, 5.0},
              {"smooth_coulomb", "coulomb_friction", "joint.leg", "torque", grows, 3.0},
              {"jittered_delay", "command_delay", "actuator.motor", "delay", grows, 5e-3, "", 0.3},
              {"two_stage_lag", "actuator_lag", "actuator.motor", "time", grows, 5e-3}};
  return rig;
}

}  // namespace hidden_effects
