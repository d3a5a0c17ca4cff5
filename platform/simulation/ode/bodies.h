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

/// The address of a body's motion in ODE, or of constants for the world.
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

/// Sets a body's motion exactly; the quaternion must be a unit quaternion. `pose`: the body's.
void set_motion(dBodyID body, const Pose& pose, const BodyState& state);

/// Sets a body's orientation, a unit quaternion, with ODE's rotation matrix. Its shapes are not updated.
void set_orientation(const Pose& pose, const Eigen::Quaterniond& orientation);
/// Updates a body's shapes after a change of its pose.
void tell_shapes(dBodyID body, const Pose& pose);

/// A robot's bodies in an ODE world. ODE's body frame is that of the spec, moved to the centre of mass.
class Bodies {
 public:
  /// Creates the bodies at their zero poses; earlier ones must have been removed.
  void create(dWorldID world, const RobotSpec& robot);
  void destroy();

  void place(std::span<const simulation::BodyMotion> motions);
  void save(simulation::StateWriter& writer) const;
  void load(simulation::StateReader& reader);

  /// Saves motions and loads, which a step changes, so that `take_back` can undo it.
  void hold();
  void take_back();

  /// Fills the spans of a `StepView`.
  void read(std::span<Eigen::Vector3d> positions, std::span<Eigen::Vector3d> velocities,
            std::span<Eigen::Quaterniond> orientations, std::span<Eigen::Vector3d> angular_velocities) const;

  /// Index of a body with values that are not finite or beyond sane bounds, or −1.
  int exploded() const;
  /// The fault of an exploded body, without a subject: "moves at ...".
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
