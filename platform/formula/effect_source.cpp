#include "formula/effect_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

constexpr const char* kSource = R"(// Written by `lacuna plugins new effect @NAME@` from the formula
//     @FORMULA@
// Change what you like; README.md has the same table of parameters.

#include <lacuna/force_law.h>
#include <lacuna/joint_laws.h>
#include <lacuna/plugin.h>

namespace lacuna {
namespace {

enum Parameter : std::size_t { @ENUMERATORS@ };
@FUNCTIONS@
class @CLASS@ : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
@HOOKS@  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                   StepLoads& loads) const override;
};

EffectDescription @CLASS@::describe() const {
  return {.summary = "The force @FORMULA@ on a joint",
          .equation = "tau = @EQUATION@",
          .literature = "none; found as a formula",
          .regime = "motion like that in which the formula was found",
          .look_alikes = {@LOOK_ALIKES@},
          .placements = {ElementKind::@KIND@},
          .parameters = {@PARAMETERS@},
          .neutral = {@NEUTRAL@}};
}

@STEP@
}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::@CLASS@>("@NAME@"))
)";

constexpr const char* kSmoothForce = R"(
/// The terms with a slope, at position q and velocity v@AND_COMMAND@.
Dual smooth_force(@ARGUMENTS@, std::span<const double> p) {
  return @SUM@;
}
)";

constexpr const char* kForceAlongMotion = R"(
/// What the terms with sgn(v) have before it: dry friction where it is negative.
Dual force_along_motion(@ARGUMENTS@, std::span<const double> p) {
  return @SUM@;
}
)";

constexpr const char* kJointHooks =
    R"(  void amend(RobotSpec& robot, const EffectContext& context) const override {
    for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
  }
)";

constexpr const char* kActuatorHooks =
    R"(  EffectStages stages() const override { return {.command = CommandStage::saturation}; }
  /// The command of each actuator, as it arrives there.
  int state_size(const EffectContext& context) const override { return static_cast<int>(context.elements.size()); }
  double command(double value, int which, const StepView&, const EffectContext&,
                 std::span<double> state) const override {
    return state[static_cast<std::size_t>(which)] = value;
  }
)";

constexpr const char* kJointStep =
    R"(void @CLASS@::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
@INDENT@StepLoads& loads) const {
  const std::span<const double> p = context.parameters;
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double q = view.positions[coordinate], v = view.velocities[coordinate];
    JointLoad& load = loads.joints[coordinate];
@ADDED@  }
}
)";

constexpr const char* kActuatorStep =
    R"(void @CLASS@::add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
@INDENT@StepLoads& loads) const {
  const std::span<const double> p = context.parameters;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const auto actuator = static_cast<std::size_t>(context.elements[i]);
    const auto coordinate = static_cast<std::size_t>(view.actuator_coordinate[actuator]);
    const double q = view.positions[coordinate], v = view.velocities[coordinate], u = state[i];
    JointLoad& load = loads.joints[coordinate];
@ADDED@  }
}
)";

