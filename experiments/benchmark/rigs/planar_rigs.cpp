#include "rigs/rig.h"

#include <stdexcept>

namespace hidden_effects {

/// An arm on a torque-controlled motor.
Rig servo_pendulum() {
  Rig rig;
  rig.name = "servo_pendulum";
  rig.nominal.bodies = {{"arm", 0.5, {0.0, -0.2}, 0.005}};
  rig.nominal.joints = {{.name = "hinge", .damping = 0.02}};
  rig.nominal.drives = {{.name = "motor", .joint = 0, .rotor_inertia = 0.004}};
  rig.nominal.sensors = {{"angle", 0, false}};
  rig.free = {{"body.arm.mass", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.bodies[0].mass; }},
              {"joint.hinge.damping", 0.4, 0.0, 10.0, [](PlantSpec& s) -> double& { return s.joints[0].damping; }}};
  rig.scales = {.amplitude = {0.2}, .slowest = 0.15, .fastest = 2.5, .sensor_noise = {5e-4}, .quantum = {1.5e-3}};
  return rig;
}

/// A carriage between springs, moved by a linear motor.
Rig spring_slider() {
  Rig rig;
  rig.name = "spring_slider";
  rig.nominal.bodies = {{"carriage", 4.0, {0.0, 0.0}, 0.01}};
  rig.nominal.joints = {{.name = "slider", .slides = true, .damping = 6.0, .stiffness = 150.0}};
  rig.nominal.drives = {{.name = "motor", .joint = 0, .rotor_inertia = 0.5}};
  rig.nominal.sensors = {{"position", 0, false}};
  rig.free = {
      {"body.carriage.mass", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.bodies[0].mass; }},
      {"joint.slider.damping", 0.4, 0.0, 10.0, [](PlantSpec& s) -> double& { return s.joints[0].damping; }},
      {"joint.slider.stiffness", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.joints[0].stiffness; }}};
  rig.scales = {.amplitude = {12.0}, .slowest = 0.2, .fastest = 3.0, .sensor_noise = {5e-5}, .quantum = {1.5e-4}};
  return rig;
}

/// A geared servo that holds a link at the position it is told, its gains not known.
Rig position_servo() {
  Rig rig;
  rig.name = "position_servo";
  rig.nominal.bodies = {{"link", 0.8, {0.15, 0.0}, 0.006}};
  rig.nominal.joints = {{.name = "hinge", .damping = 0.05}};
  rig.nominal.drives = {{.name = "servo", .joint = 0, .servo = true, .kp = 12.0, .kd = 0.6, .rotor_inertia = 0.02}};
  rig.nominal.sensors = {{"angle", 0, false}};
  rig.free = {{"actuator.servo.kp", 0.25, 0.2, 5.0, [](PlantSpec& s) -> double& { return s.drives[0].kp; }},
              {"actuator.servo.kd", 0.25, 0.1, 8.0, [](PlantSpec& s) -> double& { return s.drives[0].kd; }}};
  rig.scales = {.amplitude = {0.4}, .slowest = 0.15, .fastest = 3.0, .sensor_noise = {4e-4}, .quantum = {1.2e-3}};
  return rig;
}

/// A driven cart with a pole that hangs from it.
Rig cart_pole() {
  Rig rig;
  rig.name = "cart_pole";
  rig.nominal.bodies = {{"cart", 1.2, {0.0, 0.0}, 0.01}, {"pole", 0.3, {0.0, -0.25}, 0.006}};
  rig.nominal.joints = {{.name = "rail", .slides = true, .damping = 1.5}, {.name = "pivot", .damping = 0.004}};
  rig.nominal.drives = {{.name = "motor", .joint = 0, .rotor_inertia = 0.2}};
  rig.nominal.sensors = {{"place", 0, false}, {"angle", 1, false}};
  rig.free = {{"body.cart.mass", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.bodies[0].mass; }},
              {"body.pole.mass", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.bodies[1].mass; }},
              {"joint.rail.damping", 0.4, 0.0, 10.0, [](PlantSpec& s) -> double& { return s.joints[0].damping; }},
              {"joint.pivot.damping", 0.4, 0.0, 20.0, [](PlantSpec& s) -> double& { return s.joints[1].damping; }}};
  rig.scales = {
      .amplitude = {3.0}, .slowest = 0.3, .fastest = 3.0, .sensor_noise = {1e-4, 5e-4}, .quantum = {3e-4, 1.5e-3}};
  return rig;
}

/// Two links that hang in the vertical plane, a torque motor in each joint.
Rig two_link_arm() {
  Rig rig;
  rig.name = "two_link_arm";
  rig.nominal.bodies = {{"upper", 0.9, {0.0, -0.15}, 0.009}, {"lower", 0.6, {0.0, -0.14}, 0.005}};
  rig.nominal.joints = {{.name = "shoulder", .damping = 0.1},
                        {.name = "elbow", .anchor = {0.0, -0.3}, .damping = 0.04}};
  rig.nominal.drives = {{.name = "shoulder_motor", .joint = 0, .rotor_inertia = 0.015},
                        {.name = "elbow_motor", .joint = 1, .rotor_inertia = 0.008}};
  rig.nominal.sensors = {{"shoulder_angle", 0, false}, {"elbow_angle", 1, false}};
  rig.free = {{"body.upper.mass", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.bodies[0].mass; }},
              {"body.lower.mass", 0.15, 0.3, 3.0, [](PlantSpec& s) -> double& { return s.bodies[1].mass; }},
              {"joint.shoulder.damping", 0.4, 0.0, 10.0, [](PlantSpec& s) -> double& { return s.joints[0].damping; }},
              {"joint.elbow.damping", 0.4, 0.0, 10.0, [](PlantSpec& s) -> double& { return s.joints[1].damping; }}};
  rig.scales = {.amplitude = {0.7, 0.2},
                .slowest = 0.2,
                .fastest = 3.0,
                .sensor_noise = {4e-4, 4e-4},
                .quantum = {1.2e-3, 1.2e-3}};
  return rig;
}

const std::vector<Rig>& planar_rigs() {
  static const std::vector<Rig> all = {servo_pendulum(), spring_slider(), position_servo(), cart_pole(),
                                       two_link_arm()};
  return all;
}

const Rig& rig_named(const std::string& name) {
  for (const Rig& rig : planar_rigs())
    if (rig.name == name) return rig;
  throw std::invalid_argument("no rig is called " + name);
}

}  // namespace hidden_effects
