#include "diagnosis/rounds/channel_errors.h"

#include "diagnosis/refit/cross_validation.h"

#include <cmath>

namespace lacuna {
namespace {

struct Sums {
  double floor = 0.0, fit = 0.0, held_out = 0.0, count = 0.0;
};

/// Variance of what noise alone leaves in each bin once the segment's start, which is N(0, 1) in `state`, was fitted.
Eigen::VectorXd left_by_noise(Eigen::MatrixXd noise, const Eigen::MatrixXd& state) {
  Eigen::MatrixXd both = noise;
  dense::add_square(1.0, state, both);
  dense::Cholesky(std::move(both)).solve_lower(noise);
  return noise.colwise().squaredNorm().transpose();
}

}  // namespace

std::vector<ChannelError> channel_errors(const BaseSolution& base, const RowBins& bins, const NoiseModel& noise,
                                         const Refit& fit, const Folds& folds) {
  const std::vector<Eigen::VectorXd> steps = steps_without(fit, folds);
  std::vector<Sums> sums(base.noise.size());
  for (std::size_t k = 0; k < bins.segments(); ++k) {
    const Eigen::VectorXd variance = left_by_noise(noise.covariance(k), base.linear[k].state);
    for (std::size_t i = 0; i < bins.bins(k).size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      Sums& channel = sums[bins.bins(k)[i].channel];
      channel.floor += variance(row);
      channel.fit += std::pow(fit.bin_residuals[k](row), 2);
      const Eigen::VectorXd& step = steps[folds[k][fit.segments[k].block_of[i]]];
      channel.held_out += std::pow(fit.bin_residuals[k](row) + fit.bin_derivatives[k].row(row).dot(step), 2);
      channel.count += 1.0;
    }
  }
  std::vector<ChannelError> errors;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    if (sums[c].count == 0.0) continue;
    const ChannelNoise& sensor = base.noise[c];
    const auto size = [&](double squares) { return sensor.deviation * std::sqrt(squares / sums[c].count); };
    errors.push_back({sensor.channel, sensor.unit, size(sums[c].floor), size(sums[c].fit), size(sums[c].held_out)});
  }
  return errors;
}

double times_floor(const std::vector<ChannelError>& errors) {
  double squares = 0.0;
  for (const ChannelError& error : errors) squares += std::pow(error.held_out / error.floor, 2);
  return errors.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(errors.size()));
}

double above_floor(const ChannelError& error) { return std::pow(error.held_out / error.floor, 2) - 1.0; }

double above_floor(const std::vector<ChannelError>& errors) { return std::pow(times_floor(errors), 2) - 1.0; }

}  // namespace lacuna
