#include "simulation/articulated/step.h"

#include "simulation/articulated/step_weights.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

constexpr int kMostRepeats = 10;
constexpr double kSettled = 1e-10;  ///< of the velocities; each iteration reduces the change by a factor of some tens
/// Of the joint's inertia, for a rotor without inertia: it then follows its forces within a step.
constexpr double kLeastRotor = 1e-9;
constexpr double kNotFound = -1.0;  ///< of a mobility, which is positive

}  // namespace

Step::Step(const Machine& machine, const simulation::ElementCoordinates& elements)
    : machine_(machine),
      tree_(machine.tree()),
      dynamics_(tree_),
      system_(machine.dofs(), machine.coordinates().size() + machine.actuators().size()),
      dofs_(machine.dofs()),
      middle_(machine.positions()),
      mean_(dofs_),
      asked_(dofs_),
      momentum_(dofs_),
      pushed_(dofs_),
      inertia_(dofs_ * dofs_),
      factor_(dofs_ * dofs_),
      memory_(dofs_),
      bias_(dofs_),
      mobility_(dofs_),
      weights_(dofs_),
      damping_of_dof_(dofs_),
      stiffness_of_dof_(dofs_),
      friction_law_(machine.coordinates().size()),
      servo_law_(machine.actuators().size()),
      loads_(machine.coordinates().size()),
      body_loads_(tree_.links().size()),
      link_forces_(tree_.links().size()),
      drag_(tree_.dofs() * tree_.dofs()),
      actuator_forces_(machine.actuators().size()),
      coordinate_forces_(machine.coordinates().size()),
      supply_shares_(machine.actuators().size(), 1.0),
      positions_(machine.coordinates().size()),
      velocities_(machine.coordinates().size()),
      body_positions_(tree_.links().size()),
      body_velocities_(tree_.links().size()),
      body_angular_velocities_(tree_.links().size()),
      body_orientations_(tree_.links().size(), Eigen::Quaterniond::Identity()) {
  laws_.reserve(machine.coordinates().size() + machine.actuators().size());
  view_ = {.time = 0.0,
           .positions = positions_,
           .velocities = velocities_,
           .actuator_forces = actuator_forces_,
           .first_coordinate = elements.joints,
           .actuator_coordinate = elements.actuators,
           .sensor_coordinate = elements.sensors,
           .body_positions = body_positions_,
           .body_velocities = body_velocities_,
           .body_orientations = body_orientations_,
           .body_angular_velocities = body_angular_velocities_};
  after_.configuration.resize(machine.positions());
  after_.velocities.resize(dofs_);
  after_.accelerations.resize(dofs_);
  after_.integrals.resize(machine.actuators().size());
}

void Step::place_in_middle(const Motion& from, double length) {
  std::copy(from.configuration.begin(), from.configuration.end(), middle_.begin());
  drift(from.velocities, 0.5 * length, middle_);
  find_inertia(middle_);
  std::fill(mobility_.begin(), mobility_.end(), kNotFound);
}

/// Found where it is asked for: most dofs have neither a damper nor a spring.
double Step::mobility(std::size_t dof) {
  if (mobility_[dof] == kNotFound) mobility_[dof] = inverse_diagonal(factor_, dofs_, dof, memory_);
  return mobility_[dof];
}

void Step::drift(std::span<const double> velocities, double time, std::span<double> configuration) const {
  tree_.drift(velocities, time, configuration);
  for (std::size_t r = 0; r < machine_.rotors(); ++r)
    configuration[tree_.positions() + r] += time * velocities[tree_.dofs() + r];
}

/// And its factor.
void Step::find_inertia(std::span<const double> configuration) {
  dynamics_.place(configuration, look_at_bodies_);
  const std::size_t n = tree_.dofs();
  std::fill(inertia_.begin(), inertia_.end(), 0.0);
  std::span<double> own(factor_.data(), n * n);
  dynamics_.inertia(own);
  for (std::size_t i = 0; i < n; ++i) std::copy_n(&own[i * n], n, &inertia_[i * dofs_]);
  for (const CoordinateNumbers& c : machine_.coordinates()) inertia_[c.dof * (dofs_ + 1)] += c.armature;
  for (const ActuatorNumbers& actuator : machine_.actuators()) {
    if (!actuator.compliant) continue;
    const double joint = inertia_[machine_.coordinates()[actuator.coordinate].dof * (dofs_ + 1)];
    inertia_[actuator.dof * (dofs_ + 1)] = std::max(actuator.rotor_inertia, kLeastRotor * joint);
  }
  std::copy(inertia_.begin(), inertia_.end(), factor_.begin());
  if (!factor_in_place(factor_, dofs_)) throw Error("the robot's inertia is not positive");
}

