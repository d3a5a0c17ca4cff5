#include "measurement/clocks/alignment_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lacuna {
namespace {

constexpr double kSlow = 0.1;  ///< of the usual speed: friction changes its sign within it

/// `alike`: columns that are shifted and scaled in the same way.
void standardise(Eigen::MatrixXd& columns, Eigen::MatrixXd* alike = nullptr) {
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (const double value : columns.col(c)) {
      if (std::isnan(value)) continue;
      sum += value;
      squares += value * value;
      count += 1.0;
    }
    const double mean = sum / count, deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
    if (!(deviation > 0.0)) continue;
    columns.col(c) = (columns.col(c).array() - mean) / deviation;
    if (alike) alike->col(c) = (alike->col(c).array() - mean) / deviation;
  }
}

double size_of(const std::vector<double>& values) {
  double squares = 0.0, count = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) squares += value * value, count += 1.0;
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

using Column = std::vector<double>;

Column twice_beside_rates(const Column& values) { return means_beside_rates(means_beside_rates(values)); }

/// Features of the forces on a reading's joint. Each is smoothed twice, like all other signals, and averaged like a
/// signal that is differentiated twice; otherwise slow and fast parts of a force would belong to different times.
/// Nonlinear functions of the reading are computed before the second smoothing, which changes little.
std::vector<Column> features_of(const ClockedSignal& reading, const Lattice& lattice, std::size_t reach) {
  const Column once = smoothed(step_means(reading.times, reading.values, false, lattice), reach);
  const bool is_position = reading.unit == "rad" || reading.unit == "m";
  const Column same = twice_beside_rates(once), rates = means_beside_rates(rates_of(once, lattice.step));
  std::vector<Column> features = {same, rates};
  if (is_position) features.push_back(rates_of(rates_of(once, lattice.step), lattice.step));
  const Column& velocity = is_position ? rates : same;
  const double usual = size_of(velocity);
  Column direction;
  for (const double value : velocity) direction.push_back(usual > 0.0 ? std::tanh(value / (kSlow * usual)) : 0.0);
  features.push_back(std::move(direction));
  for (const double shift : {0.0, 0.5 * M_PI}) {
    if (reading.unit != "rad") continue;
    Column sine;
    for (const double value : same) sine.push_back(std::sin(value + shift));
    features.push_back(std::move(sine));
  }
  for (Column& feature : features) feature = smoothed(feature, reach);
  return features;
}

/// Every other reading.
ClockedSignal half_of(const ClockedSignal& reading, std::size_t first) {
  ClockedSignal half{reading.name, reading.unit, reading.is_reading, reading.held, {}, {}};
  for (std::size_t i = first; i < reading.times.size(); i += 2) {
    half.times.push_back(reading.times[i]);
    half.values.push_back(reading.values[i]);
  }
  return half;
}

Eigen::MatrixXd matrix_of(const std::vector<Column>& columns, std::size_t rows) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c)
    matrix.col(static_cast<Eigen::Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(columns[c].data(), static_cast<Eigen::Index>(rows));
  return matrix;
}

Sampled sample(const std::vector<ClockedSignal>& signals, const Lattice& lattice) {
  std::vector<Column> features, again, targets;
  for (const ClockedSignal& one : signals) {
    const Column once = smoothed(step_means(one.times, one.values, one.held, lattice), kAlignmentReach);
    targets.push_back(smoothed(twice_beside_rates(once), kAlignmentReach));
    if (!one.is_reading) continue;
    for (Column& feature : features_of(half_of(one, 0), lattice, kAlignmentReach))
      features.push_back(std::move(feature));
    for (Column& feature : features_of(half_of(one, 1), lattice, kAlignmentReach)) again.push_back(std::move(feature));
  }
  Sampled sampled{lattice, matrix_of(features, lattice.count), matrix_of(again, lattice.count),
                  matrix_of(targets, lattice.count)};
  standardise(sampled.features, &sampled.again);
  standardise(sampled.targets);
  return sampled;
}

}  // namespace

double begin_of(const std::vector<ClockedSignal>& signals) {
  double begin = std::numeric_limits<double>::infinity();
  for (const ClockedSignal& one : signals) begin = std::min(begin, one.times.front());
  return begin;
}

double end_of(const std::vector<ClockedSignal>& signals) {
  double end = -std::numeric_limits<double>::infinity();
  for (const ClockedSignal& one : signals) end = std::max(end, one.times.back());
  return end;
}

SampledPair sample_pair(const std::vector<ClockedSignal>& first, const std::vector<ClockedSignal>& second, double step,
                        double offset) {
  const auto lattice = [step](const std::vector<ClockedSignal>& signals, double begin) {
    return Lattice{begin, step, static_cast<std::size_t>((end_of(signals) - begin) / step) + 1};
  };
  const Lattice a = lattice(first, begin_of(first));
  const double behind = std::remainder(a.start - offset - begin_of(second), step);
  const Lattice b = lattice(second, begin_of(second) + behind);
  return {sample(first, a), sample(second, b), a.start - b.start};
}

}  // namespace lacuna
