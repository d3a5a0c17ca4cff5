#include "measurement/trials/mixed_rows.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"
#include "measurement/series/glitches.h"
#include "measurement/series/second_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kNamed = 3;      ///< readings whose times are listed
constexpr double kMostGlitches = 0.1;  ///< of the readings
constexpr double kMostAtRest = 0.05;   ///< of a position's readings that leave one level: more may be motion

bool is_position(const std::string& unit) { return unit == "rad" || unit == "m"; }
bool is_motion(const std::string& unit) { return is_position(unit) || unit == "rad/s" || unit == "m/s"; }

std::vector<double> readings_of(const TimeSeries& series, std::size_t c) {
  const auto column = series.samples.col(static_cast<Eigen::Index>(c));
  return {column.begin(), column.end()};
}

std::span<const double> times_of(const TimeSeries& series) {
  return {series.times.data(), static_cast<std::size_t>(series.times.size())};
}

/// One channel of a trial, with the texts for messages about its readings.
struct LookedAt {
  TimeSeries& series;
  std::size_t channel;
  const ColumnMapping& mapping;
  const std::vector<int>& lines;
  double origin;

  double& value(std::size_t row) const {
    return series.samples(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(channel));
  }
  std::string quantity(double value) const { return format_quantity(value, series.channels[channel].unit); }
  std::string time(std::size_t row) const {
    return fmt::format("{:.9g} s", origin + series.times(static_cast<Eigen::Index>(row)));
  }
  std::string keep() const { return fmt::format("keep = [\"glitches\"] in target.sensors.{}", mapping.channel); }

  /// "6 of 600 readings (1 %), at 1 s, 2 s, 3 s and 3 more times,"
  std::string readings(const std::vector<std::size_t>& rows, std::size_t of) const {
    std::string text = fmt::format("{} of {} readings ({:.2g} %), at ", rows.size(), of,
                                   100.0 * static_cast<double>(rows.size()) / static_cast<double>(of));
    const std::size_t named = std::min(rows.size(), kNamed);
    for (std::size_t i = 0; i < named; ++i) text += (i > 0 ? ", " : "") + time(rows[i]);
    if (rows.size() > named) text += fmt::format(" and {}", counted(rows.size() - named, "more time"));
    return text + ",";
  }
};

std::string course_of(const LookedAt& at, const SecondStream& stream) {
  return stream.constant ? "are " + at.quantity(*stream.constant) : std::string("belong to another series");
}

void say_stream(const LookedAt& at, const SecondStream& stream, FileReport& report) {
  const int line = at.lines[stream.readings.front()];
  if (stream.is_sure)
    report.doubt("stream of " + at.mapping.column, line, [&] {
      return fmt::format(
          "column `{}`: {} are left out with their rows. They {} between the others, as if a second publisher or "
          "another sensor wrote to the file; {} keeps them",
          at.mapping.column, at.readings(stream.readings, stream.of), course_of(at, stream), at.keep());
    });
  else
    report.problem("stream of " + at.mapping.column, line, [&] {
      return fmt::format(
          "column `{}` contains two series: {} {} between the others, as if two publishers or sensors wrote to one "
          "file. The right series cannot be determined; delete the rows of the other one. If all readings come from "
          "this sensor: {}",
          at.mapping.column, at.readings(stream.readings, stream.of), course_of(at, stream), at.keep());
    });
}

void clear(TimeSeries& series, std::size_t channel, const std::vector<std::size_t>& rows) {
  for (const std::size_t row : rows)
    series.samples(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(channel)) = std::nan("");
}

/// In these rows the previous command stays.
void hold_command(TimeSeries& commands, std::size_t channel, const std::vector<std::size_t>& rows) {
  const auto c = static_cast<Eigen::Index>(channel);
  for (const std::size_t row : rows)
    if (row > 0)
      commands.samples(static_cast<Eigen::Index>(row), c) = commands.samples(static_cast<Eigen::Index>(row) - 1, c);
}

