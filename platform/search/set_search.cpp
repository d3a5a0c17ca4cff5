#include "search/set_search.h"

#include "foundation/figure_text.h"
#include "foundation/interrupt.h"
#include "search/set_order.h"
#include "search/set_starts.h"
#include "search/slots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kSlots = 12;          ///< effects fitted alone
constexpr std::size_t kPairs = 4;           ///< fitted at once, of those that promise most together
constexpr std::size_t kToPairUp = 6;        ///< effects alone that are tried two at a time
constexpr std::size_t kParents = 3;         ///< effects alone beside which a second is looked for
constexpr std::size_t kPairParents = 2;     ///< pairs beside which a third is
constexpr std::size_t kPromisesBeside = 5;  ///< effects fitted beside each
constexpr std::size_t kFinishedAlone = 6;   ///< effects alone fitted to all segments,
constexpr std::size_t kFinishedPairs = 4;   ///< pairs,
constexpr std::size_t kFinishedBeside = 2;  ///< and of those beside a parent
constexpr double kWorthFinishing = 0.5;     ///< of what an effect must gain: a fit to all segments is made for

constexpr double kFewSamples = 6000.0;    ///< of all rungs: with fewer, more sets are fitted
constexpr double kManySamples = 25000.0;  ///< of all rungs: with more, fewer are
constexpr double kFewCoordinates = 2.0;   ///< of a robot: a sample of one with more costs more, by the square
constexpr double kBroadest = 4.0;

class SetSearch {
 public:
  SetSearch(const Ground& ground, ModelSets& sets)
      : ground_(ground),
        sets_(sets),
        few_(sets.all(), Segments::few),
        all_(sets.all(), Segments::all),
        breadth_(breadth_of(ground)) {}

  SearchedLibrary run() {
    SearchedLibrary searched;
    try {
      look_alone();
      searched.hypotheses = first_.hypotheses.size();
      searched.untestable = first_.untestable;
      finish(few_.best_of(1, many(kFinishedAlone)));
      pair_up();
      finish(few_.best_of(2, many(kFinishedPairs)));
      grow(1, std::min(kParents, many(kParents)));
      grow(2, std::min(kPairParents, many(kPairParents)));
      simplify();
    } catch (const TimeIsUp&) {
      lift_time_limit();
      searched.stopped = true;
    }
    return searched;
  }

