#include "diagnosis/diagnosis.h"

#include "diagnosis/channel_errors.h"
#include "diagnosis/cut_trials.h"
#include "diagnosis/data_doubts.h"
#include "diagnosis/diagnosis_findings.h"
#include "diagnosis/integration_error.h"
#include "diagnosis/propose_test.h"
#include "diagnosis/rejudge.h"
#include "diagnosis/round.h"
#include "diagnosis/selection.h"
#include "diagnosis/sufficient_substeps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lacuna {
namespace {

constexpr std::size_t kMostEffects = 3;
constexpr double kFirstLevel = 0.05, kFurtherLevel = 0.01;  ///< of chance, for the first effect and those after it

std::string name_of(const Hypothesis& hypothesis) { return hypothesis.entry.effect + " @ " + hypothesis.where(); }

std::set<std::string> names_of(const Contender& contender) {
  std::set<std::string> names;
  for (const EffectEntry& entry : contender.added)
    names.insert(entry.effect + " @ " + (entry.where.empty() ? "world" : entry.where.front()));
  return names;
}

std::vector<RandomForce> random_forces(const Round& round) {
  std::vector<RandomForce> forces;
  for (const NoiseComponent& one : round.noise.components())
    if (one.kind == NoiseComponent::Kind::force)
      forces.push_back({"joint." + round.forces.joints[one.index], round.forces.units[one.index], one.deviation,
                        round.forces.width});
  return forces;
}

class Diagnostician {
 public:
  explicit Diagnostician(const DiagnosisTask& task) : task_(task), meter_(task.progress) {
    meter_.set_parts(kRoundParts * static_cast<int>(kMostEffects + 1));
  }

  Diagnosis run() {
    BaseSolution start = cut_trials({task_.definition, task_.model, task_.trials, task_.values, task_.segment});
    const BaseSolution uncorrected = start;
    Contender contender = plain(task_.experiment, task_.catalog, task_.values,
                                sufficient_substeps(task_.definition, start, task_.threads));
    plain_ = contender.experiment;
    std::optional<Step> last;
    for (;;) {
      start.trials = uncorrected.trials;
      start.values = contender.values;
      correct_for_steps(contender.definition, start, task_.threads);
      Round round = run_round({task_.catalog, contender, start, task_.among, task_.seed, task_.threads, meter_});
      if (tried_.empty()) describe_first(contender, round);
      tried_.insert(names_of(contender));
      if (last && takes_another(*last, round)) {
        take(*last, contender, start);
        continue;
      }
      const std::optional<std::size_t> chosen = next_of(contender, round);
      if (!chosen) {
        finish(contender, round);
        break;
      }
      remember(contender, round, chosen);
      last.emplace(Step{contender, std::move(round), *chosen});
      take(*last, contender, start);
      if (leave_out_spent(contender, *last)) last.reset();
    }
    result_.seconds = meter_.seconds();
    return std::move(result_);
  }

 private:
  /// The rival to go on with: not one that leads back to where the search was.
  std::optional<std::size_t> next_of(const Contender& contender, const Round& round) const {
    if (contender.added.size() >= kMostEffects) return std::nullopt;
    const std::optional<std::size_t> chosen = choose(round, contender.added.empty() ? kFirstLevel : kFurtherLevel);
    if (!chosen) return std::nullopt;
    std::set<std::string> names = names_of(contender);
    names.insert(name_of(round.hypotheses[round.rivals[*chosen].hypothesis]));
    return tried_.contains(names) ? std::nullopt : chosen;
  }

  /// A model, what was looked for in it, and what was chosen to be added.
  struct Step {
    Contender from;
    Round round;
    std::size_t chosen;
  };

  static void take(const Step& step, Contender& contender, BaseSolution& start) {
    const Rival& rival = step.round.rivals[step.chosen];
    contender = with(step.from, step.round.hypotheses[rival.hypothesis], rival.fit.values);
    start.states = rival.fit.states;
  }

