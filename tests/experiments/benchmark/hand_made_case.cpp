#include "hand_made_case.h"

#include "plant/draw.h"

namespace hidden_effects {
namespace {

Start at_rest(const PlantSpec& spec) {
  const auto joints = static_cast<Eigen::Index>(spec.joints.size());
  return {Coordinates::Zero(joints), Coordinates::Zero(joints)};
}

std::vector<double> random_force(double deviation, double time, double knot_interval, std::size_t knots,
                                 std::uint64_t seed) {
  bench::Disturbance force(deviation, time, knot_interval, seed);
  std::vector<double> values;
  for (std::size_t k = 0; k < knots; ++k, force.next()) values.push_back(force.value());
  return values;
}

void add_sensor_noise(std::vector<double>& readings, const CaseNoise& noise, double interval, std::uint64_t seed) {
  bench::Normal white(mixed(seed, 1));
  bench::Disturbance slow(noise.sensor_slow[0], noise.sensor_time, interval, mixed(seed, 2));
  for (double& value : readings) {
    value += noise.sensor_white[0] * white() + slow.value();
    slow.next();
    if (noise.quantum[0] > 0.0) value = bench::rounded(value, noise.quantum[0]);
  }
}

MadeCase case_of(const Rig& rig, std::vector<double> values, const std::vector<SizedPlacedLaw>& hidden,
                 const CaseNoise& noise, std::size_t samples) {
  MadeCase made;
  made.plan.rig = rig.name;
  made.base = {rig.nominal, rig.free, {}};
  made.truth = made.base;
  made.noise = noise;
  made.base_values = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  for (const SizedPlacedLaw& one : hidden) {
    made.plan.hidden.push_back({one.law, one.element});
    made.truth.laws.push_back({&law_kind(one.law), one.element});
    values.insert(values.end(), one.parameters.begin(), one.parameters.end());
  }
  made.truth_values = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  for (int t = 0; t < 3; ++t) {
    MadeTrial trial;
    trial.applied.interval = rig.interval;
    trial.applied.commands = commands(rig, t, static_cast<double>(samples) * rig.interval, 7);
    for (std::vector<double>& of_drive : trial.applied.commands) of_drive.resize(samples);
    trial.recorded_commands = trial.applied.commands;
    trial.clean = predict(made.truth, made.truth_values, trial.applied, at_rest(rig.nominal));
    trial.readings = trial.clean;
    made.trials.push_back(std::move(trial));
  }
  return made;
}

}  // namespace

CaseNoise white_noise(std::size_t sensors) {
  const std::vector<double> none(sensors, 0.0);
  return {.sensor_white = std::vector<double>(sensors, 5e-4),
          .sensor_slow = none,
          .quantum = none,
          .random_force = none,
          .command = none};
}

CaseNoise disturbed_noise() {
  return {.sensor_white = {4e-4}, .sensor_slow = {6e-4}, .quantum = {5e-4}, .random_force = {0.01}, .command = {0.01}};
}

MadeCase pendulum_case(const std::vector<SizedPlacedLaw>& hidden, const CaseNoise& noise, std::size_t samples) {
  return case_of(servo_pendulum(), {0.53, 0.024}, hidden, noise, samples);  // mass, damping
}

MadeCase two_link_case(const std::vector<SizedPlacedLaw>& hidden, const CaseNoise& noise, std::size_t samples) {
  return case_of(two_link_arm(), {0.9, 0.6, 0.1, 0.04}, hidden, noise, samples);  // masses, dampings
}

void make_noisy(MadeCase& made, std::uint64_t seed) {
  for (std::size_t t = 0; t < made.trials.size(); ++t) {
    MadeTrial& trial = made.trials[t];
    const std::uint64_t own = mixed(seed, t);
    const CaseNoise& noise = made.noise;
    const double interval = trial.applied.interval;
    const auto knots = static_cast<std::size_t>(static_cast<double>(trial.applied.samples()) * interval /
                                                trial.applied.knot_interval) +
                       2;
    if (noise.random_force[0] > 0.0)
      trial.applied.forces = {
          random_force(noise.random_force[0], noise.force_time, trial.applied.knot_interval, knots, mixed(own, 3))};
    trial.readings = predict(made.truth, made.truth_values, trial.applied, at_rest(made.truth.spec));
    add_sensor_noise(trial.readings[0], noise, interval, own);
    trial.recorded_commands = trial.applied.commands;
    bench::Normal normal(mixed(own, 4));
    for (double& value : trial.recorded_commands[0]) value += noise.command[0] * normal();
  }
}

}  // namespace hidden_effects
