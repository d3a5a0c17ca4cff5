#include "eea/ensemble/band_support.h"

#include <lacuna/random_stream.h>

#include "foundation/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace lacuna {
namespace {

constexpr double kLevel = 0.95;
constexpr int kResamples = 2000;

/// Ratios of one trial.
using Ratios = std::vector<double>;

double share_within(const Ratios& ratios, double factor) {
  const auto inside = std::count_if(ratios.begin(), ratios.end(), [&](double ratio) { return ratio <= factor; });
  return static_cast<double>(inside) / static_cast<double>(ratios.size());
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Of shares, one per trial.
Coverage coverage_of(const std::vector<double>& shares, std::uint64_t seed) {
  if (shares.empty()) return {};
  RandomStream random(std::array{seed});
  std::vector<double> means(kResamples), drawn(shares.size());
  for (double& mean : means) {
    for (double& share : drawn) share = shares[random.index(shares.size())];
    mean = mean_of(drawn);
  }
  std::sort(means.begin(), means.end());
  const auto at = [&](double probability) { return means[static_cast<std::size_t>(probability * (kResamples - 1))]; };
  return {mean_of(shares), at(0.5 * (1.0 - kLevel)), at(0.5 * (1.0 + kLevel))};
}

/// The smallest factor under which 95 % of the readings lie; each trial has the same weight.
double factor_of(const std::vector<Ratios>& trials) {
  std::vector<std::pair<double, double>> weighted;  // ratio, weight
  for (const Ratios& ratios : trials)
    for (const double ratio : ratios) weighted.emplace_back(ratio, 1.0 / static_cast<double>(ratios.size()));
  std::sort(weighted.begin(), weighted.end());
  constexpr double kRounding = 1e-9;
  const double wanted = (kLevel - kRounding) * static_cast<double>(trials.size());
  double weight = 0.0;
  for (const auto& [ratio, own] : weighted)
    if ((weight += own) >= wanted) return ratio;
  return kNotKnown;
}

double error_of(const std::vector<Ratios>& trials) {
  double sum = 0.0;
  for (const Ratios& ratios : trials)
    sum += std::inner_product(ratios.begin(), ratios.end(), ratios.begin(), 0.0) / static_cast<double>(ratios.size());
  return kWithin95 * std::sqrt(sum / static_cast<double>(trials.size()));
}

ChannelSupport channel_support(const std::vector<Ratios>& trials, std::uint64_t seed) {
  ChannelSupport support;
  support.trials = trials.size();
  if (trials.empty()) return support;
  std::vector<double> shares;
  for (const Ratios& ratios : trials) shares.push_back(share_within(ratios, 1.0));
  support.inside = coverage_of(shares, seed);
  support.error = error_of(trials);
  support.factor = factor_of(trials);
  return support;
}

/// A channel's ratios of all but one of the trials that measured it.
std::vector<Ratios> of_channel(const std::vector<HeldOutTrial>& trials, std::size_t channel,
                               const HeldOutTrial* without = nullptr) {
  std::vector<Ratios> chosen;
  for (const HeldOutTrial& trial : trials)
    if (&trial != without && !trial.ratios[channel].empty()) chosen.push_back(trial.ratios[channel]);
  return chosen;
}

/// All channels' ratios, one row per trial; `factors`: of the channels' bands.
std::vector<double> all_of(const HeldOutTrial& trial, const std::vector<double>& factors) {
  std::vector<double> all;
  for (std::size_t c = 0; c < trial.ratios.size(); ++c)
    for (const double ratio : trial.ratios[c]) all.push_back(ratio / factors[c]);
  return all;
}

/// Factors of the channels, from the other trials.
std::vector<double> factors_without(const std::vector<HeldOutTrial>& trials, const HeldOutTrial& trial) {
  std::vector<double> factors;
  for (std::size_t c = 0; c < trial.ratios.size(); ++c) {
    const std::vector<Ratios> others = of_channel(trials, c, &trial);
    const double factor = others.empty() ? 1.0 : factor_of(others);
    factors.push_back(factor > 1.0 && std::isfinite(factor) ? factor : 1.0);
  }
  return factors;
}

Coverage widened_coverage(const std::vector<HeldOutTrial>& trials, std::uint64_t seed) {
  std::vector<double> shares;
  for (const HeldOutTrial& trial : trials)
    if (const std::vector<double> all = all_of(trial, factors_without(trials, trial)); !all.empty())
      shares.push_back(share_within(all, 1.0));
  return coverage_of(shares, seed);
}

}  // namespace

double ChannelSupport::widening() const {
  return trials >= kFewestHeldOut && factor > 1.0 && std::isfinite(factor) ? factor : 1.0;
}

std::vector<std::vector<double>> band_ratios(const EnsembleBand& band, const Trial& trial,
                                             const std::vector<Eigen::Index>& map) {
  std::vector<std::vector<double>> ratios(static_cast<std::size_t>(band.mean.cols()));
  for (std::size_t c = 0; c < map.size(); ++c)
    for (Eigen::Index row = 0; row < trial.measured.samples.rows(); ++row) {
      const double off = std::abs(trial.measured.samples(row, static_cast<Eigen::Index>(c)) - band.mean(row, map[c]));
      const double half_width = band.half_width(row, map[c]);
      if (std::isfinite(off)) ratios[static_cast<std::size_t>(map[c])].push_back(off > 0.0 ? off / half_width : 0.0);
    }
  return ratios;
}

BandSupport support_of(std::vector<HeldOutTrial> trials, std::uint64_t seed) {
  BandSupport support;
  const std::size_t channels = trials.empty() ? 0 : trials.front().ratios.size();
  std::vector<Ratios> all;
  for (const HeldOutTrial& trial : trials)
    if (Ratios one = all_of(trial, std::vector<double>(channels, 1.0)); !one.empty()) all.push_back(std::move(one));
  for (std::size_t c = 0; c < channels; ++c) support.channels.push_back(channel_support(of_channel(trials, c), seed));
  support.all = channel_support(all, seed);
  if (support.enough()) support.widened = widened_coverage(trials, seed);
  support.trials = std::move(trials);
  return support;
}

void widen(EnsembleBand& band, const BandSupport& support) {
  for (std::size_t c = 0; c < support.channels.size(); ++c)
    band.half_width.col(static_cast<Eigen::Index>(c)) *= support.channels[c].widening();
}

}  // namespace lacuna
