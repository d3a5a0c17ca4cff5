#pragma once

#include "foundation/encoding.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// An encoding that a column shows.
struct FoundEncoding {
  Encoding encoding;
  std::size_t jumps = 0;  ///< that it explains
  std::size_t first = 0;  ///< the reading after the first of them, counted over all files
};

/// The one encoding under which a column's jumps vanish. `files`: the column as each file writes it, NaN where a
/// reading is missing; `unit`: as the experiment gives it. Found only where every jump of half the modulus or more
/// becomes a change as small as the usual ones, and the values are such as the encoding can write:
///  - `sign_bit 2^(b−1)`: whole numbers, some of them from 2^(b−1) on and none that is large in both ranges;
///  - `twos_complement 2^b`: whole numbers within [0, 2^b), all in the lowest and the highest quarter;
///  - `wraps M`: values within [0, M) or [−M/2, M/2); M a power of two of counts, or a turn of the unit.
/// Nothing where a column has no such jump, as any that was measured as it is.
std::optional<FoundEncoding> guess_encoding(std::span<const std::vector<double>> files, const std::string& unit);

}  // namespace lacuna
