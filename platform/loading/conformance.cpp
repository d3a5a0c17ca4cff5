#include "loading/conformance.h"

#include "foundation/address.h"
#include "foundation/placement_unit.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace lacuna {
namespace {

bool is_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
}

std::string name_problem(const ParameterDeclarations& parameters, std::size_t i) {
  const std::string& name = parameters[i].name;
  if (name.empty()) return fmt::format("its parameter {} has no name; give it one", i + 1);
  if (!is_name(name))
    return fmt::format("its parameter \"{}\" may contain only letters, digits and _ in its name", name);
  for (std::size_t other = 0; other < i; ++other)
    if (parameters[other].name == name) return fmt::format("two of its parameters are named \"{}\"; rename one", name);
  return {};
}

std::string bounds_problem(const ParameterDeclaration& parameter) {
  const auto problem = [&](const std::string& what) {
    return fmt::format("its parameter \"{}\" has {}: lower {}, default {}, upper {}; correct the declaration",
                       parameter.name, what, parameter.lower, parameter.default_value, parameter.upper);
  };
  if (!std::isfinite(parameter.lower) || !std::isfinite(parameter.upper) || !std::isfinite(parameter.default_value))
    return problem("bounds or a default that are not finite numbers");
  if (parameter.lower > parameter.upper) return problem("a lower bound above its upper bound");
  if (parameter.default_value < parameter.lower || parameter.default_value > parameter.upper)
    return problem("a default outside of its bounds");
  return {};
}

/// For an effect's parameter: the problem on the first placement where its unit is invalid.
std::string unit_problem(const ParameterDeclaration& parameter, const std::vector<ElementKind>& placements) {
  for (const ElementKind kind : placements) {
    if (is_unit_on(kind, parameter.unit)) continue;
    const std::string words = unit_words_on(kind);
    return fmt::format("its parameter \"{}\" has the unit \"{}\", which is not a unit for {}; known are {}{}",
                       parameter.name, parameter.unit,
                       kind == ElementKind::world ? "the world" : "elements of kind " + std::string(to_string(kind)),
                       known_units(), words.empty() ? "" : "; placeholders are " + words);
  }
  return {};
}

std::string unit_problem(const ParameterDeclaration& parameter) {
  if (parse_unit(parameter.unit)) return {};
  return fmt::format("its parameter \"{}\" has the unknown unit \"{}\"; known are {}", parameter.name, parameter.unit,
                     known_units());
}

template <class UnitProblem>
std::string first_problem(const ParameterDeclarations& parameters, UnitProblem&& unit_problem_of) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const std::string& problem :
         {name_problem(parameters, i), bounds_problem(parameters[i]), unit_problem_of(parameters[i])})
      if (!problem.empty()) return problem;
  return {};
}

std::string neutral_problem(const EffectDescription& description) {
  const std::size_t values = description.neutral.size();
  if (values != 0 && values != description.parameters.size())
    return fmt::format("it has {} neutral values for {} parameters; give one for each, or none", values,
                       description.parameters.size());
  if (std::any_of(description.neutral.begin(), description.neutral.end(), [](double v) { return !std::isfinite(v); }))
    return "one of its neutral values is not a finite number";
  return {};
}

std::string stage_problem(const char* hook, const char* stages, bool overridden, bool has_stage) {
  if (overridden == has_stage) return {};
  return overridden ? fmt::format(
                          "it overrides `{}` but names no stage for it, so it would never be called; return one in "
                          "`stages()`: {{.{} = lacuna::{}::...}}",
                          hook, hook == std::string("sense") ? "sensor" : hook, stages)
                    : fmt::format(
                          "it names a stage in `stages()`, of lacuna::{}, but does not override `{}`; override it or "
                          "remove the stage",
                          stages, hook);
}

}  // namespace

std::string declaration_problem(const ParameterDeclarations& parameters) {
  return first_problem(parameters, [](const ParameterDeclaration& parameter) { return unit_problem(parameter); });
}

std::string endings_problem(const std::vector<std::string>& endings, std::string_view taken) {
  if (endings.empty()) return "it names no file ending; name one, such as \".urdf\"";
  for (const std::string& ending : endings)
    if (ending.size() < 2 || ending.front() != '.' || ending == taken)
      return fmt::format("it reads files that end with \"{}\"; an ending must begin with a dot, and {} is taken",
                         ending, taken);
  return {};
}

std::string effect_problem(const EffectDescription& description, const EffectStages& stages,
                           const OverriddenHooks& overridden) {
  if (description.placements.empty())
    return "it has no placement; name in `describe()` the kinds of element on which it acts, such as .placements = "
           "{lacuna::ElementKind::joint}";
  for (const std::string& problem :
       {first_problem(
            description.parameters,
            [&](const ParameterDeclaration& parameter) { return unit_problem(parameter, description.placements); }),
        neutral_problem(description),
        stage_problem("command", "CommandStage", overridden.command, stages.command != CommandStage::none),
        stage_problem("sense", "SensorStage", overridden.sense, stages.sensor != SensorStage::none)})
    if (!problem.empty()) return problem;
  return {};
}

}  // namespace lacuna
