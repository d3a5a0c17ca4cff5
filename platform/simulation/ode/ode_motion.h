#pragma once

#include "simulation/ode/mechanism.h"
#include "simulation/shared/actuator_laws.h"
#include "simulation/shared/engine_model.h"
#include "simulation/shared/robot_motion.h"

#include <memory>
#include <optional>
#include <vector>

namespace lacuna::ode {

/// A robot in ODE with its actuators. Loads are requested at the start of a step; their slopes apply to the change of
/// the velocity to its end, and to the distance that follows (implicit Euler).
class OdeMotion : public simulation::RobotMotion {
 public:
  explicit OdeMotion(const simulation::EngineModel& model);

  void build(const RobotSpec& robot) override;
  void begin(const StartState& start) override;
  const StepView& look(double time, bool at_bodies) override;
  void advance(const simulation::StepOrder& order) override;
  simulation::SensedForces sensed_forces() const override;
  Eigen::Vector3d centre_of_mass() const override { return mechanism_->bodies().centre_of_mass(); }
  std::vector<std::pair<std::string, std::size_t>> sections() const override;
  void save(simulation::StateWriter& writer) const override;
  void load(simulation::StateReader& reader) override;

 private:
  void place_actuators();
  void lay_out_view();
  void set_laws(const simulation::StepOrder& order);
  void ask(simulation::LoadSource& source);
  void remember_asked();
  void apply_actuator(std::size_t actuator);
  void settle_actuators(const simulation::StepOrder& order);
  void sum_joint_forces();
  double position_of(std::size_t actuator) const;

  const simulation::JointTree& tree_;
  const EngineSettings& settings_;
  double h_;
  MechanismNeeds needs_;
  const RobotSpec* robot_ = nullptr;
  std::unique_ptr<Mechanism> mechanism_;
  ContactSpec contact_;
  std::vector<ActuatorPlace> places_;                                            // per actuator
  std::vector<simulation::ActuatorMemory> memories_;                             // per actuator
  std::vector<simulation::ImplicitForce> laws_;                                  // per actuator
  std::vector<std::optional<simulation::CompliantTransmission>> transmissions_;  // per actuator
  std::vector<double> actuator_forces_;                                          // per actuator, for the view
  simulation::ElementCoordinates elements_;
  std::vector<double> joint_forces_;  // per coordinate
  std::vector<JointLoad> loads_;      // per coordinate
  std::vector<BodyLoad> body_loads_;
  std::vector<simulation::BodyMotion> start_motions_;  // per body
  StepView view_;
  StepView asked_;  // positions of the step's start; the velocities of its end move it in ODE
  std::vector<double> asked_positions_;
  std::vector<Eigen::Vector3d> body_positions_, body_velocities_, body_angular_velocities_;
  std::vector<Eigen::Quaterniond> body_orientations_;
};

}  // namespace lacuna::ode