/// A number as C++ takes it for one of type double.
std::string literal(double number) {
  const std::string text = number_text(number);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

/// The index of each parameter, as a constant in the source.
std::map<std::string, std::string> enumerators_of(const ForceLaw& law) {
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
  for (const LawParameter& parameter : law.parameters) {
    std::string name = "k" + camel_case(parameter.name);
    while (!taken.insert(name).second) name += "X";
    names[parameter.name] = name;
  }
  return names;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  return fmt::format("{}", fmt::join(words, between));
}

/// The sum of the terms with sgn(v), or of the others, as C++; empty if there are none.
std::string sum_of(const ForceLaw& law, bool along) {
  const std::map<std::string, std::string> enumerators = enumerators_of(law);
  const ExpressionStyle style = {literal, [&](const std::string& name) { return "p[" + enumerators.at(name) + "]"; },
                                 true};
  std::vector<std::string> terms;
  for (const LawTerm& term : law.terms)
    if (term.along_motion == along) terms.push_back(written(term.value, style));
  return joined(terms, " +\n         ");
}

bool uses(const Expression& expression, const std::string& variable) {
  bool found = false;
  walk(expression, [&](const Expression& e) { found = found || (e.kind == Kind::variable && e.name == variable); });
  return found;
}

/// The variables as arguments of such a sum; unused ones have no name.
std::string arguments_of(const ForceLaw& law, bool along) {
  std::vector<std::string> arguments;
  for (const char* variable : {"q", "v", "u"}) {
    if (*variable == 'u' && !law.uses_command) continue;
    bool used = false;
    for (const LawTerm& term : law.terms) used = used || (term.along_motion == along && uses(term.value, variable));
    arguments.push_back(used ? std::string("const Dual& ") + variable : "const Dual&");
  }
  return joined(arguments, ", ");
}

/// Effects of the library with a similar influence on the motion.
std::string look_alikes(const ForceLaw& law) {
  std::set<std::string> names;
  for (const LawTerm& term : law.terms) {
    const bool q = uses(term.value, "q"), v = uses(term.value, "v"), u = uses(term.value, "u");
    if (term.along_motion) names.insert(q ? "position_friction" : "coulomb_friction");
    if (v) names.insert("viscous_friction");
    if (q && !term.along_motion) names.insert("joint_spring");
    if (u) names.insert("torque_gain");
    if (!(q || v || u || term.along_motion)) names.insert("joint_offset_torque");
  }
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back("\"" + name + "\"");
  return joined(quoted, ", ");
}

std::string declarations(const ForceLaw& law) {
  std::vector<std::string> all;
  for (const LawParameter& p : law.parameters)
    all.push_back(fmt::format("{{\"{}\", \"{}\", {}, {}, {}, Scale::{},\n                          \"{}\"}}", p.name,
                              p.unit, literal(p.default_value), literal(p.lower), literal(p.upper),
                              p.scale == Scale::logarithmic ? "logarithmic" : "linear", p.description));
  return joined(all, ",\n                         ");
}

std::string enumerators(const ForceLaw& law) {
  const std::map<std::string, std::string> names = enumerators_of(law);
  std::vector<std::string> all;
  for (const LawParameter& parameter : law.parameters) all.push_back(names.at(parameter.name));
  return joined(all, ", ");
}

std::string neutral_values(const ForceLaw& law) {
  std::vector<std::string> all;
  for (const LawParameter& parameter : law.parameters) all.push_back(literal(parameter.neutral));
  return joined(all, ", ");
}

bool has_terms(const ForceLaw& law, bool along) {
  return std::any_of(law.terms.begin(), law.terms.end(),
                     [&](const LawTerm& term) { return term.along_motion == along; });
}

/// The functions that compute the force.
std::string functions_of(const ForceLaw& law) {
  std::string text;
  if (has_terms(law, false))
    text += filled(kSmoothForce, {{"AND_COMMAND", law.uses_command ? ", with the actuator's command u" : ""},
                                  {"ARGUMENTS", arguments_of(law, false)},
                                  {"SUM", sum_of(law, false)}});
  if (has_terms(law, true))
    text += filled(kForceAlongMotion, {{"ARGUMENTS", arguments_of(law, true)}, {"SUM", sum_of(law, true)}});
  return text;
}

/// The lines that add it to a joint's load.
std::string calls_of(const ForceLaw& law) {
  const std::string u = law.uses_command ? ", u" : "";
  std::string text;
  if (has_terms(law, false))
    text += "    add_force_law(load, q, v, [&](const Dual& at, const Dual& speed) { return smooth_force(at, speed" + u +
            ", p); });\n";
  if (has_terms(law, true))
    text += "    add_force_along_motion(load, v, force_along_motion(q, v" + u + ", p).value);\n";
  return text;
}

}  // namespace

std::string filled(std::string text, const std::map<std::string, std::string>& with) {
  for (const auto& [word, content] : with) {
    const std::string mark = "@" + word + "@";
    for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + content.size()))
      text.replace(at, mark.size(), content);
  }
  return text;
}

std::string camel_case(const std::string& name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '_';
  }
  return result;
}

std::string effect_source(const std::string& name, const ForceLaw& law) {
  const bool u = law.uses_command;
  const std::string type = camel_case(name) + "Law";
  std::string text = filled(kSource, {{"FUNCTIONS", functions_of(law)},
                                      {"HOOKS", u ? kActuatorHooks : kJointHooks},
                                      {"STEP", u ? kActuatorStep : kJointStep}});  // these texts contain further marks
  return filled(text, {{"ADDED", calls_of(law)},
                       {"CLASS", type},
                       {"ENUMERATORS", enumerators(law)},
                       {"EQUATION", law.equation()},
                       {"FORMULA", law.text},
                       {"INDENT", std::string(type.size() + 19, ' ')},
                       {"KIND", u ? "actuator" : "joint"},
                       {"LOOK_ALIKES", look_alikes(law)},
                       {"NAME", name},
                       {"NEUTRAL", neutral_values(law)},
                       {"PARAMETERS", declarations(law)}});
}

std::string effect_project(const std::string& name) {
  return filled(R"(if(NOT TARGET lacuna::interface)  # a project of its own, outside of Lacuna's source tree
  cmake_minimum_required(VERSION 3.25)
  project(@NAME@ VERSION 1.0.0 LANGUAGES CXX)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  find_package(lacuna 0.1 REQUIRED)
  enable_testing()
endif()
lacuna_add_plugin(@NAME@ @NAME@.cpp)
lacuna_test_plugin(@NAME@)
)",
                {{"NAME", name}});
}

}  // namespace lacuna
