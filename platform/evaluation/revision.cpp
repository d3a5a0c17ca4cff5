#include "evaluation/revision.h"

#include "foundation/digest.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

using nlohmann::json;

/// JSON has no infinities; they are part of many defaults.
json number(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}
json vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
json rotation(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

json document(const ShapeSpec& shape) {
  return {{"kind", static_cast<int>(shape.kind)},
          {"size", vector(shape.size)},
          {"position", vector(shape.position)},
          {"orientation", rotation(shape.orientation)}};
}

json document(const BodySpec& body) {
  json shapes = json::array();
  for (const ShapeSpec& shape : body.shapes) shapes.push_back(document(shape));
  const InertiaSpec& i = body.inertia;
  return {{"name", body.name},
          {"mass", body.mass},
          {"com", vector(body.com)},
          {"inertia", {i.xx, i.yy, i.zz, i.xy, i.xz, i.yz}},
          {"inertia_scales_with_mass", body.inertia_scales_with_mass},
          {"position", vector(body.position)},
          {"orientation", rotation(body.orientation)},
          {"shapes", shapes}};
}

json document(const JointSpec& joint) {
  return {{"name", joint.name},
          {"kind", static_cast<int>(joint.kind)},
          {"parent", joint.parent},
          {"child", joint.child},
          {"anchor", vector(joint.anchor)},
          {"axis", vector(joint.axis)},
          {"axis2", vector(joint.axis2)},
          {"stops", {number(joint.lower), number(joint.upper)}},
          {"laws", {joint.damping, joint.dry_friction, joint.stiffness, joint.rest, joint.armature, joint.force}}};
}

json document(const ActuatorSpec& actuator) {
  const TransmissionSpec& t = actuator.transmission;
  return {{"name", actuator.name},
          {"joint", actuator.joint},
          {"kind", static_cast<int>(actuator.kind)},
          {"command", {actuator.gain, actuator.offset, actuator.delay}},
          {"gains", {actuator.kp, actuator.ki, actuator.kd}},
          {"limits", {number(actuator.force_limit), number(actuator.command_lower), number(actuator.command_upper)}},
          {"transmission", {t.ratio, t.rotor_inertia, number(t.stiffness), t.damping, t.gap}}};
}

json document(const SensorSpec& sensor) {
  return {{"name", sensor.name},
          {"kind", static_cast<int>(sensor.kind)},
          {"element", sensor.element},
          {"beacon", vector(sensor.beacon)},
          {"stages", {sensor.delay, sensor.scale, sensor.offset, sensor.noise, sensor.quantum}}};
}

json document(const FreeValue& value) {
  return {{"address", value.address},     {"unit", value.unit},   {"lower", number(value.lower)},
          {"upper", number(value.upper)}, {"start", value.start}, {"scale", static_cast<int>(value.scale)}};
}

json document(const EffectEntry& entry) {
  return {{"id", entry.id},
          {"effect", entry.effect},
          {"where", entry.where},
          {"start", entry.start},
          {"fixed", entry.fixed}};
}

template <class Specs>
json documents(const Specs& specs) {
  json list = json::array();
  for (const auto& spec : specs) list.push_back(document(spec));
  return list;
}

json document(const RobotSpec& robot) {
  const ContactSpec& c = robot.contact;
  return {{"name", robot.name},
          {"bodies", documents(robot.bodies)},
          {"joints", documents(robot.joints)},
          {"actuators", documents(robot.actuators)},
          {"sensors", documents(robot.sensors)},
          {"contact", {c.ground, number(c.stiffness), c.damping, number(c.friction), c.slope}},
          {"gravity", vector(robot.gravity)}};
}

json document(const EngineSettings& engine) {
  return {{"engine", engine.engine},       {"step", engine.step},
          {"substeps", engine.substeps},   {"control_period", engine.control_period},
          {"joint_erp", engine.joint_erp}, {"delay_rounding", static_cast<int>(engine.delay_rounding)}};
}

std::string_view bytes(const double* values, Eigen::Index count) {
  return {reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(double)};
}

std::string digest_of(const TimeSeries& series) {
  std::string text;
  for (const Channel& channel : series.channels) text += channel.name + '[' + channel.unit + ']';
  text += bytes(series.times.data(), series.times.size());
  text += bytes(series.samples.data(), series.samples.size());
  return sha256(text);
}

}  // namespace

std::string digest_of(const Trial& trial) {
  json start = json::array();
  for (const InitialValue& value : trial.initial)
    start.push_back({static_cast<int>(value.knowledge), value.position, value.velocity});
  return sha256(digest_of(trial.commands.series) + digest_of(trial.measured) + start.dump() +
                (trial.commands.hold == Hold::zero_order ? "zero" : "first"));
}

std::string to_json(const EffectList& effects) { return documents(effects).dump(); }

EffectList effects_from_json(const std::string& text) {
  EffectList effects;
  for (const json& entry : json::parse(text))
    effects.push_back({entry.at("id"), entry.at("effect"), entry.at("where"), entry.at("start"), entry.at("fixed")});
  return effects;
}

Revision revision_of(const ModelDefinition& model, const std::vector<Trial>& trials) {
  Revision revision;
  revision.robot = document(model.structure.robot).dump();
  revision.free_values = documents(model.free).dump();
  revision.effects = to_json(model.effects);
  revision.engine = document(model.engine).dump();
  std::string data;
  for (const Trial& trial : trials)
    if (!trial.held_out) data += digest_of(trial);
  revision.data_digest = sha256(data);
  revision.digest =
      sha256(revision.robot + revision.free_values + revision.effects + revision.engine + revision.data_digest);
  return revision;
}

}  // namespace lacuna
