#pragma once

#include "fitting/comparison.h"
#include "fitting/error_parts.h"
#include "fitting/numerics/seeded_noise.h"
#include "foundation/address.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace lacuna {

inline constexpr double kInterval = 0.004;  // s
inline constexpr Eigen::Index kReadings = 2500;
inline constexpr double kNoise = 1e-3;  // rad

/// A wheel on a hinge, 1 kg·m² about it, which a motor turns.
inline RobotSpec wheel() {
  RobotSpec robot;
  robot.name = "wheel";
  robot.gravity.setZero();
  BodySpec body;
  body.name = "wheel";
  body.inertia = {.xx = 1.0, .yy = 1.0, .zz = 1.0};
  robot.bodies = {body};
  JointSpec joint;
  joint.name = "hinge";
  joint.child = "wheel";
  robot.joints = {joint};
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

/// What the wheel lacks: an angular acceleration that depends on time, velocity and command.
using Missing = std::function<double(double time, double velocity, double command)>;

inline double command_at(double time) {
  return 3.0 * std::cos(2.0 * time) + 2.0 * std::cos(5.1 * time + 0.4) + 1.5 * std::cos(3.3 * time);
}

/// The wheel with what the model lacks, in steps of a tenth of a millisecond, and the comparison that `compare` would
/// make of it with a rigid model: the latter's free run from the same start is known exactly.
struct Rig {
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<Trial> trials;
  Comparison comparison;
};

inline Rig rig_lacking(const Missing& missing, std::uint64_t seed = 1) {
  Rig rig;
  rig.definition.structure.robot = wheel();
  rig.definition.engine.step = kInterval;
  rig.model = compile(rig.definition.structure, rig.definition.engine);
  Trial trial;
  trial.name = "multisine";
  trial.initial = {{InitialKnowledge::given, 0.0, 0.0}};
  trial.measured.channels = {{"angle", "rad"}};
  trial.commands.series.channels = command_channels(wheel());
  trial.measured.times = Eigen::VectorXd::LinSpaced(kReadings, 0.0, kInterval * (kReadings - 1));
  trial.commands.series.times = trial.measured.times;
  trial.measured.samples.resize(kReadings, 1);
  trial.commands.series.samples.resize(kReadings, 1);
  trial.sensor_noise = {kNoise};
  TimeSeries::Samples predicted(kReadings, 1);
  SeededNoise random(seed, 0);
  double q = 0.0, v = 0.0, rigid_q = 0.0, rigid_v = 0.0;
  constexpr int kSubsteps = 40;
  constexpr double h = kInterval / kSubsteps;
  for (Eigen::Index i = 0; i < kReadings; ++i) {
    trial.measured.samples(i, 0) = q + kNoise * random.normal();
    predicted(i, 0) = rigid_q;
    trial.commands.series.samples(i, 0) = command_at(trial.measured.times(i));
    for (int k = 0; k < kSubsteps; ++k) {
      const double time = trial.measured.times(i) + k * h, command = command_at(time);
      v += h * (command + missing(time, v, command));
      q += h * v;
      rigid_v += h * command;
      rigid_q += h * rigid_v;
    }
  }
  TrialComparison compared;
  compared.trial = trial.name;
  compared.times = trial.measured.times;
  compared.measured = trial.measured.samples;
  compared.predicted = predicted;
  compared.residuals = compared.measured - predicted;
  compared.start = {{0.0}, {0.0}};
  ChannelScore score;
  score.channel = "angle";
  score.unit = "rad";
  score.samples = kReadings;
  score.floor = kNoise;
  score.rmse = compared.residuals.norm() / std::sqrt(static_cast<double>(kReadings));
  score.times_floor = score.rmse / kNoise;
  score.normalised_rmse = score.rmse / std::sqrt(compared.measured.col(0).squaredNorm() / kReadings);
  score.bias = compared.residuals.mean();
  score.parts = error_parts(compared.measured.col(0), predicted.col(0));
  compared.channels = {score};
  rig.comparison.trials = {compared};
  rig.comparison.floors = {{trial.name, {{"angle", "rad", kNoise, 0.0, 0.0, kNoise, ""}}}};
  rig.trials = {trial};
  return rig;
}

}  // namespace lacuna