void Step::find_weights(double length, const Commanded& commanded) {
  std::fill(damping_of_dof_.begin(), damping_of_dof_.end(), 0.0);
  std::fill(stiffness_of_dof_.begin(), stiffness_of_dof_.end(), 0.0);
  for (std::size_t c = 0; c < loads_.size(); ++c) {
    damping_of_dof_[machine_.coordinates()[c].dof] += loads_[c].damping;
    stiffness_of_dof_[machine_.coordinates()[c].dof] += loads_[c].stiffness;
  }
  for (std::size_t i = 0; i < machine_.actuators().size(); ++i) {
    const ActuatorNumbers& a = machine_.actuators()[i];
    if (std::isnan(commanded.values[i]) || a.kind == ActuatorKind::motion) continue;
    const bool position = a.kind == ActuatorKind::position_servo || a.kind == ActuatorKind::pid;
    damping_of_dof_[a.dof] += a.drag + (a.kind == ActuatorKind::force ? 0.0 : a.kd);
    if (position) stiffness_of_dof_[a.dof] += a.kp + 0.5 * length * a.ki;
  }
  for (std::size_t i = 0; i < dofs_; ++i) {
    weights_[i] = {};
    if (damping_of_dof_[i] == 0.0 && stiffness_of_dof_[i] == 0.0) continue;
    const SpringWeights spring = spring_weights(length * length * stiffness_of_dof_[i] * mobility(i));
    weights_[i] = {.late = late_damping(length * damping_of_dof_[i] * mobility(i)),
                   .before = spring.before,
                   .after = spring.after};
  }
}

/// A force that equals `force` without any change since the middle of the step, and decreases with position and
/// velocity.
void Step::add_linear(std::size_t dof, double force, double damping, double stiffness, const Motion& from,
                      double length) {
  const Weights& w = weights_[dof];
  const double before = from.velocities[dof];
  system_.right()[dof] += length * (force - (damping * (1.0 - w.late) + stiffness * w.before * length) * before);
  system_.matrix()[dof * (dofs_ + 1)] += length * (damping * w.late + stiffness * w.after * length);
}

void Step::add_coordinate(std::size_t c, const Motion& from, double length, Contact stopped, bool reversals) {
  const CoordinateNumbers& numbers = machine_.coordinates()[c];
  const JointLoad& load = loads_[c];
  const double before = from.velocities[numbers.dof];
  add_linear(numbers.dof, load.force + load.damping * asked_[numbers.dof], load.damping, load.stiffness, from, length);
  friction_law_[c] = kNone;
  if (numbers.imposed) return;
  double lower = length * load.friction_lower, upper = length * load.friction_upper;
  if (before != 0.0 && !reversals && stopped == Contact::free) {
    system_.right()[numbers.dof] += before > 0.0 ? lower : upper;
    return;
  }
  if (stopped == Contact::at_upper) lower = -kInfinity;
  if (stopped == Contact::at_lower) upper = kInfinity;
  if (lower == 0.0 && upper == 0.0) return;
  friction_law_[c] = laws_.size();
  laws_.push_back({.dof = numbers.dof, .resistance = kInfinity, .lower = lower, .upper = upper});
}

void Step::gather(double length, const Eigen::Vector3d& gravity) {
  for (std::size_t c = 0; c < loads_.size(); ++c) {
    const CoordinateNumbers& own = machine_.coordinates()[c];
    const double position = own.ball ? positions_[c] : middle_[own.position];
    loads_[c] = {.force = own.force - own.damping * mean_[own.dof] - own.stiffness * (position - own.rest),
                 .friction_lower = -own.dry_friction,
                 .friction_upper = own.dry_friction,
                 .damping = own.damping,
                 .stiffness = own.stiffness};
  }
  gravity_ = gravity;
  has_drag_ = false;
  if (source_ != nullptr) {
    std::fill(body_loads_.begin(), body_loads_.end(), BodyLoad{});
    ContactSpec contact;
    StepLoads loads{.joints = loads_, .bodies = body_loads_, .contact = contact, .gravity = gravity_};
    source_->add_loads(view_, length, loads);
    bool on_bodies = false;
    for (std::size_t i = 0; i < link_forces_.size(); ++i) {
      const BodyLoad& load = body_loads_[static_cast<std::size_t>(tree_.links()[i].body)];
      link_forces_[i] = {.force = load.force, .torque = load.torque};
      has_drag_ = has_drag_ || load.damping > 0.0 || load.angular_damping > 0.0;
      on_bodies = on_bodies || !load.force.isZero(0.0) || !load.torque.isZero(0.0);
    }
    if (!look_at_bodies_ && (on_bodies || has_drag_)) {  // an effect on a joint loads a body
      dynamics_.place(middle_, true);
      dynamics_.move(mean_);
    }
  }
  if (has_drag_) find_drag();
}