  /// Judges the last choice again, now that its noise is known. Whether another rival is better; `last` has it then.
  bool takes_another(Step& last, const Round& now) {
    const Rejudged again = rejudge(last.round, last.chosen, now, task_.seed, task_.threads);
    if (again.better) {
      std::set<std::string> names = names_of(last.from);
      names.insert(name_of(last.round.hypotheses[last.round.rivals[*again.better].hypothesis]));
      if (!tried_.contains(names)) {
        last.chosen = *again.better;
        remember(last.from, last.round, last.chosen);
        return true;
      }
    }
    std::vector<std::string>& alike = result_.ranking.front().look_alikes;
    alike.clear();
    for (const auto& [other, fit] : again.inseparable)
      alike.push_back(name_of(last.round.hypotheses[last.round.rivals[other].hypothesis]));
    result_.next_test.clear();
    if (!again.inseparable.empty()) propose(last, now, again.inseparable.front());
    return false;
  }

  /// The test that would tell the answer from what looks most like it.
  void propose(const Step& last, const Round& now, const std::pair<std::size_t, Refit>& alike) {
    const Hypothesis& chosen = last.round.hypotheses[last.round.rivals[last.chosen].hypothesis];
    const Hypothesis& other = last.round.hypotheses[last.round.rivals[alike.first].hypothesis];
    const std::optional<NextTest> test =
        propose_test(task_.catalog, {name_of(chosen), chosen.definition, now.fit},
                     {name_of(other), other.definition, alike.second}, now.base, task_.seed, task_.threads, {});
    if (test) result_.next_test = test->line;
    if (test) result_.next_test_worth = to_string(*test);
  }

  /// Backward deletion: an effect that was added before leaves again where, with the new one there, it predicts
  /// nothing better. Whether one left.
  bool leave_out_spent(Contender& contender, const Step& step) {
    bool left = false;
    const Eigen::VectorXd& with_it = step.round.rivals[step.chosen].held_out;
    for (std::size_t i = 0; i + 1 < contender.added.size();) {
      Contender less = without(contender, i, plain_, task_.catalog);
      const Refit fit = refit_reduced(less, step.round, task_.threads);
      const bool spent = fit.valid && gain(held_out_deviance(fit, step.round.folds), with_it, task_.seed).value <= 0.0;
      if (!spent || tried_.contains(names_of(less))) {
        ++i;
        continue;
      }
      less.values = fit.values;
      contender = std::move(less);
      left = true;
    }
    return left;
  }

  void describe_first(const Contender& contender, const Round& round) {
    first_ = {contender.definition.free, round.fit.values};
    first_curves_ = round.free_force.curves;
    first_formulas_ = round.formulas;
    result_.hypotheses = round.hypotheses.size();
    result_.untestable = round.untestable;
    result_.base = channel_errors(round.base, round.bins, round.noise, round.fit, round.folds);
    result_.base_times_floor = times_floor(result_.base);
    result_.p_by_chance = round.screening.p;
    result_.chance_95 = 0.5 * round.screening.chance_95;
  }

  /// Models with one more effect than `contender` become the ranking, the chosen one first.
  void remember(const Contender& contender, const Round& round, std::optional<std::size_t> chosen) {
    const Gain before = contender.added.empty() ? Gain{} : gains_[names_of(contender)];
    std::vector<RankedModel> ranking;
    std::vector<std::size_t> order;
    if (chosen) order.push_back(*chosen);
    for (std::size_t i = 0; i < round.rivals.size(); ++i)
      if (i != chosen) order.push_back(i);
    for (const std::size_t i : order) {
      const Rival& rival = round.rivals[i];
      RankedModel model;
      const Contender longer = with(contender, round.hypotheses[rival.hypothesis], rival.fit.values);
      model.effects = found_effects(longer, rival.fit);
      model.gain = sum(before, rival.gain);
      model.chance_95 = 0.5 * round.screening.chance_95;
      model.errors = channel_errors(round.base, round.bins, round.noise, rival.fit, round.folds);
      model.times_floor = times_floor(model.errors);
      if (i == chosen)
        for (const std::size_t other : inseparable(round, i, task_.seed))
          model.look_alikes.push_back(name_of(round.hypotheses[round.rivals[other].hypothesis]));
      gains_[names_of(longer)] = model.gain;
      ranking.push_back(std::move(model));
    }
    result_.ranking = std::move(ranking);
  }

