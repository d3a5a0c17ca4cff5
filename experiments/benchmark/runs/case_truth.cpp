#include "runs/case_truth.h"

#include "cases/write_case.h"
#include "rigs/rig.h"
#include "runs/run_contact_case.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hidden_effects {
namespace {

HiddenLawRecord record_of(const LawKind& kind, int element, const PlantSpec& spec) {
  const std::string place = where_of(kind, element, spec);
  return {kind.name, {kind.effect, place.empty() ? "world" : place}, kind.library_form, {}};
}

}  // namespace

CaseRecord about_plan(const CasePlan& plan, const std::string& version) {
  CaseRecord about{version,
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
  if (is_contact_case(plan)) {
    about.hidden = hidden_contact_laws(plan);
    return about;
  }
  const PlantSpec& spec = rig_named(plan.rig).nominal;
  for (const HiddenLaw& one : plan.hidden) about.hidden.push_back(record_of(law_kind(one.law), one.element, spec));
  return about;
}

CaseRecord about_case(const MadeCase& made, const std::string& version) {
  CaseRecord about = about_plan(made.plan, version);
  about.strength = made.strength;
  about.absorbed = made.absorbed;
  about.hidden.clear();
  Eigen::Index next = made.base_values.size();
  for (const PlacedLaw& law : made.truth.laws) {
    about.hidden.push_back(record_of(*law.kind, law.element, made.truth.spec));
    for (const std::string& name : law.kind->parameters)
      about.hidden.back().parameters.push_back({name, made.truth_values[next++]});
  }
  return about;
}

std::vector<NamedValue> true_free_values(const MadeCase& made) {
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < made.base.free.size(); ++i)
    values.push_back({made.base.free[i].address, made.base_values[static_cast<Eigen::Index>(i)]});
  return values;
}

std::string truth_json(const CasePlan& plan, const CaseRecord& about, const std::vector<NamedValue>& free_values) {
  using nlohmann::ordered_json;
  ordered_json hidden = ordered_json::array(), values = ordered_json::object();
  for (const HiddenLawRecord& law : about.hidden) {
    ordered_json parameters = ordered_json::object();
    for (const NamedValue& one : law.parameters) parameters[one.name] = one.value;
    hidden.push_back({{"law", law.law},
                      {"effect", law.answer.effect},
                      {"where", law.answer.place},
                      {"library_form", law.library_form},
                      {"parameters", parameters}});
  }
  for (const NamedValue& one : free_values) values[one.name] = one.value;
  return ordered_json{
             {"case", plan.name()},        {"group", about.group},       {"rig", about.rig}, {"noise", about.noise},
             {"strength", about.strength}, {"absorbed", about.absorbed}, {"hidden", hidden}, {"values", values}}
             .dump(2) +
         "\n";
}

}  // namespace hidden_effects
