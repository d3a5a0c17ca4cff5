#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace lacuna {

/// Probability by chance below which something is there.
inline constexpr double kPresent = 0.05;

/// Neighbouring blocks of time may err together: so many are taken for one, and the worst counts.
inline constexpr std::array<Eigen::Index, 3> kBlocksTogether = {1, 2, 4};

/// The standard error of a sum over blocks of time: the largest from blocks taken once, twice and four times as long,
/// since neighbouring blocks may err together.
double standard_error(const Eigen::VectorXd& by_block);

/// How often the largest of several gains, each a sum over blocks of time, is as large by chance: under random signs of
/// the blocks, the same for all gains (P. H. Westfall and S. S. Young, "Resampling-Based Multiple Testing", 1993).
/// Gains are over the root of their blocks' squares. The largest for blocks once, twice and four times as long. At
/// least 1/1000; 1 where there are too few blocks.
double sign_probability(const std::vector<Eigen::VectorXd>& gains, std::uint64_t seed);

}  // namespace lacuna
