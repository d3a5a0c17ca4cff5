#include "search/effect_search.h"

#include "search/fit_starts.h"
#include "search/fitted_sets.h"
#include "search/nesting.h"
#include "search/promise_order.h"
#include "search/spread.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace lacuna {
namespace {

constexpr std::size_t kSingles = 18;  ///< effects that are fitted alone
constexpr std::size_t kLeading = 2;   ///< sets beside which the whole library is examined
constexpr std::size_t kBeside = 2;    ///< effects that are fitted beside each of them
constexpr std::size_t kKinds = 5;     ///< the best effects that act differently, fitted in pairs
constexpr std::size_t kBesidePair = 3;
constexpr std::size_t kSwapped = 3;     ///< effects tried in place of a member
constexpr std::size_t kMostOnEach = 3;  ///< values of a set that differ from joint to joint; more take too long to fit
constexpr std::uint64_t kSeed = 1;      ///< of the random signs

class EffectSearch {
 public:
  EffectSearch(const SearchData& data, const PredictionLadder& ladder, KeptFits& kept)
      : data_(data), models_(data, ladder, kept), sets_(models_, look_) {}

  void run() {
    say("the model as it is");
    const std::vector<NamedValues> start = {{}};
    if (!models_.fit({}, start, {}))
      throw NothingPredictable("the model cannot be simulated from any initial state; check its values");
    look_ = look_at_library(data_, models_.base(), models_.ladder());
    looked_.push_back({{}, look_.gains});
    say("first-order gains of the library");
    fit_singles();
    if (!gains_anything()) return;
    fit_pairs();
    fit_triples();
    swap_members();
    simplify_members();
    refit_parts();
    refit_nearly_as_good();
    mend_nesting();
    fit_twins_of_answer();
    spread_answer();
  }

  /// Whether an effect gains more than its error.
  bool gains_anything() const {
    const std::vector<const FittedModel*> singles = sets_.ordered(1);
    return std::any_of(singles.begin(), singles.end(),
                       [&](const FittedModel* one) { return gain_of(one->judged, models_.base().judged).is_told(); });
  }

  bool has_base() const { return models_.find({}) != nullptr; }
  const FittedModels& models() const { return models_; }
  const EffectLook& look() const { return look_; }
  const std::vector<LookedBeside>& looked() const { return looked_; }
  /// In place of the set with these members.
  const std::optional<FittedModel>& spread_from(const FittedModels::Members& members) const {
    static const std::optional<FittedModel> kNone;
    return members == spread_from_ ? spread_ : kNone;
  }

 private:
  void say(const std::string& what) const {
    data_.task().work.stop.throw_if_due();
    if (data_.task().note) data_.task().note(what);
  }

  const FittedModel* fit(const Entries& added, const std::vector<NamedValues>& starts, double least_share = 0.0) {
    if (is_twice(added, data_.plain().definition.structure.robot) || values_on_each(added) > kMostOnEach)
      return nullptr;
    std::vector<NamedValues> slight;
    for (std::size_t i = 0; i < added.size(); ++i)
      if (const FittedModel* part = models_.find(members_of(without_member(added, i))))
        slight.push_back(slightly(starts.front(), part->values, look_));
    return noted(models_.fit(added, starts, slight, least_share));
  }

  const FittedModel* noted(const FittedModel* found) const {
    if (!found) return nullptr;
    say(fmt::format("{}", fmt::join(found->judged.members, " + ")));
    return found;
  }

  void fit_singles() {
    for (const EffectPromise& promise : best_promises(look_, {}, kSingles)) {
      const Entries added = {look_.hypotheses[promise.hypothesis].entry};
      const NamedValues start = start_of_fit(data_, models_.base(), look_, promise);
      fit(added, {start, slightly(start, models_.base().values, look_)}, kLeastShare);
    }
  }