void Step::find_drag() {
  std::fill(drag_.begin(), drag_.end(), 0.0);
  for (std::size_t i = 0; i < tree_.links().size(); ++i) {
    const BodyLoad& load = body_loads_[static_cast<std::size_t>(tree_.links()[i].body)];
    if (load.damping > 0.0 || load.angular_damping > 0.0)
      dynamics_.add_drag(i, load.damping, load.angular_damping, drag_);
  }
}

/// Decrease of the drag on bodies beyond the velocities of the request.
void Step::add_drag(const Motion& from, double length) {
  const std::size_t n = tree_.dofs();
  double rate = 0.0;
  for (std::size_t i = 0; i < n; ++i) rate = std::max(rate, drag_[i * (n + 1)] * mobility(i));
  const double late = late_damping(length * rate);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double drag = length * drag_[i * n + j];
      system_.right()[i] += drag * (asked_[j] - (1.0 - late) * from.velocities[j]);
      system_.matrix()[i * dofs_ + j] += late * drag;
    }
}

void Step::take(const Motion& from, double begin, double length, const Commanded& commanded,
                std::span<const Contact> stopped, bool reversals, const Eigen::Vector3d& gravity) {
  length_ = length;
  middle_time_ = begin + 0.5 * length;
  place_in_middle(from, length);
  find_momentum(from);
  for (std::size_t i = 0; i < dofs_; ++i) mean_[i] = from.velocities[i] + 0.5 * length * from.accelerations[i];
  const int asks =
      source_ == nullptr && !machine_.sags() ? 1 : 2;  // at an estimate of the mean velocities, then at them
  for (int ask = 1; ask <= asks; ++ask) {
    std::copy(mean_.begin(), mean_.end(), asked_.begin());
    dynamics_.move(mean_);
    if (source_ != nullptr || machine_.has_balls()) fill_view(middle_, mean_, middle_time_, look_at_bodies_);
    gather(length, gravity);
    find_weights(length, commanded);
    assemble(from, length, commanded, stopped, reversals);
    settle(from, length, ask == asks && machine_.has_coriolis_forces());
    measure(from, length, commanded);
  }
  for (std::size_t i = 0; i < dofs_; ++i)
    after_.accelerations[i] = (after_.velocities[i] - from.velocities[i]) / length;
  std::copy(middle_.begin(), middle_.end(), after_.configuration.begin());
  drift(after_.velocities, 0.5 * length, after_.configuration);
}

void Step::find_momentum(const Motion& from) {
  for (std::size_t i = 0; i < dofs_; ++i) {
    momentum_[i] = 0.0;
    for (std::size_t j = 0; j < dofs_; ++j) momentum_[i] += inertia_[i * dofs_ + j] * from.velocities[j];
  }
}

/// Everything except the inertial forces that depend on the velocities.
void Step::assemble(const Motion& from, double length, const Commanded& commanded, std::span<const Contact> stopped,
                    bool reversals) {
  std::copy(inertia_.begin(), inertia_.end(), system_.matrix().begin());
  std::copy(momentum_.begin(), momentum_.end(), system_.right().begin());
  if (has_drag_) add_drag(from, length);
  couple(system_.matrix());
  laws_.clear();
  for (std::size_t c = 0; c < loads_.size(); ++c) add_coordinate(c, from, length, stopped[c], reversals);
  for (std::size_t a = 0; a < machine_.actuators().size(); ++a) {
    add_actuator(a, from, length, commanded);
    add_transmission(a, from, length);
  }
  std::copy(system_.right().begin(), system_.right().end(), pushed_.begin());
}

/// Finds the velocities after the step. The inertial forces are those of the mean velocities: iterated to convergence
/// where `exactly`, which keeps the step symmetric in time.
void Step::settle(const Motion& from, double length, bool exactly) {
  for (int repeat = 0; repeat < kMostRepeats; ++repeat) {
    if (repeat > 0) dynamics_.move(mean_);
    dynamics_.bias(gravity_, link_forces_, bias_);
    for (std::size_t i = 0; i < tree_.dofs(); ++i) system_.right()[i] = pushed_[i] - length * bias_[i];
    system_.solve(laws_, after_.velocities, repeat > 0);
    double change = 0.0, size = 0.0;
    for (std::size_t i = 0; i < dofs_; ++i) {
      const double mean = 0.5 * (from.velocities[i] + after_.velocities[i]);
      change = std::max(change, std::abs(mean - mean_[i]));
      size = std::max(size, std::abs(mean));
      mean_[i] = mean;
    }
    if (!exactly || change <= kSettled * size) break;
  }
}

