#include "diagnosis/likelihoods/effect_search.h"

#include "diagnosis/likelihoods/search_ending.h"
#include "diagnosis/refit/timing.h"
#include "diagnosis/rounds/channel_errors.h"
#include "diagnosis/rounds/cut_trials.h"
#include "diagnosis/rounds/deeper_minimum.h"
#include "diagnosis/rounds/fewer_effects.h"
#include "diagnosis/rounds/outdone_library.h"
#include "diagnosis/rounds/ranking.h"
#include "diagnosis/rounds/rejudge.h"
#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/selection.h"
#include "diagnosis/rounds/unaided.h"
#include "diagnosis/verdict/stopped_search.h"
#include "foundation/interrupt.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace lacuna {
namespace {

constexpr double kSpent = 2.0;       ///< of the deviance, a parameter (H. Akaike, 1974)
constexpr double kLittleMore = 0.1;  ///< of the gain: no reason for more parameters
/// Of the gain, and standard errors: an effect that adds less of both makes up for the form of those that are there.
constexpr double kHardlyMore = 0.03, kNotSure = 4.0;
constexpr int kUsualRounds = 2;  ///< one that finds an effect, one that finds nothing more

class EffectSearch {
 public:
  explicit EffectSearch(const DiagnosisTask& task)
      : task_(task),
        meter_(task.progress),
        cut_(cut_trials({task.definition, task.model, task.trials, task.values, task.segment, task.threads})),
        plain_(plain(task.experiment, task.catalog, cut_.values)),
        contender_(plain_) {
    meter_.set_parts(kRoundParts * kUsualRounds);
    if (task.resume == nullptr) return;
    state_ = *task.resume;
    const int before = rounds_before();
    meter_.set_parts(kRoundParts * std::max(kUsualRounds, before + 1));
    meter_.skip_parts(kRoundParts * before);
    contender_ = with_effects(plain_, state_.added, state_.values, task.catalog);
    seconds_before_ = state_.so_far.seconds;
  }

  Diagnosis run() {
    for (int number = 1 + rounds_before();; ++number) {
      if (number > kUsualRounds) meter_.add_parts(kRoundParts);
      const SearchState state_before = state_;
      const Contender model_before = contender_;
      std::optional<Round> round;
      try {
        round.emplace(look());
        if (round->stopped) return stopped(round);
        if (std::optional<Diagnosis> end = judge(*round)) return std::move(*end);
      } catch (const TimeIsUp&) {
        state_ = state_before;
        contender_ = model_before;
        return stopped(round);
      }
      keep();
    }
  }

 private:
  /// Chooses the model that the search goes on with, or ends it.
  std::optional<Diagnosis> judge(Round& round) {
    unaided_.reset();
    if (state_.tried.empty()) describe_first(round);
    state_.tried.insert(names_of(contender_.added));
    again_ = {};
    if (state_.last && takes_another(round)) return std::nullopt;
    const bool outdone = outdone_by_law(round);
    if (!outdone && (takes_one(round) || does_with_fewer(round))) return std::nullopt;
    return ended(round, outdone);
  }

  /// What is known where the time limit stopped the search: the answer of the rounds before, or the choice among what
  /// this one has refitted.
  Diagnosis stopped(const std::optional<Round>& round) {
    lift_time_limit();
    Diagnosis& result = state_.so_far;
    const std::size_t kept = state_.tried.size();
    if (round && state_.tried.empty()) {
      describe_first(*round);
      const std::optional<std::size_t> chosen = choose(*round, kFirstLevel);
      result.ranking = ranking_of(contender_, *round, chosen, {}, task_.seed);
      result.verdict = chosen ? Verdict::effect_found : Verdict::cannot_tell;
    } else if (!contender_.added.empty()) {
      result.verdict = Verdict::effect_found;
    }
    if (!result.ranking.empty()) result.answer_gain = result.ranking.front().gain;
    if (!state_.law_leads) {
      result.formulas.clear();
      result.residual_force.clear();
    }
    StoppedSearch stop{meter_.what(), {}, {}};
    if (round)
      stop.not_examined = round->not_examined;
    else
      stop.not_examined = candidate_names(contender_.experiment, task_.catalog, contender_.definition, task_.among);
    for (std::string& name : stop.not_examined)
      for (const EffectEntry& entry : contender_.added) name += " beside " + name_of(entry);
    mark_stopped(std::move(stop), kept, result);
    result.seconds = seconds();
    return std::move(result);
  }

