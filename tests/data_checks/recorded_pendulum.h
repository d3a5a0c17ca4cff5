#pragma once

#include "data_checks/data_warning.h"
#include "fitting/numerics/seeded_noise.h"
#include "foundation/address.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// A pendulum on a hinge with a motor and an encoder, and recordings of it that are integrated here, not by the engine.
struct PendulumTruth {
  double inertia = 0.025;               // kg·m², about the hinge
  double gravity = 0.981;               // N·m at 90°
  double damping = 0.0;                 // N·m·s/rad
  double friction = 0.0;                // N·m, dry
  double backward = 0.0;                // N·m, dry, more of it on the way back
  double spring = 0.0;                  // N·m/rad
  double cubic = 0.0;                   // N·m/rad³
  double delay = 0.0;                   // s, of the command
  double before = std::nan("");         // N·m, commanded before the recording; NaN: its first command
  double lateness = 0.0;                // s, of the reading
  double limit = 1e9;                   // N·m, of the motor at rest
  double no_load = 1e9;                 // rad/s, at which it has no torque left
  double feedback = 0.0;                // N·m/rad, of the noisy reading, added to the command
  double noise = 5e-4;                  // rad
  double tension = 0.0;                 // N, of a cable from the arm's centre of mass to a point outside
  double cable_x = 0.0, cable_z = 0.0;  // m, that point
  double disturbance = 0.0;             // N·m, standard deviation of a torque that nobody records, over about 0.2 s
};

constexpr double kPendulumLength = 0.2;  // m, to the centre of mass

/// N·m about the hinge, of the cable.
inline double pull_of_cable(const PendulumTruth& truth, double q) {
  const double x = -kPendulumLength * std::sin(q), z = -kPendulumLength * std::cos(q);
  const double along_x = truth.cable_x - x, along_z = truth.cable_z - z;
  return truth.tension * (z * along_x - x * along_z) / std::hypot(along_x, along_z);
}

inline RobotSpec pendulum_robot() {
  RobotSpec robot;
  robot.name = "pendulum";
  BodySpec arm;
  arm.name = "arm";
  arm.mass = 0.5;
  arm.com = {0.0, 0.0, -kPendulumLength};
  arm.inertia = {.xx = 0.005, .yy = 0.005, .zz = 0.0005};
  robot.bodies = {arm};
  JointSpec hinge;
  hinge.name = "hinge";
  hinge.child = "arm";
  robot.joints = {hinge};
  ActuatorSpec motor;
  motor.name = "motor";
  motor.joint = "hinge";
  robot.actuators = {motor};
  SensorSpec angle;
  angle.name = "angle";
  angle.element = "hinge";
  robot.sensors = {angle};
  return robot;
}

inline double sine(double t) { return 0.3 * std::sin(2.0 * M_PI * 0.5 * t); }
inline double multisine(double t) {
  constexpr std::array kFrequencies = {0.3, 0.7, 1.1, 1.9, 3.1};  // Hz
  double torque = 0.0;
  for (std::size_t i = 0; i < kFrequencies.size(); ++i)
    torque += 0.1 * std::sin(2.0 * M_PI * kFrequencies[i] * t + 1.3 * static_cast<double>(i * i));
  return torque;
}
inline double steps(double t) {
  constexpr std::array kLevels = {0.3, -0.2, 0.5, -0.5, 0.1, -0.4, 0.0};  // N·m
  return kLevels[static_cast<std::size_t>(t / 0.8) % kLevels.size()];
}

/// How often a recording has a sample, and where the pendulum hangs at its start.
struct RecordedAs {
  double interval = 0.01;  // s
  double angle = 0.0;      // rad
};

inline Trial recorded(const PendulumTruth& truth, const std::string& name, const std::function<double(double)>& command,
                      double duration, std::uint64_t seed, const RecordedAs& as = {}) {
  const double interval = as.interval;
  constexpr int kSubsteps = 50;
  const double h = interval / kSubsteps;
  const auto samples = static_cast<Eigen::Index>(std::lround(duration / interval)) + 1;
  Trial trial;
  trial.name = name;
  trial.measured.channels = {{"angle", "rad"}};
  trial.commands.series.channels = command_channels(pendulum_robot());
  trial.measured.times = Eigen::VectorXd::LinSpaced(samples, 0.0, interval * static_cast<double>(samples - 1));
  trial.commands.series.times = trial.measured.times;
  trial.measured.samples.resize(samples, 1);
  trial.commands.series.samples.resize(samples, 1);
  trial.sensor_noise = {truth.noise};
  SeededNoise random(seed, 0);
  double q = as.angle, v = 0.0, disturbance = 0.0;
  const auto late = static_cast<std::size_t>(std::lround(truth.lateness / h));
  std::vector<double> past(late, 0.0);
  const double kept = std::exp(-interval / 0.2);
  for (Eigen::Index i = 0; i < samples; ++i) {
    past.push_back(q);
    const double reading = past[past.size() - 1 - late] + truth.noise * random.normal();
    past.pop_back();
    trial.measured.samples(i, 0) = reading;
    trial.commands.series.samples(i, 0) = command(trial.measured.times(i)) - truth.feedback * reading;
    disturbance = kept * disturbance + truth.disturbance * std::sqrt(1.0 - kept * kept) * random.normal();
    for (int k = 0; k < kSubsteps; ++k) {
      const double sent = trial.measured.times(i) + k * h - truth.delay;
      const auto held = sent < 0.0 ? Eigen::Index{0} : static_cast<Eigen::Index>(sent / interval + 1e-9);
      const bool from_before = sent < 0.0 && std::isfinite(truth.before);
      const double wanted = from_before ? truth.before : trial.commands.series.samples(std::min(held, i), 0);
      past.push_back(q);
      q += 0.5 * h * v;
      const double motor =
          std::clamp(wanted, -truth.limit * (1.0 + v / truth.no_load), truth.limit * (1.0 - v / truth.no_load));
      const double torque = motor + disturbance - truth.gravity * std::sin(q) - truth.damping * v - truth.spring * q -
                            truth.cubic * q * q * q + (truth.tension > 0.0 ? pull_of_cable(truth, q) : 0.0);
      const double free = v + h * torque / truth.inertia;
      const double stopped = h * (truth.friction + (free < 0.0 ? truth.backward : 0.0)) / truth.inertia;
      v = std::abs(free) <= stopped ? 0.0 : free - std::copysign(stopped, free);
      q += 0.5 * h * v;
    }
  }
  return trial;
}

/// Three files of one rig, as a user would record them, and the model of the pendulum without anything hidden.
struct RecordedPendulum {
  explicit RecordedPendulum(const PendulumTruth& truth = {}, std::uint64_t seed = 1) {
    definition.structure.robot = pendulum_robot();
    definition.engine.step = 0.01;
    definition.engine.substeps = 4;
    model = compile(definition.structure, definition.engine);
    trials = {recorded(truth, "sine.csv", sine, 6.0, seed), recorded(truth, "multi.csv", multisine, 6.0, seed + 1),
              recorded(truth, "steps.csv", steps, 6.0, seed + 2)};
  }
  auto angle(std::size_t which) { return trials[which].measured.samples.col(0); }
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<Trial> trials;
  std::vector<double> values;
};

}  // namespace lacuna
