#include "prediction/smoothed_starts.h"

#include "measurement/series/quantisation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

/// A column as values of the coordinate; NaN where nothing was read.
std::vector<double> values_of(const Trial& trial, const StartStates::Reading& reading) {
  const auto rows = static_cast<std::size_t>(trial.measured.times.size());
  std::vector<double> values(rows);
  for (std::size_t i = 0; i < rows; ++i)
    values[i] =
        (trial.measured.samples(static_cast<Eigen::Index>(i), reading.channel) - reading.offset) / reading.scale;
  return values;
}

}  // namespace

SmoothedStarts::SmoothedStarts(const StartStates& states, const std::vector<Trial>& trials)
    : states_(states), trials_(trials) {
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const Trial& trial = trials[t];
    noise_.emplace_back(static_cast<std::size_t>(trial.measured.samples.cols()),
                        std::numeric_limits<double>::quiet_NaN());
    coordinates_.emplace_back(static_cast<std::size_t>(states.coordinates()));
    for (int c = 0; c < states.coordinates(); ++c) {
      const auto &position = states.position_reading(t, c), &velocity = states.velocity_reading(t, c);
      if (!position) continue;
      const bool with_velocity = velocity && velocity->others == position->others;
      const std::vector<double> positions = values_of(trial, *position);
      const std::vector<double> velocities = with_velocity ? values_of(trial, *velocity) : std::vector<double>();
      const std::span times(trial.measured.times.data(), static_cast<std::size_t>(trial.measured.times.size()));
      const double least = quantisation_step(positions) / std::sqrt(12.0);
      SmoothedCoordinate& own = coordinates_.back()[static_cast<std::size_t>(c)];
      own.others = position->others;
      own.motion = smooth_motion(
          {times, positions, velocities, least, with_velocity ? quantisation_step(velocities) / std::sqrt(12.0) : 0.0});
      noise_.back()[static_cast<std::size_t>(position->channel)] =
          own.motion->position_noise * std::abs(position->scale);
      if (with_velocity)
        noise_.back()[static_cast<std::size_t>(velocity->channel)] =
            own.motion->velocity_noise * std::abs(velocity->scale);
    }
  }
}

double SmoothedStarts::reading_noise(std::size_t trial, Eigen::Index channel) const {
  return noise_[trial][static_cast<std::size_t>(channel)];
}

Eigen::VectorXd SmoothedStarts::readings_after(std::size_t trial, Eigen::Index sample, double later) const {
  Eigen::VectorXd readings =
      Eigen::VectorXd::Constant(trials_[trial].measured.samples.cols(), std::numeric_limits<double>::quiet_NaN());
  const auto i = static_cast<std::size_t>(sample);
  for (int c = 0; c < states_.coordinates(); ++c) {
    const SmoothedCoordinate& own = coordinates_[trial][static_cast<std::size_t>(c)];
    if (!own.motion) continue;
    const double change = later * own.motion->accelerations[i], velocity = own.motion->velocities[i] + change;
    const double position = own.motion->positions[i] + later * (velocity - 0.5 * change);
    const auto &of_position = states_.position_reading(trial, c), &of_velocity = states_.velocity_reading(trial, c);
    readings(of_position->channel) = of_position->scale * position + of_position->offset;
    if (of_velocity && of_velocity->others == of_position->others)
      readings(of_velocity->channel) = of_velocity->scale * velocity + of_velocity->offset;
  }
  return readings;
}

/// From the nearest sample, extrapolated with its acceleration.
SmoothedStarts::Change SmoothedStarts::change_within(std::size_t trial, Eigen::Index sample,
                                                     const SmoothedMotion& motion, double seconds) const {
  const Eigen::VectorXd& times = trials_[trial].measured.times;
  const double wanted = std::clamp(times(sample) + seconds, times(0), times(times.size() - 1));
  const double* above = std::lower_bound(times.data(), times.data() + times.size(), wanted);
  Eigen::Index near = std::min<Eigen::Index>(above - times.data(), times.size() - 1);
  if (near > 0 && wanted - times(near - 1) < times(near) - wanted) --near;
  const auto i = static_cast<std::size_t>(near), from = static_cast<std::size_t>(sample);
  const double rest = wanted - times(near);
  const double velocity = motion.velocities[i] + rest * motion.accelerations[i];
  const double position = motion.positions[i] + 0.5 * rest * (motion.velocities[i] + velocity);
  return {position - motion.positions[from], velocity - motion.velocities[from]};
}

void SmoothedStarts::move_later(std::size_t trial, Eigen::Index sample, const std::vector<double>& lateness,
                                StartState& start) const {
  std::vector<Change> changes(static_cast<std::size_t>(states_.coordinates()));
  for (const int c : states_.outward()) {
    const SmoothedCoordinate& own = coordinates_[trial][static_cast<std::size_t>(c)];
    if (!own.motion || (sample == 0 && StartStates::given(trials_[trial], c))) continue;
    const Eigen::Index channel = states_.position_reading(trial, c)->channel;
    Change& change = changes[static_cast<std::size_t>(c)];
    change = change_within(trial, sample, *own.motion, lateness[static_cast<std::size_t>(channel)]);
    for (const auto& [other, sign] : own.others) {
      change.position -= sign * changes[static_cast<std::size_t>(other)].position;
      change.velocity -= sign * changes[static_cast<std::size_t>(other)].velocity;
    }
    const int velocity = states_.coordinates() + c;
    set_component(start, c, component(start, c) + change.position);
    set_component(start, velocity, component(start, velocity) + change.velocity);
  }
}

StartEstimate SmoothedStarts::at(std::size_t trial, Eigen::Index sample) const {
  const Stretch whole{trial, 0, trials_[trial].measured.times.size()};
  StartEstimate estimate = states_.from_samples(whole, sample);
  const int n = states_.coordinates();
  const Eigen::Index size = Eigen::Index{2} * n;
  estimate.axes = Eigen::MatrixXd::Zero(size, size);
  const auto i = static_cast<std::size_t>(sample);
  for (const int c : states_.outward()) {
    const SmoothedCoordinate& own = coordinates_[trial][static_cast<std::size_t>(c)];
    if (!own.motion || (sample == 0 && StartStates::given(trials_[trial], c))) continue;
    double position = own.motion->positions[i], velocity = own.motion->velocities[i];
    Eigen::Matrix2d covariance = own.motion->covariances[i];
    for (const auto& [other, sign] : own.others) {
      position -= sign * component(estimate.start, other);
      velocity -= sign * component(estimate.start, n + other);
      covariance(0, 0) += std::pow(estimate.deviation(other), 2);
      covariance(1, 1) += std::pow(estimate.deviation(n + other), 2);
    }
    set_component(estimate.start, c, position);
    set_component(estimate.start, n + c, velocity);
    estimate.deviation(c) = std::sqrt(covariance(0, 0));
    estimate.deviation(n + c) = std::sqrt(covariance(1, 1));
    const double along = covariance(0, 1) / std::max(estimate.deviation(c), std::numeric_limits<double>::min());
    estimate.axes(c, c) = estimate.deviation(c);
    estimate.axes(n + c, c) = along;
    estimate.axes(n + c, n + c) = std::sqrt(std::max(0.0, covariance(1, 1) - along * along));
  }
  for (int index = 0; index < 2 * n; ++index)
    if (estimate.axes.row(index).isZero() && std::isfinite(estimate.deviation(index)))
      estimate.axes(index, index) = estimate.deviation(index);
  states_.follow(estimate);
  return estimate;
}

}  // namespace lacuna