  int rounds_before() const { return static_cast<int>(state_.tried.size()); }

  Round look() {
    BaseSolution start = contender_.added.empty() ? cut_ : cut_for_contender();
    Round round = look_from(start, contender_.added.empty() ? Moving::all : Moving::if_needed);
    if (round.stopped) return round;
    const std::optional<Refit> deeper = deeper_minimum(contender_, round, task_.threads);
    if (!deeper) return round;
    go_deeper(*deeper, round);
    start = from(std::move(start), *deeper);
    start.values = deeper->values;
    return look_from(std::move(start), Moving::if_needed);
  }

  Round look_from(BaseSolution start, Moving moving) {
    return run_round({task_.catalog, contender_, start, moving, task_.among, task_.seed, task_.threads, meter_});
  }

  void go_deeper(const Refit& deeper, const Round& round) {
    contender_.values = deeper.values;
    meter_.add_parts(kRoundParts);
    if (contender_.added.empty()) return;
    Gain& known = state_.gains[names_of(contender_.added)];
    known = sum(known, gain(round.held_out, held_out_deviance(deeper, round.folds), task_.seed));
  }

  /// Into segments that the contender can follow.
  BaseSolution cut_for_contender() const {
    if (cut_.free_run) {  // blocks of the same length for all
      BaseSolution same = cut_;
      same.values = contender_.values;
      return same;
    }
    return cut_trials({task_.definition, task_.model, task_.trials, cut_.values, task_.segment, task_.threads},
                      {contender_.definition, *contender_.model, contender_.values, Moving::if_needed});
  }

  /// Of the model without any effect added: what the user's model lacks, not what a poor substitute lacks.
  void describe_first(const Round& round) {
    Diagnosis& result = state_.so_far;
    state_.base_values = round.fit.values;
    result.residual_force = round.free_force.curves;
    result.formulas = round.formulas;
    state_.law_leads = law_leads(round, task_.seed);
    result.hypotheses = round.hypotheses.size();
    result.untestable = round.untestable;
    result.base = channel_errors(round.base, round.bins, round.noise, round.fit, round.folds);
    result.base_times_floor = times_floor(result.base);
    result.base_segment = round.base.segment;
    result.p_by_chance = round.screening.p;
    result.chance_95 = 0.5 * round.screening.chance_95;
  }

  bool outdone_by_law(const Round& round) {
    return state_.law_leads && outdoes_library(state_.so_far.formulas.front(), round, contender_.added.size(),
                                               state_.gains[names_of(contender_.added)]);
  }

  /// The rival to go on with: not one that leads back to where the search was.
  std::optional<std::size_t> next_of(const Round& round) {
    if (contender_.added.size() >= state_.most_effects) return std::nullopt;
    const std::optional<std::size_t> chosen = choose(round, contender_.added.empty() ? kFirstLevel : kFurtherLevel);
    if (!chosen) return std::nullopt;
    if (adds_hardly_more(round)) return std::nullopt;
    const EffectEntry& entry = round.hypotheses[round.rivals[*chosen].hypothesis].entry;
    return state_.tried.contains(names_with(contender_.added, entry)) ? std::nullopt : chosen;
  }

  /// Whether the best rival adds little that is uncertain to what the effects gain that are there.
  bool adds_hardly_more(const Round& round) {
    const Gain& further = round.rivals.front().gain;
    if (contender_.added.empty() || further.value >= kNotSure * further.standard_error) return false;
    const std::optional<Unaided>& without = unaided(round);
    return without && further.value < kHardlyMore * without->behind.value;
  }

  /// Goes on with the rival that is chosen first of those that do not only take the place of a simpler effect. Whether
  /// there is one.
  bool takes_one(Round& round) {
    std::vector<Rival> only_richer;
    bool taken = false;
    while (const std::optional<std::size_t> chosen = next_of(round)) {
      taken = takes_in(round, *chosen);
      if (taken) break;
      only_richer.push_back(std::move(round.rivals[*chosen]));
      round.rivals.erase(round.rivals.begin() + static_cast<std::ptrdiff_t>(*chosen));
    }
    // They are no answer, but the library has them.
    std::move(only_richer.begin(), only_richer.end(), std::back_inserter(round.rivals));
    std::stable_sort(round.rivals.begin(), round.rivals.end(),
                     [](const Rival& a, const Rival& b) { return a.gain.value > b.gain.value; });
    return taken;
  }

