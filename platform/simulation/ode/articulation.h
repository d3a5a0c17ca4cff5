#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/articulated_link.h"
#include "simulation/ode/bodies.h"
#include "simulation/ode/coupled_coordinates.h"
#include "simulation/ode/robot_step.h"
#include "simulation/shared/joint_tree.h"

#include <array>
#include <span>
#include <vector>

namespace lacuna::ode {

/// The step of a robot that is a few bodies on hinges and sliders, held by the world and touching nothing. Its
/// constraints are not solved for: the motions that they leave are one a coordinate, so what is solved is as large as
/// there are joints, not six times as large. That the constraints yield a little (CFM) is taken into account to first
/// order. A link is a body with the joint that holds it; the equations are those of R. Featherstone, "Rigid body
/// dynamics algorithms", 2008, chapter 6 (inertia of the coordinates, from links that move alone).
class Articulation : public RobotStep {
 public:
  /// Whether there are not too many joints, and they yield little enough. `yielding`: CFM of the world over the step,
  /// 1/kg.
  static bool fits(const RobotSpec& robot, const Bodies& bodies, double yielding);

  Articulation(const RobotSpec& robot, const simulation::JointTree& tree, const Bodies& bodies, dWorldID world,
               double step, std::size_t laws);

  std::span<const double> advance(std::span<const CoordinateLaw> laws, std::span<const double> before) override;

 private:
  static constexpr std::size_t kMost = CoupledCoordinates::kMost;
  using PerJoint = std::array<Spatial, kMost>;

  struct Place {
    int body = 0;
    int coordinate = 0;
    int parent = -1;  ///< the link that holds this one; −1: the world
    // bit per link
    unsigned moved = 0;     ///< those that the joint moves
    unsigned strained = 0;  ///< those, and the ones that hold it: their joints notice when it moves
  };

  /// What each joint passes on: the share of its coordinate, and that of its constraints.
  struct PassedOn {
    std::array<double, kMost> share{};
    PerJoint held;
  };

  void add_link(const RobotSpec& robot, const simulation::JointTree& tree, const Bodies& bodies, std::size_t joint);
  void move_alone(std::size_t joint);
  void balance();
  void couple();
  double product(const PerJoint& a, const PerJoint& b) const;
  void move();
  void pass_on(unsigned strained, PerJoint& gained, PassedOn& passed) const;

  dWorldID world_;
  JointSettings settings_;
  std::vector<ArticulatedLink> links_;  ///< outward from the roots
  std::vector<Place> places_;           ///< per link
  unsigned all_ = 0;
  CoupledCoordinates coordinates_;
  CoupledCoordinates::Column velocity_;  ///< per coordinate
  // of a step
  std::array<PassedOn, kMost> alone_;  ///< by each joint, where one moves alone, at velocity 1
  PassedOn balance_;                   ///< where no coordinate moves
};

}  // namespace lacuna::ode