/// Other channels of rows that come from another publisher.
void leave_out_rows(Trial& trial, std::size_t found_in, const std::vector<std::size_t>& rows) {
  for (std::size_t c = 0; c < trial.measured.channels.size(); ++c)
    if (c == found_in || stands_apart(times_of(trial.measured), readings_of(trial.measured, c), rows))
      clear(trial.measured, c, rows);
  for (std::size_t c = 0; c < trial.commands.series.channels.size(); ++c)
    if (stands_apart(times_of(trial.commands.series), readings_of(trial.commands.series, c), rows))
      hold_command(trial.commands.series, c, rows);
}

void leave_out_pulses(const LookedAt& at, const Glitches& glitches, FileReport& report) {
  report.note("pulses of " + at.mapping.column, at.lines[glitches.readings.front()], [&] {
    return fmt::format(
        "column `{}`: {} leave a level at which the other readings rest and return at once. They are used, because a "
        "joint may move so briefly; if they are glitches, empty these cells",
        at.mapping.column, at.readings(glitches.readings, glitches.of));
  });
}

/// The last reading before a row that is not a glitch.
std::size_t reading_before(const LookedAt& at, const std::vector<std::size_t>& glitches, std::size_t row) {
  while (row > 0 && (!std::isfinite(at.value(row)) || std::binary_search(glitches.begin(), glitches.end(), row))) --row;
  return row;
}

/// One sentence per run of readings.
void say_each(const LookedAt& at, const std::vector<std::size_t>& glitches, FileReport& report) {
  for (std::size_t first = 0, next = 0; first < glitches.size(); first = next) {
    const std::size_t row = glitches[first];
    while (next < glitches.size() && glitches[next] - row == next - first) ++next;
    const std::string& unit = at.series.channels[at.channel].unit;
    report.doubt("glitch of " + at.mapping.column, at.lines[row], [&] {
      return fmt::format("column `{}` at {}: {:.3g} {} for {}, {:.3g} {} before: a glitch, left out; {} keeps it",
                         at.mapping.column, at.time(row), at.value(row), unit, counted(next - first, "reading"),
                         at.value(reading_before(at, glitches, row)), unit, at.keep());
    });
  }
}

void leave_out_glitches_of(const LookedAt& at, FileReport& report) {
  const Glitches glitches = find_glitches(times_of(at.series), readings_of(at.series, at.channel));
  if (glitches.readings.empty()) return;
  const double share = static_cast<double>(glitches.readings.size()) / static_cast<double>(glitches.of);
  const int line = at.lines[glitches.readings.front()];
  if (glitches.may_be_motion && (share > kMostAtRest || !is_position(at.series.channels[at.channel].unit)))
    return leave_out_pulses(at, glitches, report);
  if (share > kMostGlitches) {
    report.problem("glitches of " + at.mapping.column, line, [&] {
      return fmt::format(
          "column `{}`: {} leave the signal by far and return at once. With so many glitches the rest is not reliable; "
          "repair the connection of the sensor and record again, or empty these cells. If they are motion: {}",
          at.mapping.column, at.readings(glitches.readings, glitches.of), at.keep());
    });
    return;
  }
  if (glitches.readings.size() <= kNamed)
    say_each(at, glitches.readings, report);
  else
    report.doubt("glitches of " + at.mapping.column, line, [&] {
      return fmt::format(
          "column `{}`: {} leave the signal by far and return at once: glitches, left out; {} keeps them",
          at.mapping.column, at.readings(glitches.readings, glitches.of), at.keep());
    });
  clear(at.series, at.channel, glitches.readings);
}

bool is_searched(const PlannedColumn& column) {
  return !column.mapping->keeps_glitches && is_motion(column.channel.unit);
}

}  // namespace

void leave_out_second_streams(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                              FileReport& report) {
  for (std::size_t c = 0; c < plan.sensors.size(); ++c) {
    if (!is_searched(plan.sensors[c])) continue;
    const auto stream = find_second_stream(times_of(trial.measured), readings_of(trial.measured, c));
    if (!stream) continue;
    say_stream({trial.measured, c, *plan.sensors[c].mapping, lines, origin}, *stream, report);
    if (stream->is_sure) leave_out_rows(trial, c, stream->readings);
  }
}

void leave_out_glitches(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                        FileReport& report) {
  for (std::size_t c = 0; c < plan.sensors.size(); ++c)
    if (is_searched(plan.sensors[c]))
      leave_out_glitches_of({trial.measured, c, *plan.sensors[c].mapping, lines, origin}, report);
}

}  // namespace lacuna
