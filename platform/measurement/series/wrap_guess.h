#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// A counter that restarts, according to the jumps of its readings.
struct FoundWrap {
  std::vector<double> moduli;  ///< counts that agree with the readings, the most likely first; empty: no usual one
  bool is_certain = false;     ///< the first one is the only one, or is known to the experiment
  double estimate = 0.0;       ///< estimate of the modulus from the jumps alone
  double error = 0.0;          ///< of that, standard
  std::size_t jumps = 0;
  std::size_t first = 0;  ///< the reading after the first jump, counted over all files
};

/// Whether a position jumps like a counter that restarts, and at which count: a jump is the modulus minus the motion
/// during the step, which the readings around it show. The accuracy of this is measured where nothing jumps. Usual are
/// moduli that readings do not exceed, with factors 2, 3 and 5, and those in `turns`, counts or lengths of a turn in
/// the column's unit. A modulus is also impossible if crossings as slow as these would have shown readings beyond the
/// largest and smallest. Nothing where jumps differ, like those of glitches and steps. `files`: the column of each;
/// NaN: missing.
std::optional<FoundWrap> find_wrap(std::span<const std::vector<double>> files, std::span<const double> turns);

}  // namespace lacuna
