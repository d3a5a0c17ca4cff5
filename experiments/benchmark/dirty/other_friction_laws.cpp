#include "dirty/other_laws.h"
#include "laws/joint_law.h"

#include <algorithm>
#include <cmath>

/// B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083-1138; P. Hamon, M. Gautier, P.
/// Garrec, IROS 2010, 6187-6193.
namespace hidden_effects::dirty {
namespace {

/// Dry friction without a step: F·tanh(|v|/v₀), as a film of grease makes it.
class SmoothDry : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    brake(load, p_[0] * std::tanh(std::abs(velocity(at)) / p_[1]));
  }
};

/// Stribeck's fall of friction with another exponent than 2.
class StribeckPower : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    brake(load, p_[0] + p_[1] * std::exp(-std::pow(std::abs(velocity(at)) / p_[2], p_[3])));
  }
};

/// Friction that grows with a power of the velocity, at the joint.
class PowerDrag : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double v = velocity(at);
    push(load, -p_[0] * std::copysign(std::pow(std::abs(v), p_[1]), v));
  }
};

/// Dry friction that grows along the way, as of a bent rail or a seal.
class WayFriction : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    brake(load, std::max(0.0, p_[0] + p_[1] * (position(at) - p_[2])));
  }
};

/// Gear friction that does not grow in proportion to the load: F·(|τ|/τ₀)^p.
class LoadPowerFriction : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    brake(load, p_[0] * std::pow(std::abs(drive(at)) / p_[1], p_[2]));
  }
};

}  // namespace

std::vector<LawKind> other_friction_laws() {
  return {
      {"smooth_dry_friction",
       "coulomb_friction",
       Place::joint,
       false,
       {"torque", "velocity"},
       make<SmoothDry>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.force, between(0.02, 0.2, u[0]) * at.velocity};
       },
       everywhere},
      {"stribeck_power_friction",
       "stribeck_friction",
       Place::joint,
       false,
       {"coulomb", "excess", "velocity", "exponent"},
       make<StribeckPower>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.06 * size * at.force, 0.08 * between(0.5, 1.5, u[0]) * size * at.force,
                       between(0.05, 0.2, u[1]) * at.velocity, between(0.5, 1.5, u[2])};
       },
       everywhere},
      {"drag_between_powers",
       "viscous_friction",
       Place::joint,
       false,
       {"drag", "power"},
       make<PowerDrag>,
       [](double size, const Scales& at, const Shape& u) {
         const double power = between(1.25, 1.75, u[0]);
         return Values{0.1 * size * at.force / std::pow(at.velocity, power), power};
       },
       everywhere},
      {"way_friction",
       "position_friction",
       Place::joint,
       false,
       {"torque", "gradient", "middle"},
       make<WayFriction>,
       [](double size, const Scales& at, const Shape& u) {
         const double middle = 0.5 * (at.lowest + at.highest);
         return Values{0.1 * size * at.force,
                       with_sign(0.1 * size * at.force * between(0.5, 1.0, u[0]) / at.position, u[1]), middle};
       },
       everywhere},
      {"load_power_friction",
       "load_friction",
       Place::joint,
       false,
       {"torque", "load", "exponent"},
       make<LoadPowerFriction>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{std::min(0.8, 0.1 * size) * at.force, at.force, between(0.6, 1.3, u[0])};
       },
       on_driven_joints},
  };
}

}  // namespace hidden_effects::dirty
