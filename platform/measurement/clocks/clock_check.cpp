#include "measurement/clocks/clock_check.h"

#include "foundation/statistics.h"
#include "foundation/unit.h"
#include "measurement/clocks/clock_wraps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kGapInIntervals = 10.0;
constexpr double kDroppedInIntervals = 1.6;
constexpr double kNotedJitter = 0.05;      // of the median interval
constexpr double kSlowestPlausible = 1.0;  // s between samples of a robot
constexpr double kFastestPlausible = 5e-6;

bool same_value(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_row(const CsvTable& table, std::size_t a, std::size_t b) {
  return std::all_of(table.columns.begin(), table.columns.end(), [&](const std::vector<double>& column) {
    return column.empty() || same_value(column[a], column[b]);
  });
}

std::string seconds(double value) { return fmt::format("{:.9g} s", value); }

/// Whether one mask range covers everything between two samples.
bool is_masked(const RecordingSource& source, double from, double to) {
  return std::any_of(source.mask.begin(), source.mask.end(),
                     [&](const TimeRange& range) { return range.start <= from && to <= range.end; });
}

void take_sample(const TrialClock& clock, std::size_t i, TrialClock& piece) {
  if (piece.times.empty()) piece.origin = clock.origin + clock.times[i];
  piece.rows.push_back(clock.rows[i]);
  piece.times.push_back(clock.times[i]);
}

void begin_at_zero(TrialClock& piece) {
  const double first = piece.times.front();
  for (double& time : piece.times) time -= first;
}

/// Rows of a joined table that come from another file have no line.
TrialClock rows_of_first_file(const TrialClock& clock, const CsvTable& table) {
  TrialClock own;
  own.origin = clock.origin;
  for (std::size_t i = 0; i < clock.rows.size(); ++i) {
    if (table.lines[clock.rows[i]] == 0) continue;
    own.rows.push_back(clock.rows[i]);
    own.times.push_back(clock.times[i]);
  }
  return own;
}

void check_unit(double median, int line, const RecordingSource& source, FileReport& report) {
  const bool slow = median > kSlowestPlausible;
  if (!slow && median >= kFastestPlausible) return;
  report.doubt("time unit", line, [&] {
    return fmt::format(
        "samples are {} apart when column `{}` is read in {}; is it in {}? Then write unit = \"{}\" under "
        "[target.time]",
        seconds(median), source.time_column, source.time_unit, slow ? "ms or us" : "s or ms", slow ? "ms" : "s");
  });
}

/// The encoding to write if the clock itself restarts where it goes back to `after`.
std::string advice_on_period(const TrialClock& clock, double after, double seconds_per_unit) {
  const double usual = std::abs(median_interval(clock.times));
  const double period = period_of_step_back(clock.origin + clock.times.back(), after, usual);
  if (period == 0.0) return {};
  return fmt::format("; if the clock restarts every {:.9g} s, write encoding = \"{}\" in target.time", period,
                     to_string(Encoding{EncodingKind::wraps, std::round(1e6 * period / seconds_per_unit) / 1e6}));
}

/// Files that are not text have rows instead of lines.
std::string place_of(const CsvTable& table, std::size_t row) {
  return table.lines[row] > 0 ? fmt::format("line {}", table.lines[row]) : fmt::format("row {}", row + 1);
}

}  // namespace

TrialClock read_clock(const CsvTable& table, const std::vector<std::size_t>& rows, double seconds_per_unit,
                      FileReport& report) {
  TrialClock clock;
  if (rows.empty()) return clock;
  const double first = table.times[rows.front()];
  if (table.dated) seconds_per_unit = 1.0;
  clock.origin = table.dated ? first - table.first_date : (table.time_origin + first) * seconds_per_unit;
  for (const std::size_t row : rows) {
    const double time = (table.times[row] - first) * seconds_per_unit;
    if (!clock.times.empty() && time == clock.times.back()) {
      const std::size_t before = clock.rows.back();
      if (same_row(table, before, row)) {
        report.note("repeated row", table.lines[row],
                    [&] { return fmt::format("the same sample as in {} again; left out", place_of(table, before)); });
      } else {
        report.problem("repeated time", table.lines[row], [&] {
          return fmt::format(
              "the time of {} again, {}, with other values; write time stamps with more digits, or keep one row. If "
              "fractions of a second are in another column, give the two columns matching names, as in sec and nanosec",
              place_of(table, before), seconds(clock.origin + time));
        });
      }
      continue;
    }
    if (!clock.times.empty() && time < clock.times.back())
      report.problem("time goes back", table.lines[row], [&] {
        return fmt::format(
            "time goes back from {} to {}; sort the rows, or if another trial starts here, give the "
            "trials a column and name it in target.trial_column{}",
            seconds(clock.origin + clock.times.back()), seconds(clock.origin + time),
            advice_on_period(clock, clock.origin + time, seconds_per_unit));
      });
    clock.rows.push_back(row);
    clock.times.push_back(time);
  }
  return clock;
}

