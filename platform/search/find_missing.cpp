#include "search/find_missing.h"

#include "search/set_order.h"
#include "search/set_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kPresent = 2.0;  ///< standard errors by which the cost rises where an effect goes
constexpr std::size_t kMostSets = 16;
constexpr double kWorse = 0.05;  ///< nats of held-out predictions by which an effect that makes them worse is left out

/// What follows from sets that are fitted to all segments.
class Conclusion {
 public:
  Conclusion(const Ground& ground, ModelSets& sets) : ground_(ground), sets_(sets), order_(sets.all(), Segments::all) {}

  Missing conclude() {
    Missing missing;
    const FittedSet& answer = confirmed(choose(), missing.not_confirmed);
    missing.ladder = ground_.ladder();
    missing.base = ranked("", answer);
    for (const std::string& name : by_cost(answer)) {
      if (sets_.find(name) == &answer) missing.answer = missing.ranking.size();
      missing.ranking.push_back(ranked(name, answer));
    }
    find_alike(answer, missing);
    missing.refits = sets_.refits();
    missing.timing = ground_.timing();
    return missing;
  }

 private:
  /// The first in the order whose members are all needed.
  const FittedSet& choose() {
    std::set<std::string> rejected;
    for (;;) {
      const std::vector<std::string> names = order_.ordered();  // what is left of a rejected set is among them
      const auto next =
          std::find_if(names.begin(), names.end(), [&](const std::string& name) { return !rejected.contains(name); });
      if (next == names.end()) return sets_.base();
      if (all_present(*sets_.find(*next))) return *sets_.find(*next);
      rejected.insert(*next);
    }
  }

  static std::vector<EffectEntry> others_than(const FittedSet& set, std::size_t member) {
    std::vector<EffectEntry> others = set.model.added;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(member));
    return others;
  }

  /// What is left of a set when one member goes, fitted to all segments.
  const FittedSet& without_member(const FittedSet& set, std::size_t member) {
    const std::string name = name_of_set(others_than(set, member));
    if (!sets_.find(name)) {
      Contender less = without(set.model, member, ground_.plain(), ground_.task().catalog);
      if (ground_.timing()) less.values.push_back(set.model.values.back());
      sets_.fit(less, {{less.values}});
      if (ground_.task().note) ground_.task().note("  without one: " + name);
    }
    return sets_.finish(name);
  }

  /// Whether each member is needed: without it the cost is higher by more than its error.
  bool all_present(const FittedSet& set) {
    for (std::size_t i = 0; i < set.model.added.size(); ++i) {
      const FittedSet& less = without_member(set, i);
      if (!less.all.valid()) continue;
      const CostDifference worth = difference(set.all, less.all);
      if (!(worth.nats > kPresent * worth.error)) return false;
    }
    return true;
  }

  /// What is left of an answer of several effects without those that make predictions of held-out recordings worse:
  /// what is missing helps there, too.
  const FittedSet& confirmed(const FittedSet& answer, std::vector<NotConfirmed>& left_out) {
    const FittedSet* set = &answer;
    while (set->model.added.size() > 1) {
      const HorizonErrors with_all = held_out(*set);
      if (!with_all.valid) break;
      const FittedSet* best = nullptr;
      std::size_t worst = 0;
      double least = with_all.cost - kWorse;
      for (std::size_t i = 0; i < set->model.added.size(); ++i) {
        const FittedSet& less = without_member(*set, i);
        const HorizonErrors errors = less.all.valid() ? held_out(less) : HorizonErrors();
        if (errors.valid && errors.cost < least) least = errors.cost, best = &less, worst = i;
      }
      if (!best) break;
      const double base = held_out(sets_.base()).cost;
      left_out.push_back(
          {name_of_set({set->model.added[worst]}), std::exp(with_all.cost - base), std::exp(least - base)});
      set = best;
    }
    return *set;
  }

  HorizonErrors held_out(const FittedSet& set) const { return held_out_errors(ground_, set.model); }

  /// Names, the least cost first; the answer's among them, and the model's as it is.
  std::vector<std::string> by_cost(const FittedSet& answer) const {
    std::vector<std::string> names = order_.ordered();
    if (names.size() > kMostSets) names.resize(kMostSets);
    for (const std::string& name : {name_of_set(answer.model.added), std::string()})
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return order_.cost(a) < order_.cost(b); });
    return names;
  }

  RankedSet ranked(const std::string& name, const FittedSet& answer) const {
    const FittedSet& set = *sets_.find(name);
    const JudgedFit& fit = set.all;
    return {set.model,
            fit.cross.covariance,
            fit.cross.cost,
            fit.fit.errors,
            held_out(set),
            difference(answer.all, fit),
            difference(fit, sets_.base().all)};
  }

  void find_alike(const FittedSet& answer, Missing& missing) {
    std::optional<std::string> nearest;
    for (const auto& [name, set] : sets_.all()) {
      for (const EffectEntry& entry : set.model.added) missing.examined.insert(name_of_set({entry}));
      if (!does_the_same(set, answer)) continue;
      missing.alike.merge(effects_of(set));
      if (!nearest || set.few.errors.cost < sets_.find(*nearest)->few.errors.cost) nearest = name;
    }
    for (const std::string& name : effects_of(answer)) missing.alike.erase(name);
    if (nearest && sets_.finish(*nearest).all.valid()) missing.look_alike = ranked(*nearest, answer);
  }

  const Ground& ground_;
  ModelSets& sets_;
  const SetOrder order_;
};

}  // namespace

double times_floor(const Ladder& ladder, const HorizonErrors& errors) {
  double sum = 0.0, weights = 0.0;
  for (std::size_t r = 0; r < ladder.rungs.size(); ++r)
    for (std::size_t c = 0; c < ladder.channels.size(); ++c) {
      const double weight = errors.weight[r][c];
      if (weight > 0.0) sum += weight * 0.5 * std::log(errors.mean_square[r][c] / ladder.rungs[r].floor[c]);
      weights += weight;
    }
  return weights > 0.0 ? std::exp(sum / weights) : std::numeric_limits<double>::quiet_NaN();
}

double most_times_floor(const Ladder& ladder, const HorizonErrors& errors) {
  double most = 0.0;
  for (std::size_t r = 0; r < ladder.rungs.size(); ++r)
    for (std::size_t c = 0; c < ladder.channels.size(); ++c)
      if (errors.weight[r][c] > 0.0)
        most = std::max(most, std::sqrt(errors.mean_square[r][c] / ladder.rungs[r].floor[c]));
  return most;
}

Missing find_missing(const Ground& ground) {
  ModelSets sets(ground);
  const SearchedLibrary searched = search_sets(ground, sets);
  Missing missing = Conclusion(ground, sets).conclude();
  missing.stopped = searched.stopped;
  missing.hypotheses = searched.hypotheses;
  missing.untestable = searched.untestable;
  return missing;
}

}  // namespace lacuna
