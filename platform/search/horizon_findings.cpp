#include "search/horizon_findings.h"

#include "diagnosis/rounds/selection.h"
#include "fitting/parameter_space.h"
#include "foundation/figure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kFarAboveFloor = 3.0;  ///< of the model's error, where no effect lowers it: something else is missing
constexpr std::size_t kMostRanked = 8;
constexpr double kTwoSided = 1.96;
constexpr double kLongEnough = 0.3;  ///< of the longest trial

Gain gain_of(const CostDifference& difference) {
  return {difference.nats, difference.error, difference.nats - kTwoSided * difference.error,
          difference.nats + kTwoSided * difference.error};
}

double rms(const HorizonErrors& errors, std::size_t rung, std::size_t channel) {
  const bool is_known = errors.valid && errors.weight[rung][channel] > 0.0;
  return is_known ? std::sqrt(errors.mean_square[rung][channel]) : kUnknown;
}

/// s; 0: nothing is.
double longest_judged(const Ladder& ladder) {
  for (std::size_t r = ladder.rungs.size(); r-- > 0;)
    for (const double weight : ladder.rungs[r].weight)
      if (weight > 0.0) return ladder.rungs[r].length;
  return 0.0;
}

class Told {
 public:
  explicit Told(const Missing& missing) : missing_(missing), answer_(missing.ranking[missing.answer]) {}

  void into(Diagnosis& result) const {
    result.hypotheses = missing_.hypotheses;
    result.untestable = missing_.untestable;
    result.horizons = horizons();
    result.base = errors_of(missing_.base);
    result.base_segment = longest();
    result.base_times_floor = times_floor(missing_.ladder, missing_.base.errors);
    for (const RankedSet* set : shown()) result.ranking.push_back(ranked(*set));
    if (!answer_.model.added.empty()) {
      result.verdict = Verdict::effect_found;
      result.ranking.front().look_alikes.assign(missing_.alike.begin(), missing_.alike.end());
      result.answer_gain = gain_of(answer_.over_base);
    } else if (!missing_.stopped) {
      result.verdict = result.base_times_floor > kFarAboveFloor ? Verdict::not_in_library : Verdict::nothing_missing;
    }
    result.values = own_values(answer_.model.added, answer_.model.definition, refit_of(answer_, missing_.timing));
  }

 private:
  /// The answer, if it has effects, then the others that have, the least cost first.
  std::vector<const RankedSet*> shown() const {
    std::vector<const RankedSet*> sets;
    if (!answer_.model.added.empty()) sets.push_back(&answer_);
    for (const RankedSet& set : missing_.ranking)
      if (&set != &answer_ && !set.model.added.empty() && sets.size() < kMostRanked) sets.push_back(&set);
    return sets;
  }

  double longest() const { return longest_judged(missing_.ladder); }

  std::vector<HorizonError> horizons() const {
    std::vector<HorizonError> all;
    for (std::size_t r = 0; r < missing_.ladder.rungs.size(); ++r)
      for (std::size_t c = 0; c < missing_.ladder.channels.size(); ++c) {
        if (!(missing_.base.errors.weight[r][c] > 0.0)) continue;
        const std::string& channel = missing_.ladder.channels[c].channel;
        all.push_back({missing_.ladder.rungs[r].length, channel, missing_.ladder.channels[c].unit,
                       std::sqrt(missing_.ladder.rungs[r].floor[c]), rms(missing_.base.errors, r, c),
                       rms(answer_.errors, r, c), rms(missing_.base.held_out, r, c), rms(answer_.held_out, r, c)});
      }
    return all;
  }

  /// Over the longest horizon at which a channel is judged.
  std::vector<ChannelError> errors_of(const RankedSet& set) const {
    std::vector<ChannelError> errors;
    for (std::size_t c = 0; c < missing_.ladder.channels.size(); ++c) {
      const std::string& channel = missing_.ladder.channels[c].channel;
      for (std::size_t r = missing_.ladder.rungs.size(); r-- > 0;) {
        if (!(set.errors.weight[r][c] > 0.0)) continue;
        errors.push_back({channel, missing_.ladder.channels[c].unit, std::sqrt(missing_.ladder.rungs[r].floor[c]),
                          rms(set.errors, r, c), rms(set.held_out, r, c)});
        break;
      }
    }
    return errors;
  }

  RankedModel ranked(const RankedSet& set) const {
    RankedModel model;
    model.effects = found_effects(set.model.added, set.model.definition, refit_of(set, missing_.timing));
    model.gain = gain_of(set.over_base);
    model.errors = errors_of(set);
    model.times_floor = times_floor(missing_.ladder, set.errors);
    model.segment = longest();
    return model;
  }

  const Missing& missing_;
  const RankedSet& answer_;
};

}  // namespace

Refit refit_of(const RankedSet& set, bool timing) {
  Refit fit;
  fit.valid = fit.converged = true;
  const ParameterSpace space(set.model.definition.free);
  fit.values = set.model.values;
  if (timing) {
    fit.timing = fit.values.back();
    fit.values.pop_back();
  }
  fit.covariance = set.covariance;
  const Eigen::VectorXd at = space.to_coordinates(fit.values);
  for (Eigen::Index j = 0; j < at.size(); ++j)
    fit.at_bound.push_back(at(j) <= space.lower()(j) || at(j) >= space.upper()(j));
  return fit;
}

void doubt_answer(const Helped& helped, Diagnosis& result) {
  result.verdict = Verdict::cannot_tell;
  result.probability = kUnknown;
  result.calibrated = false;
  result.next_test.clear();  // it would tell the answer from another, and neither is one
  result.next_test_worth.clear();
  result.next_test_setup.reset();
  result.findings.insert(
      result.findings.begin(),
      fmt::format(
          "the best of the library lowers the error at {} of {} horizons and channels only, and what is missing "
          "would lower it at nearly all: it stands for something else; the table of errors says which it leaves: "
          "record what differs there, one joint at a time where there are several",
          helped.at, helped.of));
}

std::vector<std::string> confirmation_notes(const Missing& missing) {
  std::vector<std::string> notes;
  for (const NotConfirmed& one : missing.not_confirmed)
    notes.push_back(fmt::format(
        "{} lowers the error of what was fitted, but not of the held-out files ({} with it, {} without, against the "
        "model's), and is left out: it stands for what is particular to the fitted files; fit to more and more varied "
        "ones",
        one.effect, error_change_text(one.with_it, 1.0), error_change_text(one.without, 1.0)));
  return notes;
}

std::string reach_note(const Ladder& ladder, const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out)
      longest = std::max(longest, trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0));
  const double reach = longest_judged(ladder);
  if (!(reach > 0.0) || reach > kLongEnough * longest) return "";
  return fmt::format(
      "predictions are judged over {:.2g} s at most, of recordings of {:.3g} s: {}; what acts more slowly "
      "(a drift, warming, a clock) is not told",
      reach, longest,
      ladder.ended_by_starts
          ? "over longer ones what is unknown of a start grows to more than a quarter of the motion, as "
            "with unstable or chaotic motion and noisy readings"
          : "longer ones would take more time than they tell");
}

Diagnosis findings_of(const Missing& missing) {
  Diagnosis result;
  Told(missing).into(result);
  return result;
}

}  // namespace lacuna
