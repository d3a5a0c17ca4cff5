#include "diagnosis/noise_model.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

/// Bins of one channel: white, or correlated as exp(−|Δt|/τ).
Eigen::MatrixXd sensor_shape(const std::vector<RowBins::Bin>& bins, std::size_t channel, bool slow) {
  const auto rows = static_cast<Eigen::Index>(bins.size());
  Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(rows, rows);
  for (Eigen::Index a = 0; a < rows; ++a) {
    const RowBins::Bin& one = bins[static_cast<std::size_t>(a)];
    if (one.channel != channel) continue;
    if (!slow) {
      shape(a, a) = 1.0 / one.count;
      continue;
    }
    for (Eigen::Index b = 0; b < rows; ++b) {
      const RowBins::Bin& other = bins[static_cast<std::size_t>(b)];
      if (other.channel == channel) shape(a, b) = std::exp(-std::abs(one.time - other.time) / kSlowSensor);
    }
  }
  return shape;
}

Eigen::MatrixXd force_shape(const Eigen::MatrixXd& response, const Eigen::VectorXd& times, bool slow) {
  if (!slow) return dense::square(response);
  Eigen::MatrixXd correlation(times.size(), times.size());
  for (Eigen::Index a = 0; a < times.size(); ++a)
    for (Eigen::Index b = 0; b < times.size(); ++b)
      correlation(a, b) = std::exp(-std::abs(times(a) - times(b)) / kSlowForce);
  return dense::product(dense::product(response, correlation), response.transpose());
}

/// Whether a bin lies so near another of its channel that the moment of an event may as well be in one as in the other.
bool near(const RowBins::Bin& one, const RowBins::Bin& other) {
  return one.channel == other.channel && std::abs(one.time - other.time) <= kSlowSensor + 1e-9;
}

/// RMS of the doubts around each bin.
Eigen::VectorXd doubt_around(const std::vector<RowBins::Bin>& bins, const Eigen::MatrixXd& doubt) {
  const Eigen::VectorXd variance = doubt.rowwise().squaredNorm() / static_cast<double>(doubt.cols());
  Eigen::VectorXd around(doubt.rows());
  for (Eigen::Index a = 0; a < doubt.rows(); ++a) {
    double sum = 0.0, count = 0.0;
    for (Eigen::Index b = 0; b < doubt.rows(); ++b) {
      if (!near(bins[static_cast<std::size_t>(a)], bins[static_cast<std::size_t>(b)])) continue;
      sum += variance(b);
      count += 1.0;
    }
    around(a) = std::sqrt(sum / count);
  }
  return around;
}

/// The doubts, and beside them what is as large but less alike: moments of events are not known to a bin.
Eigen::MatrixXd doubt_shape(const std::vector<RowBins::Bin>& bins, const Eigen::MatrixXd& doubt) {
  const Eigen::VectorXd around = doubt_around(bins, doubt);
  Eigen::MatrixXd shape = dense::square(doubt);
  for (Eigen::Index a = 0; a < doubt.rows(); ++a)
    for (Eigen::Index b = 0; b < doubt.rows(); ++b) {
      const RowBins::Bin &one = bins[static_cast<std::size_t>(a)], &other = bins[static_cast<std::size_t>(b)];
      if (one.channel == other.channel)
        shape(a, b) += around(a) * around(b) * std::exp(-std::abs(one.time - other.time) / kSlowSensor);
    }
  return shape;
}

std::vector<NoiseComponent> list_components(const RowBins& bins, const ForceResponses& forces, bool doubtful) {
  using Kind = NoiseComponent::Kind;
  std::map<std::size_t, bool> channels;
  for (std::size_t k = 0; k < bins.segments(); ++k)
    for (const RowBins::Bin& bin : bins.bins(k)) channels[bin.channel] = true;
  std::vector<NoiseComponent> components;
  for (const auto& [channel, unused] : channels) components.push_back({Kind::sensor, channel, 1.0});
  for (const auto& [channel, unused] : channels) components.push_back({Kind::slow_sensor, channel, 0.0});
  for (const Kind kind : {Kind::force, Kind::slow_force})
    for (std::size_t joint = 0; joint < forces.joints.size(); ++joint) components.push_back({kind, joint, 0.0});
  if (doubtful) components.push_back({Kind::doubt, 0, 1.0});
  return components;
}

}  // namespace

