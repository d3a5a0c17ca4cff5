#include "prediction/random_walk_smoother.h"

#include "fitting/numerics/robust_loss.h"

#include <lacuna/error.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

constexpr std::size_t kMostToSize = 4000;  ///< readings from which the sizes are estimated
constexpr std::size_t kStretches = 8;
constexpr double kFarthest = 10.0;  ///< standard deviations of an innovation that counts fully
constexpr double kVague = 1e4;      ///< of the initial state: times the range of the readings
constexpr int kSizeRounds = 3;      ///< of the search; one pass estimates each size once
constexpr int kSections = 24;       ///< of a golden section

/// log of noise and jerk.
struct Sizes {
  double position = 0.0, velocity = 0.0, jerk = 0.0;
};

Matrix transition(double h) {
  Matrix f = Matrix::Identity();
  f(0, 1) = f(1, 2) = h;
  f(0, 2) = 0.5 * h * h;
  return f;
}

Matrix growth(double h, double jerk) {
  const double h2 = h * h, h3 = h2 * h, h4 = h3 * h, h5 = h4 * h;
  Matrix q;
  q << h5 / 20.0, h4 / 8.0, h3 / 6.0, h4 / 8.0, h3 / 3.0, h2 / 2.0, h3 / 6.0, h2 / 2.0, h;
  return jerk * jerk * q;
}

/// The filter's state, updated by a reading of one of its components.
struct Belief {
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  /// Adds the contribution of the reading to −2 log likelihood.
  void take(int component, double value, double noise, double& cost) {
    const double variance = covariance(component, component) + noise * noise;
    const double off = value - mean(component), deviation = std::sqrt(variance);
    const double counted = std::clamp(off, -kFarthest * deviation, kFarthest * deviation);
    const Vector gain = covariance.col(component) / variance;
    mean += gain * counted;
    covariance -= gain * covariance.row(component);
    covariance = (0.5 * (covariance + covariance.transpose())).eval();
    cost += std::log(variance) + RobustLoss{kFarthest}.cost(off / deviation);
  }
};

double deviation_of(std::span<const double> values) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    squares += value * value;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count))) : 0.0;
}

std::size_t count_of(std::span<const double> values) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); }));
}

class Smoother {
 public:
  explicit Smoother(CoordinateReadings readings) : readings_(readings) {
    has_positions_ = count_of(readings.positions) > 0;
    has_velocities_ = count_of(readings.velocities) > 0;
    if (count_of(readings.positions) + count_of(readings.velocities) < 5)
      throw Error("fewer than five readings of a coordinate");
    const double span = readings.times.back() - readings.times.front();
    interval_ = span / static_cast<double>(readings.times.size() - 1);
    position_scale_ = std::max(deviation_of(readings.positions), deviation_of(readings.velocities) * interval_);
    velocity_scale_ = std::max(deviation_of(readings.velocities), position_scale_ / span);
  }

  SmoothedMotion smooth() {
    find_sizes();
    return run_back();
  }

 private:
  Belief start(std::size_t first) const {
    Belief belief;
    for (std::size_t i = first; has_positions_ && i < readings_.positions.size(); ++i)
      if (!std::isnan(readings_.positions[i])) {
        belief.mean(0) = readings_.positions[i];
        break;
      }
    const double position = kVague * std::max(position_scale_, 1e-12);
    belief.covariance.diagonal() << position * position, std::pow(position / (100.0 * interval_), 2),
        std::pow(position / (100.0 * interval_ * interval_), 2);
    if (!has_positions_) belief.covariance(0, 0) = 0.0;  // measured nowhere: counted from the start
    return belief;
  }

  void read(std::size_t i, const Sizes& sizes, Belief& belief, double& cost) const {
    if (has_positions_ && !std::isnan(readings_.positions[i]))
      belief.take(0, readings_.positions[i], std::exp(sizes.position), cost);
    if (has_velocities_ && !std::isnan(readings_.velocities[i]))
      belief.take(1, readings_.velocities[i], std::exp(sizes.velocity), cost);
  }

  /// Over stretches spread through the motion, because its beginning may be at rest.
  double cost_of(const Sizes& sizes) const {
    const std::size_t size = readings_.times.size();
    const std::size_t stretches = size > kMostToSize ? kStretches : 1, length = std::min(size, kMostToSize) / stretches;
    double cost = 0.0, unused = 0.0;
    for (std::size_t k = 0; k < stretches; ++k) {
      const std::size_t first = stretches == 1 ? 0 : k * (size - length) / (stretches - 1);
      Belief belief = start(first);
      for (std::size_t i = first; i < first + length; ++i) {
        if (i > first) move(readings_.times[i] - readings_.times[i - 1], sizes, belief);
        read(i, sizes, belief, i < first + kRunIn ? unused : cost);
      }
    }
    return cost;
  }

  static void move(double h, const Sizes& sizes, Belief& belief) {
    const Matrix f = transition(h);
    belief.mean = f * belief.mean;
    belief.covariance = f * belief.covariance * f.transpose() + growth(h, std::exp(sizes.jerk));
  }