std::vector<TrialClock> cut_to_ranges(const TrialClock& clock, const std::vector<TimeRange>& ranges) {
  if (ranges.empty()) return {clock};
  std::vector<TrialClock> pieces;
  for (const TimeRange& range : ranges) {
    TrialClock piece;
    for (std::size_t i = 0; i < clock.times.size(); ++i)
      if (is_in({range}, clock.origin + clock.times[i])) take_sample(clock, i, piece);
    if (piece.times.empty()) continue;
    begin_at_zero(piece);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<ClockPart> cut_at_holdout(const TrialClock& clock, const std::vector<TimeRange>& holdout) {
  std::vector<ClockPart> parts;
  for (std::size_t i = 0; i < clock.times.size(); ++i) {
    const bool held_out = is_in(holdout, clock.origin + clock.times[i]);
    if (parts.empty() || parts.back().held_out != held_out) parts.push_back({{}, held_out, i > 0});
    take_sample(clock, i, parts.back().clock);
  }
  for (ClockPart& part : parts) begin_at_zero(part.clock);
  return parts;
}

double median_interval(std::span<const double> times) {
  if (times.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> intervals(times.size() - 1);
  for (std::size_t i = 0; i < intervals.size(); ++i) intervals[i] = times[i + 1] - times[i];
  return median_of(intervals);
}

void check_intervals(const TrialClock& whole, const CsvTable& table, const RecordingSource& source,
                     FileReport& report) {
  const TrialClock clock = rows_of_first_file(whole, table);
  const double median = median_interval(clock.times);
  if (!(median > 0.0)) return;
  const double longest = source.max_gap > 0.0 ? source.max_gap : kGapInIntervals * median;
  double dropped = 0.0, deviation = 0.0, smallest = median, largest = median;
  int first_dropped = 0;
  for (std::size_t i = 0; i + 1 < clock.times.size(); ++i) {
    const double interval = clock.times[i + 1] - clock.times[i];
    const int line = table.lines[clock.rows[i + 1]];
    const double from = clock.origin + clock.times[i];
    if (interval > longest && !is_masked(source, from, from + interval)) {
      report.problem("gap", line, [&] {
        return fmt::format(
            "a gap of {} before this sample (usual interval: {}); leave it out with target.time.use or "
            "target.time.mask, or allow it with target.time.max_gap",
            seconds(interval), seconds(median));
      });
    } else if (interval > kDroppedInIntervals * median) {
      if (first_dropped == 0) first_dropped = line;
      dropped += std::round(interval / median) - 1.0;
    } else {
      deviation += std::abs(interval - median);
      smallest = std::min(smallest, interval);
      largest = std::max(largest, interval);
    }
  }
  if (dropped > 0.0)
    report.doubt("dropped", first_dropped, [&] {
      return fmt::format(
          "about {:.0f} samples of {} are missing (usual interval {}), the first before this line; the time stamps are "
          "used as they are",
          dropped, static_cast<double>(clock.times.size()) + dropped, seconds(median));
    });
  if (deviation > kNotedJitter * median * static_cast<double>(clock.times.size()))
    report.note("jitter", table.lines[clock.rows.front()], [&] {
      return fmt::format("intervals vary between {} and {} (median {}); the time stamps are used as they are",
                         seconds(smallest), seconds(largest), seconds(median));
    });
  check_unit(median, table.lines[clock.rows.front()], source, report);
}

bool is_in(const std::vector<TimeRange>& ranges, double time) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const TimeRange& range) { return range.start <= time && time <= range.end; });
}

}  // namespace lacuna
