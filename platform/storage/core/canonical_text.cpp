#include "storage/core/canonical_text.h"

#include "foundation/digest.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace lacuna {
namespace {

using Json = nlohmann::json;  // keeps keys in alphabetical order

/// JSON knows no infinity; a robot has them where nothing limits.
Json number(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value == 0.0 ? 0.0 : value;  // one zero
}

double number_from(const Json& json) {
  if (json.is_null()) return kNotKnown;
  if (json.is_string()) return json == "inf" ? kInfinity : -kInfinity;
  return json.get<double>();
}

Json vector(const Eigen::Vector3d& v) { return {number(v.x()), number(v.y()), number(v.z())}; }
Json rotation(const Eigen::Quaterniond& q) { return {number(q.w()), number(q.x()), number(q.y()), number(q.z())}; }

Json shape(const ShapeSpec& s) {
  return {{"kind", static_cast<int>(s.kind)},
          {"size", vector(s.size)},
          {"position", vector(s.position)},
          {"orientation", rotation(s.orientation)}};
}

Json body(const BodySpec& b) {
  Json shapes = Json::array();
  for (const ShapeSpec& s : b.shapes) shapes.push_back(shape(s));
  const InertiaSpec& i = b.inertia;
  return {{"name", b.name},
          {"mass", number(b.mass)},
          {"com", vector(b.com)},
          {"inertia", {number(i.xx), number(i.yy), number(i.zz), number(i.xy), number(i.xz), number(i.yz)}},
          {"inertia_scales_with_mass", b.inertia_scales_with_mass},
          {"position", vector(b.position)},
          {"orientation", rotation(b.orientation)},
          {"shapes", shapes}};
}

Json joint(const JointSpec& j) {
  return {{"name", j.name},
          {"kind", static_cast<int>(j.kind)},
          {"parent", j.parent},
          {"child", j.child},
          {"anchor", vector(j.anchor)},
          {"axis", vector(j.axis)},
          {"axis2", vector(j.axis2)},
          {"lower", number(j.lower)},
          {"upper", number(j.upper)},
          {"damping", number(j.damping)},
          {"dry_friction", number(j.dry_friction)},
          {"stiffness", number(j.stiffness)},
          {"rest", number(j.rest)},
          {"armature", number(j.armature)},
          {"force", number(j.force)}};
}

Json actuator(const ActuatorSpec& a) {
  const TransmissionSpec& t = a.transmission;
  Json text = {{"name", a.name},
               {"joint", a.joint},
               {"kind", static_cast<int>(a.kind)},
               {"gain", number(a.gain)},
               {"offset", number(a.offset)},
               {"delay", number(a.delay)},
               {"kp", number(a.kp)},
               {"ki", number(a.ki)},
               {"kd", number(a.kd)},
               {"force_limit", number(a.force_limit)},
               {"command_lower", number(a.command_lower)},
               {"command_upper", number(a.command_upper)},
               {"transmission",
                {{"ratio", number(t.ratio)},
                 {"rotor_inertia", number(t.rotor_inertia)},
                 {"stiffness", number(t.stiffness)},
                 {"damping", number(t.damping)},
                 {"gap", number(t.gap)}}}};
  if (a.relative) text["relative"] = true;
  if (a.supply_sag != 0.0) text["supply_sag"] = number(a.supply_sag);
  if (a.kind == ActuatorKind::voltage || a.kind == ActuatorKind::voltage_servo)
    text["motor"] = {{"torque_constant", number(a.motor.torque_constant)},
                     {"resistance", number(a.motor.resistance)},
                     {"back_emf", number(a.motor.back_emf)},
                     {"supply", number(a.motor.supply)},
                     {"duty_limit", number(a.motor.duty_limit)},
                     {"gain_unit", number(a.motor.gain_unit)}};
  if (a.motor.sample_time > 0.0) text["motor"]["sample_time"] = number(a.motor.sample_time);
  return text;
}

Json sensor(const SensorSpec& s) {
  Json text = {{"name", s.name},
               {"kind", static_cast<int>(s.kind)},
               {"element", s.element},
               {"beacon", vector(s.beacon)},
               {"delay", number(s.delay)},
               {"scale", number(s.scale)},
               {"offset", number(s.offset)},
               {"noise", number(s.noise)},
               {"quantum", number(s.quantum)}};
  if (s.relative) text["relative"] = true;
  if (s.kind == SensorKind::accelerometer) text["at"] = vector(s.at);
  return text;
}

template <class Spec>
Json list(const std::vector<Spec>& specs, Json (*one)(const Spec&)) {
  Json all = Json::array();
  for (const Spec& spec : specs) all.push_back(one(spec));
  return all;
}

Json effect(const EffectEntry& entry) {
  Json start = Json::object();
  for (const auto& [name, value] : entry.start) start[name] = number(value);
  std::vector<std::string> where = entry.where;
  std::vector<std::string> fixed = entry.fixed;
  std::sort(where.begin(), where.end());
  std::sort(fixed.begin(), fixed.end());
  return {{"id", entry.id}, {"effect", entry.effect}, {"where", where}, {"start", start}, {"fixed", fixed}};
}

/// Laws that a contact does not have are left out: digests of robots that never heard of them stay as they were.
Json contact(const ContactSpec& c) {
  Json json = {{"ground", c.ground},
               {"stiffness", number(c.stiffness)},
               {"damping", number(c.damping)},
               {"friction", number(c.friction)},
               {"slope", number(c.slope)}};
  for (const auto& [name, value] :
       {std::pair{"impact_damping", c.impact_damping}, std::pair{"restitution", c.restitution},
        std::pair{"rolling_lever", c.rolling_lever}, std::pair{"creep", c.creep}})
    if (value != 0.0) json[name] = number(value);
  return json;
}

}  // namespace