  /// One size after the other, each by golden section around the best so far.
  void find_sizes() {
    sizes_.position = std::log(std::max(1e-3 * position_scale_, 1e-15));
    sizes_.velocity = std::log(std::max(1e-2 * velocity_scale_, 1e-15));
    sizes_.jerk = std::log(std::max(velocity_scale_, 1e-15) / std::pow(interval_ * 20.0, 1.5));
    const double least_position = std::log(std::max(readings_.least_position_noise, 1e-9 * position_scale_ + 1e-300));
    const double least_velocity = std::log(std::max(readings_.least_velocity_noise, 1e-9 * velocity_scale_ + 1e-300));
    for (int round = 0; round < kSizeRounds; ++round) {
      const double reach = round == 0 ? 14.0 : round == 1 ? 4.0 : 1.0;
      search(&Sizes::jerk, reach, -1e9);
      if (has_positions_) search(&Sizes::position, 0.6 * reach, least_position);
      if (has_velocities_) search(&Sizes::velocity, 0.6 * reach, least_velocity);
    }
  }

  void search(double Sizes::*size, double reach, double least) {
    const double ratio = 1.0 / std::numbers::phi;
    double low = std::max(least, sizes_.*size - reach), high = std::max(least, sizes_.*size + reach);
    const auto cost_at = [&](double value) {
      Sizes tried = sizes_;
      tried.*size = value;
      return cost_of(tried);
    };
    // The likelihood of one size has one maximum but may be flat or fail far from it, so a grid comes first.
    constexpr int kGrid = 9;
    double best = low, best_cost = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kGrid; ++i) {
      const double value = low + (high - low) * i / (kGrid - 1);
      if (const double cost = cost_at(value); cost < best_cost) best_cost = cost, best = value;
    }
    const double step = (high - low) / (kGrid - 1);
    low = std::max(least, best - step);
    high = best + step;
    double a = high - ratio * (high - low), b = low + ratio * (high - low);
    double cost_a = cost_at(a), cost_b = cost_at(b);
    for (int i = 0; i < kSections && high - low > 0.02; ++i) {
      if (cost_a < cost_b) {
        high = b;
        b = a, cost_b = cost_a;
        cost_a = cost_at(a = high - ratio * (high - low));
      } else {
        low = a;
        a = b, cost_a = cost_b;
        cost_b = cost_at(b = low + ratio * (high - low));
      }
    }
    sizes_.*size = std::max(least, 0.5 * (low + high));
  }

  SmoothedMotion run_back() const {
    const std::size_t count = readings_.times.size();
    std::vector<Belief> predicted(count), known(count);
    double unused = 0.0;
    Belief belief = start(0);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) move(readings_.times[i] - readings_.times[i - 1], sizes_, belief);
      predicted[i] = belief;
      read(i, sizes_, belief, unused);
      known[i] = belief;
    }
    SmoothedMotion motion;
    motion.positions.resize(count);
    motion.velocities.resize(count);
    motion.accelerations.resize(count);
    motion.covariances.resize(count);
    for (std::size_t i = count; i-- > 0;) {
      if (i + 1 < count) {
        const Matrix f = transition(readings_.times[i + 1] - readings_.times[i]);
        const Belief& next = predicted[i + 1];
        const Matrix back = (next.covariance.ldlt().solve(f * known[i].covariance)).transpose();
        known[i].mean += back * (known[i + 1].mean - next.mean);
        known[i].covariance += back * (known[i + 1].covariance - next.covariance) * back.transpose();
      }
      motion.positions[i] = known[i].mean(0);
      motion.velocities[i] = known[i].mean(1);
      motion.accelerations[i] = known[i].mean(2);
      motion.covariances[i] = known[i].covariance.topLeftCorner<2, 2>();
    }
    motion.position_noise = has_positions_ ? std::exp(sizes_.position) : 0.0;
    motion.velocity_noise = has_velocities_ ? std::exp(sizes_.velocity) : 0.0;
    motion.jerk = std::exp(sizes_.jerk);
    return motion;
  }

  static constexpr std::size_t kRunIn = 4;  ///< readings that determine the start

  CoordinateReadings readings_;
  bool has_positions_ = false, has_velocities_ = false;
  double interval_ = 0.0, position_scale_ = 0.0, velocity_scale_ = 0.0;
  Sizes sizes_;
};

}  // namespace

/// With the mean interval as the unit of time the three parts of a state are of one size, and their covariances keep
/// their digits.
SmoothedMotion smooth_motion(const CoordinateReadings& readings) {
  if (readings.times.size() < 2) throw Error("fewer than five readings of a coordinate");
  const double unit = (readings.times.back() - readings.times.front()) / static_cast<double>(readings.times.size() - 1);
  std::vector<double> times, velocities;
  for (const double time : readings.times) times.push_back(time / unit);
  for (const double velocity : readings.velocities) velocities.push_back(velocity * unit);
  SmoothedMotion motion = Smoother({times, readings.positions, velocities, readings.least_position_noise,
                                    readings.least_velocity_noise * unit})
                              .smooth();
  for (double& velocity : motion.velocities) velocity /= unit;
  for (double& acceleration : motion.accelerations) acceleration /= unit * unit;
  for (Eigen::Matrix2d& covariance : motion.covariances) {
    covariance(0, 1) /= unit;
    covariance(1, 0) /= unit;
    covariance(1, 1) /= unit * unit;
  }
  motion.velocity_noise /= unit;
  motion.jerk /= std::pow(unit, 2.5);
  return motion;
}

}  // namespace lacuna
