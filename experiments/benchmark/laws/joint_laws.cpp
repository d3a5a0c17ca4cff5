#include "laws/joint_law.h"
#include "laws/law_kind.h"
#include "plant/coordinates.h"

#include <algorithm>
#include <cmath>

/// Springs, inertias and stops of joints. P. R. Ouyang et al. and R. Bouc's law as Y.-K. Wen wrote it (J. Eng. Mech.
/// Div. ASCE 102 (1976) 249-263); M. W. Spong, J. Dyn. Sys. Meas. Control 109 (1987) 310-319; M. Nordin, P.-O.
/// Gutman, Automatica 38 (2002) 1633-1649.
namespace hidden_effects {
namespace {

class Spring : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override { push(load, -p_[0] * (position(at) - p_[1])); }
};

class CubicSpring : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    push(load, -p_[0] * std::pow(position(at) - p_[1], 3));
  }
};

/// A spring that stiffens like rubber: k·x₀·sinh(x/x₀).
class RubberSpring : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    push(load, -p_[0] * p_[2] * std::sinh((position(at) - p_[1]) / p_[2]));
  }
};

class Armature : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void amend(PlantSpec& spec) const override { spec.joints[static_cast<std::size_t>(element_)].armature += p_[0]; }
};

class OffsetTorque : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment&, double*, Load& load) const override { push(load, p_[0]); }
};

class Cogging : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double angle = p_[2] * position(at);
    push(load, p_[0] * std::sin(angle) + p_[1] * std::cos(angle));
  }
};

/// A ripple with edges: a third harmonic of a quarter of the size beside it.
class SharpCogging : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double size = std::hypot(p_[0], p_[1]), angle = p_[2] * position(at) + std::atan2(p_[1], p_[0]);
    push(load, size * (std::sin(angle) + 0.25 * std::sin(3.0 * angle)));
  }
};

/// Integrated exactly for a velocity that is constant within the step: between zeros of z the law is linear.
class BoucWen : public JointLaw {
 public:
  using JointLaw::JointLaw;
  int memory_size() const override { return 1; }
  void act(const Moment& at, double* z, Load& load) const override {
    const double half = 0.5 * at.step * velocity(at) / p_[1];
    const double middle = moved(*z, half);
    push(load, -p_[0] * middle);
    *z = moved(middle, half);
  }

 private:
  /// z after a way in units of `distance`.
  double moved(double z, double way) const {
    if (way < 0.0) return -moved(-z, -way);
    if (z < 0.0) {  // dz = 1 − unloading·z
      const double unloading = 2.0 * p_[2] - 1.0;
      const bool even = std::abs(unloading) < 1e-9;
      const double to_zero = even ? -z : std::log1p(-unloading * z) / unloading;
      if (way <= to_zero)
        return even ? z + way : (1.0 - (1.0 - unloading * z) * std::exp(-unloading * way)) / unloading;
      way -= to_zero;
      z = 0.0;
    }
    return 1.0 - (1.0 - z) * std::exp(-way);  // dz = 1 − z
  }
};

/// Stops that push and never pull.
class HardStop : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double q = position(at), v = velocity(at);
    if (q > p_[1]) push(load, -std::max(0.0, p_[2] * (q - p_[1]) + p_[3] * v));
    if (q < p_[0]) push(load, std::max(0.0, p_[2] * (p_[0] - q) - p_[3] * v));
  }
};

/// A bending mode that follows the joint; memory: its place and velocity, integrated by the midpoint rule.
class BendingMode : public JointLaw {
 public:
  using JointLaw::JointLaw;
  int memory_size() const override { return 2; }
  void start(const Coordinates& position, const Coordinates& velocity, double* memory) const override {
    memory[0] = position[element_];
    memory[1] = velocity[element_];
  }
  void act(const Moment& at, double* memory, Load& load) const override {
    const double place = memory[0] + 0.5 * at.step * memory[1];
    const double spring = p_[1] * p_[1] * (position(at) - place), damping = 2.0 * p_[2] * p_[1];
    const double half = 0.5 * at.step * damping;
    const double rate = ((1.0 - half) * memory[1] + at.step * (spring + damping * velocity(at))) / (1.0 + half);
    push(load, -p_[0] * (rate - memory[1]) / at.step);
    memory[0] = place + 0.5 * at.step * rate;
    memory[1] = rate;
  }
};

