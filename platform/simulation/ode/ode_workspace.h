#pragma once

#include "simulation/ode/mechanism.h"
#include "simulation/ode/ode_model.h"
#include "simulation/shared/actuator_laws.h"
#include "simulation/shared/drive.h"
#include "simulation/shared/effect_runner.h"
#include "simulation/shared/model_instance.h"
#include "simulation/shared/sensor_bank.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::ode {

/// The parts of a simulation that stay from one to the next, so that a step never allocates.
class OdeWorkspace : public Workspace {
 public:
  explicit OdeWorkspace(const OdeModel& model);

  const OdeModel& model() const { return model_; }

  /// Takes the values over, amends the robot and builds it. Throws `Error` for numbers that no
  /// robot can have.
  void build(std::span<const double> parameters);
  /// After a failure inside ODE: its world and threading are gone for good, the next `build` makes
  /// new ones.
  void drop_mechanism() { mechanism.reset(); }

  /// Fills `view` from the mechanism: coordinates always, bodies where somebody looks at them.
  void look(double time, bool at_bodies);
  simulation::SensedForces sensed_forces() const;
  void sum_joint_forces();

  /// Names and sizes of the State's sections, in the order of `save`.
  std::vector<std::pair<std::string, std::size_t>> sections() const;
  void save(double origin, std::uint64_t step, State& state) const;
  /// The drive must be open, the mechanism built.
  void load(const State& state);
  /// Origin of the clock and steps since then.
  static std::pair<double, std::uint64_t> saved_clock(const State& state);

  // The parts, for the run that uses the workspace.
  simulation::ModelInstance instance;
  simulation::EffectRunner effects;
  simulation::SensorBank sensors;
  simulation::Drive drive;
  std::unique_ptr<Mechanism> mechanism;
  std::vector<ActuatorPlace> places;                                            // per actuator
  std::vector<simulation::ActuatorMemory> memories;                             // per actuator
  std::vector<double> commands;                                                 // per actuator, as its law gets it
  std::vector<simulation::ImplicitForce> laws;                                  // per actuator
  std::vector<std::optional<simulation::CompliantTransmission>> transmissions;  // per actuator
  std::vector<double> actuator_forces;                                          // per actuator, for the view
  std::vector<double> joint_forces;                                             // per coordinate
  std::vector<JointLoad> loads;                                                 // per coordinate
  std::vector<BodyLoad> body_loads;
  std::vector<simulation::BodyMotion> start_motions;  // per body
  std::vector<double> readings_before, output_row;    // per channel
  StepView view;

 private:
  void place_actuators(const RobotSpec& robot);
  /// Has the view show the arrays of the mechanism that was built.
  void lay_out_view();

  const OdeModel& model_;
  MechanismNeeds needs_;
  std::vector<int> actuator_coordinates_;  // per actuator
  std::vector<Eigen::Vector3d> body_positions_, body_velocities_, body_angular_velocities_;
  std::vector<Eigen::Quaterniond> body_orientations_;
};

}  // namespace lacuna::ode
