#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// A reading that is valid at one time.
struct CountedEvent {
  std::size_t row = 0;     ///< the first one after the event
  double position = 0.0;   ///< there, the likeliest
  double deviation = 0.0;  ///< of that: the event was at some time since the row before
};

/// A position that counts events, such as one pulse per turn, and is constant in between.
struct EventCounter {
  std::vector<CountedEvent> events;  ///< none: the channel does not count events
  double count = 0.0;                ///< from event to event
  double rows_between = 0.0;         ///< usual
};

/// Found where all changes are of one count, of at least `coarse`, with several rows in between. Between two changes
/// the position is anywhere within the count, with a constant error row after row, unlike a quantiser's; at a change it
/// is known up to the motion of one row. A slow encoder looks the same except for its count, which is far below
/// `coarse`. `values`: NaN: missing; may be rounded as printed.
EventCounter find_events(std::span<const double> times, std::span<const double> values, double coarse);

}  // namespace lacuna
