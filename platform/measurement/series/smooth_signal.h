#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// Evenly spaced moments.
struct Lattice {
  double start = 0.0;  ///< s
  double step = 0.0;   ///< s
  std::size_t count = 0;
};

/// A signal's means over the lattice's steps, each around its time: of a line through the samples that is constant
/// between them (held) or smooth (cubic, with the slopes of central differences). NaN before the first sample and after
/// the last. `times` ascend; values are finite.
std::vector<double> step_means(std::span<const double> times, std::span<const double> values, bool held,
                               const Lattice& lattice);

/// Weighted means over 2·reach + 1 neighbours, with weights that fall to zero like a squared cosine. NaN where one of
/// them is.
std::vector<double> smoothed(std::span<const double> values, std::size_t reach);

/// Rates of change by central differences; NaN at the ends. Such a rate is the mean of the true one from the time
/// before to the one after.
std::vector<double> rates_of(std::span<const double> values, double step);

/// Means from the time before to the one after, of parabolas: the form of a signal that is compared with rates.
std::vector<double> means_beside_rates(std::span<const double> values);

}  // namespace lacuna
