#include "search/find_missing.h"

#include "foundation/interrupt.h"
#include "search/set_order.h"
#include "search/slots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kSlots = 14;    ///< effects refitted alone
constexpr std::size_t kPairs = 6;     ///< refitted at once, of those that promise most together
constexpr std::size_t kToPairUp = 7;  ///< effects alone that are tried two at a time
constexpr std::size_t kFinishedPairs = 4;
constexpr std::size_t kParents = 4;         ///< of which further effects are looked for beside
constexpr std::size_t kPromisesBeside = 6;  ///< effects refitted beside each
constexpr std::size_t kFinishedBeside = 2;  ///< of these, fitted to all segments
constexpr std::size_t kTriples = 2;         ///< pairs beside which a third is looked for
constexpr double kOfAValue = 0.5;   ///< of what a value must gain: by so much simpler sets come first on the way
constexpr double kWorthAFit = 0.5;  ///< of what an effect must gain: a fit to all segments is made for
constexpr double kPresent = 2.0;    ///< standard errors by which the cost rises where an effect goes
constexpr double kSameCost = 1e-3;  ///< nats

constexpr double kFewSamples = 6000.0;  ///< of all rungs: with fewer, more sets are fitted
constexpr double kBroadest = 4.0;

/// How many times as many sets are fitted as to a long recording.
std::size_t breadth_of(const Ladder& ladder) {
  double samples = 1.0;
  for (const Segment& segment : all_segments(ladder)) samples += static_cast<double>(segment.stretch.size());
  return static_cast<std::size_t>(std::clamp(kFewSamples / samples, 1.0, kBroadest));
}

class SetSearch {
 public:
  explicit SetSearch(const Ground& ground) : ground_(ground), sets_(ground_), order_(sets_) {}

  Missing run() {
    say("the model as it is");
    breadth_ = breadth_of(ground_.ladder());
    bool stopped = false;
    try {
      expand("", kSlots, kParents + 2);
      grow(1, kParents);
      grow(2, kTriples);
    } catch (const TimeIsUp&) {
      lift_time_limit();
      stopped = true;
    }
    Missing missing = conclude();
    missing.stopped = stopped;
    return missing;
  }

 private:
  void say(const std::string& what) const {
    if (ground_.task().note) ground_.task().note(what);
  }
  std::string ratio(double cost, double to) const { return fmt::format("×{:.3f}", std::exp(cost - to)); }

  /// Refits the most promising effects beside a set.
  void expand(const std::string& name, std::size_t slots, std::size_t finished) {
    std::vector<std::string> fresh;
    const FittedSet parent = *sets_.find(name);
    Look look =
        look_beside(ground_, parent.model, parent.fit, name.empty() ? nullptr : &probes_, name.empty() ? kPairs : 0);
    if (name.empty()) {
      probes_ = look.probes;
      rough_base_ = look.cost;
    }
    say(name.empty() ? "looked beside the model" : "looked beside " + name);
    for (const Promise& promise : slots_of(look, parent.model.added, breadth_ * slots)) {
      const Hypothesis& hypothesis = look.hypotheses[promise.hypothesis];
      Contender model = parent.model;
      model.added.push_back(hypothesis.entry);
      if (sets_.find(name_of_set(model.added))) continue;
      throw_if_interrupted();
      model = with_effects(ground_.plain(), model.added, {}, ground_.task().catalog);
      const std::vector<double> without = hypothesis.values(parent.model.values, hypothesis.neutral);
      std::vector<Starts> ways{on_the_way(without, promise.values)};
      if (promise.plainly && *promise.plainly != promise.values) ways.push_back(on_the_way(without, *promise.plainly));
      sets_.fit(model, ways);
      fresh.push_back(name_of_set(model.added));
      say(fmt::format("  {} promises {}", fresh.back(), ratio(promise.cost, look.cost)));
    }
    for (const PairPromise& pair : look.pairs) fit_pair(look, pair, fresh);
    by_rough_cost(fresh);
    std::vector<std::string> different = fresh;
    keep_different(different, [&](const std::string& one) { return sets_.find(one)->rough.errors.cost; });
    finish_best(different, breadth_ * finished);
    if (!name.empty()) return;
    first_ = std::move(look);
    std::erase_if(different, [&](const std::string& one) { return sets_.find(one)->model.added.size() > 1; });
    finish_best(different, breadth_ * kParents);
    pair_up(different);
  }

