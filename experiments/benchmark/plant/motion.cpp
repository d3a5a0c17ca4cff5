#include "plant/motion.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kRunsAway = 1e4;  ///< rad/s or m/s

void keep_state(const PlantState& state, Motion& motion) {
  for (std::size_t j = 0; j < motion.position.size(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    if (!(std::abs(state.velocity[k]) < kRunsAway)) throw std::runtime_error("the plant runs away");
    motion.position[j].push_back(state.position[k]);
    motion.velocity[j].push_back(state.velocity[k]);
  }
}

}  // namespace

Motion simulate(Simulation& plant, const Start& start, std::size_t samples, int keep) {
  const int every = std::gcd(keep, plant.steps_a_sample());
  Motion motion{plant.step() * every, plant.steps_a_sample() / every, {}, {}};
  motion.position.resize(plant.spec().joints.size());
  motion.velocity.resize(plant.spec().joints.size());
  for (auto* of : {&motion.position, &motion.velocity})
    for (std::vector<double>& one : *of)
      one.reserve((samples - 1) * static_cast<std::size_t>(motion.steps_a_sample) + 1);
  PlantState state = plant.start(start.position, start.velocity);
  keep_state(state, motion);
  int step = 0;
  for (std::size_t k = 0; k + 1 < samples; ++k)
    plant.advance(state, k, [&](const PlantState& now) {
      if (++step % every == 0) keep_state(now, motion);
    });
  return motion;
}

std::vector<std::vector<double>> read_sensors(const PlantSpec& spec, const Laws& laws, const Motion& motion) {
  std::vector<std::vector<double>> readings;
  for (std::size_t s = 0; s < spec.sensors.size(); ++s) {
    const PlantSensor& sensor = spec.sensors[s];
    const auto& read = sensor.velocity ? motion.velocity : motion.position;
    DenseReadings dense{read[static_cast<std::size_t>(sensor.joint)], motion.interval};
    if (sensor.scale != 1.0)
      for (double& value : dense.values) value *= sensor.scale;
    for (const auto& law : laws) law->read(static_cast<int>(s), dense);
    std::vector<double> sampled;
    for (std::size_t k = 0; k < dense.values.size(); k += static_cast<std::size_t>(motion.steps_a_sample))
      sampled.push_back(dense.values[k]);
    readings.push_back(std::move(sampled));
  }
  return readings;
}

}  // namespace hidden_effects