 private:
  void say(const std::string& what) const {
    if (ground_.task().note) ground_.task().note(what);
  }
  /// So many sets, of a usual recording.
  std::size_t many(std::size_t usual) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(breadth_ * static_cast<double>(usual))));
  }
  static std::string change(double cost, double to) { return "error " + error_change_text(std::exp(cost - to), 1.0); }

  const FittedSet& fit(const StartedSet& set) {
    const std::string name = name_of_set(set.model.added);
    if (const FittedSet* known = sets_.find(name)) return *known;
    throw_if_interrupted();
    const FittedSet& fitted = sets_.fit(set.model, set.ways);
    if (fitted.few.errors.valid)
      say(fmt::format("  {}: {}", name, change(fitted.few.errors.cost, sets_.base().few.errors.cost)));
    return fitted;
  }

  void look_alone() {
    say("the model as it is");
    const FittedSet& base = sets_.base();
    first_ = look_beside(ground_, base.model, base.few, nullptr, std::min(kPairs, many(kPairs)));
    say("looked beside the model");
    for (const Promise& promise : slots_of(first_, {}, many(kSlots)))
      fit(with_promised(ground_, base, first_, promise));
    for (const PairPromise& pair : first_.pairs) fit(with_promised(ground_, first_, pair));
  }

  const Hypothesis& first_named(const std::string& name) const {
    return *std::find_if(first_.hypotheses.begin(), first_.hypotheses.end(),
                         [&](const Hypothesis& one) { return name_of_set({one.entry}) == name; });
  }

  /// Of effects alone in an order the first of each kind at a place.
  std::vector<std::string> one_of_a_kind(const SetOrder& order, std::size_t most) const {
    std::vector<std::string> chosen;
    for (const std::string& name : order.best_of(1, sets_.all().size())) {
      if (chosen.size() == most) break;
      const bool stands_for_another = std::any_of(chosen.begin(), chosen.end(), [&](const std::string& other) {
        return are_alike(first_named(name), first_named(other)) && same_place(first_named(name), first_named(other));
      });
      if (!stands_for_another) chosen.push_back(name);
    }
    return chosen;
  }

  /// The best effects alone, two at a time: what is missing may show in neither of them alone.
  void pair_up() {
    const std::vector<std::string> chosen = one_of_a_kind(few_, many(kToPairUp));
    for (std::size_t i = 0; i < chosen.size(); ++i)
      for (std::size_t j = i + 1; j < chosen.size(); ++j) {
        const FittedSet &one = *sets_.find(chosen[i]), &other = *sets_.find(chosen[j]);
        if (one.model.added.front().effect != other.model.added.front().effect) fit(with_both(ground_, one, other));
      }
  }

  /// Looks for a further effect beside the best sets of a size, as long as those are better than smaller ones.
  void grow(std::size_t size, std::size_t parents) {
    const double gain = all_.largest_gain();
    const std::vector<std::string> smaller = all_.best_of(size - 1, 1);
    for (const std::string& name : size == 1 ? one_of_a_kind(all_, parents) : all_.best_of(size, parents)) {
      if (size > 1 && !smaller.empty() && all_.cost(smaller.front()) - all_.cost(name) <= kRelevant * gain) continue;
      const FittedSet parent = *sets_.find(name);
      const Look look = look_beside(ground_, parent.model, parent.all.fit, &first_.probes);
      say("looked beside " + name);
      std::vector<std::string> better;
      for (const Promise& promise : slots_of(look, parent.model.added, many(kPromisesBeside))) {
        const FittedSet& set = fit(with_promised(ground_, parent, look, promise));
        if (set.few.errors.valid && parent.few.errors.cost - set.few.errors.cost > kWorthFinishing * kRelevant * gain)
          better.push_back(name_of_set(set.model.added));
      }
      finish(few_.best_among(better, many(kFinishedBeside)));
    }
  }

  static std::string name_with(const FittedSet& set, std::size_t member, const Hypothesis& other) {
    std::vector<EffectEntry> added = set.model.added;
    added[member] = other.entry;
    return name_of_set(added);
  }

  /// Of the best set each effect with those that are simpler and of its kind: a fit of these that ended beside its best
  /// values would leave the richer one as the answer.
  void simplify() {
    const std::vector<std::string> best = all_.ordered();
    if (best.empty()) return;
    const FittedSet set = *sets_.find(best.front());
    for (std::size_t i = 0; i < set.model.added.size(); ++i) {
      const Hypothesis& member = first_named(name_of_set({set.model.added[i]}));
      for (const Hypothesis& simpler : first_.hypotheses) {
        if (simpler.own.size() >= member.own.size() || simpler.where() != member.where()) continue;
        if (!are_alike(simpler, member) || effects_of(set).contains(name_of_set({simpler.entry}))) continue;
        const FittedSet* known = sets_.find(name_with(set, i, simpler));
        if (known && known->all.valid()) continue;
        throw_if_interrupted();
        const StartedSet started = with_simpler(ground_, set, i, simpler);
        say_finished(sets_.finish(started.model, started.ways.front().front()));
      }
    }
  }

  /// Fits them to all segments.
  void finish(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      if (sets_.find(name)->all.valid()) continue;
      throw_if_interrupted();
      say_finished(sets_.finish(name));
    }
  }

  void say_finished(const FittedSet& set) const {
    if (set.all.valid())
      say(fmt::format("    {} on all: {} fitted, {} where not fitted", name_of_set(set.model.added),
                      change(set.all.fit.errors.cost, sets_.base().all.fit.errors.cost),
                      change(set.all.cross.cost, sets_.base().all.cross.cost)));
  }

  const Ground& ground_;
  ModelSets& sets_;
  const SetOrder few_, all_;
  const double breadth_;
  Look first_;  ///< beside the model as it is
};

}  // namespace

double breadth_of(const Ground& ground) {
  double samples = 1.0;
  for (const Segment& segment : all_segments(ground.ladder())) samples += static_cast<double>(segment.stretch.size());
  if (samples < kFewSamples) return std::floor(std::min(kFewSamples / samples, kBroadest));
  const double coordinates = std::max(1.0, ground.coordinates() / kFewCoordinates);
  return std::min(1.0, kManySamples / (samples * coordinates * coordinates));
}

SearchedLibrary search_sets(const Ground& ground, ModelSets& sets) { return SetSearch(ground, sets).run(); }

}  // namespace lacuna
