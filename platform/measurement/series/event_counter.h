#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// A reading that is good for one moment.
struct CountedEvent {
  std::size_t row = 0;     ///< the first one after the event
  double position = 0.0;   ///< there, the likeliest
  double deviation = 0.0;  ///< of that: the event was at some time since the row before
};

/// A position that counts events, such as one pulse a turn, and stands still in between.
struct EventCounter {
  std::vector<CountedEvent> events;  ///< none: it is none
  double count = 0.0;                ///< from event to event
  double rows_between = 0.0;         ///< usual
};

/// Found where all changes are of one count, of `coarse` at least, with several rows in between. Between two of them a
/// position is anywhere within the count, and stays on one side of the error that a quantiser makes, row after row; at
/// a change it is known to what the motion goes from row to row. An encoder that moves slowly looks alike but for its
/// count, which is far below `coarse`. `values`: NaN: missing; may be rounded as printed.
EventCounter find_events(std::span<const double> times, std::span<const double> values, double coarse);

}  // namespace lacuna
