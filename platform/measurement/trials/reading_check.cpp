#include "measurement/trials/reading_check.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"
#include "measurement/series/event_counter.h"
#include "measurement/trials/mixed_rows.h"
#include "measurement/series/repeats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace lacuna {
namespace {

constexpr double kSameSignal = 1e-6;         ///< of the deviation: a copy is exact except for its digits
constexpr Eigen::Index kFewestSamples = 20;  ///< with few numbers, equality may be chance
constexpr std::size_t kFewestTurns = 4;
constexpr double kNearZero = 0.05;  ///< of the signal's size
constexpr double kHigh = 0.25;
constexpr double kCoarseAngle = M_PI / 10.0;  ///< rad, a count of a sensor with few pulses per turn, not of an encoder
constexpr double kCoarseLength = 5e-3;        ///< m
constexpr double kStraight = 0.4;             ///< of the height at twice the distance; a smooth minimum has a quarter

std::vector<double> column_of(const TimeSeries& series, std::size_t c) {
  const auto column = series.samples.col(static_cast<Eigen::Index>(c));
  return {column.begin(), column.end()};
}

void leave_out_repeats(TimeSeries& measured, std::size_t c, const ColumnMapping& mapping, int line,
                       FileReport& report) {
  const Repeats repeats = find_repeats(column_of(measured, c));
  if (repeats.every == 0) return;
  for (const std::size_t i : repeats.repeated)
    measured.samples(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) = std::nan("");
  const double interval =
      (measured.times(measured.times.size() - 1) - measured.times(0)) / static_cast<double>(measured.times.size() - 1);
  report.note("repeats of " + mapping.column, line, [&] {
    return fmt::format(
        "column `{}` has a new reading only every {} rows ({:.3g} s) and repeats it in between: each reading is used "
        "once; keep = [\"repeats\"] in target.sensors.{} uses all rows",
        mapping.column, repeats.every, static_cast<double>(repeats.every) * interval, mapping.channel);
  });
}

bool has_known_start(const Trial& trial) {
  return std::any_of(trial.initial.begin(), trial.initial.end(),
                     [](const InitialValue& value) { return value.knowledge != InitialKnowledge::from_data; });
}

/// Readings between events are left out; those at events have the noise that follows from their times, unless the
/// experiment declares one. They do not determine the start of a trial: where it is not stated, all rows stay.
bool keep_events_only(Trial& trial, std::size_t c, const ColumnMapping& mapping, int line, FileReport& report) {
  TimeSeries& measured = trial.measured;
  const std::string& unit = measured.channels[c].unit;
  const std::span times(measured.times.data(), static_cast<std::size_t>(measured.times.size()));
  const EventCounter counter = find_events(times, column_of(measured, c), unit == "rad" ? kCoarseAngle : kCoarseLength);
  if (counter.events.empty()) return false;
  const std::string found = fmt::format(
      "column `{}` counts events: it changes by one count ({}) at a time and is constant for about {:.0f} rows in "
      "between, which contain no information on the motion",
      mapping.column, format_quantity(counter.count, unit), counter.rows_between);
  if (!has_known_start(trial)) {
    report.doubt("events of " + mapping.column, line, [&] {
      return fmt::format(
          "{}. All rows are used nevertheless, because its changes do not determine the initial state. To use only the "
          "{} changes, state the initial state in target.initial or let it be fitted, as in hinge = {{ velocity = 9.0, "
          "knowledge = \"free\" }}",
          found, counter.events.size());
    });
    return false;
  }
  measured.samples.col(static_cast<Eigen::Index>(c)).setConstant(std::nan(""));
  double squares = 0.0;
  for (const CountedEvent& event : counter.events) {
    measured.samples(static_cast<Eigen::Index>(event.row), static_cast<Eigen::Index>(c)) = event.position;
    squares += event.deviation * event.deviation;
  }
  const double noise = std::sqrt(squares / static_cast<double>(counter.events.size()));
  double& declared = trial.sensor_noise[c];
  if (std::isnan(declared)) declared = noise;
  report.doubt("events of " + mapping.column, line, [&] {
    return fmt::format(
        "{}. Only its {} changes are used, each with a tolerance of {}, the length of one row; keep = [\"repeats\"] in "
        "target.sensors.{} uses all rows",
        found, counter.events.size(), format_quantity(noise, unit), mapping.channel);
  });
  return true;
}

/// Whether b = scale·a + offset, except for rounding of the digits.
bool is_copy(const std::vector<double>& a, const std::vector<double>& b) {
  const Eigen::Map<const Eigen::ArrayXd> x(a.data(), static_cast<Eigen::Index>(a.size())),
      y(b.data(), static_cast<Eigen::Index>(b.size()));
  if (x.size() < kFewestSamples || !x.isFinite().all() || !y.isFinite().all()) return false;
  const Eigen::ArrayXd dx = x - x.mean(), dy = y - y.mean();
  const double xx = dx.square().sum(), yy = dy.square().sum(), xy = (dx * dy).sum();
  if (!(xx > 0.0) || !(yy > 0.0)) return false;
  return (dy - xy / xx * dx).square().sum() < kSameSignal * kSameSignal * yy;
}

/// How often a signal that is never negative falls straight to zero and rises straight again, like a magnitude without
/// its sign.
std::size_t folded_turns(const std::vector<double>& values) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return v >= 0.0; })) return 0;
  const double size = *std::max_element(values.begin(), values.end());
  if (size == 0.0) return 0;
  std::size_t turns = 0;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    if (values[i] > kNearZero * size || values[i] > values[i - 1] || values[i] > values[i + 1]) continue;
    std::size_t reach = 1;
    while (reach <= i && i + reach < values.size() &&
           (values[i - reach] < kHigh * size || values[i + reach] < kHigh * size) && reach < values.size() / 8)
      ++reach;
    if (reach > i || i + reach >= values.size()) continue;
    if (values[i - reach] < kHigh * size || values[i + reach] < kHigh * size) continue;
    const std::size_t half = reach / 2;
    const auto is_straight = [&](std::size_t near, std::size_t far) {
      return values[near] > kStraight * values[far] && values[near] < values[far];
    };
    if (half > 0 && is_straight(i - half, i - reach) && is_straight(i + half, i + reach)) ++turns;
    i += reach;
  }
  return turns;
}

}  // namespace

