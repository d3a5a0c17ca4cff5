#include "fitting/numerics/local_polynomial.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lacuna {
namespace {

using Range = std::pair<Eigen::Index, Eigen::Index>;

std::vector<Eigen::Index> measured_within(const TimeSeries& series, Eigen::Index channel, Range range, double from,
                                          double to) {
  const double* begin = series.times.data();
  const Eigen::Index first = std::lower_bound(begin + range.first, begin + range.second, from) - begin;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = first; row < range.second && series.times(row) <= to; ++row)
    if (std::isfinite(series.samples(row, channel))) rows.push_back(row);
  return rows;
}

std::vector<Eigen::Index> nearby(const TimeSeries& series, Eigen::Index channel, Range range, Eigen::Index sample,
                                 double window, std::size_t wanted) {
  const double first = series.times(range.first);
  const double last = series.times(range.second - 1);
  while (true) {
    const double from = std::max(first, std::min(series.times(sample) - 0.5 * window, last - window));
    std::vector<Eigen::Index> rows = measured_within(series, channel, range, from, from + window * (1.0 + 1e-9));
    if (rows.size() >= wanted || window > last - first) return rows;
    window *= 2.0;
  }
}

constexpr int kOfOneStep = 4;  ///< number of readings to which a line on one step of an encoder is equivalent

}  // namespace

double repetition(const TimeSeries& series, Eigen::Index channel, Range range) {
  int readings = 0, worth = kOfOneStep;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (Eigen::Index row = range.first; row < range.second; ++row) {
    const double reading = series.samples(row, channel);
    if (!std::isfinite(reading)) continue;
    if (readings > 0 && reading != before) ++worth;
    ++readings;
    before = reading;
  }
  return readings > worth ? std::sqrt(static_cast<double>(readings) / worth) : 1.0;
}

LocalPolynomial fit_local_polynomial(const TimeSeries& series, Eigen::Index channel, Range range, Eigen::Index sample,
                                     int degree, double window, double noise) {
  const std::vector<Eigen::Index> rows =
      nearby(series, channel, range, sample, window, 2 * static_cast<std::size_t>(degree) + 3);
  LocalPolynomial result;
  result.points = static_cast<int>(rows.size());
  if (rows.empty()) return result;
  const auto size = static_cast<Eigen::Index>(rows.size());
  const Eigen::Index terms = std::min<Eigen::Index>(degree + 1, std::max<Eigen::Index>(1, size / 2));
  const double span = std::max(window, series.times(rows.back()) - series.times(rows.front()));

  Eigen::MatrixXd powers(size, terms);
  Eigen::VectorXd values(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index row = rows[static_cast<std::size_t>(i)];
    const double x = (series.times(row) - series.times(sample)) / span;
    for (Eigen::Index term = 0; term < terms; ++term) powers(i, term) = std::pow(x, static_cast<double>(term));
    values(i) = series.samples(row, channel);
  }
  const Eigen::VectorXd coefficients = powers.colPivHouseholderQr().solve(values);
  const Eigen::MatrixXd information = powers.transpose() * powers;
  const Eigen::MatrixXd covariance = information.completeOrthogonalDecomposition().pseudoInverse();
  result.value = coefficients(0);
  // Where the motion is no parabola, the scatter about it shows this.
  if (size > terms)
    noise = std::max(noise, (powers * coefficients - values).norm() / std::sqrt(static_cast<double>(size - terms)));
  noise *= repetition(series, channel, {rows.front(), rows.back() + 1});
  result.value_deviation = noise * std::sqrt(covariance(0, 0));
  result.slope = terms > 1 ? coefficients(1) / span : 0.0;
  result.slope_deviation = terms > 1 ? noise * std::sqrt(covariance(1, 1)) / span : noise / window;
  return result;
}

}  // namespace lacuna
