#include "runs/dirty_truth.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hidden_effects {
namespace {

using nlohmann::ordered_json;

DirtyEffectRecord record_of_effect(const dirty::DirtyEffect& one, const PlantSpec& stated) {
  DirtyEffectRecord record{one.what(stated),
                           {one.effect(stated), one.place(stated)},
                           dirty::to_string(one.role),
                           one.library_form(),
                           one.share,
                           one.accepted(stated),
                           {}};
  if (!one.kind) {
    const double value = one.value.in(stated);
    record.values = {{"stated", value}, {"true", value * one.factor}};
    return record;
  }
  for (std::size_t i = 0; i < one.parameters.size(); ++i)
    record.values.push_back({one.kind->law.parameters[i], one.parameters[i]});
  return record;
}

ordered_json json_of_effect(const DirtyEffectRecord& one) {
  ordered_json values = ordered_json::object();
  for (const NamedValue& value : one.values) values[value.name] = value.value;
  return {{"what", one.what},   {"effect", one.answer.effect},      {"place", one.answer.place},
          {"role", one.role},   {"library_form", one.library_form}, {"values", values},
          {"share", one.share}, {"accepted", one.accepted}};
}

ordered_json json_of_readings(const dirty::DirtyCase& made) {
  const dirty::Recording& how = made.recording;
  ordered_json sensors = ordered_json::object();
  for (std::size_t s = 0; s < made.rig.stated.sensors.size(); ++s)
    sensors[made.rig.stated.sensors[s].name] = {
        {"white", how.white[s]}, {"lasting", how.lasting[s]}, {"quantum", how.quantum[s]}, {"all", made.noise[s]}};
  return {{"sensors", sensors},   {"lasting_time", how.lasting_time},
          {"jitter", how.jitter}, {"late_stamps", how.receipt},
          {"drops", how.drops},   {"two_devices", how.two_devices}};
}

ordered_json json_of_free(const dirty::DirtyCase& made) {
  ordered_json values = ordered_json::object();
  for (const dirty::OwnerFree& one : made.rig.free)
    values[one.value.address(made.rig.stated)] = one.value.in(made.truth.spec);
  return values;
}

}  // namespace

std::vector<CasePlan> dirty_case_plans(const std::string& set) {
  std::vector<CasePlan> plans;
  for (const dirty::DirtyPlan& one : dirty::plan_dirty_cases(set)) {
    CasePlan& plan = plans.emplace_back();
    plan.set = one.set;
    plan.number = one.number;
    plan.group = plan.rig = one.family;
    plan.strength = one.mains == 0 ? 1.0 : one.strength;
    plan.noise = NoiseLevel::coloured;
    plan.seed = one.seed;
  }
  return plans;
}

dirty::DirtyPlan dirty_plan_of(const CasePlan& plan) {
  return dirty::plan_dirty_cases(plan.set).at(static_cast<std::size_t>(plan.number));
}

CaseRecord about_dirty_plan(const CasePlan& plan, const std::string& version) {
  return {version,
          plan.set,
          plan.number,
          plan.group,
          plan.rig,
          std::string(to_string(plan.noise)),
          plan.strength,
          kUnknown,
          false,
          fmt::format("{}", plan.seed),
          {}};
}

CaseRecord about_dirty_case(const dirty::DirtyCase& made, const CasePlan& plan, const std::string& version) {
  CaseRecord about = about_dirty_plan(plan, version);
  about.strength = made.error;
  for (const DirtyEffectRecord& one : dirty_effects(made))
    if (one.role == "main") about.hidden.push_back({one.what, one.answer, one.library_form, one.values});
  return about;
}

std::vector<DirtyEffectRecord> dirty_effects(const dirty::DirtyCase& made) {
  std::vector<DirtyEffectRecord> records;
  for (const dirty::DirtyEffect& one : made.effects) records.push_back(record_of_effect(one, made.rig.stated));
  return records;
}

std::string dirty_truth_json(const dirty::DirtyCase& made) {
  ordered_json effects = ordered_json::array();
  for (const DirtyEffectRecord& one : dirty_effects(made)) effects.push_back(json_of_effect(one));
  return ordered_json{{"case", made.plan.name()},   {"seed", fmt::format("{}", made.plan.seed)},
                      {"family", made.plan.family}, {"error_over_noise", made.error},
                      {"effects", effects},         {"readings", json_of_readings(made)},
                      {"free", json_of_free(made)}}
             .dump(2) +
         "\n";
}

}  // namespace hidden_effects
