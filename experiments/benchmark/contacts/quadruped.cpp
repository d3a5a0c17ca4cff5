#include "contacts/contact_rig.h"
#include "plant/draw.h"

#include <cmath>
#include <numbers>

namespace hidden_effects {
namespace {

constexpr double kQuadrupedInterval = 0.01;  ///< s
constexpr const char* kLegs[] = {"front_left", "front_right", "rear_left", "rear_right"};

/// Slow sines of each joint, in shares of its range: what the robot's servos multiply by 30° (its actuators' gain).
Samples sines(int samples, std::uint64_t seed) {
  Draw draw(seed, 1);
  Samples all;
  for (int joint = 0; joint < 8; ++joint) {
    const double size = draw.between(0.3, 0.9), frequency = draw.between(0.5, 2.0),
                 phase = draw.between(0.0, 2.0 * std::numbers::pi);
    std::vector<double>& values = all.emplace_back();
    for (int k = 0; k < samples; ++k)
      values.push_back(size * std::sin(2.0 * std::numbers::pi * frequency * kQuadrupedInterval * k + phase));
  }
  return all;
}

}  // namespace

ContactRig quadruped() {
  ContactRig rig;
  rig.name = "quadruped";
  rig.interval = rig.step = kQuadrupedInterval;
  rig.substeps = 4;
  rig.duration = 0.8;
  rig.fit_trials = 12;
  rig.held_out_trials = 2;
  rig.free = "body.torso.mass";
  rig.nominal = 1.0;
  rig.spread = 0.15;
  rig.believed = {2e4, 300.0};
  rig.real = {2.2e4, 340.0};
  rig.commands = sines;
  for (const std::string leg : kLegs) {
    rig.channels.push_back({"touch_" + leg, "1"});
    for (const char* joint : {"_hip", "_knee"}) {
      rig.drives.push_back({leg + joint, "rad", 0.005, 0.01});
      rig.starts.push_back({leg + joint});
    }
  }
  for (const std::string leg : kLegs) rig.channels.push_back({"angle_" + leg, "1", 2e-3, 6e-3});
  using enum SizeRule;
  rig.laws = {{"contact_friction", "contact_friction", "", "coefficient", yields, 0.3},
              {"contact_compliance", "contact_compliance", "", "stiffness", yields, 5e3, "damping = 0.5"},
              {"rolling_resistance", "rolling_resistance", "", "lever", grows, 0.03},
              {"wheel_slip", "wheel_slip", "", "creep", grows, 0.01},
              {"slope", "slope", "", "angle", grows, 0.05},
              {"viscous_friction", "viscous_friction", "joint.front_left_knee", "damping", grows, 10.0},
              {"coulomb_friction", "coulomb_friction", "joint.*", "torque", grows, 5.0},
              {"payload", "payload", "body.rear_left_lower", "mass", grows, 0.3, "z = 0.3"},
              {"actuator_lag", "actuator_lag", "actuator.*", "time", grows, 0.03},
              {"command_delay", "command_delay", "actuator.*", "delay", grows, 0.02, "", 0.3},
              {"torque_gain", "torque_gain", "actuator.front_right_knee", "gain", fades, 0.1},
              {"torque_saturation", "torque_saturation", "actuator.*", "limit", yields, 20.0},
              {"sensor_offset", "sensor_offset", "sensor.angle_rear_right", "offset", grows, 0.01},
              {"sensor_scale", "sensor_scale", "sensor.angle_front_left", "scale", fades, 0.05},
              {"jittered_delay", "command_delay", "actuator.*", "delay", grows, 0.02, "", 0.3},
              {"two_stage_lag", "actuator_lag", "actuator.*", "time", grows, 0.03}};
  return rig;
}

}  // namespace hidden_effects
