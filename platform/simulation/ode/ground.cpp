#include "simulation/ode/ground.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lacuna::ode {
namespace {

constexpr double kBouncing = 0.01;  // m/s; slower impacts do not bounce
constexpr double kHolding = 1e6;    // μ for infinite friction where limits must follow the normal force
constexpr double kTie = 1e-12;      // m
constexpr double kSliding = 1e-6;   // m/s; slower contacts keep the default directions of the friction pyramid

int most_contacts_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::sphere: return 1;
    case ShapeKind::capsule: return 2;
    case ShapeKind::box:
    case ShapeKind::cylinder: return 4;
  }
  return 4;
}

dGeomID make_geom(const ShapeSpec& shape) {
  const Eigen::Vector3d& size = shape.size;
  switch (shape.kind) {
    case ShapeKind::box: return dCreateBox(nullptr, size.x(), size.y(), size.z());
    case ShapeKind::sphere: return dCreateSphere(nullptr, size.x());
    case ShapeKind::capsule: return dCreateCapsule(nullptr, size.x(), size.y());
    case ShapeKind::cylinder: return dCreateCylinder(nullptr, size.x(), size.y());
  }
  return nullptr;
}

/// Settings of ODE's contact joint for the laws of a contact; laws that are absent cost no row. In ODE the limits of
/// sliding and rolling can follow the normal force only together, and not with an infinite μ.
void set_surface(dContact& c, const ContactSpec& contact, double step, double rigid_erp) {
  const bool rigid = std::isinf(contact.stiffness);
  const double damping =
      contact.damping + (rigid ? 0.0 : contact.impact_damping * contact.stiffness * std::max(0.0, c.geom.depth));
  const double spring = step * contact.stiffness + damping;
  c.surface.mode = dContactSoftERP | (rigid ? 0 : dContactSoftCFM);
  c.surface.soft_erp = rigid ? rigid_erp : step * contact.stiffness / spring;
  c.surface.soft_cfm = rigid ? 0.0 : 1.0 / spring;
  const bool rolling = contact.rolling_lever > 0.0;
  c.surface.mu = rolling ? std::min(contact.friction, kHolding) : contact.friction;
  if (std::isfinite(c.surface.mu)) c.surface.mode |= dContactApprox1;
  if (contact.restitution > 0.0) {
    c.surface.mode |= dContactBounce;
    c.surface.bounce = contact.restitution;
    c.surface.bounce_vel = kBouncing;
  }
  if (rolling) {
    c.surface.mode |= dContactRolling;
    c.surface.rho = contact.rolling_lever;
  }
  if (contact.creep > 0.0) {
    c.surface.mode |= dContactSlip1 | dContactSlip2;
    c.surface.slip1 = c.surface.slip2 = contact.creep;
  }
}

}  // namespace

Ground::Ground() : group_(dJointGroupCreate(0)) {}

Ground::~Ground() {
  destroy();
  dJointGroupDestroy(group_);
}

void Ground::create(dWorldID world, const RobotSpec& robot, const Bodies& bodies, bool measure_force) {
  bodies_ = &bodies;
  measure_force_ = measure_force;
  touching_.assign(robot.bodies.size(), 0);
  contact_forces_.assign(robot.bodies.size(), Eigen::Vector3d::Zero());
  contact_count_ = 0;
  std::size_t most = 0;
  if (robot.contact.ground) {
    plane_ = dCreatePlane(nullptr, 0, 0, 1, 0);
    slope_ = 0.0;
    for (std::size_t i = 0; i < robot.bodies.size(); ++i)
      for (const ShapeSpec& shape : robot.bodies[i].shapes)
        add_shape(shape, robot.bodies[i], static_cast<int>(i), bodies);
    for (const Shape& shape : shapes_) most += static_cast<std::size_t>(shape.most_contacts);
  }
  contacts_.assign(most, {});
  contact_bodies_.assign(most, 0);
  feedback_.assign(most, {});
  // The group keeps its memory when it is emptied: no contact of a later step allocates.
  for (const dContact& contact : contacts_) dJointCreateContact(world, group_, &contact);
  dJointGroupEmpty(group_);
}

