#include "dirty/true_trial.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

constexpr double kStepShare = 0.05;  ///< of 1 over the fastest rate: an integration step
constexpr double kTooFast = 1e4;     ///< rad/s or m/s
constexpr double kKnots = 0.1;       ///< of the time in which a random force forgets

/// The controllers outside of a rig's drives, sample by sample.
class Controllers {
 public:
  Controllers(const DirtyRig& rig, const std::vector<double>& noise, std::uint64_t seed)
      : rig_(rig), noise_(noise), normal_(seed), memory_(rig.loops.size()) {}

  /// Force of drive `d` at sample `k`.
  double force(std::size_t d, const PlantState& state, double reference) {
    const auto joint = static_cast<std::size_t>(rig_.stated.drives[d].joint);
    const PlantSensor& sensor = rig_.stated.sensors[joint];
    const auto j = static_cast<Eigen::Index>(joint);
    const double reading = (sensor.velocity ? state.velocity[j] : state.position[j]) + noise_[joint] * normal_();
    Memory& memory = memory_[d];
    if (!memory.begun) memory.before = reading;
    memory.begun = true;
    const double rate = sensor.velocity ? reading : smoothed(memory, reading);
    const Loop& loop = rig_.loops[d];
    const double controlled = rig_.driving == Driving::velocity_loop ? rate : reading;
    const double error = reference - controlled;
    memory.integral += error * rig_.interval;
    const double wanted = loop.proportional * error + loop.integral * memory.integral - loop.derivative * rate;
    return std::clamp(wanted, -loop.limit, loop.limit);
  }

 private:
  struct Memory {
    bool begun = false;
    double before = 0.0, rate = 0.0, integral = 0.0;
  };

  /// The reading's backward difference behind a low-pass of two samples.
  double smoothed(Memory& memory, double reading) const {
    memory.rate += 0.4 * ((reading - memory.before) / rig_.interval - memory.rate);
    memory.before = reading;
    return memory.rate;
  }

  const DirtyRig& rig_;
  const std::vector<double>& noise_;
  bench::Normal normal_;
  std::vector<Memory> memory_;
};

bool has_loops(const DirtyRig& rig) {
  return rig.driving == Driving::position_loop || rig.driving == Driving::velocity_loop;
}

Motion empty_motion(const PlantSpec& spec, const Simulation& plant) {
  Motion motion{plant.step(), plant.steps_a_sample(), {}, {}};
  motion.position.resize(spec.joints.size());
  motion.velocity.resize(spec.joints.size());
  return motion;
}

void keep(const PlantState& state, Motion& motion) {
  for (std::size_t j = 0; j < motion.position.size(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    if (!(std::abs(state.velocity[k]) < kTooFast)) throw std::runtime_error("the rig runs away");
    motion.position[j].push_back(state.position[k]);
    motion.velocity[j].push_back(state.velocity[k]);
  }
}

/// By joint, one a knot.
std::vector<std::vector<double>> random_forces(const Disturbance& disturbance, double duration, std::uint64_t seed) {
  std::vector<std::vector<double>> forces;
  const double interval = kKnots * disturbance.memory;
  for (std::size_t j = 0; j < disturbance.forces.size(); ++j) {
    bench::Disturbance force(disturbance.forces[j], disturbance.memory, interval, mixed(seed, 100 + j));
    std::vector<double>& values = forces.emplace_back();
    for (double time = -interval; time < duration; time += interval, force.next()) values.push_back(force.value());
  }
  return forces;
}

TrueTrial impose(const DirtyRig& rig, const Truth& truth, const TrialPlan& trial) {
  const std::vector<double>& positions = trial.reference[0];
  TrueTrial done;
  done.motion = {rig.interval, 1, {positions}, {{}}};
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, positions.size() - 1);
    done.motion.velocity[0].push_back((positions[after] - positions[before]) /
                                      (rig.interval * static_cast<double>(after - before)));
  }
  done.force = force_needed(truth.spec, truth.laws, positions, rig.interval);
  return done;
}

}  // namespace

int steps_a_sample(const DirtyRig& rig, int finer) {
  return std::max(1, static_cast<int>(std::ceil(rig.interval * rig.fastest / kStepShare))) * finer;
}

