#include "fitting/starts/segments.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFree = 100.0;  ///< a free state's prior is wider by this factor than its guess is uncertain

bool tells_from_data(const Trial& trial) {
  if (trial.initial.empty()) return true;
  return std::any_of(trial.initial.begin(), trial.initial.end(),
                     [](const InitialValue& value) { return value.knowledge == InitialKnowledge::from_data; });
}

bool is_free(const Trial& trial, int coordinate) {
  return !trial.initial.empty() &&
         trial.initial[static_cast<std::size_t>(coordinate)].knowledge == InitialKnowledge::free;
}

void list_measured(const Trial& trial, Eigen::Index first_row, Segment& segment) {
  for (Eigen::Index row = first_row; row < segment.stretch.size(); ++row)
    for (Eigen::Index column = 0; column < trial.measured.samples.cols(); ++column) {
      if (!std::isfinite(trial.measured.samples(segment.stretch.first + row, column))) continue;
      segment.rows.push_back(row);
      segment.columns.push_back(column);
    }
}

/// The first sample that is no more than `run_in` s before another one.
Eigen::Index first_of_run_in(const Trial& trial, Eigen::Index sample, double run_in) {
  const Eigen::VectorXd& times = trial.measured.times;
  return std::lower_bound(times.data(), times.data() + sample, times(sample) - run_in * (1.0 + 1e-9)) - times.data();
}

Segment make_segment(const TrialPredictor& predictor, const StartStates& states, const Stretch& counted, double run_in,
                     const std::vector<double>& values) {
  const Trial& trial = predictor.trials()[counted.trial];
  const Stretch stretch{counted.trial, first_of_run_in(trial, counted.first, run_in), counted.last};
  const bool on_head = counted.first == 0 && tells_from_data(trial);
  StartEstimate estimate = on_head ? fit_head(predictor, states, stretch, values, 0) : StartEstimate{};
  const bool scored_after_head = on_head && estimate.valid;
  if (!estimate.valid) estimate = states.from_samples(stretch, stretch.first);

  Segment segment;
  segment.stretch = stretch;
  segment.run_in = counted.first - stretch.first;
  segment.start = estimate.start;
  std::vector<double> deviation;
  for (int index = 0; index < 2 * states.coordinates(); ++index) {
    if (!estimate.tells(index)) continue;
    const double known_to = estimate.deviation(index);
    const bool free = !scored_after_head || is_free(trial, index % states.coordinates());
    segment.unknown.push_back(index);
    deviation.push_back(free ? kFree * known_to : known_to);
  }
  segment.deviation = Eigen::Map<Eigen::VectorXd>(deviation.data(), static_cast<Eigen::Index>(deviation.size()));
  const double memory = predictor.model().has_memory() ? kLongestMemory : std::min(run_in, kHead);
  const Eigen::Index first =
      first_scored(predictor, stretch, scored_after_head ? estimate : StartEstimate{}, memory) - stretch.first;
  list_measured(trial, std::max(first, segment.run_in), segment);
  return segment;
}

}  // namespace

double duration_of(const Segment& segment, const std::vector<Trial>& trials) {
  const Eigen::VectorXd& times = trials[segment.stretch.trial].measured.times;
  return times(segment.stretch.last - 1) - times(segment.first_counted());
}

std::vector<Stretch> cut(const Trial& trial, std::size_t index, double length) {
  const Eigen::VectorXd& times = trial.measured.times;
  const Eigen::Index size = times.size();
  const double begin = times(0);
  const double duration = times(size - 1) - begin;
  const Eigen::Index pieces =
      length > 0.0 ? std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::lround(duration / length))) : 1;
  std::vector<Stretch> stretches;
  Eigen::Index first = 0;
  for (Eigen::Index piece = 1; piece <= pieces; ++piece) {
    const double until = begin + duration * static_cast<double>(piece) / static_cast<double>(pieces);
    const Eigen::Index last =
        piece == pieces ? size : std::lower_bound(times.data(), times.data() + size, until) - times.data();
    if (last > first) stretches.push_back({index, first, last});
    first = last;
  }
  return stretches;
}

std::vector<Segment> make_segments(const TrialPredictor& predictor, const StartStates& states, double length,
                                   const std::vector<double>& values, double run_in) {
  std::vector<Segment> segments;
  for (std::size_t trial = 0; trial < predictor.trials().size(); ++trial) {
    if (predictor.trials()[trial].held_out) continue;
    for (const Stretch& stretch : cut(predictor.trials()[trial], trial, length)) {
      Segment segment = make_segment(predictor, states, stretch, run_in, values);
      if (segment.rows.size() > segment.unknown.size()) segments.push_back(std::move(segment));
    }
  }
  return segments;
}

bool same_starts(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t j = 0; j < a[k].unknown.size(); ++j) {
      const int index = a[k].unknown[j];
      const double change = std::abs(component(a[k].start, index) - component(b[k].start, index));
      if (change > 0.1 * a[k].deviation(static_cast<Eigen::Index>(j))) return false;
    }
  return true;
}

std::vector<Segment> thinned(std::vector<Segment> segments, std::size_t most) {
  if (segments.size() <= most) return segments;
  std::vector<Segment> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(std::move(segments[i * segments.size() / most]));
  return kept;
}

}  // namespace lacuna
