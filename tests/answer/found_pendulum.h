#pragma once

#include "criterion/value_errors.h"
#include "residual_law/pendulum_data.h"
#include "search/effect_search.h"

#include <string>
#include <vector>

namespace lacuna {

/// What a search of recordings of the pendulum would have found, had it fitted the model as it is and that with each of
/// these effects on its hinge. The decision is left to the test.
struct FoundPendulum {
  explicit FoundPendulum(std::vector<Trial> trials, const std::vector<std::string>& effects = {})
      : data(std::move(trials)) {
    found.data = data.shared();
    found.layout = data.data().deciding().layout;
    add(data.fitted().model);
    for (const std::string& effect : effects) {
      const EffectEntry entry{
          .id = effect + "_added1", .effect = effect, .where = {"joint.hinge"}, .start = {}, .fixed = {}};
      FittedModel with = data.fitted(with_effects(data.data().plain(), {entry}, {}, built_catalog())).model;
      with.judged.members = {effect + " @ joint.hinge"};
      add(std::move(with));
    }
  }

  /// With this set as the answer.
  SearchResult decided(std::size_t answer) const {
    SearchResult result = found;
    result.decision.answer = result.decision.best = answer;
    result.decision.p = 0.001;
    result.decision.gain = gain_of(found.sets[answer].judged, found.sets[0].judged);
    result.decision.whole_gain = result.decision.gain.nats;
    return result;
  }

  PendulumData data;
  SearchResult found;

 private:
  void add(FittedModel set) {
    const LinearCost least = least_cost(found.layout, set.fit.products, set.fit.bounds);
    set.judged.cost = cross_fit(found.layout, set.fit.products, set.fit.bounds, least);
    set.judged.mean_square = least.mean_square;
    set.judged.told = static_cast<int>(set.judged.members.size());
    found.sets.push_back(std::move(set));
  }
};

}  // namespace lacuna
