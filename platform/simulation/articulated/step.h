#pragma once

#include <lacuna/physical_effect.h>

#include "simulation/articulated/bounded_system.h"
#include "simulation/articulated/dynamics.h"
#include "simulation/articulated/machine.h"
#include "simulation/shared/load_source.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lacuna::articulated {

/// The motion of a machine at one time. Rotors follow the tree.
struct Motion {
  std::vector<double> configuration, velocities;
  std::vector<double> accelerations;  ///< of the last step, from which the next one is estimated
  /// Per actuator: integral of a PID's error; the held force of a servo with a sample time.
  std::vector<double> integrals;
};

/// Settings of a coordinate's stops and dry friction in a step.
enum class Contact : unsigned char { free, at_lower, at_upper };

/// Commands of a step; constant within it except for imposed velocities, which change linearly.
struct Commanded {
  std::span<const double>
      values;                     ///< per actuator; NaN: it is off; for an imposed velocity its value at the step's end
  std::span<const double> rates;  ///< per actuator, its rate of change; for a PID and an imposed velocity
  double end = 0.0;               ///< s, of the step
};

/// One trial step of a machine from a motion. In the middle of the step, reached at the velocities before, the equation
/// of motion is solved for the velocities after it, with forces at the mean of both velocities; the second half of the
/// way is made at those. This is symmetric in time, of second order, and has no energy drift (position Verlet, with the
/// forces that depend on velocities at the mean: the implicit midpoint rule). Springs and dampers enter implicitly
/// (step_weights.h), dry friction as an impulse.
class Step {
 public:
  Step(const Machine& machine, const simulation::ElementCoordinates& elements);

  /// Lets the views of a source contain bodies; otherwise they are not computed.
  void look_at_bodies(bool look) { look_at_bodies_ = look; }
  /// Updates to new numbers of the machine.
  void take_numbers() { dynamics_.take_numbers(); }
  /// Whether a source has any loads.
  void ask(simulation::LoadSource* source) { source_ = source; }

  /// `stopped`: per coordinate. `reversals`: whether dry friction may change its sign within the step; otherwise it
  /// keeps the sign from the start of the step, where there is motion, whatever the motion does.
  void take(const Motion& from, double begin, double length, const Commanded& commanded,
            std::span<const Contact> stopped, bool reversals, const Eigen::Vector3d& gravity);

  const Motion& after() const { return after_; }
  /// Informs the source that the step was taken.
  void keep();
  /// Removes the velocity of a coordinate at a motion, by an impulse on it.
  void stop(std::size_t coordinate, Motion& motion);

  /// Whether dry friction acts on a coordinate.
  bool rubs(std::size_t coordinate) const {
    if (machine_.coordinates()[coordinate].imposed) return false;
    return loads_[coordinate].friction_lower < 0.0 || loads_[coordinate].friction_upper > 0.0;
  }
  /// Change of a PID's integral over the step; 0 where the force is at its limit and would go further into it.
  double integral_rate(std::size_t actuator, double command) const;

  /// Mean force of a coordinate's laws and actuators.
  double coordinate_force(std::size_t coordinate) const { return coordinate_forces_[coordinate]; }

  /// Fills the view with a motion.
  const StepView& look(const Motion& motion, double time, bool at_bodies);
  Eigen::Vector3d centre_of_mass(const Motion& motion);
  std::span<double> actuator_forces() { return actuator_forces_; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Weights {
    double late = 0.5;
    double before = -0.25, after = 0.25;
  };

  void place_in_middle(const Motion& from, double length);
  void drift(std::span<const double> velocities, double time, std::span<double> configuration) const;
  void find_inertia(std::span<const double> configuration);
  double mobility(std::size_t dof);
  void find_weights(double length, const Commanded& commanded);
  void gather(double length, const Eigen::Vector3d& gravity);
  void add_coordinate(std::size_t coordinate, const Motion& from, double length, Contact stopped, bool reversals);
  void add_actuator(std::size_t actuator, const Motion& from, double length, const Commanded& commanded);
  void impose(std::size_t actuator, const Motion& from, double length, const Commanded& commanded);
  void add_transmission(std::size_t actuator, const Motion& from, double length);
  /// Dry friction over the step on a coordinate with an imposed velocity: it changes its sign with the velocity.
  double imposed_friction(std::size_t coordinate, double before, double after) const;
  void add_linear(std::size_t dof, double force, double damping, double stiffness, const Motion& from, double length);
  void couple(std::span<double> matrix) const;
  void find_drag();
  void add_drag(const Motion& from, double length);
  void find_momentum(const Motion& from);
  void assemble(const Motion& from, double length, const Commanded& commanded, std::span<const Contact> stopped,
                bool reversals);
  void settle(const Motion& from, double length, bool exactly);
  void measure(const Motion& from, double length, const Commanded& commanded);
  void fill_view(std::span<const double> configuration, std::span<const double> velocities, double time,
                 bool with_bodies);

  const Machine& machine_;
  const Tree& tree_;
  Dynamics dynamics_;
  BoundedSystem system_;
  simulation::LoadSource* source_ = nullptr;
  bool look_at_bodies_ = false;
  std::size_t dofs_;
  // of the step
  double middle_time_ = 0.0, length_ = 0.0;
  Eigen::Vector3d gravity_{0.0, 0.0, 0.0};
  std::vector<double> middle_, mean_, asked_, momentum_, pushed_;  // asked_: velocities of the loads
  std::vector<double> inertia_, factor_, memory_, bias_;
  std::vector<double> mobility_;  ///< per dof, of the inertia alone; as far as it was asked for
  std::vector<Weights> weights_;  ///< per dof
  std::vector<double> damping_of_dof_, stiffness_of_dof_;
  std::vector<VelocityLaw> laws_;
  std::vector<std::size_t> friction_law_, servo_law_;  ///< per coordinate and actuator: index into laws_
  std::vector<JointLoad> loads_;                       ///< per coordinate
  std::vector<BodyLoad> body_loads_;                   ///< per body
  std::vector<BodyForce> link_forces_;
  std::vector<double> drag_;  ///< of the tree's velocities
  bool has_drag_ = false;
  std::vector<double> actuator_forces_, coordinate_forces_;
  std::vector<double> supply_shares_;  ///< per actuator: the share of its force that the sagging supply leaves
  Motion after_;
  // the view
  StepView view_;
  std::vector<double> positions_, velocities_;
  std::vector<Eigen::Vector3d> body_positions_, body_velocities_, body_angular_velocities_;
  std::vector<Eigen::Quaterniond> body_orientations_;
};

}  // namespace lacuna::articulated