dense::Cholesky factor_of(Eigen::MatrixXd covariance) {
  constexpr double kRounding = 1e-10;  // of the largest variance
  dense::Cholesky factor(covariance);
  if (factor.exists()) return factor;
  covariance.diagonal().array() += kRounding * covariance.diagonal().maxCoeff();
  return dense::Cholesky(std::move(covariance));
}

NoiseModel::NoiseModel(const RowBins& bins, const ForceResponses& forces, const std::vector<Eigen::MatrixXd>& doubts)
    : components_(list_components(bins, forces, !doubts.empty())), shapes_(bins.segments()) {
  using Kind = NoiseComponent::Kind;
  std::vector<double> power(components_.size(), 0.0);
  for (std::size_t k = 0; k < bins.segments(); ++k)
    for (std::size_t i = 0; i < components_.size(); ++i) {
      const NoiseComponent& one = components_[i];
      if (one.kind == Kind::doubt) {
        shapes_[k].push_back(doubt_shape(bins.bins(k), doubts[k]));
        power[i] += shapes_[k].back().trace();
        continue;
      }
      const bool slow = one.kind == Kind::slow_sensor || one.kind == Kind::slow_force;
      const bool sensor = one.kind == Kind::sensor || one.kind == Kind::slow_sensor;
      shapes_[k].push_back(sensor ? sensor_shape(bins.bins(k), one.index, slow)
                                  : force_shape(forces.of[k][one.index], forces.times[k], slow));
      power[i] += shapes_[k].back().trace();
    }
  const double white = std::max(power.front(), 1e-300);
  for (const double one : power) sizes_.push_back(one > 0.0 ? std::sqrt(white / one) : 0.0);
  least_.assign(components_.size(), 0.0);
  if (!doubts.empty()) least_.back() = 1.0;
}

void NoiseModel::require_force(std::size_t joint, double deviation) {
  for (std::size_t i = 0; i < components_.size(); ++i)
    if (components_[i].kind == NoiseComponent::Kind::force && components_[i].index == joint) least_[i] = deviation;
}

std::vector<double> NoiseModel::deviations() const {
  std::vector<double> all;
  for (const NoiseComponent& one : components_) all.push_back(one.deviation);
  return all;
}

void NoiseModel::set_deviations(const std::vector<double>& deviations) {
  for (std::size_t i = 0; i < components_.size(); ++i) components_[i].deviation = deviations[i];
}

Eigen::MatrixXd NoiseModel::covariance(std::size_t k) const {
  Eigen::MatrixXd sum = lower_covariance(k);
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  return sum;
}

Eigen::MatrixXd NoiseModel::lower_covariance(std::size_t k) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(shapes_[k].front().rows(), shapes_[k].front().cols());
  std::vector<double> variances;
  std::vector<const double*> shapes;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    if (!(components_[i].deviation > 0.0)) continue;
    variances.push_back(std::pow(components_[i].deviation, 2));
    shapes.push_back(shapes_[k][i].data());
  }
  dense::add_lower(variances, shapes, sum);
  return sum;
}

Eigen::VectorXd NoiseModel::slopes(std::size_t k, const Eigen::MatrixXd& weights) const {
  std::vector<const double*> shapes;
  for (const Eigen::MatrixXd& shape : shapes_[k]) shapes.push_back(shape.data());
  Eigen::VectorXd slopes = dense::trace_products(weights, shapes);
  for (std::size_t i = 0; i < components_.size(); ++i)
    slopes(static_cast<Eigen::Index>(i)) *= 2.0 * std::pow(components_[i].deviation, 2);
  return slopes;
}

}  // namespace lacuna
