#include "diagnosis/rounds/segment_lengths.h"

#include "diagnosis/rounds/selection.h"
#include "fitting/stages.h"
#include "foundation/address.h"
#include "foundation/interrupt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace lacuna {
namespace {

constexpr std::array kUsualLengths = {0.1, 0.5};  ///< s
constexpr double kSameLength = 1.3;               ///< lengths that differ by less tell nothing new
constexpr double kShortestOther = 0.1;            ///< s: shorter ones hold little more than their start

bool can_cut(const StartStates& states, std::size_t trials) {
  for (std::size_t trial = 0; trial < trials; ++trial)
    if (!states.reconstructible(trial)) return false;
  return true;
}

/// How long a start stays certain. Nothing where the model cannot be started anywhere.
std::optional<double> horizon(const LengthTask& task, const RobotSpec& robot, const CompiledModel& model,
                              const std::vector<double>& values) {
  const TrialPredictor predictor(model, task.last.base.trials, task.threads);
  const StartStates states(robot, predictor, task.last.base.noise);
  if (!can_cut(states, predictor.trials().size())) return std::nullopt;
  return automatic_horizon(predictor, states, values, task.cut.segment);
}

/// Of the contender, or, where one of its effects has a state that no sensor tells, of the model without them.
double horizon(const LengthTask& task) {
  const Contender& contender = task.contender;
  const std::optional<double> own =
      horizon(task, contender.definition.structure.robot, *contender.model, task.fit.values);
  if (own) return *own;
  return horizon(task, task.cut.definition.structure.robot, task.cut.model, task.cut.values).value_or(0.0);
}

/// Shorter ones first.
std::vector<double> other_lengths(const LengthTask& task) {
  const double longest = longest_fit_trial(task.cut.trials);
  std::vector<double> lengths(kUsualLengths.begin(), kUsualLengths.end());
  lengths.push_back(std::min(horizon(task), longest));
  std::sort(lengths.begin(), lengths.end());
  std::vector<double> kept;
  for (const double length : lengths) {
    const auto alike = [&](double other) { return std::max(length, other) < kSameLength * std::min(length, other); };
    if (length < kShortestOther || length > longest || alike(task.cut.segment) || (!kept.empty() && alike(kept.back())))
      continue;
    kept.push_back(length);
  }
  return kept;
}

/// The noise of the last round on other segments: sensors keep theirs; a white force's mean over a longer pulse is
/// smaller. Nothing where they hold other channels.
std::optional<NoiseModel> same_noise(const Round& last, const RowBins& bins, const ForceResponses& forces) {
  NoiseModel noise(bins, forces);
  const auto same = [](const NoiseComponent& a, const NoiseComponent& b) {
    return a.kind == b.kind && a.index == b.index;
  };
  if (!std::equal(noise.components().begin(), noise.components().end(), last.noise.components().begin(),
                  last.noise.components().end(), same))
    return std::nullopt;
  std::vector<double> deviations = last.noise.deviations();
  for (std::size_t i = 0; i < deviations.size(); ++i)
    if (last.noise.components()[i].kind == NoiseComponent::Kind::force && forces.width > 0.0)
      deviations[i] *= std::sqrt(last.forces.width / forces.width);
  noise.set_deviations(deviations);
  return noise;
}

Refit refit_over(const LengthTask& task, double length) {
  CutTask cut = task.cut;
  cut.segment = length;
  const Contender& contender = task.contender;
  BaseSolution base = cut_trials(cut, {contender.definition, *contender.model, task.fit.values, Moving::if_needed});
  base.timing = task.fit.timing;
  const ModelDefinition& definition = contender.definition;
  const TrialPredictor predictor(*contender.model, base.trials, task.threads);
  const ParameterSpace space(definition.free);
  ShootingProblem problem(predictor, space, base.segments, base.noise);
  const RowBins bins(problem);
  base.steps = problem.steps();
  const FitPoint point{space.to_coordinates(base.values), base.states};
  const ForceResponses forces = force_responses(definition, problem, bins, point, base.values,
                                                std::max(1.0, task.last.base.residual), task.threads);
  const std::optional<NoiseModel> noise = same_noise(task.last, bins, forces);
  if (!noise) return {};
  std::vector<std::size_t> places(base.values.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  return refit({definition, *contender.model, places}, base, bins, noise_factors(*noise), {base.values}, task.threads);
}

/// By how much the deviance grows where the effects get the answer's values and all else is fitted again.
double deviance_against_answer(const LengthTask& task, const Refit& fit) {
  const ParameterSpace space(task.contender.definition.free);
  const auto count = static_cast<Eigen::Index>(fit.at_bound.size());
  std::vector<Eigen::Index> moved, others;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    if (place < fit.values.size() && is_of_effect(task.contender.definition.free[place].address))
      moved.push_back(i);
    else if (!fit.at_bound[place])
      others.push_back(i);
  }
  Eigen::VectorXd way(static_cast<Eigen::Index>(moved.size()));
  for (std::size_t m = 0; m < moved.size(); ++m) {
    const auto place = static_cast<std::size_t>(moved[m]);
    way(static_cast<Eigen::Index>(m)) =
        space.to_coordinate(moved[m], task.fit.values[place]) - space.to_coordinate(moved[m], fit.values[place]);
  }
  return std::max(0.0, cost_of_moving(normal_equations(fit.weighted, count), moved, way, others));
}

}  // namespace

std::vector<EffectsAtLength> refit_at_lengths(const LengthTask& task) {
  std::vector<EffectsAtLength> found;
  const TrialPredictor predictor(task.cut.model, task.last.base.trials, 1);
  const StartStates states(task.cut.definition.structure.robot, predictor, task.last.base.noise);
  if (!can_cut(states, predictor.trials().size())) return found;
  for (const double length : other_lengths(task)) {
    throw_if_interrupted();
    try {
      const Refit fit = refit_over(task, length);
      if (fit.valid)
        found.push_back({length, found_effects(task.contender.added, task.contender.definition, fit),
                         deviance_against_answer(task, fit)});
    } catch (const Interrupted&) {
      throw;
    } catch (const Error&) {  // a length over which these data tell nothing
    }
  }
  return found;
}

}  // namespace lacuna