std::string canonical_text(const RobotSpec& robot) {
  Json text{{"name", robot.name},
            {"bodies", list(robot.bodies, body)},
            {"joints", list(robot.joints, joint)},
            {"actuators", list(robot.actuators, actuator)},
            {"sensors", list(robot.sensors, sensor)},
            {"contact", contact(robot.contact)},
            {"gravity", vector(robot.gravity)}};
  for (const CouplingSpec& c : robot.couplings)
    text["couplings"].push_back({{"name", c.name},
                                 {"joint", c.joint},
                                 {"follows", c.follows},
                                 {"ratio", number(c.ratio)},
                                 {"offset", number(c.offset)}});
  return text.dump();
}

std::string canonical_text(const EffectList& effects) {
  std::vector<Json> entries;
  for (const EffectEntry& entry : effects) entries.push_back(effect(entry));
  std::sort(entries.begin(), entries.end(), [](const Json& a, const Json& b) {
    return std::tie(a["effect"], a["where"], a["id"]) < std::tie(b["effect"], b["where"], b["id"]);
  });
  return Json(entries).dump();
}

std::string canonical_text(const EngineSettings& engine) {
  return Json{{"engine", engine.engine},
              {"step", number(engine.step)},
              {"substeps", engine.substeps},
              {"control_period", number(engine.control_period)},
              {"joint_erp", number(engine.joint_erp)},
              {"delay_rounding", engine.delay_rounding == DelayRounding::none ? "none" : "step"}}
      .dump();
}

std::string canonical_text(const std::vector<FreeValueRecord>& free) {
  Json values = Json::array();
  for (const FreeValueRecord& value : free) {
    values.push_back({{"address", value.address},
                      {"unit", value.unit},
                      {"lower", number(value.lower)},
                      {"upper", number(value.upper)},
                      {"start", number(value.start)}});
  }
  return values.dump();
}

EffectList effects_from_text(const std::string& text) {
  EffectList effects;
  for (const Json& entry : Json::parse(text)) {
    EffectEntry effect_entry{.id = entry.at("id"),
                             .effect = entry.at("effect"),
                             .where = entry.at("where"),
                             .start = {},
                             .fixed = entry.at("fixed")};
    for (const auto& [name, value] : entry.at("start").items()) {
      effect_entry.start[name] = number_from(value);
    }
    effects.push_back(std::move(effect_entry));
  }
  return effects;
}

std::vector<FreeValueRecord> free_from_text(const std::string& text) {
  std::vector<FreeValueRecord> free;
  for (const Json& value : Json::parse(text)) {
    free.push_back({.address = value.at("address"),
                    .unit = value.at("unit"),
                    .lower = number_from(value.at("lower")),
                    .upper = number_from(value.at("upper")),
                    .start = number_from(value.at("start"))});
  }
  return free;
}

EngineSettings engine_from_text(const std::string& text) {
  const Json engine = Json::parse(text);
  return {.engine = engine.at("engine"),
          .step = number_from(engine.at("step")),
          .substeps = engine.at("substeps"),
          .control_period = number_from(engine.at("control_period")),
          .joint_erp = number_from(engine.at("joint_erp")),
          .delay_rounding = engine.at("delay_rounding") == "step" ? DelayRounding::step : DelayRounding::none};
}

std::string digest_of(const RevisionRecord& revision) {
  return sha256(revision.robot_text + '\n' + canonical_text(revision.free) + '\n' + canonical_text(revision.effects) +
                '\n' + canonical_text(revision.engine) + '\n' + revision.fit_data_digest);
}

}  // namespace lacuna