  const Hypothesis& hypothesis_of(const EffectEntry& entry) const {
    return *std::find_if(look_.hypotheses.begin(), look_.hypotheses.end(),
                         [&](const Hypothesis& one) { return member_name(one.entry) == member_name(entry); });
  }

  /// On each of many joints.
  std::size_t values_on_each(const Entries& added) const {
    std::size_t values = 0;
    for (const EffectEntry& entry : added)
      if (const Hypothesis& one = hypothesis_of(entry); one.placed.size() > 1) values += one.parameters();
    return values;
  }

  bool of_one_kind_as(const FittedModel& single, const std::vector<Entries>& chosen) const {
    return std::any_of(chosen.begin(), chosen.end(), [&](const Entries& other) {
      return of_one_kind(hypothesis_of(single.model.added.front()), hypothesis_of(other.front())) ||
             sets_.does_the_same(single, *models_.find(members_of(other)));
    });
  }

  /// Whether an effect acts like one of these, or is a richer law of its kind.
  bool is_like(const FittedModel& single, const std::vector<Entries>& chosen) const {
    return std::any_of(chosen.begin(), chosen.end(), [&](const Entries& other) {
      const FittedModel& before = *models_.find(members_of(other));
      const bool is_richer = of_one_kind(hypothesis_of(single.model.added.front()), hypothesis_of(other.front())) &&
                             single.judged.values > before.judged.values;
      return is_richer || sets_.does_the_same(single, before);
    });
  }

  void look_beside(const Entries& parent, std::size_t most) {
    FittedModels::Members members;
    for (const EffectEntry& entry : parent) members.insert(member_name(entry));
    const FittedModel known = *models_.find(members);
    const EffectLook look = lacuna::look_beside(data_, known, look_);
    std::erase_if(looked_, [&](const LookedBeside& before) { return before.members == members; });
    looked_.push_back({members, look.gains});
    say(fmt::format("first-order gains of the library beside {}", fmt::join(members, " + ")));
    for (const EffectPromise& promise : best_promises(look, members, most)) {
      Entries added = parent;
      added.push_back(look.hypotheses[promise.hypothesis].entry);
      if (!models_.find(members_of(added))) fit(added, {start_of_fit(data_, known, look, promise)});
    }
  }

  void fit_pairs() {
    std::vector<Entries> leading, kinds;
    for (const FittedModel* single : sets_.ordered(1)) {
      if (leading.size() < kLeading && !of_one_kind_as(*single, leading)) leading.push_back(single->model.added);
      if (kinds.size() < kKinds && !is_like(*single, kinds)) kinds.push_back(single->model.added);
    }
    for (const Entries& parent : leading) look_beside(parent, kBeside);
    for (std::size_t i = 0; i < kinds.size(); ++i)
      for (std::size_t j = i + 1; j < kinds.size(); ++j) fit_both(kinds[i], kinds[j]);
  }

  void fit_both(const Entries& one, const Entries& other) {
    const Entries both = {one.front(), other.front()};
    if (models_.find({member_name(one.front()), member_name(other.front())})) return;
    const NamedValues of_one = models_.find({member_name(one.front())})->values;
    const NamedValues of_other = models_.find({member_name(other.front())})->values;
    fit(both, {both_values(of_other, of_one), slightly(of_one, of_other, look_)});
  }

  /// Beside the leading pairs, where a pair gains more than one effect does.
  void fit_triples() {
    const std::vector<const FittedModel*> pairs = sets_.ordered(2), singles = sets_.ordered(1);
    if (pairs.empty() || singles.empty()) return;
    const CostGain more = gain_of(pairs.front()->judged, singles.front()->judged);
    if (!more.is_told() || more.nats < kWorthATriple * sets_.whole_gain()) return;
    std::vector<Entries> leading;
    for (const FittedModel* pair : pairs) {
      const bool is_like = std::any_of(leading.begin(), leading.end(), [&](const Entries& other) {
        return sets_.does_the_same(*pair, *models_.find(members_of(other)));
      });
      if (leading.size() < kLeading && !is_like && sets_.gains_by_both(*pair)) leading.push_back(pair->model.added);
    }
    for (const Entries& pair : leading) look_beside(pair, kBesidePair);
  }

