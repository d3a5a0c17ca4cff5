#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// A counter that starts again, as the jumps of its readings show it.
struct FoundWrap {
  std::vector<double> moduli;  ///< that the readings allow, the likeliest first; empty: no usual one
  bool is_certain = false;     ///< the first one is the only one, or the one that the experiment knows
  double estimate = 0.0;       ///< of the modulus, from the jumps alone
  double error = 0.0;          ///< of that, standard
  std::size_t jumps = 0;
  std::size_t first = 0;  ///< the reading after the first jump, counted over all files
};

/// Whether a position jumps as a counter that starts again does, and at which count: a jump is the modulus less the
/// step that the motion took meanwhile, which the readings around it tell. What that is good to is measured where
/// nothing jumps. Usual are moduli that readings do not exceed, of factors 2, 3 and 5, and those in `turns`, counts or
/// lengths of a turn in the column's unit. A modulus is also impossible where crossings as slow as these would have
/// shown readings beyond the largest and smallest. Nothing where jumps are not alike, as those of glitches and steps.
/// `files`: the column of each; NaN: missing.
std::optional<FoundWrap> find_wrap(std::span<const std::vector<double>> files, std::span<const double> turns);

}  // namespace lacuna
