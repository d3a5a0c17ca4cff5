#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace lacuna::articulated {

/// Spatial vectors in the world's axes, all of a tree about one fixed point (R. Featherstone, "Rigid body dynamics
/// algorithms", 2008, chapter 2).

/// A velocity or an acceleration: of the body's point that is currently at the reference.
struct Twist {
  Eigen::Vector3d angular{0.0, 0.0, 0.0}, linear{0.0, 0.0, 0.0};

  Twist& operator+=(const Twist& other) {
    angular += other.angular;
    linear += other.linear;
    return *this;
  }
  friend Twist operator+(Twist a, const Twist& b) { return a += b; }
  friend Twist operator*(double factor, const Twist& a) { return {factor * a.angular, factor * a.linear}; }
};

/// A force or a momentum, its moment about the reference.
struct Wrench {
  Eigen::Vector3d moment{0.0, 0.0, 0.0}, force{0.0, 0.0, 0.0};

  Wrench& operator+=(const Wrench& other) {
    moment += other.moment;
    force += other.force;
    return *this;
  }
  Wrench& operator-=(const Wrench& other) {
    moment -= other.moment;
    force -= other.force;
    return *this;
  }
  friend Wrench operator+(Wrench a, const Wrench& b) { return a += b; }
};

inline double dot(const Twist& a, const Wrench& b) { return a.angular.dot(b.moment) + a.linear.dot(b.force); }

/// Change of a twist that moves with `velocity`.
inline Twist cross(const Twist& velocity, const Twist& carried) {
  return {velocity.angular.cross(carried.angular),
          velocity.angular.cross(carried.linear) + velocity.linear.cross(carried.angular)};
}

/// Change of a wrench that moves with `velocity`.
inline Wrench cross(const Twist& velocity, const Wrench& carried) {
  return {velocity.angular.cross(carried.moment) + velocity.linear.cross(carried.force),
          velocity.angular.cross(carried.force)};
}

/// Of one body, or of several that move as one.
struct SpatialInertia {
  double mass = 0.0;
  Eigen::Vector3d first_moment{0.0, 0.0, 0.0};  ///< mass times the vector from the reference to the centre of mass
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the reference

  SpatialInertia& operator+=(const SpatialInertia& other) {
    mass += other.mass;
    first_moment += other.first_moment;
    inertia += other.inertia;
    return *this;
  }
  Wrench operator*(const Twist& motion) const {
    return {inertia * motion.angular + first_moment.cross(motion.linear),
            mass * motion.linear - first_moment.cross(motion.angular)};
  }
};

}  // namespace lacuna::articulated
