#include "oracle/kalman_whitener.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <memory>

namespace hidden_effects {
namespace {

using Index = Eigen::Index;

/// One sample of the filter: x is (plant's state, random forces, slow noise of the sensors).
struct FilterSample {
  Eigen::MatrixXd reading;     ///< sensors × x
  Eigen::MatrixXd scale;       ///< of the innovations: the inverse of their covariance's Cholesky factor
  Eigen::MatrixXd gain;        ///< x × sensors, onto the next sample
  Eigen::MatrixXd transition;  ///< x × x, to the next sample
};
using Filter = std::vector<FilterSample>;

bool any(const std::vector<double>& sizes) {
  return std::any_of(sizes.begin(), sizes.end(), [](double size) { return size > 0.0; });
}

Eigen::VectorXd squares(const std::vector<double>& deviations) {
  return Eigen::Map<const Eigen::VectorXd>(deviations.data(), static_cast<Index>(deviations.size())).cwiseAbs2();
}

class FilterBuilder {
 public:
  FilterBuilder(const PlantSpec& spec, const LinearTrial& trial, const CaseNoise& noise, double interval)
      : spec_(spec), trial_(trial), noise_(noise), states_(trial.states) {
    force_memory_ = std::exp(-interval / noise.force_time);
    slow_memory_ = std::exp(-interval / noise.sensor_time);
    white_ = squares(noise.sensor_white) + squares(noise.quantum) / 12.0;
  }

  Filter run(std::size_t samples) const {
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size(), size());
    covariance.diagonal().segment(states_, joints()) = squares(noise_.random_force);
    covariance.diagonal().tail(sensors()) = squares(noise_.sensor_slow);
    Filter filter;
    for (std::size_t k = 0; k < samples; ++k) {
      FilterSample at{reading(k), {}, {}, transition(k)};
      const Eigen::MatrixXd across = covariance * at.reading.transpose();
      Eigen::MatrixXd innovation = at.reading * across;
      innovation.diagonal() += white_;
      const Eigen::LLT<Eigen::MatrixXd> factor(innovation);
      at.scale = factor.matrixL().solve(Eigen::MatrixXd::Identity(sensors(), sensors()));
      const Eigen::MatrixXd update = factor.solve(across.transpose()).transpose();
      at.gain = at.transition * update;
      covariance -= update * across.transpose();
      covariance = at.transition * covariance * at.transition.transpose() + added(k);
      covariance = 0.5 * (covariance + covariance.transpose()).eval();
      filter.push_back(std::move(at));
    }
    return filter;
  }

 private:
  Index joints() const { return static_cast<Index>(noise_.random_force.size()); }
  Index sensors() const { return static_cast<Index>(spec_.sensors.size()); }
  Index size() const { return states_ + joints() + sensors(); }

  Eigen::MatrixXd reading(std::size_t k) const {
    Eigen::MatrixXd of = Eigen::MatrixXd::Zero(sensors(), size());
    of.rightCols(sensors()).setIdentity();
    for (Index s = 0; s < sensors() && states_ > 0; ++s) {
      const PlantSensor& sensor = spec_.sensors[static_cast<std::size_t>(s)];
      of(s, sensor.joint + (sensor.velocity ? trial_.coordinates : 0)) = trial_.reading[static_cast<std::size_t>(s)][k];
    }
    return of;
  }

  const LinearSample* step_from(std::size_t k) const {
    return k < trial_.samples.size() ? &trial_.samples[k] : nullptr;
  }

  Eigen::MatrixXd transition(std::size_t k) const {
    Eigen::MatrixXd of = Eigen::MatrixXd::Zero(size(), size());
    if (const LinearSample* step = step_from(k)) {
      of.topLeftCorner(states_, states_) = step->of_state;
      of.block(0, states_, states_, joints()) = step->of_force_before + force_memory_ * step->of_force_after;
    }
    of.diagonal().segment(states_, joints()).setConstant(force_memory_);
    of.diagonal().tail(sensors()).setConstant(slow_memory_);
    return of;
  }

  /// The covariance of what is new at the next sample.
  Eigen::MatrixXd added(std::size_t k) const {
    Eigen::MatrixXd of_force = Eigen::MatrixXd::Zero(size(), joints());
    of_force.middleRows(states_, joints()).setIdentity();
    const LinearSample* step = step_from(k);
    if (step) of_force.topRows(states_) = step->of_force_after;
    const double new_force = 1.0 - force_memory_ * force_memory_, new_slow = 1.0 - slow_memory_ * slow_memory_;
    Eigen::MatrixXd sum = of_force * (new_force * squares(noise_.random_force)).asDiagonal() * of_force.transpose();
    if (step)
      sum.topLeftCorner(states_, states_) +=
          step->of_command * squares(noise_.command).asDiagonal() * step->of_command.transpose();
    sum.diagonal().tail(sensors()) += new_slow * squares(noise_.sensor_slow);
    return sum;
  }

  const PlantSpec& spec_;
  const LinearTrial& trial_;
  const CaseNoise& noise_;
  Index states_;
  double force_memory_ = 0.0, slow_memory_ = 0.0;
  Eigen::VectorXd white_;
};

Eigen::VectorXd innovations(const Filter& filter, const Eigen::MatrixXd& differences) {
  const Index sensors = differences.cols();
  Eigen::VectorXd whitened(differences.size()), x = Eigen::VectorXd::Zero(filter.front().transition.rows()), next = x;
  Eigen::VectorXd innovation(sensors);
  for (Index k = 0; k < differences.rows(); ++k) {
    const FilterSample& at = filter[static_cast<std::size_t>(k)];
    innovation = differences.row(k).transpose();
    innovation.noalias() -= at.reading * x;
    whitened.segment(k * sensors, sensors).noalias() = at.scale * innovation;
    next.noalias() = at.transition * x;
    next.noalias() += at.gain * innovation;
    x.swap(next);
  }
  return whitened;
}

}  // namespace

Whiten kalman_whitener(const PlantModel& truth, const Eigen::VectorXd& values, const std::vector<TrueTrial>& trials,
                       const CaseNoise& noise, double step) {
  auto filters = std::make_shared<std::vector<Filter>>();  // shared: a Whiten is copied, and filters are large
  const bool disturbed = any(noise.random_force) || any(noise.command);
  for (const TrueTrial& trial : trials) {
    LinearTrial linear;  // of a plant that nothing disturbs, nothing is asked
    if (disturbed) linear = linearised(truth, values, trial, noise.random_force, noise.command, step);
    const FilterBuilder builder(truth.spec, linear, noise, trial.excitation.interval);
    filters->push_back(builder.run(trial.excitation.samples()));
  }
  return [filters](std::size_t trial, const Eigen::MatrixXd& differences) {
    return innovations((*filters)[trial], differences);
  };
}

}  // namespace hidden_effects
