#include "bench/bare_quadruped.h"

#include <ode/ode.h>

#include <array>

namespace lacuna {

struct BareQuadruped::Parts {
  dWorldID world = nullptr;
  dGeomID ground = nullptr;
  dJointGroupID contacts = nullptr;
  dThreadingImplementationID threading = nullptr;
  std::vector<dBodyID> bodies;
  std::vector<dGeomID> geoms;  // torso, lower legs
  std::vector<dJointID> hinges;
  std::array<bool, kLegs + 1> touches{};
  std::vector<std::array<dReal, 7>> start;  // pose of each body
};

namespace {

dBodyID make_body(dWorldID world, const BodySpec& spec) {
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetParameters(&mass, spec.mass, 0, 0, 0, spec.inertia.xx, spec.inertia.yy, spec.inertia.zz, 0, 0, 0);
  dBodySetMass(body, &mass);
  return body;
}

dGeomID make_geom(dBodyID body, const ShapeSpec& shape) {
  const dGeomID geom = shape.kind == ShapeKind::sphere ? dCreateSphere(nullptr, shape.size.x())
                                                       : dCreateCapsule(nullptr, shape.size.x(), shape.size.y());
  dGeomSetBody(geom, body);
  return geom;
}

dJointID make_hinge(dWorldID world, dBodyID parent, dBodyID child, const JointSpec& spec, double torque) {
  const dJointID hinge = dJointCreateHinge(world, nullptr);
  dJointAttach(hinge, child, parent);
  dJointSetHingeAnchor(hinge, spec.anchor.x(), spec.anchor.y(), spec.anchor.z());
  dJointSetHingeAxis(hinge, spec.axis.x(), spec.axis.y(), spec.axis.z());
  dJointSetHingeParam(hinge, dParamLoStop, spec.lower);
  dJointSetHingeParam(hinge, dParamHiStop, spec.upper);
  dJointSetHingeParam(hinge, dParamFMax, torque);
  return hinge;
}

}  // namespace

BareQuadruped::BareQuadruped(const QuadrupedNumbers& numbers) : numbers_(numbers), parts_(std::make_unique<Parts>()) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  const RobotSpec robot = quadruped_for_bench(numbers);
  Parts& p = *parts_;
  p.world = dWorldCreate();
  p.threading = dThreadingAllocateSelfThreadedImplementation();
  dWorldSetStepThreadingImplementation(p.world, dThreadingImplementationGetFunctions(p.threading), p.threading);
  dWorldSetGravity(p.world, 0, 0, -numbers.gravity);
  p.ground = dCreatePlane(nullptr, 0, 0, 1, 0);
  p.contacts = dJointGroupCreate(0);
  for (const BodySpec& spec : robot.bodies) {
    p.bodies.push_back(make_body(p.world, spec));
    p.start.push_back({spec.position.x(), spec.position.y(), spec.position.z(), spec.orientation.w(),
                       spec.orientation.x(), spec.orientation.y(), spec.orientation.z()});
    for (const ShapeSpec& shape : spec.shapes) p.geoms.push_back(make_geom(p.bodies.back(), shape));
  }
  reset();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const std::size_t upper = 1 + 2 * (i / 2);
    const bool hip = i % 2 == 0;
    p.hinges.push_back(make_hinge(p.world, p.bodies[hip ? 0 : upper], p.bodies[hip ? upper : upper + 1],
                                  robot.joints[i], numbers.torque));
    // A servo kp·(c − q) − kd·v, taken with the coming position and velocity, is a motor that gives way.
    dJointSetHingeParam(p.hinges.back(), dParamCFM, 1.0 / (numbers.kd + numbers.step * numbers.kp));
  }
}

BareQuadruped::~BareQuadruped() {
  for (const dGeomID geom : parts_->geoms) dGeomDestroy(geom);
  dGeomDestroy(parts_->ground);
  dJointGroupDestroy(parts_->contacts);
  dWorldDestroy(parts_->world);
  dThreadingFreeImplementation(parts_->threading);
}

void BareQuadruped::reset() {
  for (std::size_t i = 0; i < parts_->bodies.size(); ++i) {
    const auto& pose = parts_->start[i];
    const dQuaternion q = {pose[3], pose[4], pose[5], pose[6]};
    dBodySetPosition(parts_->bodies[i], pose[0], pose[1], pose[2]);
    dBodySetQuaternion(parts_->bodies[i], q);
    dBodySetLinearVel(parts_->bodies[i], 0, 0, 0);
    dBodySetAngularVel(parts_->bodies[i], 0, 0, 0);
  }
}

void BareQuadruped::drive(double time) {
  const double share = numbers_.kp / (numbers_.kd + numbers_.step * numbers_.kp);
  for (std::size_t i = 0; i < parts_->hinges.size(); ++i) {
    const double error = quadruped_command(i, time) - dJointGetHingeAngle(parts_->hinges[i]);
    dJointSetHingeParam(parts_->hinges[i], dParamVel, share * error);
  }
}

void BareQuadruped::touch_ground() {
  constexpr int kMostContacts = 4;
  std::array<dContact, kMostContacts> contacts{};
  const double spring = numbers_.step * numbers_.ground_stiffness;
  dJointGroupEmpty(parts_->contacts);
  for (std::size_t g = 0; g < parts_->geoms.size(); ++g) {
    const int count = dCollide(parts_->geoms[g], parts_->ground, kMostContacts, &contacts[0].geom, sizeof(dContact));
    parts_->touches[g] = count > 0;
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts[static_cast<std::size_t>(i)];
      contact.surface.mode = dContactSoftERP | dContactSoftCFM;  // endless friction needs no cone
      contact.surface.mu = dInfinity;
      contact.surface.soft_erp = spring / (spring + numbers_.ground_damping);
      contact.surface.soft_cfm = 1.0 / (spring + numbers_.ground_damping);
      const dJointID joint = dJointCreateContact(parts_->world, parts_->contacts, &contact);
      dJointAttach(joint, dGeomGetBody(parts_->geoms[g]), nullptr);
    }
  }
}

void BareQuadruped::record() {
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    readings_.push_back(parts_->touches[leg + 1] ? 1.0 : -1.0);
    readings_.push_back(dJointGetHingeAngle(parts_->hinges[2 * leg + 1]));
  }
  const dReal* position = dBodyGetPosition(parts_->bodies[0]);
  readings_.insert(readings_.end(), position, position + 3);
}

void BareQuadruped::run(int steps) {
  reset();
  readings_.clear();
  readings_.reserve(static_cast<std::size_t>((steps + 1) * kReadings));
  for (int i = 0; i < steps; ++i) {
    touch_ground();
    record();
    drive(i * numbers_.step);
    dWorldStep(parts_->world, numbers_.step);
  }
  touch_ground();
  record();
}

}  // namespace lacuna
