#include "search/settling_test.h"

#include "diagnosis/experiment_design/propose_test.h"
#include "search/horizon_findings.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// Mean square of the answer's errors over the longest horizon at which a channel is judged; 0 where it is at none.
double longest_error(const Ladder& ladder, const HorizonErrors& errors, const std::string& channel) {
  for (std::size_t c = 0; c < ladder.channels.size(); ++c) {
    if (ladder.channels[c].channel != channel) continue;
    for (std::size_t r = ladder.rungs.size(); r-- > 0;)
      if (errors.weight[r][c] > 0.0) return errors.mean_square[r][c];
  }
  return 0.0;
}

/// As the first recording begins. What the answer leaves beyond the noise of readings stays alike for about as long as
/// the shortest horizon.
TestConditions conditions(const Ground& ground, const HorizonErrors& errors, double period) {
  TestConditions conditions;
  const std::vector<Trial>& trials = ground.task().trials;
  const auto fitted = std::find_if(trials.begin(), trials.end(), [](const Trial& trial) { return !trial.held_out; });
  const StartEstimate start = ground.starts().at(static_cast<std::size_t>(fitted - trials.begin()), 0);
  conditions.start = start.start;
  for (const double deviation : start.deviation)
    conditions.start_deviation.push_back(std::isfinite(deviation) ? deviation : 0.0);
  conditions.noise = ground.noise();
  const double alike = std::max(1.0, 2.0 * ground.ladder().rungs.front().length / period);
  for (ChannelNoise& noise : conditions.noise) {
    const double reading = noise.deviation * noise.deviation;
    const double beyond = std::max(0.0, longest_error(ground.ladder(), errors, noise.channel) - reading);
    noise.deviation = std::sqrt(reading + alike * beyond);
  }
  return conditions;
}

}  // namespace

void propose_settling_test(const DiagnosisTask& task, const Ground& ground, const Missing& missing, Diagnosis& result) {
  if (!missing.look_alike) return;
  const RankedSet& answer = missing.ranking[missing.answer];
  const RankedSet& other = *missing.look_alike;
  const Refit fit = refit_of(answer, missing.timing), of_other = refit_of(other, missing.timing);
  state_next_test(
      propose_test(
          task.catalog, task.experiment, {name_of_set(answer.model.added), answer.model.definition, fit},
          {name_of_set(other.model.added), other.model.definition, of_other}, task.trials,
          [&](double period) { return conditions(ground, answer.errors, period); }, task.seed, task.threads),
      result);
}

}  // namespace lacuna
