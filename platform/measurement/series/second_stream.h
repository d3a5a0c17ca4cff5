#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// Readings among those of a channel that belong to another series, constant or smooth: from a second publisher or
/// another sensor.
struct SecondStream {
  std::vector<std::size_t> readings;  ///< indices of the column, ascending
  std::size_t of = 0;                 ///< readings in all
  std::optional<double> constant;     ///< the common value of all of them
  bool is_sure = false;               ///< few enough to identify the channel's own series
};

/// Found where the readings form two series, each changing much less from one of its readings to the next than the
/// distance between them, in groups of a few readings, and neither follows the other at a distance, like the two sides
/// of a vibration or of a quantiser. `times` ascend; NaN among `column`: missing.
std::optional<SecondStream> find_second_stream(std::span<const double> times, std::span<const double> column);

/// Whether a channel's readings in some rows, those of another channel's second series, are apart from the others, too.
bool stands_apart(std::span<const double> times, std::span<const double> column, std::span<const std::size_t> rows);

}  // namespace lacuna
