#pragma once

#include "simulation/articulated/integrator.h"
#include "simulation/shared/engine_model.h"
#include "simulation/shared/robot_motion.h"

#include <memory>
#include <vector>

namespace lacuna::articulated {

/// A robot in reduced coordinates, with any number of bodies and without contacts.
class ArticulatedMotion : public simulation::RobotMotion {
 public:
  explicit ArticulatedMotion(const simulation::EngineModel& model);

  void build(const RobotSpec& robot) override;
  void begin(const StartState& start) override;
  const StepView& look(double time, bool at_bodies) override;
  void advance(const simulation::StepOrder& order) override;
  simulation::SensedForces sensed_forces() const override;
  Eigen::Vector3d centre_of_mass() const override;
  std::vector<std::pair<std::string, std::size_t>> sections() const override;
  void save(simulation::StateWriter& writer) const override;
  void load(simulation::StateReader& reader) override;

 private:
  void make_integrator();
  void sample_servos(const simulation::StepOrder& order);
  void check() const;

  double length_;
  const RobotSpec* robot_ = nullptr;
  simulation::ElementCoordinates elements_;
  Machine machine_;
  bool loads_look_at_bodies_;
  std::unique_ptr<Integrator> integrator_;
  std::vector<Eigen::Vector3d> contact_forces_;  // none
  std::vector<unsigned char> touching_;          // nothing
};

}  // namespace lacuna::articulated