  /// Fits the first of these to all segments, but for those that even there gain less than they must.
  void finish_best(const std::vector<std::string>& ordered, std::size_t most) {
    const double gain = order_.largest_gain();
    for (std::size_t i = 0; i < std::min(ordered.size(), most); ++i) {
      const FittedSet& set = *sets_.find(ordered[i]);
      double before = rough_base_;
      for (std::size_t one = 0; set.model.added.size() > 1 && one < set.model.added.size(); ++one) {
        std::vector<EffectEntry> less = set.model.added;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(one));
        if (const FittedSet* smaller = sets_.find(name_of_set(less)))
          before = std::min(before, smaller->rough.errors.cost);
      }
      const bool promising = before - set.rough.errors.cost > kWorthAFit * kRelevant * gain;
      if (promising || i == 0) finish(ordered[i]);
    }
  }

  static void own_at_rest(const Hypothesis& hypothesis, const std::string& id, std::map<std::string, double>& values) {
    for (std::size_t i = 0; i < hypothesis.own.size(); ++i) {
      const std::string& address = hypothesis.definition.free[hypothesis.own[i]].address;
      values["effect." + id + address.substr(address.rfind('.'))] = hypothesis.neutral[i];
    }
  }

  /// Starts a part of the way from a model without an effect to what is promised, and there.
  static Starts on_the_way(const std::vector<double>& without, const std::vector<double>& promised) {
    Starts starts;
    for (const double part : {1.0, 0.5, 0.1}) {
      starts.push_back(promised);
      for (std::size_t i = 0; i < without.size(); ++i)
        starts.back()[i] = without[i] + part * (promised[i] - without[i]);
    }
    return starts;
  }

  void fit_pair(const Look& look, const PairPromise& pair, std::vector<std::string>& fresh) {
    const Hypothesis &one = look.hypotheses[pair.one], &other = look.hypotheses[pair.other];
    std::vector<EffectEntry> added{one.entry, other.entry};
    if (sets_.find(name_of_set(added))) return;
    added.back().id = one.entry.effect == other.entry.effect ? other.entry.id + "_2" : other.entry.id;
    const Contender model = with_effects(ground_.plain(), added, {}, ground_.task().catalog);
    std::map<std::string, double> known;
    for (std::size_t i = 0; i < one.base.size(); ++i) known[one.definition.free[one.base[i]].address] = pair.base[i];
    const auto own = [&](const Hypothesis& hypothesis, const std::string& id, const std::vector<double>& values) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string& address = hypothesis.definition.free[hypothesis.own[i]].address;
        known["effect." + id + address.substr(address.rfind('.'))] = values[i];
      }
    };
    own(one, added.front().id, pair.of_one);
    own(other, added.back().id, pair.of_other);
    std::map<std::string, double> neutral;
    own_at_rest(one, added.front().id, neutral);
    own_at_rest(other, added.back().id, neutral);
    std::vector<double> start, without;
    for (const FreeValue& free : model.definition.free) {
      start.push_back(known.at(free.address));
      without.push_back(neutral.contains(free.address) ? neutral.at(free.address) : start.back());
    }
    if (ground_.timing()) start.push_back(pair.base.back());
    sets_.fit(model, {on_the_way(without, start)});
    fresh.push_back(name_of_set(added));
    say(fmt::format("  {} promise {}", fresh.back(), ratio(pair.cost, look.cost)));
  }

  /// Values of a set's effects by address, and where asked for of the model's own.
  static void take_values(const FittedSet& set, bool own, std::map<std::string, double>& values) {
    for (std::size_t i = 0; i < set.model.definition.free.size(); ++i) {
      const std::string& address = set.model.definition.free[i].address;
      if (own || address.starts_with("effect.")) values[address] = set.model.values[i];
    }
  }

  /// Two effects that were fitted alone, beside each other.
  void fit_both(const FittedSet& better, const FittedSet& other, std::vector<std::string>& fresh) {
    std::vector<EffectEntry> added{better.model.added.front(), other.model.added.front()};
    if (sets_.find(name_of_set(added)) || added.front().effect == added.back().effect) return;
    const Contender model = with_effects(ground_.plain(), added, {}, ground_.task().catalog);
    std::map<std::string, double> values;
    take_values(better, true, values);
    take_values(other, false, values);
    std::vector<double> start;
    for (const FreeValue& free : model.definition.free) start.push_back(values.at(free.address));
    if (ground_.timing()) start.push_back(better.model.values.back());
    Starts starts;
    for (const double part : {0.5, 1.0, 0.1}) {  // of what either is alone
      starts.push_back(start);
      for (std::size_t i = 0; i < model.definition.free.size(); ++i)
        if (model.definition.free[i].address.starts_with("effect.") && model.definition.free[i].scale == Scale::linear)
          starts.back()[i] *= part;
    }
    sets_.fit(model, {starts});
    fresh.push_back(name_of_set(added));
    say("  both: " + fresh.back());
  }

  const Hypothesis& first_named(const std::string& name) const {
    return *std::find_if(first_.hypotheses.begin(), first_.hypotheses.end(),
                         [&](const Hypothesis& one) { return name_of_set({one.entry}) == name; });
  }

  /// Of effects alone in the order of their costs the first of each kind at a place.
  std::vector<std::string> one_of_a_kind(const std::vector<std::string>& alone, std::size_t most) const {
    std::vector<std::string> chosen;
    for (const std::string& name : alone) {
      if (chosen.size() == most) break;
      const bool stands_for_another = std::any_of(chosen.begin(), chosen.end(), [&](const std::string& other) {
        return are_alike(first_named(name), first_named(other)) && same_place(first_named(name), first_named(other));
      });
      if (!stands_for_another) chosen.push_back(name);
    }
    return chosen;
  }

  /// The best effects alone, two at a time: what is missing may show in neither of them alone.
  void pair_up(const std::vector<std::string>& alone) {
    std::vector<std::string> fresh;
    const std::vector<std::string> chosen = one_of_a_kind(alone, kToPairUp * breadth_);
    for (std::size_t i = 0; i < chosen.size(); ++i)
      for (std::size_t j = i + 1; j < chosen.size(); ++j) {
        throw_if_interrupted();
        const FittedSet one = *sets_.find(chosen[i]), other = *sets_.find(chosen[j]);
        fit_both(one, other, fresh);
      }
    by_rough_cost(fresh);
    finish_best(fresh, breadth_ * kFinishedPairs);
  }

  /// Of names in the order of a cost, those whose cost is another one's: models that do the same cost the same.
  template <class Cost>
  static void keep_different(std::vector<std::string>& names, const Cost& cost) {
    const auto same = [&](const std::string& a, const std::string& b) { return cost(b) - cost(a) < kSameCost; };
    names.erase(std::unique(names.begin(), names.end(), same), names.end());
  }

  /// Of effects that do the same, one at a joint comes first: far less than any difference that matters.
  static double far_from_joints(const FittedSet& set) {
    double elsewhere = 0.0;
    for (const EffectEntry& entry : set.model.added)
      if (entry.where.empty() || !entry.where.front().starts_with("joint.")) elsewhere += 1.0;
    return 0.2 * kSameCost * elsewhere;
  }

  /// By what they cost on some of the segments, with a little for each value, so that rich laws do not come first.
  void by_rough_cost(std::vector<std::string>& names) const {
    double least = rough_base_;
    for (const std::string& name : names) least = std::min(least, sets_.find(name)->rough.errors.cost);
    const auto cost = [&](const std::string& name) {
      const FittedSet& set = *sets_.find(name);
      if (!set.rough.errors.valid) return std::numeric_limits<double>::infinity();
      return far_from_joints(set) + set.rough.errors.cost +
             kOfAValue * kRelevant * (rough_base_ - least) * static_cast<double>(set.model.values.size());
    };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return cost(a) < cost(b); });
  }

  void finish(const std::string& name) {
    const FittedSet& set = sets_.finish(name);
    say(fmt::format("    {}: {} fitted, {} where not fitted", name,
                    ratio(set.fit.errors.cost, ground_.fit().errors.cost), ratio(set.cross.cost, cross_of(""))));
  }

  /// Looks for a further effect beside the best sets of a size, as long as those are better than smaller ones.
  void grow(std::size_t size, std::size_t parents) {
    std::vector<std::string> names = order_.best_of(size, 4 * parents);
    keep_different(names,
                   [&](const std::string& name) { return order_.with_size(*sets_.find(name), order_.largest_gain()); });
    if (names.size() > parents) names.resize(parents);
    const std::vector<std::string> smaller = order_.best_of(size - 1, 1);
    const double gain = order_.largest_gain();
    for (const std::string& name : names)
      if (size == 1 || cross_of(smaller.front()) - cross_of(name) > kRelevant * gain)
        expand(name, kPromisesBeside, kFinishedBeside);
  }
  double cross_of(const std::string& name) const { return sets_.find(name)->cross.cost; }

  /// Fits what is left of a set when one member goes, where that was not fitted yet.
  void drop_members(const FittedSet& full) {
    for (std::size_t i = 0; i < full.model.added.size(); ++i) {
      std::vector<EffectEntry> added = full.model.added;
      added.erase(added.begin() + static_cast<std::ptrdiff_t>(i));
      if (!sets_.find(name_of_set(added))) {
        Contender less = without(full.model, i, ground_.plain(), ground_.task().catalog);
        if (ground_.timing()) less.values.push_back(full.model.values.back());
        sets_.fit(less, {{less.values}});
        say("  without one: " + name_of_set(added));
      }
      sets_.finish(name_of_set(added));
    }
  }

  RankedSet ranked(const std::string& name, const FittedSet& answer) const {
    const FittedSet& set = *sets_.find(name);
    RankedSet one{set.model,
                  set.cross.covariance,
                  set.cross.cost,
                  set.fit.errors,
                  {},
                  difference(answer, set),
                  difference(set, *sets_.find(""))};
    const MissingTask& task = ground_.task();
    const ModelBench bench(set.model.definition, *set.model.model, task.trials, ground_.timing(), task.threads);
    one.held_out = errors_on(ground_.ladder_for(bench, true), bench.predictor(), bench.space(), set.model.values);
    return one;
  }

  /// Whether each member is needed: without it the cost is higher by more than its error.
  bool all_present(const FittedSet& set) {
    drop_members(set);
    for (std::size_t i = 0; i < set.model.added.size(); ++i) {
      std::vector<EffectEntry> others = set.model.added;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const FittedSet* without = sets_.find(name_of_set(others));
      if (!without || !without->fit.errors.valid) continue;
      const CostDifference worth = difference(set, *without);
      if (!(worth.nats > kPresent * worth.error)) return false;
    }
    return true;
  }

  Missing conclude() {
    Missing missing;
    missing.ladder = ground_.ladder();
    std::vector<std::string> names;
    for (std::size_t size = 0; size <= 3; ++size)
      for (const std::string& name : order_.best_of(size, 8)) names.push_back(name);
    std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
      return sets_.find(a)->cross.cost < sets_.find(b)->cross.cost;
    });
    const double gain = std::max(0.0, cross_of("") - cross_of(names.front()));  // of those, which the data tell
    std::vector<std::string> order = names;
    std::stable_sort(order.begin(), order.end(), [&](const std::string& a, const std::string& b) {
      return order_.with_size(*sets_.find(a), gain) < order_.with_size(*sets_.find(b), gain);
    });
    const FittedSet* answer = sets_.find("");
    for (const std::string& name : order) {
      answer = sets_.find(name);
      if (all_present(*answer)) break;
    }
    missing.base = ranked("", *answer);
    for (const std::string& name : names) {
      if (sets_.find(name) == answer) missing.answer = missing.ranking.size();
      missing.ranking.push_back(ranked(name, *answer));
    }
    std::optional<std::string> nearest;
    for (const auto& [name, set] : sets_.all()) {
      for (const EffectEntry& entry : set.model.added) missing.examined.insert(name_of_set({entry}));
      if (!does_the_same(set, *answer)) continue;
      missing.alike.merge(effects_of(set));
      if (!nearest || set.rough.errors.cost < sets_.find(*nearest)->rough.errors.cost) nearest = name;
    }
    if (nearest && sets_.finish(*nearest).fit.errors.valid) missing.look_alike = ranked(*nearest, *answer);
    for (const std::string& name : effects_of(*answer)) missing.alike.erase(name);
    missing.refits = sets_.refits();
    missing.hypotheses = first_.hypotheses.size();
    missing.untestable = first_.untestable;
    missing.timing = ground_.timing();
    return missing;
  }

  const Ground& ground_;
  ModelSets sets_;
  SetOrder order_;
  std::size_t breadth_ = 1;
  KnownProbes probes_;  ///< of the first look
  Look first_;
  double rough_base_ = 0.0;  ///< of the model as it is, on some of the segments
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

Missing find_missing(const Ground& ground) { return SetSearch(ground).run(); }

}  // namespace lacuna