/// A mount that the drive's reaction shakes; memory: its motion and velocity.
class ShakingBase : public JointLaw {
 public:
  using JointLaw::JointLaw;
  int memory_size() const override { return 2; }
  void act(const Moment& at, double* memory, Load& load) const override {
    const double place = memory[0] + 0.5 * at.step * memory[1];
    const double half = at.step * p_[2] * p_[1];
    const double push_back = -p_[1] * p_[1] * place - drive(at);
    const double rate = ((1.0 - half) * memory[1] + at.step * push_back) / (1.0 + half);
    push(load, -p_[0] * (rate - memory[1]) / at.step);
    memory[0] = place + 0.5 * at.step * rate;
    memory[1] = rate;
  }
};

}  // namespace

std::vector<LawKind> joint_laws() {
  return {
      {"joint_spring",
       "joint_spring",
       Place::joint,
       true,
       {"stiffness", "rest"},
       make<Spring>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.force / at.position, between(-0.5, 0.5, u[0]) * at.position};
       },
       everywhere},
      {"cubic_stiffness",
       "cubic_stiffness",
       Place::joint,
       true,
       {"stiffness", "rest"},
       make<CubicSpring>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.2 * size * at.force / std::pow(at.position, 3), between(-0.2, 0.2, u[0]) * at.position};
       },
       everywhere},
      {"rubber_spring",
       "cubic_stiffness",
       Place::joint,
       false,
       {"stiffness", "rest", "width"},
       make<RubberSpring>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.force / at.position, between(-0.2, 0.2, u[0]) * at.position, 0.4 * at.position};
       },
       everywhere},
      {"hysteresis",
       "hysteresis",
       Place::joint,
       true,
       {"torque", "distance", "sharpness"},
       make<BoucWen>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.force, between(0.1, 0.3, u[0]) * at.position, between(0.5, 1.0, u[1])};
       },
       everywhere},
      {"hard_stop",
       "hard_stop",
       Place::joint,
       true,
       {"lower", "upper", "stiffness", "damping"},
       make<HardStop>,
       [](double size, const Scales& at, const Shape& u) {
         const double reach = (at.highest - at.lowest) * std::min(0.45, 0.1 * size);
         const double stiffness = between(20.0, 60.0, u[0]) * at.force / at.position;
         const double damping = 0.1 * std::sqrt(stiffness * at.inertia);
         return u[1] < 0.5 ? Values{at.lowest + reach, 1000.0, stiffness, damping}
                           : Values{-1000.0, at.highest - reach, stiffness, damping};
       },
       everywhere},
      {"armature",
       "armature",
       Place::joint,
       true,
       {"inertia"},
       make<Armature>,
       [](double size, const Scales& at, const Shape&) { return Values{0.1 * size * at.inertia}; },
       everywhere},
      {"cogging",
       "cogging",
       Place::joint,
       true,
       {"sine", "cosine", "periods"},
       make<Cogging>,
       [](double size, const Scales& at, const Shape& u) {
         const double wave = 0.1 * size * at.force, phase = kTurn * u[0];
         return Values{wave * std::sin(phase), wave * std::cos(phase), between(5.0, 15.0, u[1]) / at.position};
       },
       everywhere},
      {"sharp_cogging",
       "cogging",
       Place::joint,
       false,
       {"sine", "cosine", "periods"},
       make<SharpCogging>,
       [](double size, const Scales& at, const Shape& u) {
         const double wave = 0.1 * size * at.force, phase = kTurn * u[0];
         return Values{wave * std::sin(phase), wave * std::cos(phase), between(5.0, 15.0, u[1]) / at.position};
       },
       everywhere},
      {"joint_offset_torque",
       "joint_offset_torque",
       Place::joint,
       true,
       {"torque"},
       make<OffsetTorque>,
       [](double size, const Scales& at, const Shape& u) { return Values{with_sign(0.1 * size * at.force, u[0])}; },
       everywhere},
      {"link_flexibility",
       "link_flexibility",
       Place::joint,
       true,
       {"inertia", "frequency", "damping_ratio"},
       make<BendingMode>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.inertia, kTurn * between(5.0, 12.0, u[0]), between(0.02, 0.06, u[1])};
       },
       everywhere},
      {"base_compliance",
       "base_compliance",
       Place::joint,
       true,
       {"ratio", "frequency", "damping_ratio"},
       make<ShakingBase>,
       [](double size, const Scales&, const Shape& u) {
         return Values{0.1 * size, kTurn * between(5.0, 12.0, u[0]), between(0.03, 0.1, u[1])};
       },
       on_driven_joints},
  };
}

}  // namespace hidden_effects
