#include "effects/payload.h"

namespace lacuna {

EffectDescription Payload::describe() const {
  return {.summary = "A point mass carried by a body",
          .equation = "m' = m + mass, c' = (m*c + mass*place)/m', I' by Steiner's theorem",
          .literature = "any textbook of mechanics",
          .regime = "accelerations, and gravity where it moves the centre of mass",
          .look_alikes = {},
          .placements = {ElementKind::body},
          .parameters = {{"mass", "kg", 0.0, 0.0, 1e3, Scale::linear, "Mass of the payload"},
                         {"x", "m", 0.0, -10.0, 10.0, Scale::linear, "Its place in the body frame"},
                         {"y", "m", 0.0, -10.0, 10.0, Scale::linear, "Its place in the body frame"},
                         {"z", "m", 0.0, -10.0, 10.0, Scale::linear, "Its place in the body frame"}}};
}

namespace {

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

void Payload::amend(RobotSpec& robot, const EffectContext& context) const {
  const auto p = context.parameters;
  const Eigen::Vector3d place(p[1], p[2], p[3]);
  for (const int element : context.elements) {
    BodySpec& body = robot.bodies[static_cast<std::size_t>(element)];
    const double total = body.mass + p[0];
    const Eigen::Vector3d centre = (body.mass * body.com + p[0] * place) / total;
    add_point(body.inertia, body.mass, body.com - centre);
    add_point(body.inertia, p[0], place - centre);
    body.mass = total;
    body.com = centre;
  }
}

}  // namespace lacuna
