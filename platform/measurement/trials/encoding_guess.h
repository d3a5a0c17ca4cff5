#pragma once

#include "foundation/text/encoding.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// Knowledge about a column before its readings are examined.
struct EncodingHints {
  bool is_position = true;         ///< only a position continues where a counter restarts
  std::vector<double> turns = {};  ///< full turns in the column's numbers
};

/// An encoding that a column shows.
struct FoundEncoding {
  Encoding encoding;      ///< automatic: the jumps are those of a counter that restarts, and its count is not certain
  std::size_t jumps = 0;  ///< that it explains
  std::size_t first = 0;  ///< the reading after the first of them, counted over all files
  std::vector<double> moduli = {};     ///< for a counter that restarts: all counts that agree with the readings
  double estimate = 0.0, error = 0.0;  ///< estimate of that count from the jumps alone, and its standard error
};

/// The one encoding under which a column's jumps vanish. `files`: the column as each file writes it, NaN where a
/// reading is missing. Of whole numbers that are not negative, of at least 8 bits:
///  - `sign_bit 2^b`, b the highest bit in use: found where every jump of half of 2^b or more becomes a change as small
///    as the usual ones;
///  - `twos_complement 2^(b+1)`: the same, and a position stays in the lowest and the highest quarter.
/// Of any position: `wraps M` (wrap_guess.h). Nothing where a column has no such jump, as any that was measured as it
/// is.
std::optional<FoundEncoding> guess_encoding(std::span<const std::vector<double>> files, const EncodingHints& hints);

}  // namespace lacuna
