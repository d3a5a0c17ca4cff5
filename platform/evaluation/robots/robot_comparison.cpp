#include "evaluation/robots/robot_comparison.h"

#include "foundation/address.h"
#include "foundation/text/counted.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kSameNumber = 1e-12;  ///< of the larger one
constexpr double kSameShare = 1e-13;   ///< of the largest component of a vector or tensor, for its small components
constexpr double kSamePlace = 1e-9;    ///< m, or of a unit vector

template <class Spec>
const Spec* called(const std::vector<Spec>& specs, const std::string& name) {
  const auto found = std::find_if(specs.begin(), specs.end(), [&](const Spec& one) { return one.name == name; });
  return found == specs.end() ? nullptr : &*found;
}

Eigen::Matrix3d tensor(const InertiaSpec& i) {
  Eigen::Matrix3d matrix;
  matrix << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  return matrix;
}

bool same_frame(const BodySpec& a, const BodySpec& b) {
  return (a.position - b.position).norm() < kSamePlace && a.orientation.angularDistance(b.orientation) < kSamePlace;
}

/// The body as seen in the frame of the other one.
BodySpec in_frame_of(const BodySpec& body, const BodySpec& other) {
  if (body.position == other.position && body.orientation.coeffs() == other.orientation.coeffs()) return body;
  BodySpec seen = body;
  const Eigen::Quaterniond turn = other.orientation.conjugate() * body.orientation;
  seen.com = other.orientation.conjugate() * (body.position + body.orientation * body.com - other.position);
  const Eigen::Matrix3d r = turn.toRotationMatrix(), inertia = r * tensor(body.inertia) * r.transpose();
  seen.inertia = {inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  seen.position = other.position;
  seen.orientation = other.orientation;
  return seen;
}

template <class Spec>
void name_unmatched(const std::vector<Spec>& wanted, const std::vector<Spec>& other, const std::string& kind,
                    std::vector<std::string>& sentences) {
  for (const Spec& one : wanted)
    if (!called(other, one.name)) sentences.push_back("the file has no " + kind + " " + one.name);
  for (const Spec& one : other)
    if (!called(wanted, one.name)) sentences.push_back("the file also has " + with_article(kind) + " " + one.name);
}

void compare_joints(const RobotSpec& wanted, const RobotSpec& other, std::vector<std::string>& sentences) {
  for (const JointSpec& joint : wanted.joints) {
    const JointSpec* there = called(other.joints, joint.name);
    if (!there) continue;
    if (there->kind != joint.kind || there->parent != joint.parent || there->child != joint.child)
      sentences.push_back("joint " + joint.name + " has another kind in the file, or connects other bodies");
    else if (joint.kind != JointKind::free && joint.kind != JointKind::fixed &&
             ((joint.anchor - there->anchor).cross(joint.axis).norm() > kSamePlace ||
              (joint.axis - there->axis).norm() > kSamePlace))
      sentences.push_back("joint " + joint.name + " has another place in the file");
  }
}

bool reads_a_body(SensorKind kind) {
  return kind == SensorKind::body_position || kind == SensorKind::body_velocity ||
         kind == SensorKind::body_orientation || kind == SensorKind::accelerometer || kind == SensorKind::beacon_range;
}

void compare_channels(const RobotSpec& wanted, const RobotSpec& other, std::vector<std::string>& sentences) {
  for (const ActuatorSpec& actuator : wanted.actuators) {
    const ActuatorSpec* there = called(other.actuators, actuator.name);
    if (there &&
        (there->kind != actuator.kind || there->joint != actuator.joint || there->relative != actuator.relative))
      sentences.push_back("actuator " + actuator.name + " has another kind in the file");
  }
  for (const SensorSpec& sensor : wanted.sensors) {
    const SensorSpec* there = called(other.sensors, sensor.name);
    if (!there) continue;
    const BodySpec *body = called(wanted.bodies, sensor.element), *body_there = called(other.bodies, sensor.element);
    if (there->kind != sensor.kind || there->element != sensor.element || there->relative != sensor.relative ||
        (sensor.at - there->at).norm() > kSamePlace)
      sentences.push_back("sensor " + sensor.name + " measures something else in the file");
    else if (reads_a_body(sensor.kind) && body && body_there && !same_frame(*body, *body_there))
      sentences.push_back("sensor " + sensor.name + " measures a frame with another place in the file");
  }
}

/// Magnitude of the group of numbers that one belongs to: all components of a centre or an inertia.
double scale_of(const RobotSpec& robot, const std::string& address) {
  for (const BodySpec& body : robot.bodies) {
    if (!address.starts_with("body." + body.name + ".")) continue;
    const std::string key = address.substr(body.name.size() + 6);
    if (key.starts_with("com.")) return std::max(body.com.cwiseAbs().maxCoeff(), 1e-3);
    if (key.starts_with("inertia.")) return tensor(body.inertia).cwiseAbs().maxCoeff();
  }
  return 0.0;
}

bool same_number(double a, double b, double scale) {
  if (a == b) return true;
  return std::abs(a - b) <= std::max(kSameNumber * std::max(std::abs(a), std::abs(b)), kSameShare * scale);
}

void set_values(RobotSpec wanted, RobotSpec other, std::map<std::string, double>& set) {
  std::map<std::string, double> there;
  for (const AddressedValue& value : addressed_values(other)) there[value.address] = *value.value;
  const std::vector<AddressedValue> values = addressed_values(wanted);
  std::set<std::string> new_masses;
  for (const AddressedValue& value : values) {
    const auto found = there.find(value.address);
    if (found == there.end() || same_number(*value.value, found->second, scale_of(wanted, value.address))) continue;
    set[value.address] = *value.value;
    if (matches("body.*.mass", value.address)) new_masses.insert(value.address.substr(0, value.address.rfind('.')));
  }
  for (const AddressedValue& value : values)
    for (const std::string& body : new_masses)
      if (value.address.starts_with(body + ".inertia.")) set[value.address] = *value.value;
}

}  // namespace

RobotComparison compare_robots(const RobotSpec& wanted, const RobotSpec& other) {
  RobotComparison comparison;
  name_unmatched(wanted.bodies, other.bodies, "body", comparison.other);
  name_unmatched(wanted.joints, other.joints, "joint", comparison.other);
  name_unmatched(wanted.actuators, other.actuators, "actuator", comparison.other);
  name_unmatched(wanted.sensors, other.sensors, "sensor", comparison.other);
  name_unmatched(wanted.couplings, other.couplings, "coupling", comparison.other);
  compare_joints(wanted, other, comparison.other);
  compare_channels(wanted, other, comparison.other);
  RobotSpec seen = wanted;
  for (BodySpec& body : seen.bodies)
    if (const BodySpec* there = called(other.bodies, body.name)) body = in_frame_of(body, *there);
  set_values(std::move(seen), other, comparison.set);
  return comparison;
}

}  // namespace lacuna
