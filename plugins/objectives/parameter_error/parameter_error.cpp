#include "parameter_error.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

struct Group {
  std::string name;  // body.*.mass
  std::string unit;
  bool one_unit = true;
  int members = 0;
  double sum = 0.0;
};

/// Empty for an address without an element.
std::string group_name(const std::string& address) {
  const std::size_t first = address.find('.'), last = address.rfind('.');
  return first == last ? "" : address.substr(0, first) + ".*" + address.substr(last);
}

void add(std::vector<Group>& groups, const ObjectiveScore& score) {
  const std::string name = group_name(score.name);
  if (name.empty()) return;
  auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& other) { return other.name == name; });
  if (group == groups.end()) group = groups.insert(groups.end(), {name, score.unit});
  group->one_unit = group->one_unit && group->unit == score.unit;
  ++group->members;
  group->sum += score.value;
}

}  // namespace

std::string ParameterError::summary() const {
  return "|value - truth| of each free parameter, and its mean for each kind of parameter";
}

std::vector<ObjectiveScore> ParameterError::score(const ModelSpace& space, const ModelProposal& model,
                                                  const HiddenTruth& hidden, std::span<const double>) const {
  const std::span<const double> truth = hidden.values;
  if (model.values.size() != space.free.size() || truth.size() != space.free.size())
    throw Error("a model of " + std::to_string(model.values.size()) + " values and a truth of " +
                std::to_string(truth.size()) + " do not fit " + std::to_string(space.free.size()) + " free parameters");
  std::vector<ObjectiveScore> scores;
  std::vector<Group> groups;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (std::isnan(truth[i])) continue;
    scores.push_back({space.free[i].address, space.free[i].unit, std::abs(model.values[i] - truth[i])});
    add(groups, scores.back());
  }
  for (const Group& group : groups)
    if (group.members >= 2 && group.one_unit) scores.push_back({group.name, group.unit, group.sum / group.members});
  return scores;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ObjectiveMetric, lacuna::ParameterError>("parameter_error"))
