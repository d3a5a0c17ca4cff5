#include "evaluation/model/hidden_truth.h"

#include "foundation/address.h"

#include <lacuna/random_stream.h>

#include <array>
#include <limits>
#include <map>
#include <string>

namespace lacuna {
namespace {

/// Every number of the target that has an address.
std::map<std::string, double> values_by_address(const ModelDefinition& target, const std::vector<double>& hidden) {
  std::map<std::string, double> values;
  RobotSpec robot = target.structure.robot;
  for (const AddressedValue& value : addressed_values(robot)) values[value.address] = *value.value;
  for (const EffectEntry& effect : target.effects)
    for (const auto& [parameter, value] : effect.start) values[effect_address(effect.id, parameter)] = value;
  for (std::size_t i = 0; i < target.free.size(); ++i) values[target.free[i].address] = hidden[i];
  return values;
}

}  // namespace

std::vector<double> draw_hidden_values(const ModelDefinition& target, const SimulatedSource& source, int replicate) {
  const auto draw = static_cast<std::uint64_t>(source.redraw == Redraw::replicate ? replicate : 0);
  std::vector<double> hidden;
  for (const FreeValue& value : target.free) {
    RandomStream random(std::array<std::uint64_t, 3>{source.hidden_seed, draw, hidden.size()});
    hidden.push_back(random.uniform(value.lower, value.upper));
  }
  return hidden;
}

std::vector<double> true_values(const ModelDefinition& model, const ModelDefinition& target,
                                const std::vector<double>& hidden) {
  const std::map<std::string, double> known = values_by_address(target, hidden);
  std::vector<double> values;
  for (const FreeValue& free : model.free) {
    const auto found = known.find(free.address);
    values.push_back(found == known.end() ? std::numeric_limits<double>::quiet_NaN() : found->second);
  }
  return values;
}

}  // namespace lacuna
