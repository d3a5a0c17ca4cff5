#pragma once

#include "foundation/processes/stop.h"
#include "storage/queries/query.h"
#include "storage/traces/named_trace.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// A channel of a trace, and which of its parts have it.
struct TraceChannel {
  Channel channel;
  struct Place {
    std::size_t part = 0;
    Eigen::Index column = 0;
  };
  std::vector<Place> places;  ///< in the order of the parts
};

/// The channels of all parts, each once, in the order in which the parts have them.
std::vector<TraceChannel> channels_of(const NamedTrace& trace);

/// A time of a trace, s, and the row of each part that has it; −1: the part has none at that time.
struct TraceTime {
  double time = 0.0;
  std::vector<Eigen::Index> rows;
};

/// Calls `visit` for each time that any part has, the earliest first.
void for_each_time(const NamedTrace& trace, const std::function<void(const TraceTime&)>& visit);

/// The value at a time; NaN where there is none.
double value_at(const NamedTrace& trace, const TraceChannel::Place& place, const TraceTime& time);

/// Hands a trace to `output` as one table: "time [s]", and for each channel a column a part that has it, "angle
/// measured [rad]" beside "angle predicted [rad]". A value that is not known is NULL.
void write_trace_rows(const NamedTrace& trace, QueryOutput& output, const Stop& stop = {});

}  // namespace lacuna
