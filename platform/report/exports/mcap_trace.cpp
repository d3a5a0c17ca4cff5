#include "report/exports/mcap_trace.h"

#include "report/exports/mcap_writer.h"
#include "report/exports/trace_rows.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kNanoseconds = 1e9;  ///< in a second

std::string schema_of(const NamedTrace& trace, const TraceChannel& channel) {
  nlohmann::ordered_json properties = {{"time", {{"type", "number"}, {"description", "time in s"}}}};
  for (const TraceChannel::Place& place : channel.places) {
    const std::string& label = trace.parts[place.part].label;
    properties[label] = {
        {"type", "number"},
        {"description", fmt::format("{} {} in {}", label, channel.channel.name, channel.channel.unit)}};
  }
  return nlohmann::ordered_json{{"type", "object"}, {"properties", properties}}.dump(
      -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<McapChannel> topics_of(const NamedTrace& trace, const std::vector<TraceChannel>& channels) {
  std::vector<McapChannel> topics;
  for (const TraceChannel& one : channels) {
    McapChannel topic{"/" + one.channel.name, "lacuna." + one.channel.name, schema_of(trace, one), {}};
    topic.metadata = {{"experiment", trace.experiment}, {"trial", trace.trial}, {"unit", one.channel.unit}};
    if (trace.revision) topic.metadata["revision"] = std::to_string(*trace.revision);
    topics.push_back(std::move(topic));
  }
  return topics;
}

/// Empty where nothing of the channel is known at that time.
std::string message(const NamedTrace& trace, const TraceChannel& channel, const TraceTime& time) {
  std::string values;
  for (const TraceChannel::Place& place : channel.places) {
    const double value = value_at(trace, place, time);
    if (std::isfinite(value)) values += fmt::format(",\"{}\":{}", trace.parts[place.part].label, value);
  }
  return values.empty() ? values : fmt::format("{{\"time\":{}{}}}", time.time, values);
}

/// What is taken off all times, s: none may be negative.
double origin_of(const NamedTrace& trace) {
  double first = 0.0;
  for (const NamedTrace::Part& part : trace.parts)
    if (part.series.times.size() > 0) first = std::min(first, part.series.times[0]);
  return std::floor(first);
}

}  // namespace

void write_mcap_trace(const NamedTrace& trace, std::ostream& stream, const Stop& stop) {
  const std::vector<TraceChannel> channels = channels_of(trace);
  const double origin = origin_of(trace);
  McapWriter writer(stream, topics_of(trace, channels));
  for_each_time(trace, [&](const TraceTime& time) {
    stop.throw_if_due();
    const auto stamp = static_cast<std::uint64_t>(std::llround((time.time - origin) * kNanoseconds));
    for (std::size_t i = 0; i < channels.size(); ++i)
      if (const std::string json = message(trace, channels[i], time); !json.empty()) writer.add(i, stamp, json);
  });
  writer.finish();
}

}  // namespace lacuna
