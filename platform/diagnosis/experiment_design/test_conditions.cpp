#include "diagnosis/experiment_design/test_conditions.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kForceShare = 0.25;  ///< of a segment: as long as what a random force does to readings stays alike

/// Readings of `time` s on either side that say the same as the one between them.
double alike(double time, double period) { return std::max(1.0, 2.0 * time / period); }

double mean_duration(const BaseSolution& base) {
  double sum = 0.0;
  for (const Segment& segment : base.segments) sum += duration_of(segment, base.trials);
  return sum / static_cast<double>(base.segments.size());
}

/// Mean over all bins of what each is divided by when noise of a reading becomes noise of a bin.
double mean_inverse_count(const RowBins& bins) {
  double sum = 0.0;
  for (std::size_t k = 0; k < bins.segments(); ++k)
    for (const RowBins::Bin& bin : bins.bins(k)) sum += 1.0 / bin.count;
  return sum / static_cast<double>(bins.rows());
}

/// Variance of independent readings of a channel, in multiples of its sensor's.
double slow_variance(const Round& round, std::size_t channel, double period) {
  using Kind = NoiseComponent::Kind;
  const std::vector<NoiseComponent>& parts = round.noise.components();
  double sum = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double variance = parts[i].deviation * parts[i].deviation;
    if (variance == 0.0 || parts[i].kind == Kind::doubt) continue;
    if (parts[i].kind == Kind::force || parts[i].kind == Kind::slow_force)
      sum += variance / std::pow(round.noise.sizes()[i], 2) * mean_inverse_count(round.bins) *
             alike(kForceShare * mean_duration(round.base), period);
    else if (parts[i].index == channel)
      sum += variance * (parts[i].kind == Kind::slow_sensor ? alike(kSlowSensor, period) : 1.0);
  }
  return sum;
}

const Segment* first_of_trial(const BaseSolution& base) {
  const auto found = std::find_if(base.segments.begin(), base.segments.end(), [](const Segment& segment) {
    return segment.stretch.first == 0 && segment.run_in == 0;
  });
  return found == base.segments.end() ? nullptr : &*found;
}

}  // namespace

TestConditions like_the_trials(const Round& round, double period) {
  TestConditions conditions;
  if (const Segment* first = first_of_trial(round.base)) {
    conditions.start = first->start;
    conditions.start_deviation.assign(first->start.positions.size() + first->start.velocities.size(), 0.0);
    for (std::size_t i = 0; i < first->unknown.size(); ++i) {
      const double deviation = first->deviation(static_cast<Eigen::Index>(i));
      if (std::isfinite(deviation)) conditions.start_deviation[static_cast<std::size_t>(first->unknown[i])] = deviation;
    }
  }
  conditions.noise = round.base.noise;
  for (std::size_t channel = 0; channel < conditions.noise.size(); ++channel)
    conditions.noise[channel].deviation *= std::sqrt(std::max(1.0, slow_variance(round, channel, period)));
  return conditions;
}

}  // namespace lacuna
