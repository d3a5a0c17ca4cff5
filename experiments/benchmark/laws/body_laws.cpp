#include "laws/joint_law.h"
#include "laws/law_kind.h"

#include <algorithm>
#include <cmath>

/// What acts on bodies, and the world.
namespace hidden_effects {
namespace {

constexpr double kAir = 1.2;  ///< kg/m³, the library's default

bool on_a_hinge(const PlantSpec& spec, int body) { return !spec.joints[static_cast<std::size_t>(body)].slides; }

/// A point mass at (x, z) of the body's frame.
class Payload : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void amend(PlantSpec& spec) const override {
    PlantBody& body = spec.bodies[static_cast<std::size_t>(element_)];
    const InPlane at(p_[1], p_[2]);
    const double mass = body.mass + p_[0];
    const InPlane com = (body.mass * body.com + p_[0] * at) / mass;
    body.inertia += body.mass * (body.com - com).squaredNorm() + p_[0] * (at - com).squaredNorm();
    body.com = com;
    body.mass = mass;
  }
};

class QuadraticDrag : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const InPlane& v = at.chain.com_velocity(element_);
    at.chain.add_body_force(element_, -0.5 * kAir * p_[0] * v.norm() * v, load.force);
  }
};

/// Air in between laminar and turbulent: ½·ρ·A·|v|^1.8.
class RoughDrag : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const InPlane& v = at.chain.com_velocity(element_);
    const double speed = v.norm();
    if (speed > 0.0) at.chain.add_body_force(element_, -0.5 * kAir * p_[0] * std::pow(speed, 0.8) * v, load.force);
  }
};

class LinearDrag : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void act(const Moment& at, double*, Load& load) const override {
    at.chain.add_body_force(element_, -p_[0] * at.chain.com_velocity(element_), load.force);
  }
};

class Buoyancy : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void act(const Moment& at, double*, Load& load) const override {
    at.chain.add_body_force(element_, -p_[0] * at.spec.gravity, load.force);
  }
};

class CablePull : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void act(const Moment& at, double*, Load& load) const override {
    const InPlane way = InPlane(p_[1], p_[2]) - at.chain.com(element_);
    at.chain.add_body_force(element_, p_[0] * way.normalized(), load.force);
  }
};

/// The rig turned about y, which turns gravity the other way in the rig's frame, and then about its own x, which leaves
/// less of it in the plane.
class MountTilt : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void amend(PlantSpec& spec) const override {
    spec.gravity = turned(spec.gravity, -p_[1]);
    spec.gravity.y() *= std::cos(p_[0]);
  }
};

}  // namespace

std::vector<LawKind> body_laws() {
  return {
      {"payload",
       "payload",
       Place::body,
       true,
       {"mass", "x", "z"},
       make<Payload>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.mass, between(-0.5, 0.5, u[0]) * at.lever, -between(0.8, 1.5, u[1]) * at.lever};
       },
       on_a_hinge},
      {"quadratic_drag",
       "quadratic_drag",
       Place::body,
       true,
       {"area"},
       make<QuadraticDrag>,
       [](double size, const Scales& at, const Shape&) {
         const double speed = at.velocity * at.lever;
         return Values{0.1 * size * at.force / at.lever / (0.5 * kAir * speed * speed)};
       },
       everywhere},
      {"rough_drag",
       "quadratic_drag",
       Place::body,
       false,
       {"area"},
       make<RoughDrag>,
       [](double size, const Scales& at, const Shape&) {
         const double speed = at.velocity * at.lever;
         return Values{0.1 * size * at.force / at.lever / (0.5 * kAir * std::pow(speed, 1.8))};
       },
       everywhere},
      {"linear_drag",
       "linear_drag",
       Place::body,
       true,
       {"drag"},
       make<LinearDrag>,
       [](double size, const Scales& at, const Shape&) {
         return Values{0.1 * size * at.force / at.lever / (at.velocity * at.lever)};
       },
       everywhere},
      {"buoyancy",
       "buoyancy",
       Place::body,
       true,
       {"displaced"},
       make<Buoyancy>,
       [](double size, const Scales& at, const Shape&) { return Values{0.1 * size * at.mass}; },
       on_a_hinge},
      {"cable_pull",
       "cable_pull",
       Place::body,
       true,
       {"tension", "x", "z"},
       make<CablePull>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.1 * size * at.force / at.lever, with_sign(between(2.0, 4.0, u[0]) * at.lever, u[1]),
                       between(-1.0, 2.0, u[2]) * at.lever};
       },
       everywhere},
      {"mount_tilt",
       "mount_tilt",
       Place::world,
       true,
       {"roll", "pitch"},
       make<MountTilt>,
       [](double size, const Scales&, const Shape& u) {
         return Values{std::min(1.2, 0.2 * size * u[1]), with_sign(std::min(1.0, 0.05 * size), u[0])};
       },
       everywhere,
       {"roll"}},
  };
}

}  // namespace hidden_effects
