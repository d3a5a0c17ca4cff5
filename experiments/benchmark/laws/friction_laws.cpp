#include "laws/joint_law.h"
#include "laws/law_kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Friction in joints. A. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083-1138;
/// C. Canudas de Wit et al., IEEE Trans. Automatic Control 40 (1995) 419-425.
namespace hidden_effects {
namespace {

class Coulomb : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment&, double*, Load& load) const override { brake(load, p_[0]); }
};

class Viscous : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override { push(load, -p_[0] * velocity(at)); }
};

/// A fluid film whose resistance grows less than the velocity: −b·v₀·sgn(v)·(|v|/v₀)^0.8 with v₀ = 1.
class ThinningViscous : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double v = velocity(at);
    push(load, -p_[0] * std::copysign(std::pow(std::abs(v), 0.8), v));
  }
};

double stribeck(double coulomb, double excess, double scale, double v) {
  return coulomb + excess * std::exp(-(v / scale) * (v / scale));
}

class Stribeck : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    brake(load, stribeck(p_[0], p_[1], p_[2], velocity(at)));
  }
};

/// The same fall of friction, after Tustin: exp(−|v|/velocity).
class Tustin : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    brake(load, p_[0] + p_[1] * std::exp(-std::abs(velocity(at)) / p_[2]));
  }
};

class LoadDependent : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override { brake(load, p_[0] * std::abs(drive(at))); }
};

class Directional : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment&, double*, Load& load) const override { brake(load, p_[0], p_[1]); }
};

class Positional : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double angle = p_[3] * position(at);
    brake(load, std::max(0.0, p_[0] + p_[1] * std::sin(angle) + p_[2] * std::cos(angle)));
  }
};

/// Bristles, their bending integrated exactly for a velocity that is constant within the step.
class LuGre : public JointLaw {
 public:
  using JointLaw::JointLaw;
  int memory_size() const override { return 1; }
  void act(const Moment& at, double* z, Load& load) const override {
    const double v = velocity(at);
    const double rate = p_[3] * std::abs(v) / stribeck(p_[0], p_[1], p_[2], v);
    const double decay = std::exp(-0.5 * rate * at.step);
    const double reach = rate * at.step < 1e-9 ? 0.5 * at.step : (1.0 - decay) / rate;
    const double middle = *z * decay + v * reach;
    push(load, -(p_[3] * middle + p_[4] * (v - rate * middle)));
    *z = middle * decay + v * reach;
  }
};

/// LuGre's bristles, stiff, with hardly any Stribeck effect: what passes for Coulomb friction on a real bench.
std::shared_ptr<const Law> bristly_coulomb(std::span<const double> p, int joint) {
  const Values lugre{p[0], 0.05 * p[0], 0.05, p[0] / p[1], 0.0};
  return std::make_shared<LuGre>(lugre, joint);
}

}  // namespace

std::vector<LawKind> friction_laws() {
  return {
      {"coulomb_friction",
       "coulomb_friction",
       Place::joint,
       true,
       {"torque"},
       make<Coulomb>,
       [](double size, const Scales& at, const Shape&) { return Values{0.1 * size * at.force}; },
       everywhere},
      {"bristly_coulomb_friction",
       "coulomb_friction",
       Place::joint,
       false,
       {"torque", "bending"},
       bristly_coulomb,
       [](double size, const Scales& at, const Shape&) {
         return Values{0.1 * size * at.force, 0.002 * at.position};
       },
       everywhere},
      {"viscous_friction",
       "viscous_friction",
       Place::joint,
       true,
       {"damping"},
       make<Viscous>,
       [](double size, const Scales& at, const Shape&) { return Values{0.1 * size * at.force / at.velocity}; },
       everywhere},
      {"thinning_viscous_friction",
       "viscous_friction",
       Place::joint,
       false,
       {"damping"},
       make<ThinningViscous>,
       [](double size, const Scales& at, const Shape&) {
         return Values{0.1 * size * at.force / std::pow(at.velocity, 0.8)};
       },
       everywhere},
      {"stribeck_friction",
       "stribeck_friction",
       Place::joint,
       true,
       {"coulomb", "excess", "velocity"},
       make<Stribeck>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.06 * size * at.force, 0.08 * between(0.7, 1.5, u[0]) * size * at.force,
                       between(0.05, 0.15, u[1]) * at.velocity};
       },
       everywhere},
      {"tustin_friction",
       "stribeck_friction",
       Place::joint,
       false,
       {"coulomb", "excess", "velocity"},
       make<Tustin>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.06 * size * at.force, 0.08 * between(0.7, 1.5, u[0]) * size * at.force,
                       between(0.05, 0.15, u[1]) * at.velocity};
       },
       everywhere},
      {"load_friction",
       "load_friction",
       Place::joint,
       true,
       {"ratio"},
       make<LoadDependent>,
       [](double size, const Scales&, const Shape&) { return Values{std::min(0.9, 0.1 * size)}; },
       on_driven_joints},
      {"directional_friction",
       "directional_friction",
       Place::joint,
       true,
       {"positive", "negative"},
       make<Directional>,
       [](double size, const Scales& at, const Shape& u) {
         const double mean = 0.1 * size * at.force, part = with_sign(between(0.3, 0.7, u[1]), u[0]);
         return Values{mean * (1.0 + part), mean * (1.0 - part)};
       },
       everywhere},
      {"position_friction",
       "position_friction",
       Place::joint,
       true,
       {"mean", "sine", "cosine", "periods"},
       make<Positional>,
       [](double size, const Scales& at, const Shape& u) {
         const double mean = 0.1 * size * at.force, wave = between(0.5, 0.9, u[0]) * mean;
         const double phase = 2.0 * std::numbers::pi * u[1];
         return Values{mean, wave * std::sin(phase), wave * std::cos(phase), between(1.5, 4.0, u[2]) / at.position};
       },
       everywhere},
      {"lugre_friction",
       "lugre_friction",
       Place::joint,
       true,
       {"coulomb", "excess", "velocity", "bristle_stiffness", "bristle_damping"},
       make<LuGre>,
       [](double size, const Scales& at, const Shape& u) {
         const double coulomb = 0.08 * size * at.force;
         const double stiffness = coulomb / (between(0.01, 0.04, u[0]) * at.position);
         return Values{coulomb, between(0.3, 1.0, u[1]) * coulomb, between(0.05, 0.15, u[2]) * at.velocity, stiffness,
                       0.2 * std::sqrt(stiffness * at.inertia)};
       },
       everywhere},
  };
}

}  // namespace hidden_effects