  bool takes_in(const Round& round, std::size_t chosen) {
    const SearchState state_before = state_;
    const Contender model_before = contender_;
    if (state_.last) keep_class();
    const Gain before = contender_.added.empty() ? Gain{} : state_.gains[names_of(contender_.added)];
    state_.so_far.ranking = ranking_of(contender_, round, chosen, before, task_.seed);
    state_.last = step_of(contender_, round, chosen);
    for (const KeptRival& rival : state_.last->rivals)
      state_.gains[names_with(contender_.added, rival.entry)] = sum(before, rival.gain);
    if (!state_.first) {
      state_.first = state_.last;
      state_.first_ranking = state_.so_far.ranking;
    }
    take_chosen();
    if (!leave_out_spent(round, chosen)) return true;
    if (only_richer(model_before, round, chosen)) {
      state_ = state_before;
      contender_ = model_before;
      return false;
    }
    state_.last.reset();
    state_.so_far.ranking.front().look_alikes.clear();  // they stand for the last effect beside those that left
    return true;
  }

  /// Whether an effect took the place of a simpler one and adds little to what that gained: a friction of more
  /// parameters makes up for the form of a plain one.
  bool only_richer(const Contender& before, const Round& round, std::size_t chosen) {
    if (contender_.added.size() > before.added.size() || contender_.values.size() <= before.values.size()) return false;
    const EffectNames stayed = names_of(contender_.added);
    double gained = 0.0;  // by those that left
    for (std::size_t i = 0; i < before.added.size(); ++i)
      if (!stayed.contains(name_of(before.added[i]))) gained += gain_of(before, i, round);
    return round.rivals[chosen].gain.value <= kLittleMore * gained;
  }

  /// What one of its effects gains beside the others, in a round of that model.
  double gain_of(const Contender& model, std::size_t which, const Round& round) const {
    const Refit less = refit_under(round, lacuna::without(model, which, plain_, task_.catalog), task_.threads);
    return less.valid ? gain(held_out_deviance(less, round.folds), round.held_out, task_.seed).value : 0.0;
  }

  const std::optional<Unaided>& unaided(const Round& round) {
    if (!unaided_) {
      Contender none = plain_;
      none.values = state_.base_values;
      unaided_ = refit_unaided(none, round, task_.seed, task_.threads);
    }
    return *unaided_;
  }

  /// The ranking names the look-alikes of the last effect alone; those of one before become a finding.
  void keep_class() {
    const RankedModel& answer = state_.so_far.ranking.front();
    if (!answer.look_alikes.empty())
      state_.so_far.findings.push_back(fmt::format("{} was not told apart from {}", name_of(contender_.added.back()),
                                                   fmt::join(answer.look_alikes, ", ")));
  }

  void take_chosen() {
    const KeptRival& rival = state_.last->rivals[state_.last->chosen];
    contender_ = with_effect_of(rival, *state_.last, plain_, task_.catalog);
  }

  /// Judges the last choice again, now that its noise is known. Whether another rival is better; it is the choice then.
  bool takes_another(const Round& now) {
    SearchStep& last = *state_.last;
    again_ = rejudge({last, plain_, task_.catalog, now, task_.seed, task_.threads});
    if (again_.better && !state_.tried.contains(names_with(last.added, last.rivals[*again_.better].entry))) {
      last.rivals[last.chosen].values = now.fit.values;
      last.chosen = *again_.better;
      last.rivals[last.chosen].values = again_.values;
      bring_to_front(state_.so_far.ranking, name_of(last.rivals[last.chosen].entry));
      take_chosen();
      return true;
    }
    name_look_alikes(now);
    return false;
  }

  /// Beside the answer, and with the errors that they have under the noise of `now`, as it has.
  void name_look_alikes(const Round& now) {
    std::vector<RankedModel>& ranking = state_.so_far.ranking;
    ranking.front().look_alikes.clear();
    for (const auto& [other, fit] : again_.inseparable) {
      const std::string name = name_of(state_.last->rivals[other].entry);
      ranking.front().look_alikes.push_back(name);
      for (RankedModel& model : ranking)
        if (is_last_effect(model, name)) {
          model.errors = channel_errors(now.base, now.bins, now.noise, fit, now.folds);
          model.segment = now.base.segment;
        }
    }
  }

