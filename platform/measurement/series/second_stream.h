#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// Readings between those of a channel that follow another course, constant or smooth: what a second publisher or
/// another sensor wrote.
struct SecondStream {
  std::vector<std::size_t> readings;  ///< indices of the column, ascending
  std::size_t of = 0;                 ///< readings in all
  std::optional<double> constant;     ///< the value that all of them have
  bool is_sure = false;               ///< few enough to tell which of the two courses is the channel's
};

/// Found where two courses go through the readings, both of which change much less from one of their readings to the
/// next than they are apart, in turns of a few readings, and neither follows the other at a distance, as the two sides
/// of a vibration or of a quantiser do. `times` ascend; NaN among `column`: missing.
std::optional<SecondStream> find_second_stream(std::span<const double> times, std::span<const double> column);

/// Whether a channel's readings in some rows, those of another channel's second stream, are apart from the others, too.
bool stands_apart(std::span<const double> times, std::span<const double> column, std::span<const std::size_t> rows);

}  // namespace lacuna