  /// The best set with each member in turn replaced by the effect with the largest predicted gain beside the others.
  void swap_members() {
    const Entries added = sets_.best()->model.added;
    const NamedValues values = sets_.best()->values;
    for (std::size_t i = 0; i < added.size() && added.size() > 1; ++i) {
      const Entries rest = without_member(added, i);
      if (!models_.find(members_of(rest))) noted(models_.refine(rest, values));
      if (models_.find(members_of(rest))) look_beside(rest, kSwapped);
    }
  }

  /// The best set and the best single effect, each member replaced by one or two simpler effects of its kind.
  void simplify_members() {
    const std::vector<const FittedModel*> singles = sets_.ordered(1);
    if (!singles.empty()) simplify(singles.front()->model.added, NamedValues(singles.front()->values));
    const FittedModel* best = sets_.best();
    simplify(Entries(best->model.added), NamedValues(best->values));
  }

  void simplify(const Entries& added, const NamedValues& values) {
    for (std::size_t i = 0; i < added.size(); ++i) {
      const Entries rest = without_member(added, i);
      const std::vector<EffectPromise> simpler = simpler_than(added[i], added);
      for (std::size_t a = 0; a < simpler.size(); ++a) {
        fit_in_place(rest, {simpler[a]}, values);
        for (std::size_t b = a + 1; b < simpler.size() && rest.size() + 2 <= kMostMembers; ++b)
          fit_in_place(rest, {simpler[a], simpler[b]}, values);
      }
    }
  }

  /// Effects of the same kind with fewer values, the largest predicted gain first.
  std::vector<EffectPromise> simpler_than(const EffectEntry& entry, const Entries& added) const {
    std::vector<EffectPromise> simpler;
    const Hypothesis& rich = hypothesis_of(entry);
    for (const EffectPromise& promise : look_.promises) {
      const Hypothesis& one = look_.hypotheses[promise.hypothesis];
      const bool is_member = members_of(added).contains(member_name(one.entry));
      if (!is_member && one.own.size() < rich.own.size() && of_one_kind(one, rich) && simpler.size() < kSwapped)
        simpler.push_back(promise);
    }
    return simpler;
  }

  void fit_in_place(Entries added, const std::vector<EffectPromise>& promises, const NamedValues& values) {
    NamedValues start = values;
    for (const EffectPromise& promise : promises) {
      added.push_back(look_.hypotheses[promise.hypothesis].entry);
      const FittedModel* single = models_.find(members_of({added.back()}));
      start = both_values(single ? single->values : start_of_fit(data_, models_.base(), look_, promise), start);
    }
    if (!models_.find(members_of(added))) fit(added, {start});
  }

  /// Refits the parts of the best sets from the values of the sets; parts of the very best even where they are fitted.
  void refit_parts() {
    std::vector<std::pair<Entries, NamedValues>> best = {{sets_.best()->model.added, sets_.best()->values}};
    for (const FittedModel* set : sets_.ordered(kMostMembers))
      if (best.size() <= kLeading) best.emplace_back(set->model.added, set->values);
    for (std::size_t i = 0; i < best.size(); ++i) refit_parts_of(best[i].first, best[i].second, i == 0);
  }

  /// Refits the sets that are nearly as good as the best, with their own derivatives.
  void refit_nearly_as_good() {
    const double enough = sets_.best()->judged.cost.cost + kSame * sets_.whole_gain();
    std::vector<std::pair<Entries, NamedValues>> near;
    for (const auto& [members, model] : models_.all())
      if (model.judged.cost.cost < enough) near.emplace_back(model.model.added, model.values);
    for (const auto& [added, values] : near) noted(models_.refine(added, values));
  }

