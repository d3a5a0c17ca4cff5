#include "cases/recorded_trial.h"

#include "plant/draw.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kMakeStep = 2.5e-5;  ///< s

void add_sensor_noise(Readings& readings, const CaseNoise& noise, double interval, std::uint64_t seed) {
  for (std::size_t s = 0; s < readings.size(); ++s) {
    bench::Normal white(mixed(seed, 200 + s));
    bench::Disturbance slow(noise.sensor_slow[s], noise.sensor_time, interval, mixed(seed, 300 + s));
    for (double& value : readings[s]) {
      value += noise.sensor_white[s] * white() + slow.value();
      slow.next();
      if (noise.quantum[s] > 0.0) value = bench::rounded(value, noise.quantum[s]);
    }
  }
}

Readings carry_out(const PlantModel& model, const Eigen::VectorXd& values, const Excitation& excitation) {
  const Laws laws = model.laws_at(values);
  Simulation plant(model.spec_at(values), laws, excitation, kMakeStep);
  const auto joints = static_cast<Eigen::Index>(model.spec.joints.size());
  const Start rest{Coordinates::Zero(joints), Coordinates::Zero(joints)};
  const Motion motion = simulate(plant, rest, excitation.samples(), 10);
  return read_sensors(plant.spec(), laws, motion);
}

std::vector<std::vector<double>> recorded_commands(const Excitation& applied, const CaseNoise& noise,
                                                   std::uint64_t seed) {
  std::vector<std::vector<double>> recorded = applied.commands;
  for (std::size_t d = 0; d < recorded.size(); ++d) {
    bench::Normal normal(mixed(seed, 400 + d));
    if (noise.command[d] > 0.0)
      for (double& value : recorded[d]) value += noise.command[d] * normal();
  }
  return recorded;
}

}  // namespace

void add_random_forces(Excitation& excitation, const CaseNoise& noise, std::uint64_t seed) {
  if (std::all_of(noise.random_force.begin(), noise.random_force.end(), [](double size) { return size == 0.0; }))
    return;
  const double duration = static_cast<double>(excitation.samples()) * excitation.interval;
  const auto knots = static_cast<std::size_t>(std::ceil(duration / excitation.knot_interval)) + 2;
  for (std::size_t j = 0; j < noise.random_force.size(); ++j) {
    bench::Disturbance force(noise.random_force[j], noise.force_time, excitation.knot_interval, mixed(seed, 100 + j));
    std::vector<double>& values = excitation.forces.emplace_back();
    for (std::size_t k = 0; k < knots; ++k) {
      values.push_back(force.value());
      force.next();
    }
  }
}

MadeTrial recorded_trial(const MadeCase& made, const Excitation& excitation, std::uint64_t seed) {
  MadeTrial trial;
  trial.applied = excitation;
  trial.clean = carry_out(made.truth, made.truth_values, trial.applied);
  add_random_forces(trial.applied, made.noise, seed);
  trial.readings = trial.applied.forces.empty() ? trial.clean : carry_out(made.truth, made.truth_values, trial.applied);
  add_sensor_noise(trial.readings, made.noise, excitation.interval, seed);
  trial.recorded_commands = recorded_commands(trial.applied, made.noise, seed);
  return trial;
}

}  // namespace hidden_effects
