#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/articulated_link.h"
#include "simulation/ode/bodies.h"
#include "simulation/ode/coupled_coordinates.h"
#include "simulation/shared/joint_tree.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace lacuna::ode {

/// The step of a robot that is a few bodies on hinges and sliders, held by the world and touching nothing: the
/// equations that dWorldStep solves (constraint rows with the world's ERP and CFM, implicit gyroscopic torque,
/// semi-implicit Euler), to rounding, in a sixth of its time. The constraints are not solved for: the motions that they
/// leave are one a coordinate, so what is solved is as large as there are joints. That the constraints yield a little
/// (CFM) is taken into account to first order.
class Articulation {
 public:
  /// Whether this can be the step of a robot whose bodies stand at their zero poses. `yielding`: CFM of the world over
  /// the step, 1/kg.
  static bool fits(const RobotSpec& robot, const Bodies& bodies, double yielding);

  /// For a robot whose bodies stand at their zero poses in ODE's world. `step`: of the integration, s; `laws`: the most
  /// that a step can have.
  void prepare(const RobotSpec& robot, const simulation::JointTree& tree, const Bodies& bodies, dWorldID world,
               double step, std::size_t laws);

  /// The law of a coordinate's stop, where it is at one or beyond.
  std::optional<CoordinateLaw> stop(std::size_t coordinate, double position) const;

  /// Moves the bodies by one step under the forces that ODE has gathered for them, gravity and `laws`. Returns the
  /// coordinates' velocities, along their axes at the step's start; `before`: those of then.
  std::span<const double> advance(std::span<const CoordinateLaw> laws, std::span<const double> before);

 private:
  static constexpr std::size_t kMost = CoupledCoordinates::kMost;
  using PerJoint = std::array<Spatial, kMost>;

  struct Place {
    int coordinate = 0;
    int parent = -1;  ///< the link that holds this one; −1: the world
    // bit per link
    unsigned moved = 0;     ///< those that the joint moves
    unsigned strained = 0;  ///< those, and the ones that hold it: their joints notice when it moves
  };

  /// What each joint passes on: the share of its coordinate, and that of its constraints.
  struct PassedOn {
    std::array<double, kMost> share;
    PerJoint held;
  };

  void move_alone(std::size_t joint);
  void balance();
  void couple();
  void move();
  void pass_on(unsigned strained, PerJoint& gained, PassedOn& passed) const;

  dWorldID world_ = nullptr;
  JointSettings settings_;
  double erp_ = 0.0, cfm_ = 0.0;
  std::vector<ArticulatedLink> links_;            ///< outward from the roots
  std::vector<Place> places_;                     ///< per link
  std::vector<std::pair<double, double>> stops_;  ///< per coordinate
  unsigned all_ = 0;
  CoupledCoordinates coordinates_;
  CoupledCoordinates::Column velocity_;  ///< per coordinate
  // of a step
  std::array<PassedOn, kMost> alone_;  ///< by each joint, where one moves alone, at velocity 1
  PassedOn balance_;                   ///< where no coordinate moves
};

}  // namespace lacuna::ode
