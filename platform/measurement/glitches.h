#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// Indices of readings that are glitches: up to three in a row that leave the signal by far more than it ever changes
/// from one reading to the next and come back to where it went on. `values`: in order of time; NaN: missing. Impacts,
/// steps and the largest swings are none: they do not come back, or are no farther than the usual changes allow.
std::vector<std::size_t> find_glitches(std::span<const double> values);

}  // namespace lacuna
