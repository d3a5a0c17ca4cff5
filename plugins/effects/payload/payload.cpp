#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A point mass carried by a body.
class Payload : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

namespace {

enum Parameter : std::size_t { kMass, kX, kY, kZ };

/// Adds the inertia of a point mass at `arm` from the centre.
void add_point(InertiaSpec& inertia, double mass, const Eigen::Vector3d& arm) {
  inertia.xx += mass * (arm.y() * arm.y() + arm.z() * arm.z());
  inertia.yy += mass * (arm.x() * arm.x() + arm.z() * arm.z());
  inertia.zz += mass * (arm.x() * arm.x() + arm.y() * arm.y());
  inertia.xy -= mass * arm.x() * arm.y();
  inertia.xz -= mass * arm.x() * arm.z();
  inertia.yz -= mass * arm.y() * arm.z();
}

}  // namespace

EffectDescription Payload::describe() const {
  return {.summary = "A point mass carried by a body",
          .equation = "m' = m + mass, com' = (m*com + mass*place)/m', inertia by Steiner's theorem",
          .literature = "C. G. Atkeson, C. H. An, J. M. Hollerbach, Int. J. Robotics Research 5 (1986) 101-119",
          .regime = "accelerations, and gravity where the payload shifts the centre of mass",
          .look_alikes = {"armature", "torque_gain"},
          .placements = {ElementKind::body},
          .parameters = {{"mass", "kg", 0.0, 0.0, 1000.0, Scale::linear, "Mass of the payload"},
                         {"x", "m", 0.0, -10.0, 10.0, Scale::linear, "Position in the body frame"},
                         {"y", "m", 0.0, -10.0, 10.0, Scale::linear, "Position in the body frame"},
                         {"z", "m", 0.0, -10.0, 10.0, Scale::linear, "Position in the body frame"}}};
}

void Payload::amend(RobotSpec& robot, const EffectContext& context) const {
  const auto p = context.parameters;
  if (p[kMass] == 0.0) return;
  const Eigen::Vector3d place(p[kX], p[kY], p[kZ]);
  for (const int element : context.elements) {
    BodySpec& body = robot.bodies[static_cast<std::size_t>(element)];
    const double total = body.mass + p[kMass];
    const Eigen::Vector3d centre = (body.mass * body.com + p[kMass] * place) / total;
    add_point(body.inertia, body.mass, body.com - centre);
    add_point(body.inertia, p[kMass], place - centre);
    body.mass = total;
    body.com = centre;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Payload>("payload"))
