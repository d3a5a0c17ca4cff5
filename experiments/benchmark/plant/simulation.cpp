#include "plant/simulation.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr int kMostSweeps = 50;
constexpr double kSettled = 1e-14;  ///< of a velocity, between two sweeps

/// The part of `x` beyond a play of width `gap`.
double beyond(double x, double gap) { return x - std::clamp(x, -0.5 * gap, 0.5 * gap); }

/// A velocity at the end of a step, dry friction and all. It is `from` at the step's beginning and would be `free` at
/// its end without friction, which takes off at most `forwards` or `backwards` in a whole step. The instant of a stop
/// or a reversal lies anywhere within the step; friction changes its sign there, not at the step's end.
double braked(double from, double free, double forwards, double backwards) {
  if (from < 0.0) return -braked(-from, -free, backwards, forwards);
  const double slid = free - forwards, change = free - from;
  if (from > 0.0 && slid >= 0.0) return slid;
  const double left = from > 0.0 ? slid / (slid - from) : 1.0;  // of the step, once the velocity is zero
  if (change > forwards) return left * (change - forwards);
  if (change < -backwards) return left * (change + backwards);
  return 0.0;
}

}  // namespace

Simulation::Simulation(PlantSpec spec, Laws laws, const Excitation& excitation, double step)
    : spec_(std::move(spec)),
      laws_(std::move(laws)),
      excitation_(&excitation),
      step_(step),
      steps_a_sample_(static_cast<int>(std::lround(excitation.interval / step))),
      coordinates_(0),
      chain_(spec_) {
  if (steps_a_sample_ < 1 || std::abs(steps_a_sample_ * step - excitation.interval) > 1e-12)
    throw std::invalid_argument("an integration step has to divide the sample interval");
  int memory = 0;
  for (const auto& law : laws_) {
    law->amend(spec_);
    memory_of_law_.push_back(memory);
    memory += law->memory_size();
  }
  coordinates_ = static_cast<int>(spec_.joints.size());
  for (const PlantDrive& drive : spec_.drives) rotor_of_drive_.push_back(drive.elastic ? coordinates_++ : -1);
  if (coordinates_ > kMostCoordinates || memory > static_cast<int>(PlantState{}.memory.size()))
    throw std::invalid_argument("a plant with too many coordinates or memories");
  drive_ = Coordinates::Zero(static_cast<Eigen::Index>(spec_.joints.size()));
}

PlantState Simulation::start(const Coordinates& joint_positions, const Coordinates& joint_velocities) const {
  PlantState state;
  state.position = state.velocity = state.acceleration = Coordinates::Zero(coordinates_);
  state.position.head(joint_positions.size()) = joint_positions;
  state.velocity.head(joint_velocities.size()) = joint_velocities;
  for (std::size_t d = 0; d < spec_.drives.size(); ++d) {
    if (rotor_of_drive_[d] < 0) continue;
    state.position[rotor_of_drive_[d]] = joint_positions[spec_.drives[d].joint];
    state.velocity[rotor_of_drive_[d]] = joint_velocities[spec_.drives[d].joint];
  }
  for (std::size_t l = 0; l < laws_.size(); ++l)
    laws_[l]->start(state.position, state.velocity, state.memory.data() + memory_of_law_[l]);
  return state;
}

double Simulation::mean_command(std::size_t drive, double from) const {
  const std::vector<double>& held = excitation_->commands[drive];
  const double last = static_cast<double>(held.size() - 1);
  const auto at = [&](double place) { return held[static_cast<std::size_t>(std::clamp(place, 0.0, last))]; };
  constexpr double kRounding = 1e-9;  // of a sample: times are sums of steps
  const double first = from / excitation_->interval + kRounding, second = first + step_ / excitation_->interval;
  const double change = std::floor(second);
  if (change <= first) return at(std::floor(first));
  const double share = (second - change) / (second - first);
  return (1.0 - share) * at(std::floor(first)) + share * at(change);
}

double Simulation::random_force(std::size_t joint, double time) const {
  if (excitation_->forces.empty()) return 0.0;
  const std::vector<double>& knots = excitation_->forces[joint];
  const double place = time / excitation_->knot_interval;
  const auto k = std::min(static_cast<std::size_t>(place), knots.size() - 2);
  const double part = place - static_cast<double>(k);
  return (1.0 - part) * knots[k] + part * knots[k + 1];
}

void Simulation::add_joint_forces(const Moment& at, double time, Load& load) const {
  for (std::size_t j = 0; j < spec_.joints.size(); ++j) {
    const PlantJoint& joint = spec_.joints[j];
    const auto k = static_cast<Eigen::Index>(j);
    load.force[k] += joint.force - joint.damping * at.velocity[k] - joint.stiffness * (at.position[k] - joint.rest) +
                     random_force(j, time);
  }
}

