#include "search/set_starts.h"

#include <map>

namespace lacuna {
namespace {

using ValuesByAddress = std::map<std::string, double>;

/// Starts a part of the way from a model without an effect to what is promised, and there.
Starts on_the_way(const std::vector<double>& without, const std::vector<double>& promised) {
  Starts starts;
  for (const double part : {1.0, 0.5, 0.1}) {
    starts.push_back(promised);
    for (std::size_t i = 0; i < without.size(); ++i) starts.back()[i] = without[i] + part * (promised[i] - without[i]);
  }
  return starts;
}

/// Addresses of an effect's values begin with its name in the set, and end with the parameter's.
void take_own(const Hypothesis& hypothesis, const std::string& id, const std::vector<double>& own,
              ValuesByAddress& values) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::string& address = hypothesis.definition.free[hypothesis.own[i]].address;
    values["effect." + id + address.substr(address.rfind('.'))] = own[i];
  }
}

bool is_of_effect(const FreeValue& free) { return free.address.starts_with("effect."); }

/// Values of a set's effects, and where asked for of the model's own.
void take_values(const FittedSet& set, bool own, ValuesByAddress& values) {
  for (std::size_t i = 0; i < set.model.definition.free.size(); ++i)
    if (const FreeValue& free = set.model.definition.free[i]; own || is_of_effect(free))
      values[free.address] = set.model.values[i];
}

}  // namespace

StartedSet with_promised(const Ground& ground, const FittedSet& parent, const Look& look, const Promise& promise) {
  const Hypothesis& hypothesis = look.hypotheses[promise.hypothesis];
  std::vector<EffectEntry> added = parent.model.added;
  added.push_back(hypothesis.entry);
  StartedSet set{with_effects(ground.plain(), added, {}, ground.task().catalog), {}};
  const std::vector<double> without = hypothesis.values(parent.model.values, hypothesis.neutral);
  set.ways.push_back(on_the_way(without, promise.values));
  if (promise.plainly && *promise.plainly != promise.values) set.ways.push_back(on_the_way(without, *promise.plainly));
  return set;
}

StartedSet with_promised(const Ground& ground, const Look& look, const PairPromise& pair) {
  const Hypothesis &one = look.hypotheses[pair.one], &other = look.hypotheses[pair.other];
  std::vector<EffectEntry> added{one.entry, other.entry};
  if (one.entry.effect == other.entry.effect) added.back().id = other.entry.id + "_2";
  StartedSet set{with_effects(ground.plain(), added, {}, ground.task().catalog), {}};
  ValuesByAddress there;
  for (std::size_t i = 0; i < one.base.size(); ++i) there[one.definition.free[one.base[i]].address] = pair.base[i];
  ValuesByAddress rest = there;
  take_own(one, added.front().id, pair.of_one, there);
  take_own(other, added.back().id, pair.of_other, there);
  take_own(one, added.front().id, one.neutral, rest);
  take_own(other, added.back().id, other.neutral, rest);
  std::vector<double> promised, without;
  for (const FreeValue& free : set.model.definition.free) {
    promised.push_back(there.at(free.address));
    without.push_back(rest.at(free.address));
  }
  if (ground.timing()) promised.push_back(pair.base.back());
  set.ways.push_back(on_the_way(without, promised));
  return set;
}

StartedSet with_both(const Ground& ground, const FittedSet& better, const FittedSet& other) {
  StartedSet set{
      with_effects(ground.plain(), {better.model.added.front(), other.model.added.front()}, {}, ground.task().catalog),
      {}};
  ValuesByAddress values;
  take_values(better, true, values);
  take_values(other, false, values);
  std::vector<double> start;
  for (const FreeValue& free : set.model.definition.free) start.push_back(values.at(free.address));
  if (ground.timing()) start.push_back(better.model.values.back());
  Starts starts;
  for (const double part : {0.5, 1.0, 0.1}) {  // of what either is alone
    starts.push_back(start);
    for (std::size_t i = 0; i < set.model.definition.free.size(); ++i)
      if (const FreeValue& free = set.model.definition.free[i]; is_of_effect(free) && free.scale == Scale::linear)
        starts.back()[i] *= part;
  }
  set.ways.push_back(std::move(starts));
  return set;
}

StartedSet with_simpler(const Ground& ground, const FittedSet& set, std::size_t member, const Hypothesis& simpler) {
  std::vector<EffectEntry> added = set.model.added;
  const std::string old_id = added[member].id;
  added[member] = simpler.entry;
  ValuesByAddress values;
  take_values(set, true, values);
  ValuesByAddress of_other = values;
  take_own(simpler, simpler.entry.id, simpler.defaults, values);
  for (const auto& [address, value] : of_other)
    if (const std::string same = "effect." + simpler.entry.id + address.substr(address.rfind('.'));
        address.starts_with("effect." + old_id + ".") && values.contains(same))
      values[same] = value;
  StartedSet started{with_effects(ground.plain(), added, {}, ground.task().catalog), {}};
  std::vector<double> start;
  for (const FreeValue& free : started.model.definition.free) start.push_back(values.at(free.address));
  if (ground.timing()) start.push_back(set.model.values.back());
  started.ways.push_back({start});
  return started;
}

}  // namespace lacuna
