#include "bench/bare_quadruped.h"

#include "bench/bench_quadruped.h"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <string>

namespace lacuna {

struct BareQuadruped::Parts {
  RobotSpec robot = bench_quadruped();
  dWorldID world = nullptr;
  dGeomID ground = nullptr;
  dJointGroupID contacts = nullptr;
  dThreadingImplementationID threading = nullptr;
  std::vector<dBodyID> bodies;
  std::vector<dGeomID> geoms;  // of the bodies that have a shape
  std::vector<dJointID> hinges;
  std::vector<char> touches;  // per geom
  /// What a sensor reads: a geom's touch or a hinge's angle.
  struct Reading {
    bool touch;
    std::size_t index;
    double scale;
  };
  std::vector<Reading> sensors;
};

namespace {

dBodyID make_body(dWorldID world, const BodySpec& spec) {
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetParameters(&mass, spec.mass, 0, 0, 0, spec.inertia.xx, spec.inertia.yy, spec.inertia.zz, 0, 0, 0);
  dBodySetMass(body, &mass);
  return body;
}

void place(dBodyID body, const BodySpec& spec) {
  const dQuaternion q = {spec.orientation.w(), spec.orientation.x(), spec.orientation.y(), spec.orientation.z()};
  dBodySetPosition(body, spec.position.x(), spec.position.y(), spec.position.z());
  dBodySetQuaternion(body, q);
  dBodySetLinearVel(body, 0, 0, 0);
  dBodySetAngularVel(body, 0, 0, 0);
}

dGeomID make_geom(dBodyID body, const ShapeSpec& shape) {
  const dGeomID geom = shape.kind == ShapeKind::sphere ? dCreateSphere(nullptr, shape.size.x())
                                                       : dCreateCapsule(nullptr, shape.size.x(), shape.size.y());
  dGeomSetBody(geom, body);
  return geom;
}

dJointID make_hinge(dWorldID world, dBodyID parent, dBodyID child, const JointSpec& spec, const ActuatorSpec& servo) {
  const dJointID hinge = dJointCreateHinge(world, nullptr);
  dJointAttach(hinge, child, parent);
  dJointSetHingeAnchor(hinge, spec.anchor.x(), spec.anchor.y(), spec.anchor.z());
  dJointSetHingeAxis(hinge, spec.axis.x(), spec.axis.y(), spec.axis.z());
  dJointSetHingeParam(hinge, dParamLoStop, spec.lower);
  dJointSetHingeParam(hinge, dParamHiStop, spec.upper);
  dJointSetHingeParam(hinge, dParamFMax, servo.force_limit);
  // A servo kp·(c − q) − kd·v, taken with the coming position and velocity, is a motor that gives way.
  dJointSetHingeParam(hinge, dParamCFM, 1.0 / (servo.kd + kBenchStep * servo.kp));
  return hinge;
}

template <class Spec>
std::size_t index_of(const std::vector<Spec>& specs, const std::string& name) {
  const auto found = std::ranges::find(specs, name, &Spec::name);
  return static_cast<std::size_t>(found - specs.begin());
}

}  // namespace

BareQuadruped::BareQuadruped() : parts_(std::make_unique<Parts>()) {
  dInitODE2(0);
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
  Parts& p = *parts_;
  p.world = dWorldCreate();
  p.threading = dThreadingAllocateSelfThreadedImplementation();
  dWorldSetStepThreadingImplementation(p.world, dThreadingImplementationGetFunctions(p.threading), p.threading);
  dWorldSetGravity(p.world, 0, 0, p.robot.gravity.z());
  p.ground = dCreatePlane(nullptr, 0, 0, 1, 0);
  p.contacts = dJointGroupCreate(0);
  std::vector<std::size_t> geom_of_body;
  for (const BodySpec& spec : p.robot.bodies) {
    p.bodies.push_back(make_body(p.world, spec));
    geom_of_body.push_back(p.geoms.size());
    for (const ShapeSpec& shape : spec.shapes) p.geoms.push_back(make_geom(p.bodies.back(), shape));
  }
  p.touches.assign(p.geoms.size(), 0);
  reset();
  for (std::size_t i = 0; i < p.robot.joints.size(); ++i) {
    const JointSpec& joint = p.robot.joints[i];
    p.hinges.push_back(make_hinge(p.world, p.bodies[index_of(p.robot.bodies, joint.parent)],
                                  p.bodies[index_of(p.robot.bodies, joint.child)], joint, p.robot.actuators[i]));
  }
  for (const SensorSpec& sensor : p.robot.sensors) {
    const bool touch = sensor.kind == SensorKind::touch;
    const std::size_t index =
        touch ? geom_of_body[index_of(p.robot.bodies, sensor.element)] : index_of(p.robot.joints, sensor.element);
    p.sensors.push_back({touch, index, sensor.scale});
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
  for (std::size_t i = 0; i < parts_->bodies.size(); ++i) place(parts_->bodies[i], parts_->robot.bodies[i]);
}

void BareQuadruped::drive(double time) {
  for (std::size_t i = 0; i < parts_->hinges.size(); ++i) {
    const ActuatorSpec& servo = parts_->robot.actuators[i];
    const double command = std::clamp(servo.gain * bench_command(i, time), servo.command_lower, servo.command_upper);
    const double error = command - dJointGetHingeAngle(parts_->hinges[i]);
    dJointSetHingeParam(parts_->hinges[i], dParamVel, servo.kp / (servo.kd + kBenchStep * servo.kp) * error);
  }
}

void BareQuadruped::touch_ground() {
  constexpr int kMostContacts = 2;
  std::array<dContact, kMostContacts> contacts{};
  const ContactSpec& ground = parts_->robot.contact;
  const double spring = kBenchStep * ground.stiffness;
  dJointGroupEmpty(parts_->contacts);
  for (std::size_t g = 0; g < parts_->geoms.size(); ++g) {
    const int count = dCollide(parts_->geoms[g], parts_->ground, kMostContacts, &contacts[0].geom, sizeof(dContact));
    parts_->touches[g] = count > 0 ? 1 : 0;
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts[static_cast<std::size_t>(i)];
      contact.surface.mode = dContactSoftERP | dContactSoftCFM;  // endless friction needs no cone
      contact.surface.mu = dInfinity;
      contact.surface.soft_erp = spring / (spring + ground.damping);
      contact.surface.soft_cfm = 1.0 / (spring + ground.damping);
      const dJointID joint = dJointCreateContact(parts_->world, parts_->contacts, &contact);
      dJointAttach(joint, dGeomGetBody(parts_->geoms[g]), nullptr);
    }
  }
}

void BareQuadruped::record() {
  for (const Parts::Reading& sensor : parts_->sensors)
    readings_.push_back(sensor.touch ? (parts_->touches[sensor.index] ? 1.0 : -1.0)
                                     : sensor.scale * dJointGetHingeAngle(parts_->hinges[sensor.index]));
}

void BareQuadruped::run(int steps) {
  reset();
  readings_.clear();
  readings_.reserve(static_cast<std::size_t>(steps + 1) * parts_->sensors.size());
  for (int i = 0; i < steps; ++i) {
    touch_ground();
    record();
    drive(i * kBenchStep);
    dWorldStep(parts_->world, kBenchStep);
  }
  touch_ground();
  record();
}

}  // namespace lacuna