void leave_out_false_readings(Trial& trial, const RecordingPlan& plan, const std::vector<int>& lines, double origin,
                              FileReport& report) {
  leave_out_second_streams(trial, plan, lines, origin, report);
  for (std::size_t c = 0; c < plan.sensors.size(); ++c) {
    const ColumnMapping& mapping = *plan.sensors[c].mapping;
    const std::string& unit = plan.sensors[c].channel.unit;
    const bool is_position = unit == "rad" || unit == "m";
    if (!mapping.keeps_repeats && is_position && keep_events_only(trial, c, mapping, lines.front(), report)) continue;
    if (!mapping.keeps_repeats) leave_out_repeats(trial.measured, c, mapping, lines.front(), report);
  }
  leave_out_glitches(trial, plan, lines, origin, report);
}

void check_commands(const Trial& trial, const RecordingPlan& plan, int line, FileReport& report) {
  for (std::size_t c = 0; c < plan.commands.size(); ++c) {
    const ColumnMapping& mapping = *plan.commands[c].mapping;
    const std::vector<double> command = column_of(trial.commands.series, c);
    for (std::size_t s = 0; s < plan.sensors.size(); ++s) {
      if (!is_copy(column_of(trial.measured, s), command)) continue;
      report.doubt("copy " + mapping.column, line, [&] {
        return fmt::format(
            "the command column `{}` is a copy of the reading `{}`: name the column of the commands sent to the "
            "actuator",
            mapping.column, plan.sensors[s].mapping->column);
      });
    }
    const std::string& unit = plan.commands[c].channel.unit;
    const bool pushes = unit == "N*m" || unit == "N" || unit == "V" || unit == "1";
    if (!pushes || folded_turns(command) < kFewestTurns) continue;
    report.doubt("sign of " + mapping.column, line, [&] {
      return fmt::format(
          "the command column `{}` is never negative and turns sharply at zero {}: its sign was lost, as in the "
          "magnitude of a current; record the signed command",
          mapping.column, counted(folded_turns(command), "time"));
    });
  }
}

}  // namespace lacuna
