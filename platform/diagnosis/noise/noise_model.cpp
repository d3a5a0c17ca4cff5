#include "diagnosis/noise/noise_model.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

/// Correlated as exp(−|Δt|/τ) within each channel.
Eigen::MatrixXd slow_sensor_shape(const std::vector<RowBins::Bin>& bins) {
  const auto rows = static_cast<Eigen::Index>(bins.size());
  Eigen::MatrixXd shape(rows, rows);
  for (Eigen::Index b = 0; b < rows; ++b)
    for (Eigen::Index a = 0; a < rows; ++a) {
      const RowBins::Bin &one = bins[static_cast<std::size_t>(a)], &other = bins[static_cast<std::size_t>(b)];
      shape(a, b) = one.channel == other.channel ? std::exp(-std::abs(one.time - other.time) / kSlowSensor) : 0.0;
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

dense::Cholesky factor_of(const LowerCovariance& covariance, Eigen::MatrixXd storage) {
  constexpr double kRounding = 1e-10;  // of the largest variance
  covariance(storage);
  dense::Cholesky factor(std::move(storage));
  if (factor.exists()) return factor;
  storage = factor.take();
  covariance(storage);
  storage.diagonal().array() += kRounding * storage.diagonal().maxCoeff();
  return dense::Cholesky(std::move(storage));
}

NoiseModel::NoiseModel(const RowBins& bins, const ForceResponses& forces, const std::vector<Eigen::MatrixXd>& doubts)
    : components_(list_components(bins, forces, !doubts.empty())) {
  using Kind = NoiseComponent::Kind;
  for (std::size_t k = 0; k < bins.segments(); ++k) {
    Segment& one = segments_.emplace_back(segment(bins.bins(k)));
    for (Component i = 0; i < components_.size(); ++i) {
      const auto [kind, index, unused] = components_[i];
      const std::vector<Component> of(one.sensor_of.size(), i);
      if (kind == Kind::doubt) one.shapes.push_back({doubt_shape(bins.bins(k), doubts[k]), of});
      if (kind == Kind::force || kind == Kind::slow_force)
        one.shapes.push_back({force_shape(forces.of[k][index], forces.times[k], kind == Kind::slow_force), of});
    }
  }
  const std::vector<double> powers = power();
  const double white = std::max(powers.front(), 1e-300);
  for (const double one : powers) sizes_.push_back(one > 0.0 ? std::sqrt(white / one) : 0.0);
  least_.assign(components_.size(), 0.0);
  if (!doubts.empty()) least_.back() = 1.0;
}

/// Of the sensors' noise.
NoiseModel::Segment NoiseModel::segment(const std::vector<RowBins::Bin>& bins) const {
  using Kind = NoiseComponent::Kind;
  Segment one{Eigen::VectorXd(static_cast<Eigen::Index>(bins.size())), {}, {{slow_sensor_shape(bins), {}}}};
  for (const RowBins::Bin& bin : bins) {
    const auto component = [&](Kind kind) {
      const auto found = std::find_if(components_.begin(), components_.end(), [&](const NoiseComponent& other) {
        return other.kind == kind && other.index == bin.channel;
      });
      return static_cast<Component>(found - components_.begin());
    };
    one.white(static_cast<Eigen::Index>(one.sensor_of.size())) = 1.0 / bin.count;
    one.sensor_of.push_back(component(Kind::sensor));
    one.shapes.front().of.push_back(component(Kind::slow_sensor));
  }
  return one;
}

std::vector<double> NoiseModel::power() const {
  std::vector<double> powers(components_.size(), 0.0);
  for (const Segment& one : segments_)
    for (std::size_t row = 0; row < one.sensor_of.size(); ++row) {
      const auto at = static_cast<Eigen::Index>(row);
      powers[one.sensor_of[row]] += one.white(at);
      for (const Shape& shape : one.shapes) powers[shape.of[row]] += shape.covariance(at, at);
    }
  return powers;
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

double NoiseModel::variance(Component component) const { return std::pow(components_[component].deviation, 2); }

Eigen::MatrixXd NoiseModel::covariance(std::size_t k) const {
  Eigen::MatrixXd sum;
  lower_covariance(k, sum);
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  return sum;
}

void NoiseModel::lower_covariance(std::size_t k, Eigen::MatrixXd& sum) const {
  const Segment& segment = segments_[k];
  const Eigen::Index rows = segment.white.size();
  Eigen::MatrixXd factors(rows, static_cast<Eigen::Index>(segment.shapes.size()));
  std::vector<const double*> terms;
  for (const Shape& shape : segment.shapes) {
    auto of_columns = factors.col(static_cast<Eigen::Index>(terms.size()));
    for (Eigen::Index column = 0; column < rows; ++column)
      of_columns(column) = variance(shape.of[static_cast<std::size_t>(column)]);
    if (!of_columns.isZero(0.0)) terms.push_back(shape.covariance.data());
  }
  sum.resize(rows, rows);
  dense::sum_lower(terms, factors, sum);
  for (Eigen::Index row = 0; row < rows; ++row)
    sum(row, row) += variance(segment.sensor_of[static_cast<std::size_t>(row)]) * segment.white(row);
}

Eigen::VectorXd NoiseModel::slopes(std::size_t k, const Eigen::MatrixXd& weights) const {
  const Segment& segment = segments_[k];
  std::vector<const double*> terms;
  for (const Shape& shape : segment.shapes) terms.push_back(shape.covariance.data());
  const Eigen::MatrixXd traces = dense::trace_products(weights, terms);
  Eigen::VectorXd slopes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(components_.size()));
  for (std::size_t row = 0; row < segment.sensor_of.size(); ++row) {
    const auto at = static_cast<Eigen::Index>(row);
    slopes(static_cast<Eigen::Index>(segment.sensor_of[row])) += weights(at, at) * segment.white(at);
    for (std::size_t i = 0; i < terms.size(); ++i)
      slopes(static_cast<Eigen::Index>(segment.shapes[i].of[row])) += traces(at, static_cast<Eigen::Index>(i));
  }
  for (Component i = 0; i < components_.size(); ++i) slopes(static_cast<Eigen::Index>(i)) *= 2.0 * variance(i);
  return slopes;
}

}  // namespace lacuna