void Simulation::add_drive_forces(const Moment& at, double time, double* memory, Load& load) {
  drive_.setZero();
  for (std::size_t d = 0; d < spec_.drives.size(); ++d) {
    const PlantDrive& drive = spec_.drives[d];
    const int rotor = rotor_of_drive_[d], moved = rotor < 0 ? drive.joint : rotor;
    double late = drive.delay + spec_.lateness;
    for (const auto& law : laws_) late += law->lateness(static_cast<int>(d), time);
    double value = mean_command(d, time - 0.5 * step_ - late);
    if (!drive.servo) value *= drive.gain;
    value += drive.offset;
    for (std::size_t l = 0; l < laws_.size(); ++l)
      value = laws_[l]->command(static_cast<int>(d), value, at, memory + memory_of_law_[l]);
    if (drive.servo) value = drive.gain * (drive.kp * (value - at.position[moved]) - drive.kd * at.velocity[moved]);
    if (drive.resistance > 0.0)
      value = drive.torque_constant * (value - drive.torque_constant * at.velocity[moved]) / drive.resistance;
    value = std::clamp(value, -drive.limit, drive.limit);
    if (rotor < 0) {
      load.force[drive.joint] += value;
      drive_[drive.joint] += value;
      continue;
    }
    const double stretch = beyond(at.position[rotor] - at.position[drive.joint], drive.gap);
    const double rate = at.velocity[rotor] - at.velocity[drive.joint];
    const double passed = stretch == 0.0 ? 0.0 : drive.stiffness * stretch + drive.damping * rate;
    load.force[rotor] += value - passed;
    load.force[drive.joint] += passed;
    drive_[drive.joint] += passed;
  }
}

/// Gauss-Seidel over the coordinates: of each the impulse that it would take with those of the others as they are.
void Simulation::brake(const Load& load, const Coordinates& from, Coordinates& velocity) const {
  Coordinates impulse = Coordinates::Zero(coordinates_);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0.0;
    for (Eigen::Index i = 0; i < coordinates_; ++i) {
      if (load.brake_forwards[i] <= 0.0 && load.brake_backwards[i] <= 0.0) continue;
      const double mobility = mobility_(i, i), free = velocity[i] - impulse[i] * mobility;
      const double forwards = step_ * mobility * std::max(0.0, load.brake_forwards[i]);
      const double backwards = step_ * mobility * std::max(0.0, load.brake_backwards[i]);
      const double more = (braked(from[i], free, forwards, backwards) - velocity[i]) / mobility;
      impulse[i] += more;
      velocity += more * mobility_.col(i);
      change = std::max(change, std::abs(more) * mobility);
    }
    if (change < kSettled) return;
  }
}

void Simulation::take_step(PlantState& state, double time) {
  state.position += 0.5 * step_ * state.velocity;
  const Coordinates foreseen = state.velocity + 0.5 * step_ * state.acceleration;
  const Moment at{time + 0.5 * step_, step_, state.position, foreseen, drive_, spec_, chain_};
  chain_.move_to(state.position, foreseen);
  Load load{Coordinates::Zero(coordinates_), Coordinates::Zero(coordinates_), Coordinates::Zero(coordinates_)};
  inertia_.setZero(coordinates_, coordinates_);
  chain_.add_inertia(inertia_, load.force);
  for (std::size_t j = 0; j < spec_.joints.size(); ++j)
    inertia_(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(j)) += spec_.joints[j].armature;
  for (std::size_t d = 0; d < spec_.drives.size(); ++d) {
    const int moved = rotor_of_drive_[d] < 0 ? spec_.drives[d].joint : rotor_of_drive_[d];
    inertia_(moved, moved) += spec_.drives[d].rotor_inertia;
  }
  add_joint_forces(at, at.time, load);
  add_drive_forces(at, at.time, state.memory.data(), load);
  for (std::size_t l = 0; l < laws_.size(); ++l) laws_[l]->act(at, state.memory.data() + memory_of_law_[l], load);
  if (coordinates_ == 1)
    mobility_ = inertia_.cwiseInverse();
  else
    mobility_ = inertia_.inverse();
  Coordinates velocity = state.velocity + step_ * (mobility_ * load.force);
  brake(load, state.velocity, velocity);
  state.acceleration = (velocity - state.velocity) / step_;
  state.velocity = velocity;
  state.position += 0.5 * step_ * velocity;
}

}  // namespace hidden_effects
