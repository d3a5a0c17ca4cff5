#pragma once

#include <lacuna/robot_spec.h>

#include <cstdint>
#include <cstddef>
#include <span>
#include <vector>

namespace lacuna::simulation {

/// A standard normal number that depends only on its key (SplitMix64 mixing, G. L. Steele et al., OOPSLA 2014; Box and
/// Muller 1958).
double keyed_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter);

/// Adds white noise to the readings of `sensors` (all channels, spec order) taken at `time`, and quantises them. The
/// same seed, time and step always give the same noise: a controller and the recorded output get the same reading.
/// Quantisers round to the nearest multiple.
void add_imperfections(const std::vector<SensorSpec>& sensors, std::span<const std::size_t> first_channel,
                       std::uint64_t seed, double time, double step, std::span<double> readings);

}  // namespace lacuna::simulation