  bool does_as_well(const Refit& less, const Rival& with_it, const Round& round) const {
    if (!less.valid) return false;
    const double explained = less.deviance - with_it.fit.deviance;
    return explained <= kSpent * (freedom(with_it.fit) - freedom(less)) ||
           gain(held_out_deviance(less, round.folds), with_it.held_out, task_.seed).value <= 0.0;
  }

  /// Backward deletion: an effect that was added before leaves again where, with the new one there, it predicts
  /// nothing better, or explains no more than its parameters would explain of noise. Whether one left.
  bool leave_out_spent(const Round& round, std::size_t chosen) {
    bool left = false;
    for (std::size_t i = 0; i + 1 < contender_.added.size();) {
      Contender less = without(contender_, i, plain_, task_.catalog);
      const Refit fit = refit_under(round, less, task_.threads);
      if (!does_as_well(fit, round.rivals[chosen], round) || state_.tried.contains(names_of(less.added))) {
        ++i;
        continue;
      }
      less.values = fit.values;
      state_.gains[names_of(less.added)] = state_.gains[names_of(contender_.added)];
      contender_ = std::move(less);
      left = true;
    }
    return left;
  }

  /// Whether fewer effects are enough; the search goes on with these, and with no more of them.
  bool does_with_fewer(const Round& round) {
    if (!state_.first || contender_.added.size() < 2 || !unaided(round)) return false;
    const std::optional<FewerEffects> fewer =
        fewer_effects({contender_, alternatives(), plain_, *unaided(round), *state_.first, task_.catalog, round,
                       task_.among, task_.seed, task_.threads});
    if (!fewer) return false;
    state_.enough[names_of(fewer->added)] = to_string(*fewer, contender_.added);
    go_on_with(*fewer);
    return true;
  }

  std::vector<Contender> alternatives() const {
    std::vector<Contender> all;
    if (state_.last)
      for (const KeptRival& rival : state_.last->rivals)
        all.push_back(with_effect_of(rival, *state_.last, plain_, task_.catalog));
    return all;
  }

  void go_on_with(const FewerEffects& fewer) {
    contender_ = with_effects(plain_, fewer.added, fewer.fit.values, task_.catalog);
    state_.most_effects = fewer.added.size();
    state_.gains[names_of(fewer.added)] = fewer.gain;
    state_.last.reset();
    std::vector<RankedModel>& ranking = state_.so_far.ranking;
    ranking = state_.first_ranking;
    if (fewer.of_first) {
      state_.last = state_.first;
      state_.last->chosen = *fewer.of_first;
      state_.last->rivals[*fewer.of_first].values = fewer.fit.values;
      bring_to_front(ranking, name_of(fewer.added.back()));
    } else {
      ranking.emplace(ranking.begin())->gain = fewer.gain;
    }
  }

  Diagnosis ended(const Round& round, bool outdone_by_law) {
    const std::optional<Unaided> none;
    const std::optional<Unaided>& without = contender_.added.empty() ? none : unaided(round);
    std::optional<double> law_ahead;
    if (outdone_by_law)
      law_ahead = lead_of(state_.so_far.formulas.front(), round, state_.gains[names_of(contender_.added)]);
    end_search({task_, cut_, plain_, contender_, again_, round, without, law_ahead, state_, meter_});
    state_.so_far.seconds = seconds();
    return std::move(state_.so_far);
  }

  void keep() {
    if (!task_.keep) return;
    state_.added = contender_.added;
    state_.values = contender_.values;
    state_.so_far.seconds = seconds();
    task_.keep(state_);
  }

  double seconds() const { return seconds_before_ + meter_.seconds(); }

  const DiagnosisTask& task_;
  ProgressMeter meter_;
  const BaseSolution cut_;
  Contender plain_;  ///< the experiment's model
  Contender contender_;
  SearchState state_;
  std::optional<std::optional<Unaided>> unaided_;  ///< of the round at hand, once it was asked for
  Rejudged again_;                                 ///< the last choice, under the noise of the round at hand
  double seconds_before_ = 0.0;
};

}  // namespace

Diagnosis search_effects(const DiagnosisTask& task) { return EffectSearch(task).run(); }

}  // namespace lacuna
