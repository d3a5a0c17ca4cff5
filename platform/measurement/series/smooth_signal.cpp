#include "measurement/series/smooth_signal.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// A line through samples, integrated.
class Integral {
 public:
  Integral(std::span<const double> times, std::span<const double> values, bool held)
      : times_(times), values_(values), held_(held), slopes_(times.size(), 0.0), to_(times.size(), 0.0) {
    const std::size_t last = times.size() - 1;
    for (std::size_t i = 0; !held && i <= last; ++i) {
      const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, last);
      slopes_[i] = (values[after] - values[before]) / (times[after] - times[before]);
    }
    for (std::size_t i = 0; i < last; ++i) to_[i + 1] = to_[i] + part(i, times[i + 1] - times[i]);
  }

  /// From the first sample to `time`, which lies between samples; times asked for ascend.
  double to(double time) {
    while (at_ + 2 < times_.size() && times_[at_ + 1] <= time) ++at_;
    return to_[at_] + part(at_, time - times_[at_]);
  }

 private:
  /// Of the piece after sample i, over its first `length` seconds.
  double part(std::size_t i, double length) const {
    if (held_) return length * values_[i];
    const double h = times_[i + 1] - times_[i], s = length / h;
    const double s2 = s * s, s3 = s2 * s, s4 = s3 * s;
    const double before = s - s3 + 0.5 * s4, after = s3 - 0.5 * s4;
    const double leaving = 0.5 * s2 - 2.0 / 3.0 * s3 + 0.25 * s4, arriving = 0.25 * s4 - s3 / 3.0;
    return h * (before * values_[i] + after * values_[i + 1] + h * (leaving * slopes_[i] + arriving * slopes_[i + 1]));
  }

  std::span<const double> times_, values_;
  bool held_;
  std::vector<double> slopes_, to_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<double> step_means(std::span<const double> times, std::span<const double> values, bool held,
                               const Lattice& lattice) {
  std::vector<double> means(lattice.count, std::nan(""));
  if (times.size() < 2) return means;
  Integral integral(times, values, held);
  for (std::size_t i = 0; i < lattice.count; ++i) {
    const double from = lattice.start + (static_cast<double>(i) - 0.5) * lattice.step, to = from + lattice.step;
    if (from < times.front() || to > times.back()) continue;
    const double before = integral.to(from);
    means[i] = (integral.to(to) - before) / lattice.step;
  }
  return means;
}

std::vector<double> smoothed(std::span<const double> values, std::size_t reach) {
  std::vector<double> weights;
  double sum = 0.0;
  for (std::size_t i = 0; i <= 2 * reach; ++i) {
    const double place = (static_cast<double>(i) - static_cast<double>(reach)) / (static_cast<double>(reach) + 1.0);
    weights.push_back(std::pow(std::cos(0.5 * M_PI * place), 2));
    sum += weights.back();
  }
  std::vector<double> result(values.size(), std::nan(""));
  for (std::size_t i = reach; i + reach < values.size(); ++i) {
    double total = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k) total += weights[k] * values[i + k - reach];
    result[i] = total / sum;
  }
  return result;
}

std::vector<double> rates_of(std::span<const double> values, double step) {
  std::vector<double> rates(values.size(), std::nan(""));
  for (std::size_t i = 1; i + 1 < values.size(); ++i) rates[i] = (values[i + 1] - values[i - 1]) / (2.0 * step);
  return rates;
}

std::vector<double> means_beside_rates(std::span<const double> values) {
  std::vector<double> means(values.size(), std::nan(""));
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    means[i] = (values[i - 1] + 4.0 * values[i] + values[i + 1]) / 6.0;
  return means;
}

}  // namespace lacuna
