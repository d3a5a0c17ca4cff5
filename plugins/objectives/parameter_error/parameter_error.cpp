#include <lacuna/error.h>
#include <lacuna/objective_metric.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace lacuna {

/// Errors of a model's free parameters against the hidden ones: |value − truth| for each by its address, and the mean
/// for each group of parameters of at least two elements, by the address with `*` for the element. With optional
/// effects also `effects`: how many of these are on and not in the target, or off and in it.
class ParameterError : public ObjectiveMetric {
 public:
  std::string summary() const override;
  /// Left out are parameters whose truth is NaN, parameters of effects that the model does not have, groups whose
  /// members have different units, and, in the count, optional effects without a free parameter, which the truth does
  /// not cover. Throws `Error` where model or truth do not match the space.
  std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model, const HiddenTruth& truth,
                                    std::span<const double> parameters) const override;
};

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

enum class Presence : unsigned char { absent, present, cannot_tell };

/// Whether the target has an effect: it does where it has one of its parameters.
Presence in_target(const ModelEffect& effect, std::span<const double> truth) {
  if (effect.values.empty()) return Presence::cannot_tell;
  const bool any =
      std::any_of(effect.values.begin(), effect.values.end(), [&](std::size_t i) { return !std::isnan(truth[i]); });
  return any ? Presence::present : Presence::absent;
}

/// Number of optional effects that are on but not in the target, or off but in it; nothing where none can be compared.
std::optional<ObjectiveScore> wrong_effects(const ModelSpace& space, const ModelProposal& model,
                                            std::span<const double> truth) {
  ObjectiveScore wrong{"effects", "1", 0.0};
  bool any = false;
  for (std::size_t i = 0; i < space.effects.size(); ++i) {
    const Presence target = in_target(space.effects[i], truth);
    if (!space.effects[i].optional || target == Presence::cannot_tell) continue;
    any = true;
    const bool on = !std::binary_search(model.without.begin(), model.without.end(), i);
    if (on != (target == Presence::present)) wrong.value += 1.0;
  }
  return any ? std::optional(wrong) : std::nullopt;
}

/// For each free parameter whether the model has it.
std::vector<bool> present_values(const ModelSpace& space, const ModelProposal& model) {
  std::vector<bool> present(space.free.size(), true);
  for (const std::size_t effect : model.without)
    for (const std::size_t value : space.effects.at(effect).values) present.at(value) = false;
  return present;
}

}  // namespace

std::string ParameterError::summary() const {
  return "value - truth| of each free parameter, its mean for each kind of parameter, and the number of wrong effects";
}

std::vector<ObjectiveScore> ParameterError::score(const ModelSpace& space, const ModelProposal& model,
                                                  const HiddenTruth& hidden, std::span<const double>) const {
  const std::span<const double> truth = hidden.values;
  if (model.values.size() != space.free.size() || truth.size() != space.free.size())
    throw Error("a model of " + std::to_string(model.values.size()) + " values and a truth of " +
                std::to_string(truth.size()) + " do not match " + std::to_string(space.free.size()) +
                " free parameters");
  const std::vector<bool> present = present_values(space, model);
  std::vector<ObjectiveScore> scores;
  std::vector<Group> groups;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (std::isnan(truth[i]) || !present[i]) continue;
    scores.push_back({space.free[i].address, space.free[i].unit, std::abs(model.values[i] - truth[i])});
    add(groups, scores.back());
  }
  for (const Group& group : groups)
    if (group.members >= 2 && group.one_unit) scores.push_back({group.name, group.unit, group.sum / group.members});
  if (const auto wrong = wrong_effects(space, model, truth)) scores.push_back(*wrong);
  return scores;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ObjectiveMetric, lacuna::ParameterError>("parameter_error"))
