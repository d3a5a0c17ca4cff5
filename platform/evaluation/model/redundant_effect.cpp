#include "evaluation/model/redundant_effect.h"

#include "evaluation/model/robot_values.h"
#include "foundation/address.h"
#include "storage/core/canonical_text.h"

#include <lacuna/physical_effect.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSomewhere = 0.382;  ///< of a parameter's range
constexpr double kRounding = 1e-12;

bool close(double a, double b) { return a == b || std::abs(a - b) <= kRounding * (std::abs(a) + std::abs(b)); }

bool is_free(const ModelDefinition& model, const std::string& address) {
  return std::any_of(model.free.begin(), model.free.end(),
                     [&](const FreeValue& one) { return one.address == address; });
}

/// The free parameters at values within their ranges, the others as they are. Empty: none is free.
std::vector<double> values_somewhere(const ModelDefinition& model, const PlacedEffect& placed) {
  const std::vector<ParameterDeclaration> parameters =
      guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); }).parameters;
  std::vector<double> values = placed.values;
  bool any = false;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const FreeValue& free : model.free) {
      if (free.address != effect_address(placed.id, parameters[i].name)) continue;
      values[i] = std::lerp(free.lower, free.upper, kSomewhere);
      any = true;
    }
  return any ? values : std::vector<double>{};
}

/// Free values with which the robot equals the amended one. Empty: there are none.
std::vector<std::string> free_values_that_do(const ModelDefinition& model, RobotSpec amended) {
  RobotSpec robot = model.structure.robot;
  std::vector<AddressedValue> own = addressed_values(robot);
  const std::vector<AddressedValue> wanted = addressed_values(amended);
  std::vector<std::string> addresses;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (close(*own[i].value, *wanted[i].value)) continue;
    if (!is_free(model, own[i].address)) continue;
    assign_value(robot, own[i], *wanted[i].value);
    addresses.push_back(own[i].address);
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!close(*own[i].value, *wanted[i].value)) return {};
    *own[i].value = *wanted[i].value;
  }
  return canonical_text(robot) == canonical_text(amended) ? addresses : std::vector<std::string>{};
}

}  // namespace

std::string redundancy_of(const ModelDefinition& model, const std::string& id) {
  const std::vector<PlacedEffect>& effects = model.structure.effects;
  const auto placed =
      std::find_if(effects.begin(), effects.end(), [&](const PlacedEffect& one) { return one.id == id; });
  if (placed == effects.end()) return "";
  const EffectHooks hooks = guarded_call(origin_of(*placed), "stages", [&] { return placed->effect->hooks(); });
  if (!hooks.amends_robot || hooks.add_loads || hooks.advance || hooks.command != CommandStage::none ||
      hooks.sensor != SensorStage::none)
    return "";
  const std::vector<double> values = values_somewhere(model, *placed);
  if (values.empty()) return "";
  RobotSpec amended = model.structure.robot;
  guarded_call(origin_of(*placed), "amend", [&] {
    placed->effect->amend(amended, {values, placed->elements, placed->kind, model.engine.step});
  });
  const std::vector<std::string> addresses = free_values_that_do(model, std::move(amended));
  if (addresses.empty()) return "";
  return fmt::format(
      "{} has the same influence as {}, which is a free value of the model: data determine only both together; remove "
      "one of them",
      placed->name, fmt::join(addresses, ", "));
}

}  // namespace lacuna