void Ground::add_shape(const ShapeSpec& spec, const BodySpec& body, int index, const Bodies& bodies) {
  const dGeomID geom = make_geom(spec);
  dGeomSetBody(geom, bodies.id(index));
  const Eigen::Vector3d offset = spec.position - body.com;
  const Eigen::Quaterniond turn = spec.orientation.normalized();
  const dQuaternion q = {turn.w(), turn.x(), turn.y(), turn.z()};
  dGeomSetOffsetPosition(geom, offset.x(), offset.y(), offset.z());
  dGeomSetOffsetQuaternion(geom, q);
  shapes_.push_back({geom, index, most_contacts_of(spec.kind)});
}

void Ground::destroy() {
  for (const Shape& shape : shapes_) dGeomDestroy(shape.geom);
  shapes_.clear();
  if (plane_) dGeomDestroy(plane_);
  plane_ = nullptr;
  dJointGroupEmpty(group_);
}

void Ground::collide(double slope) {
  contact_count_ = 0;
  if (!plane_) return;
  if (slope != slope_) {
    slope_ = slope;
    dGeomPlaneSetParams(plane_, std::sin(slope), 0, std::cos(slope), 0);
  }
  std::fill(touching_.begin(), touching_.end(), static_cast<unsigned char>(0));
  for (const Shape& shape : shapes_) {
    const int found =
        dCollide(shape.geom, plane_, shape.most_contacts, &contacts_[contact_count_].geom, sizeof(dContact));
    std::fill_n(contact_bodies_.begin() + static_cast<std::ptrdiff_t>(contact_count_), found, shape.body);
    if (found > 0) touching_[static_cast<std::size_t>(shape.body)] = 1;
    contact_count_ += static_cast<std::size_t>(found);
  }
}

void Ground::begin_step(dWorldID world, const ContactSpec& contact, double step, double rigid_erp) {
  for (std::size_t i = 0; i < contact_count_; ++i) {
    dContact& c = contacts_[i];
    set_surface(c, contact, step, rigid_erp);
    if (std::isfinite(contact.friction)) align_friction(bodies_->pose(contact_bodies_[i]), c);
    const dJointID joint = dJointCreateContact(world, group_, &c);
    dJointAttach(joint, bodies_->id(contact_bodies_[i]), nullptr);
    if (measure_force_) dJointSetFeedback(joint, &feedback_[i]);
  }
}

void Ground::align_friction(const Pose& body, dContact& contact) const {
  // The cone is solved as a pyramid; with an edge along the sliding velocity its limit equals that of the cone in any
  // direction of sliding.
  const MapVector normal(contact.geom.normal), point(contact.geom.pos);
  const Eigen::Vector3d velocity = body.v() + body.w().cross(point - body.x());
  const Eigen::Vector3d sliding = velocity - normal * normal.dot(velocity);
  const double speed = sliding.norm();
  if (!(speed > kSliding)) return;
  contact.surface.mode |= dContactFDir1;
  Eigen::Map<Eigen::Vector3d>(contact.fdir1) = sliding / speed;
}

void Ground::break_ties() {
  for (std::size_t i = 0; i < contact_count_; ++i) contacts_[i].geom.depth += kTie * static_cast<double>(i + 1);
}

void Ground::end_step() {
  if (!plane_) return;
  if (measure_force_) {
    std::fill(contact_forces_.begin(), contact_forces_.end(), Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < contact_count_; ++i)
      contact_forces_[static_cast<std::size_t>(contact_bodies_[i])] += MapVector(feedback_[i].f1);
  }
  dJointGroupEmpty(group_);
}

}  // namespace lacuna::ode
