#include "measurement/trials/column_plan.h"

#include "foundation/name_index.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <optional>

namespace lacuna {
namespace {

std::string column_and_unit(const ColumnMapping& mapping) {
  std::string text = fmt::format("column `{}` in {}", mapping.column, mapping.unit);
  if (!mapping.gain_unit.empty()) text += fmt::format(" times a gain in {}", mapping.gain_unit);
  if (mapping.derivative) text += ", its rate of change,";
  return text;
}

std::string wrong_dimension(const ColumnMapping& mapping, const Channel& channel) {
  if (!mapping.gain_unit.empty())
    return fmt::format("{} does not give {}, the unit of {}; the gain must be in {}/({})", column_and_unit(mapping),
                       channel.unit, channel.name, channel.unit, mapping.unit);
  const std::optional<Unit> column = parse_unit(mapping.unit), rate = parse_unit(channel.unit + "*s");
  const bool of_position = column && rate && column->same_dimension(*rate);
  return fmt::format(
      "{} has another unit than {}, which is in {}; correct the unit, {}or give a gain with its unit, {}/({})",
      column_and_unit(mapping), channel.name, channel.unit,
      of_position ? "write derivative = true if the column contains the rate of a command, " : "", channel.unit,
      mapping.unit);
}

/// For the angle or the distance of a tracked point, in SI.
double track_conversion(const ColumnMapping& mapping, const Channel& channel, const Unit& column, const Unit& gain,
                        ProblemList& problems) {
  if (channel.unit != "rad" && channel.unit != "m")
    problems.add(mapping.location,
                 fmt::format("y = \"{}\" makes an angle or a distance from a tracked point, but {} is in {}",
                             mapping.track.other, channel.name, channel.unit));
  if (!column.same_dimension(*parse_unit("m")) || !gain.same_dimension(*parse_unit("1")))
    problems.add(mapping.location,
                 fmt::format("x and y of a tracked point are lengths, so their gain has no unit, as in gain = -1 for "
                             "an angle in the other direction; the unit here is {}{}",
                             mapping.unit, mapping.gain_unit.empty() ? "" : " times " + mapping.gain_unit));
  return mapping.gain;
}

/// The factor from the column to the channel; 1 where the units do not allow one.
double conversion(const ColumnMapping& mapping, const Channel& channel, ProblemList& problems) {
  const std::optional<Unit> column = parse_unit(mapping.unit);
  const std::optional<Unit> gain = parse_unit(mapping.gain_unit.empty() ? "1" : mapping.gain_unit);
  const std::optional<Unit> wanted = parse_unit(channel.unit);
  for (const auto& [unit, text] : {std::pair(&column, &mapping.unit), std::pair(&gain, &mapping.gain_unit)})
    if (!*unit) problems.add(mapping.location, fmt::format("`{}` is not a unit; known are {}", *text, known_units()));
  if (!column || !gain || !wanted) return 1.0;
  if (!mapping.track.other.empty()) return track_conversion(mapping, channel, *column, *gain, problems);
  Unit product = *column;
  const Unit second = *parse_unit("s");
  for (std::size_t i = 0; i < product.exponents.size(); ++i)
    product.exponents[i] += gain->exponents[i] - (mapping.derivative ? second.exponents[i] : 0);
  if (product.exponents != wanted->exponents) problems.add(mapping.location, wrong_dimension(mapping, channel));
  return column->to_si * mapping.gain;
}

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  return names;
}

constexpr std::size_t kMostAdvice = 20;  // number of problems in one list for which the nearest names are searched

std::string no_channel(const std::string& name, const std::vector<std::string>& names, std::string_view what,
                       bool with_advice) {
  const std::string problem = fmt::format("the robot has no {} `{}`", what, name);
  if (!with_advice) return problem;
  return problem + did_you_mean(name, names) + "; it has " + (names.empty() ? "none" : nearest_names(name, names));
}

}  // namespace

std::vector<PlannedColumn> plan_columns(const std::vector<ColumnMapping>& mappings,
                                        const std::vector<Channel>& channels, std::string_view what,
                                        ProblemList& problems) {
  const std::vector<std::string> names = names_of(channels);
  const NameIndex known(names);
  std::vector<const ColumnMapping*> of_channel(channels.size(), nullptr);
  std::size_t unknown = 0;
  for (const ColumnMapping& mapping : mappings) {
    const std::optional<std::size_t> channel = known.find(mapping.channel);
    if (!channel)
      problems.add(mapping.location, no_channel(mapping.channel, names, what, ++unknown <= kMostAdvice));
    else if (of_channel[*channel])
      problems.add(mapping.location, fmt::format("{} {} has two columns; keep one", what, mapping.channel));
    else
      of_channel[*channel] = &mapping;
  }
  std::vector<PlannedColumn> planned;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (const ColumnMapping* mapping = of_channel[c])
      planned.push_back({channels[c], mapping, conversion(*mapping, channels[c], problems)});
  return planned;
}

double seconds_per_time_unit(const RecordingSource& source, ProblemList& problems) {
  const std::optional<Unit> unit = parse_unit(source.time_unit);
  if (unit && unit->same_dimension(*parse_unit("s"))) return unit->to_si;
  const SourceLocation location = source.files.empty() ? SourceLocation{} : source.files.front().location;
  problems.add(
      {location.file, 0, 0},
      fmt::format("the time column's unit `{}` is not a unit of time; use s, ms, us or min", source.time_unit));
  return 1.0;
}

}  // namespace lacuna
