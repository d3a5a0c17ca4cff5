#pragma once

#include "plant/law.h"

#include <memory>
#include <span>
#include <vector>

namespace hidden_effects {

using Values = std::vector<double>;

/// A law of one element (joint, body, drive or sensor) with parameters `p_`.
class ElementLaw : public Law {
 public:
  ElementLaw(std::span<const double> values, int element) : p_(values.begin(), values.end()), element_(element) {}

 protected:
  Values p_;
  int element_;
};

/// A law of one joint.
class JointLaw : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;

 protected:
  double position(const Moment& at) const { return at.position[element_]; }
  double velocity(const Moment& at) const { return at.velocity[element_]; }
  double drive(const Moment& at) const { return at.drive[element_]; }
  void push(Load& load, double force) const { load.force[element_] += force; }
  void brake(Load& load, double limit) const { brake(load, limit, limit); }
  void brake(Load& load, double forwards, double backwards) const {
    load.brake_forwards[element_] += forwards;
    load.brake_backwards[element_] += backwards;
  }
};

template <class Kind>
std::shared_ptr<const Law> make(std::span<const double> values, int element) {
  return std::make_shared<Kind>(values, element);
}

inline double between(double lower, double upper, double part) { return lower + (upper - lower) * part; }

/// `size` with a sign that `part` in [0, 1) draws.
inline double with_sign(double size, double part) { return part < 0.5 ? -size : size; }

/// s, a little more than the samples of these rigs are apart: what is late by less is a matter of how commands are held
/// between samples, and no effect.
inline constexpr double kSample = 0.006;

inline bool everywhere(const PlantSpec&, int) { return true; }

inline bool on_driven_joints(const PlantSpec& spec, int joint) {
  for (const PlantDrive& drive : spec.drives)
    if (drive.joint == joint) return true;
  return false;
}

}  // namespace hidden_effects