  void finish(const Contender& contender, const Round& round) {
    if (contender.added.empty()) {
      remember(contender, round, std::nullopt);
    } else {
      result_.ranking.front().effects = found_effects(contender, round.fit);
      result_.ranking.front().errors = channel_errors(round.base, round.bins, round.noise, round.fit, round.folds);
    }
    result_.forces = random_forces(round);
    result_.free_force_p = round.free_force.p;
    result_.free_force_gain = gain(round.held_out, round.free_force.held_out, task_.seed);
    result_.verdict = verdict_of(contender, round);
    if (result_.verdict == Verdict::not_in_library) {
      result_.residual_force = first_curves_;
      result_.formulas = first_formulas_;
    }
    measure_by(channel_errors(round.base, round.bins, round.noise, round.fit, round.folds));
    weigh(result_);
    result_.findings = findings_of(result_, first_, contender, round);
  }

  Verdict verdict_of(const Contender& contender, const Round& last) const {
    const double best = last.rivals.empty() ? 0.0 : last.rivals.front().gain.value;
    const double free = result_.free_force_gain.lower_95;
    if (result_.free_force_p < kFreeForceLevel && free > std::max(0.0, best)) return Verdict::not_in_library;
    if (!contender.added.empty()) return Verdict::effect_found;
    return last.screening.p <= kFirstLevel ? Verdict::cannot_tell : Verdict::nothing_missing;
  }

  /// The floor is that of the last round, in which the least that is structured passes for noise.
  void measure_by(const std::vector<ChannelError>& last) {
    const auto take_floor = [&](std::vector<ChannelError>& errors) {
      for (std::size_t c = 0; c < errors.size(); ++c) errors[c].floor = last[c].floor;
      return times_floor(errors);
    };
    result_.base_times_floor = take_floor(result_.base);
    for (RankedModel& model : result_.ranking) model.times_floor = take_floor(model.errors);
  }

  const DiagnosisTask& task_;
  ProgressMeter meter_;
  Diagnosis result_;
  Experiment plain_;                             ///< the experiment, with substeps that suffice
  std::set<std::set<std::string>> tried_;        ///< effects that were added to it
  std::map<std::set<std::string>, Gain> gains_;  ///< over the model without any
  // Of the model without any effect added: what the user's model lacks, not what a poor substitute lacks.
  BaseValues first_;
  std::vector<ForceCurve> first_curves_;
  std::vector<ForceFormula> first_formulas_;
};

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothing_missing: return "nothing_missing";
    case Verdict::effect_found: return "effect_found";
    case Verdict::not_in_library: return "not_in_library";
    case Verdict::cannot_tell: return "cannot_tell";
  }
  return "";
}

Diagnosis diagnose(const DiagnosisTask& task) {
  const bool saturation_is_tried =
      task.among.empty() || std::find(task.among.begin(), task.among.end(), "sensor_saturation") != task.among.end();
  const std::vector<Doubt> doubts =
      data_doubts({task.definition, task.model, task.trials, task.values, saturation_is_tried});
  Diagnosis result = disqualifying(doubts).empty() ? Diagnostician(task).run() : Diagnosis{};
  for (const Doubt& doubt : doubts) result.findings.push_back(doubt.sentence);
  return result;
}

}  // namespace lacuna