TrueTrial carry_out(const DirtyRig& rig, const Truth& truth, const TrialPlan& trial,
                    const std::vector<double>& reading_noise, std::uint64_t seed, const Disturbance& disturbance) {
  if (rig.driving == Driving::imposed) return impose(rig, truth, trial);
  TrueTrial done;
  done.applied.interval = rig.interval;
  done.applied.commands = trial.reference;
  const int steps = steps_a_sample(rig, truth.finer);
  done.applied.forces = random_forces(disturbance, rig.interval * static_cast<double>(trial.samples), seed);
  done.applied.knot_interval = kKnots * disturbance.memory;
  Simulation plant(truth.spec, truth.laws, done.applied, rig.interval / steps);
  Controllers controllers(rig, reading_noise, seed);
  done.motion = empty_motion(truth.spec, plant);
  PlantState state = plant.start(trial.start.position, trial.start.velocity);
  keep(state, done.motion);
  for (std::size_t k = 0; k < trial.samples; ++k) {
    done.states.push_back(state);
    if (has_loops(rig))
      for (std::size_t d = 0; d < rig.loops.size(); ++d)
        done.applied.commands[d][k] = controllers.force(d, state, trial.reference[d][k]);
    plant.advance(state, k, [&](const PlantState& now) { keep(now, done.motion); });
  }
  return done;
}

std::vector<double> force_needed(const PlantSpec& spec, const Laws& laws, const std::vector<double>& positions,
                                 double interval) {
  PlantSpec amended = spec;
  PlantState memory;
  for (const auto& law : laws) law->amend(amended);
  Chain chain(amended);
  const Coordinates drive = Coordinates::Zero(1);
  const PlantJoint& joint = amended.joints[0];
  const std::size_t gaps = positions.size() - 1;
  std::vector<double> speed(gaps), resisted(gaps);
  double inertia = 0.0, last_way = 1.0;
  for (std::size_t k = 0; k < gaps; ++k) {
    Coordinates position(1), velocity(1);
    position[0] = 0.5 * (positions[k] + positions[k + 1]);
    velocity[0] = (positions[k + 1] - positions[k]) / interval;
    chain.move_to(position, velocity);
    CoordinateMatrix mass = CoordinateMatrix::Zero(1, 1);
    Load load{Coordinates::Zero(1), Coordinates::Zero(1), Coordinates::Zero(1)};
    chain.add_inertia(mass, load.force);
    inertia = mass(0, 0) + joint.armature;
    load.force[0] += joint.force - joint.damping * velocity[0] - joint.stiffness * (position[0] - joint.rest);
    const Moment at{(static_cast<double>(k) + 0.5) * interval, interval, position, velocity, drive, amended, chain};
    std::size_t own = 0;
    for (const auto& law : laws) {
      law->act(at, memory.memory.data() + own, load);
      own += static_cast<std::size_t>(law->memory_size());
    }
    if (velocity[0] != 0.0) last_way = velocity[0] > 0.0 ? 1.0 : -1.0;
    const double brake = last_way > 0.0 ? load.brake_forwards[0] : -load.brake_backwards[0];
    speed[k] = velocity[0];
    resisted[k] = brake - load.force[0];
  }
  std::vector<double> force;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k, gaps - 1);
    force.push_back(inertia * (speed[after] - speed[before]) / interval + 0.5 * (resisted[before] + resisted[after]));
  }
  return force;
}

DenseReadings read_densely(const PlantSpec& spec, const Laws& laws, const TrueTrial& trial, std::size_t sensor) {
  const PlantSensor& what = spec.sensors[sensor];
  const bool is_force = !trial.force.empty() && sensor == 1;
  const auto& read = what.velocity ? trial.motion.velocity : trial.motion.position;
  DenseReadings dense{is_force ? trial.force : read[static_cast<std::size_t>(what.joint)], trial.motion.interval};
  if (what.scale != 1.0)
    for (double& value : dense.values) value *= what.scale;
  for (const auto& law : laws) law->read(static_cast<int>(sensor), dense);
  return dense;
}

std::size_t readings_a_sample(const TrueTrial& trial) { return static_cast<std::size_t>(trial.motion.steps_a_sample); }

}  // namespace hidden_effects::dirty
