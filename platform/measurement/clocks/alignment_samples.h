#pragma once

#include "measurement/clocks/clock_alignment.h"
#include "measurement/series/smooth_signal.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lacuna {

constexpr std::size_t kAlignmentReach = 4;  ///< steps, of each of two smoothings

/// Of all signals of a device.
double begin_of(const std::vector<ClockedSignal>& signals);
double end_of(const std::vector<ClockedSignal>& signals);

/// The signals of one device at even times: features that may explain other signals, from every other reading and from
/// those between, and targets to be explained.
struct Sampled {
  Lattice lattice;
  Eigen::MatrixXd features, again, targets;
};

/// Both devices on lattices of one step.
struct SampledPair {
  Sampled first, second;
  double base = 0.0;  ///< s, the offset at a shift of no step
  double offset(std::int64_t shift) const { return base + static_cast<double>(shift) * first.lattice.step; }
};

/// `offset`: one that is a whole number of steps from that of shift zero.
SampledPair sample_pair(const std::vector<ClockedSignal>& first, const std::vector<ClockedSignal>& second, double step,
                        double offset = 0.0);

}  // namespace lacuna
