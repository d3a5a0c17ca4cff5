#pragma once

#include "plant/plant_spec.h"

#include <array>

namespace hidden_effects {

/// Kinematics and inertia of a planar open chain at one position and velocity. The equations are those of textbooks
/// (R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 3), in joint coordinates; nothing of them
/// is shared with the engine that is tested.
class Chain {
 public:
  explicit Chain(const PlantSpec& spec) : spec_(&spec) {}

  /// Takes positions and velocities of the joints; what they are longer by is left alone.
  void move_to(const Coordinates& q, const Coordinates& v);

  /// Adds the bodies' inertia to M, and −(centrifugal, Coriolis, gravity) to `force`.
  void add_inertia(CoordinateMatrix& inertia, Coordinates& force) const;

  /// Adds what a force at a body's centre of mass, N in the world, does at the joints.
  void add_body_force(int body, const InPlane& force, Coordinates& at_joints) const;

  const InPlane& com(int body) const { return links_[static_cast<std::size_t>(body)].com; }                ///< m
  const InPlane& com_velocity(int body) const { return links_[static_cast<std::size_t>(body)].velocity; }  ///< m/s

 private:
  struct Link {
    InPlane origin, com, velocity, free_acceleration;  ///< the last: of the com, with all joint accelerations zero
    InPlane axis;                                      ///< of a slider, in the world
    double angle = 0.0, rate = 0.0;
  };
  InPlane column(int body, int joint) const;

  const PlantSpec* spec_;
  std::array<Link, kMostCoordinates> links_;
};

}  // namespace hidden_effects