double Step::integral_rate(std::size_t a, double command) const {
  const ActuatorNumbers& actuator = machine_.actuators()[a];
  if (actuator.kind != ActuatorKind::pid || std::isnan(command)) return 0.0;
  const double error = command - middle_[actuator.position];
  const bool saturated =
      std::abs(actuator_forces_[a]) >= supply_shares_[a] * actuator.limit && actuator_forces_[a] * error > 0.0;
  return saturated ? 0.0 : error;
}

/// The forces of the step, from the laws at the velocities after it.
void Step::measure(const Motion& from, double length, const Commanded& commanded) {
  for (std::size_t c = 0; c < loads_.size(); ++c) {
    const std::size_t dof = machine_.coordinates()[c].dof;
    const JointLoad& load = loads_[c];
    const Weights& w = weights_[dof];
    const double before = from.velocities[dof], after = after_.velocities[dof];
    const double way = length * (w.before * before + w.after * after);
    const double late = (1.0 - w.late) * before + w.late * after;
    coordinate_forces_[c] = load.force - load.damping * (late - asked_[dof]) - load.stiffness * way;
    if (friction_law_[c] != kNone)
      coordinate_forces_[c] += system_.impulse(friction_law_[c]) / length;
    else if (machine_.coordinates()[c].imposed)
      coordinate_forces_[c] += imposed_friction(c, before, after);
    else if (rubs(c))
      coordinate_forces_[c] += before > 0.0 ? load.friction_lower : load.friction_upper;
  }
  for (std::size_t a = 0; a < machine_.actuators().size(); ++a) {
    const ActuatorNumbers& actuator = machine_.actuators()[a];
    if (servo_law_[a] != kNone) actuator_forces_[a] = system_.impulse(servo_law_[a]) / length;
    if (actuator.drag > 0.0 && !std::isnan(commanded.values[a])) {
      const double late = weights_[actuator.dof].late;
      actuator_forces_[a] -= supply_shares_[a] * actuator.drag *
                             ((1.0 - late) * from.velocities[actuator.dof] + late * after_.velocities[actuator.dof]);
    }
    coordinate_forces_[actuator.coordinate] += actuator_forces_[a];
  }
}

void Step::keep() {
  if (source_ == nullptr) return;
  dynamics_.move(mean_);
  fill_view(middle_, mean_, middle_time_, look_at_bodies_);
  source_->advance(view_, length_);
}

void Step::stop(std::size_t coordinate, Motion& motion) {
  const std::size_t dof = machine_.coordinates()[coordinate].dof;
  find_inertia(motion.configuration);
  if (!machine_.couplings().empty()) {
    std::copy(inertia_.begin(), inertia_.end(), factor_.begin());
    couple(factor_);
    factor_in_place(factor_, dofs_);
  }
  std::fill(memory_.begin(), memory_.end(), 0.0);
  memory_[dof] = 1.0;
  solve_in_place(factor_, dofs_, memory_);
  const double impulse = motion.velocities[dof] / memory_[dof];
  for (std::size_t i = 0; i < dofs_; ++i) motion.velocities[i] -= impulse * memory_[i];
  motion.velocities[dof] = 0.0;
}

const StepView& Step::look(const Motion& motion, double time, bool at_bodies) {
  if (at_bodies) {
    dynamics_.place(motion.configuration, true);
    dynamics_.move(motion.velocities);
  }
  fill_view(motion.configuration, motion.velocities, time, at_bodies);
  return view_;
}

Eigen::Vector3d Step::centre_of_mass(const Motion& motion) {
  dynamics_.place(motion.configuration, true);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < tree_.links().size(); ++i) {
    moment += tree_.links()[i].mass * dynamics_.centre(i);
    mass += tree_.links()[i].mass;
  }
  return moment / mass;
}

void Step::fill_view(std::span<const double> configuration, std::span<const double> velocities, double time,
                     bool with_bodies) {
  view_.time = time;
  if (machine_.has_balls())
    tree_.coordinates(configuration, positions_);
  else
    for (std::size_t c = 0; c < positions_.size(); ++c)
      positions_[c] = configuration[machine_.coordinates()[c].position];
  for (std::size_t c = 0; c < velocities_.size(); ++c) velocities_[c] = velocities[machine_.coordinates()[c].dof];
  if (!with_bodies) return;
  for (std::size_t i = 0; i < tree_.links().size(); ++i) {
    const Link& link = tree_.links()[i];
    const auto body = static_cast<std::size_t>(link.body);
    body_positions_[body] = dynamics_.centre(i);
    body_velocities_[body] = dynamics_.centre_velocity(i);
    body_angular_velocities_[body] = dynamics_.angular_velocity(i);
    body_orientations_[body] = Eigen::Quaterniond(dynamics_.displacement(i).turn) * link.orientation;
  }
}

}  // namespace lacuna::articulated
