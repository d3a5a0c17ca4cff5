#include "report/exports/trace_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kNoTime = std::numeric_limits<double>::infinity();

/// The time of a part's row; infinite behind the last.
double time_of(const NamedTrace::Part& part, Eigen::Index row) {
  return row < part.series.times.size() ? part.series.times[row] : kNoTime;
}

}  // namespace

std::vector<TraceChannel> channels_of(const NamedTrace& trace) {
  std::vector<TraceChannel> channels;
  for (std::size_t p = 0; p < trace.parts.size(); ++p) {
    const std::vector<Channel>& of_part = trace.parts[p].series.channels;
    for (std::size_t c = 0; c < of_part.size(); ++c) {
      auto known = std::find_if(channels.begin(), channels.end(),
                                [&](const TraceChannel& one) { return one.channel == of_part[c]; });
      if (known == channels.end()) known = channels.insert(channels.end(), {of_part[c], {}});
      known->places.push_back({p, static_cast<Eigen::Index>(c)});
    }
  }
  return channels;
}

void for_each_time(const NamedTrace& trace, const std::function<void(const TraceTime&)>& visit) {
  const std::size_t parts = trace.parts.size();
  std::vector<Eigen::Index> next(parts, 0);
  TraceTime now{0.0, std::vector<Eigen::Index>(parts, -1)};
  while (true) {
    now.time = kNoTime;
    for (std::size_t p = 0; p < parts; ++p) now.time = std::min(now.time, time_of(trace.parts[p], next[p]));
    if (now.time == kNoTime) return;
    for (std::size_t p = 0; p < parts; ++p) now.rows[p] = time_of(trace.parts[p], next[p]) == now.time ? next[p]++ : -1;
    visit(now);
  }
}

double value_at(const NamedTrace& trace, const TraceChannel::Place& place, const TraceTime& time) {
  const Eigen::Index row = time.rows[place.part];
  if (row < 0) return std::numeric_limits<double>::quiet_NaN();
  return trace.parts[place.part].series.samples(row, place.column);
}

void write_trace_rows(const NamedTrace& trace, QueryOutput& output, const Stop& stop) {
  const std::vector<TraceChannel> channels = channels_of(trace);
  std::vector<std::string> names = {"time [s]"};
  for (const TraceChannel& one : channels)
    for (const TraceChannel::Place& place : one.places)
      names.push_back(fmt::format("{} {} [{}]", one.channel.name, trace.parts[place.part].label, one.channel.unit));
  output.begin(names);
  std::vector<Cell> cells;
  for_each_time(trace, [&](const TraceTime& time) {
    stop.throw_if_due();
    cells.assign(1, time.time);
    for (const TraceChannel& one : channels)
      for (const TraceChannel::Place& place : one.places) {
        const double value = value_at(trace, place, time);
        cells.push_back(std::isnan(value) ? Cell() : Cell(value));
      }
    output.row(cells);
  });
  output.end();
}

}  // namespace lacuna
