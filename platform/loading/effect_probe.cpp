#include "loading/effect_probe.h"

#include "loading/allocation_count.h"
#include "loading/effect_trial.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace lacuna {
namespace {

std::string reading_problem(const EffectTrial& trial, const EffectCourse& first, std::size_t parameters) {
  if (first_difference(first, trial.go({})) != nullptr)
    return {};  // different results for the same calls prove nothing
  constexpr double kOtherGuard = -1906.5;
  const char* const call = first_difference(first, trial.go({.guard = kOtherGuard}));
  return call == nullptr
             ? ""
             : fmt::format("{} reads beyond its parameters (it has {}), so its result depends on the memory after them",
                           call, parameters);
}

/// With loads of others the sum must differ, unless it was overwritten.
std::string overwriting_problem(const EffectTrial& trial, const EffectCourse& alone) {
  constexpr double kLarge = 1e9;  // so large that other loads may vanish in rounding
  const EffectCourse beside = trial.go({.has_others = true});
  const std::vector<double> others = summands_of_others();
  if (beside.threw() || beside.summands.size() != alone.summands.size()) return {};
  for (std::size_t i = 0; i < alone.summands.size(); ++i)
    if (others[i] != 0.0 && std::abs(alone.summands[i]) < kLarge && same_bits(alone.summands[i], beside.summands[i]))
      return "add_loads overwrites loads that other effects have added; add to them (+=)";
  return {};
}

std::string allocation_remark(const EffectCourse& course) {
  for (const auto& [call, count] : course.allocations)
    if (count > 0)
      return fmt::format(
          "{} allocates memory ({} per call), which an effect must not do in a step, because it slows down each model; "
          "keep the data in its state or in arrays of fixed size",
          call, count == 1 ? "once" : fmt::format("{} times", count));
  return {};
}

EffectFindings findings_at(const EffectTrial& trial, std::size_t parameters, const EffectCourse& course) {
  if (course.replaced_loads) return {"add_loads replaces the list of loads; add to its elements", {}};
  if (!course.kept_to_state)
    return {"it writes beyond its state; return the number of values it needs from `state_size`", {}};
  for (const std::string& problem : {reading_problem(trial, course, parameters),
                                     course.threw() ? std::string() : overwriting_problem(trial, course)})
    if (!problem.empty()) return {problem, {}};
  return {{}, allocation_remark(course)};
}

}  // namespace

EffectFindings try_effect(const PhysicalEffect& effect, const EffectDescription& description) {
  count_allocations();
  std::vector<double> values;
  for (const ParameterDeclaration& parameter : description.parameters) values.push_back(value_to_try(parameter));
  EffectFindings findings;
  for (const ElementKind kind : description.placements)
    for (std::vector<int> elements : {std::vector<int>{0}, std::vector<int>{0, 1}}) {
      if (kind == ElementKind::world) elements.clear();
      const EffectTrial trial(effect, description, kind, elements, values);
      const EffectCourse course = trial.go({.looks_at_process = true});
      if (course.threw() && elements.size() == 1) continue;  // some act between two elements
      const EffectFindings here = findings_at(trial, description.parameters.size(), course);
      if (!here.problem.empty()) return here;
      if (findings.remark.empty()) findings.remark = here.remark;
      break;
    }
  return findings;
}

}  // namespace lacuna
