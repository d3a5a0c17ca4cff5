#include "dirty/other_laws.h"
#include "laws/joint_law.h"

#include <algorithm>
#include <cmath>

/// Springs as hoses, cables and worn mounts make them.
namespace hidden_effects::dirty {
namespace {

/// A spring that has play about its rest before it pulls.
class SpringWithPlay : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double x = position(at) - p_[1];
    push(load, -p_[0] * (x - std::clamp(x, -0.5 * p_[2], 0.5 * p_[2])));
  }
};

/// A spring that hardens to one side only, as a cable that is drawn tight: k·x₀·(exp(x/x₀) − 1).
class CableSpring : public JointLaw {
 public:
  using JointLaw::JointLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const double x = std::clamp((position(at) - p_[1]) / p_[2], -20.0, 20.0);
    push(load, -p_[0] * std::abs(p_[2]) * std::copysign(1.0, p_[2]) * std::expm1(x));
  }
};

}  // namespace

std::vector<LawKind> other_spring_laws() {
  return {
      {"spring_with_play",
       "joint_spring",
       Place::joint,
       false,
       {"stiffness", "rest", "play"},
       make<SpringWithPlay>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.15 * size * at.force / at.position, between(-0.3, 0.3, u[0]) * at.position,
                       between(0.3, 0.9, u[1]) * at.position};
       },
       everywhere},
      {"cable_spring",
       "cubic_stiffness",
       Place::joint,
       false,
       {"stiffness", "rest", "width"},
       make<CableSpring>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.05 * size * at.force / at.position, between(-0.3, 0.3, u[0]) * at.position,
                       with_sign(between(0.5, 1.0, u[1]) * at.position, u[2])};
       },
       everywhere},
  };
}

}  // namespace hidden_effects::dirty