  void refit_parts_of(const Entries& added, const NamedValues& values, bool is_best) {
    for (std::size_t i = 0; i < added.size(); ++i) {
      const Entries rest = without_member(added, i);
      const FittedModel* part = models_.find(members_of(rest));
      if (!part || is_best) part = noted(models_.refine(rest, values));
      if (part && rest.size() > 1) refit_parts_of(rest, NamedValues(part->values), is_best);
    }
  }

  /// Where a set costs more than a part of it, refits the set from the part: its cost cannot be higher.
  void mend_nesting() {
    std::vector<Entries> all;
    for (const auto& [members, model] : models_.all()) all.push_back(model.model.added);
    std::stable_sort(all.begin(), all.end(), [](const Entries& a, const Entries& b) { return a.size() < b.size(); });
    for (const Entries& added : all)
      for (std::size_t i = 0; i < added.size(); ++i) {
        const FittedModel& set = *models_.find(members_of(added));
        const FittedModel* part = models_.find(members_of(without_member(added, i)));
        if (!part || part->fit.cost > set.fit.cost - kNested) continue;
        noted(models_.refine(added, slightly(NamedValues(set.values), part->values, look_)));
      }
  }

  const FittedModel& answer() const { return *sets_.candidates()[decide(sets_.judged(), looked_, kSeed).answer]; }

  /// The answer with a member replaced by one of equal predicted gain: indistinguishable on these data.
  void fit_twins_of_answer() {
    const FittedModel& found = answer();
    const Entries added = found.model.added;
    const NamedValues values = found.values;
    for (std::size_t i = 0; i < added.size(); ++i)
      for (const EffectPromise& twin : twins_of(look_, member_name(added[i])))
        if (!members_of(added).contains(member_name(look_.hypotheses[twin.hypothesis].entry)))
          fit_in_place(without_member(added, i), {twin}, values);
  }

  void spread_answer() {
    const FittedModel& from = answer();
    spread_from_ = from.judged.members;
    spread_ = spread_over_places(models_, look_, from, sets_.whole_gain());
    if (spread_) say("one value per joint");
  }

  const SearchData& data_;
  FittedModels models_;
  const FittedSets sets_;
  EffectLook look_;
  std::vector<LookedBeside> looked_;
  FittedModels::Members spread_from_;
  std::optional<FittedModel> spread_;
};

void conclude(const EffectSearch& search, SearchResult& result) {
  const FittedModels& models = search.models();
  result.layout = models.ladder().layout;
  result.sets.clear();
  const FittedSets sets(models, search.look());
  for (const FittedModel* set : sets.candidates()) {
    result.sets.push_back(*set);
    result.sets.back().model.added = set->model.placed;
  }
  result.looked = search.looked();
  result.decision = decide(sets.judged(), result.looked, kSeed);
  result.spread = search.spread_from(result.sets[result.decision.answer].judged.members);
  result.hypotheses = search.look().hypotheses.size();
  result.untestable = search.look().untestable;
  result.fits += models.fits();
  count_nesting(result);
}

/// Nothing where the time limit was reached before the model as it is was fitted.
bool search_over(const PredictionLadder& ladder, KeptFits& kept, SearchResult& result) {
  EffectSearch search(*result.data, ladder, kept);
  try {
    search.run();
  } catch (const TimeIsUp&) {
    result.stopped = true;
    if (!search.has_base()) return false;
    result.data->task().work.stop.lift_limit();
  }
  conclude(search, result);
  return true;
}

}  // namespace

SearchResult search_effects(const EffectSearchTask& task) {
  SearchResult result;
  result.data = std::make_shared<const SearchData>(task);
  KeptFits kept = task.known ? *task.known : KeptFits();
  if (!search_over(result.data->deciding(), kept, result)) task.work.stop.throw_if_due();
  if (result.decision.answer != 0 || result.stopped) return result;
  if (search_over(result.data->ladder(), kept, result))
    result.by_all_lengths = true;
  else
    task.work.stop.lift_limit();
  return result;
}

}  // namespace lacuna
