#pragma once

#include <lacuna/physical_effect.h>
#include <lacuna/robot_spec.h>

#include "simulation/shared/body_motion.h"
#include "simulation/shared/state_archive.h"

#include <ode/ode.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace lacuna::ode {

/// Reads and writes ODE's own arrays in place.
using MapVector = Eigen::Map<const Eigen::Vector3d>;
using MapRotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 0, Eigen::OuterStride<4>>;

/// Where ODE keeps a body's motion, or constants that stand for the world.
struct Pose {
  const double* position;
  const double* rotation;
  const double* velocity;
  const double* angular_velocity;
  const double* quaternion;  ///< w first
  MapVector x() const { return MapVector(position); }
  MapRotation R() const { return MapRotation(rotation); }
  MapVector v() const { return MapVector(velocity); }
  MapVector w() const { return MapVector(angular_velocity); }
  Eigen::Quaterniond q() const { return {quaternion[0], quaternion[1], quaternion[2], quaternion[3]}; }
};

/// A body's motion: position, quaternion (w first), velocity, angular velocity.
inline constexpr std::size_t kDoublesPerBody = 13;
using BodyState = std::array<double, kDoublesPerBody>;

/// Gives a body exactly this motion; the quaternion must be a unit one. `pose`: the body's.
void set_motion(dBodyID body, const Pose& pose, const BodyState& state);

/// Gives a body's orientation, a unit quaternion, and the rotation that ODE makes of it. Its shapes do not know yet.
void set_orientation(const Pose& pose, const Eigen::Quaterniond& orientation);
/// Tells a body's shapes that its pose has been changed.
void tell_shapes(dBodyID body, const Pose& pose);

/// A robot's bodies in an ODE world. ODE's body frame is the spec's, moved to the centre of mass.
class Bodies {
 public:
  /// Creates the bodies at their zero poses; those of before must be gone.
  void create(dWorldID world, const RobotSpec& robot);
  void destroy();

  void place(std::span<const simulation::BodyMotion> motions);
  void save(simulation::StateWriter& writer) const;
  void load(simulation::StateReader& reader);

  /// Remembers motions and loads, which a step uses up, so that `take_back` can undo it.
  void hold();
  void take_back();

  /// Fills the spans of a `StepView`.
  void read(std::span<Eigen::Vector3d> positions, std::span<Eigen::Vector3d> velocities,
            std::span<Eigen::Quaterniond> orientations, std::span<Eigen::Vector3d> angular_velocities) const;

  /// Index of a body that is not finite or beyond sane bounds, or −1.
  int exploded() const;
  /// What is wrong with an exploded body, without a subject: "moves at ...".
  std::string describe(int body) const;

  /// Of all bodies together, in the world, m.
  Eigen::Vector3d centre_of_mass() const;

  std::size_t size() const { return ids_.size(); }
  dBodyID id(int body) const { return body < 0 ? nullptr : ids_[static_cast<std::size_t>(body)]; }
  Pose pose(int body) const;

 private:
  std::vector<dBodyID> ids_;
  std::vector<Pose> poses_;
  std::vector<double> masses_;  // kg
  struct Held {
    BodyState motion;
    std::array<double, 3> force, torque;
  };
  std::vector<Held> held_;
};

}  // namespace lacuna::ode
