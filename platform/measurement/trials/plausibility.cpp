#include "measurement/trials/plausibility.h"

#include "foundation/name_index.h"
#include "foundation/unit.h"
#include "measurement/names/column_name.h"
#include "measurement/series/signal_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// Beyond these sizes another unit is more likely than such a motion.
struct PlausibleSize {
  std::string_view unit;
  double largest;
  std::string_view likelier;
};
constexpr PlausibleSize kPlausibleSizes[] = {{"rad", 12.6, "deg"}, {"rad/s", 300.0, "deg/s or rpm"},
                                             {"m", 20.0, "mm"},    {"m/s", 50.0, "mm/s"},
                                             {"N*m", 1e4, "N*mm"}, {"N", 1e5, "mN"}};

/// Below these, in the column's unit, a column with a small unit more likely has the large one.
struct SmallUnit {
  std::string_view column_unit;
  double smallest;
  std::string_view likelier;
};
constexpr SmallUnit kSmallUnits[] = {
    {"deg", 6.3, "rad"}, {"deg/s", 6.3, "rad/s"}, {"mm", 1.0, "m"}, {"mm/s", 1.0, "m/s"}};

/// Ratios of a velocity to the slope of its position with a known cause.
struct NamedRatio {
  double ratio;
  std::string_view reason;
};
constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr NamedRatio kNamedRatios[] = {{kDegreesPerRadian, "57.3 times: one is in deg, the other in rad"},
                                       {1.0 / kDegreesPerRadian, "1/57.3 times: one is in rad, the other in deg"},
                                       {1000.0, "1000 times: one is in mm, or the time in ms"},
                                       {1e-3, "1/1000 times: one is in m, or the time in ms"},
                                       {60.0 / 6.283185307179586, "9.55 times: is it in rpm?"},
                                       {1.0 / 6.283185307179586, "1/6.28 times: is it in turns?"}};
constexpr double kSameRatio = 0.03;
constexpr double kConsistentRatio = 1.25;
constexpr double kCertain = 0.98;

bool same_unit(const std::string& a, const std::string& b) {
  const std::optional<Unit> first = parse_unit(a), second = parse_unit(b);
  return first && second && first->same_dimension(*second) &&
         std::abs(first->to_si - second->to_si) < 1e-6 * second->to_si;
}

/// `names`: of the format.
void check_unit(const PlannedColumn& column, const CsvFormat& format, const NameIndex& names, FileReport& report) {
  const ColumnMapping& mapping = *column.mapping;
  const std::string in_name = unit_in_name(mapping.column);
  if (!in_name.empty() && !same_unit(in_name, mapping.unit))
    report.doubt("unit of " + mapping.column, format.header_line, [&] {
      return fmt::format("column `{}` has the unit {} in its name but is read in {}", mapping.column, in_name,
                         mapping.unit);
    });
  const std::size_t index = names.find(mapping.column).value_or(format.names.size());
  if (index < format.units.size() && !format.units[index].empty() && !same_unit(format.units[index], mapping.unit))
    report.doubt("units row of " + mapping.column, std::max(format.first_line - 1, 0), [&] {
      return fmt::format("the {} states {} for column `{}`, which is read in {}",
                         format.header_line > 0 ? "row of units" : "file", format.units[index], mapping.column,
                         mapping.unit);
    });
  if (mapping.unit == "1" && mapping.gain_unit.empty() && column.channel.unit == "rad")
    report.doubt("no unit of " + mapping.column, format.header_line, [&] {
      return fmt::format("column `{}` has no unit and is read in rad; write unit = \"rad\" or \"deg\"", mapping.column);
    });
}

void check_size(const PlannedColumn& column, const SignalShape& shape, int line, FileReport& report) {
  const ColumnMapping& mapping = *column.mapping;
  if (same_unit(unit_in_name(mapping.column), mapping.unit)) return;  // the file states it
  const double size = std::max(std::abs(shape.lowest), std::abs(shape.highest));
  for (const PlausibleSize& plausible : kPlausibleSizes) {
    if (column.channel.unit != plausible.unit || size <= plausible.largest) continue;
    report.doubt("size of " + mapping.column, line, [&] {
      return fmt::format(
          "column `{}` reaches {} when read in {}; is it in {}? Then write {} = {{ ..., unit = \"{}\" }}",
          mapping.column, format_quantity(size, column.channel.unit), mapping.unit, plausible.likelier, mapping.channel,
          plausible.likelier);
    });
  }
  const double written = (shape.highest - shape.lowest) / std::abs(column.factor);
  for (const SmallUnit& small : kSmallUnits) {
    if (mapping.unit != small.column_unit || written > small.smallest || mapping.gain != 1.0) continue;
    report.doubt("size of " + mapping.column, line, [&] {
      return fmt::format("column `{}` moves by only {:.3g} {}; is it in {}? Then write {} = {{ ..., unit = \"{}\" }}",
                         mapping.column, written, mapping.unit, small.likelier, mapping.channel, small.likelier);
    });
  }
}

void check_column(const PlannedColumn& column, const TimeSeries& series, Eigen::Index c, bool command, int line,
                  FileReport& report) {
  const SignalShape shape = shape_of(series, c);
  const ColumnMapping& mapping = *column.mapping;
  if (shape.count == 0) {
    report.doubt("no value of " + mapping.column, line,
                 [&] { return fmt::format("column `{}` has no value in the whole trial", mapping.column); });
    return;
  }
  if (shape.lowest == shape.highest && shape.count > 1)
    report.note("constant " + mapping.column, line, [&] {
      return fmt::format("column `{}` stays at {} for the whole trial{}", mapping.column,
                         format_quantity(shape.lowest, column.channel.unit),
                         command ? "" : "; is the sensor connected?");
    });
  if (shape.lowest < shape.highest) check_size(column, shape, line, report);
  if (shape.clipped == 0 || command) return;
  report.doubt("saturated " + mapping.column, line, [&] {
    return fmt::format(
        "column `{}` stays at its {} {} for {} samples, {} times after a fast motion: is it saturated? "
        "target.time.mask excludes such times",
        mapping.column, shape.clipped_high ? "largest value" : "smallest value",
        format_quantity(shape.clipped_high ? shape.highest : shape.lowest, column.channel.unit), shape.clipped,
        shape.clipped_runs);
  });
}

std::string in_words(double ratio) {
  for (const NamedRatio& named : kNamedRatios)
    if (std::abs(std::abs(ratio) / named.ratio - 1.0) < kSameRatio)
      return (ratio < 0.0 ? "minus " : "") + std::string(named.reason);
  if (std::abs(ratio + 1.0) < kSameRatio) return "the signs of the two differ";
  return fmt::format("{:.3g} times", ratio);
}

void check_velocity(const Trial& trial, const RecordingPlan& plan, std::size_t velocity, int line, FileReport& report) {
  const std::string unit = plan.sensors[velocity].channel.unit;
  if (!unit.ends_with("/s")) return;
  SlopeMatch best;
  std::size_t best_position = 0;
  for (std::size_t p = 0; p < plan.sensors.size(); ++p) {
    if (plan.sensors[p].channel.unit + "/s" != unit) continue;
    const SlopeMatch match =
        match_slope(trial.measured, static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(velocity));
    if (match.correlation > 0.9 && match.ratio < kConsistentRatio && match.ratio > 1.0 / kConsistentRatio) return;
    if (std::abs(match.correlation) > std::abs(best.correlation)) {
      best = match;
      best_position = p;
    }
  }
  if (std::abs(best.correlation) < kCertain) return;
  report.doubt("slope of " + plan.sensors[velocity].mapping->column, line, [&] {
    return fmt::format("column `{}` against the slope of `{}`: {}", plan.sensors[velocity].mapping->column,
                       plan.sensors[best_position].mapping->column, in_words(best.ratio));
  });
}

}  // namespace

void check_units(const RecordingPlan& plan, const CsvFormat& format, FileReport& report) {
  const NameIndex names(format.names);
  for (const auto* planned : {&plan.sensors, &plan.commands})
    for (const PlannedColumn& column : *planned) check_unit(column, format, names, report);
}

void check_values(const Trial& trial, const RecordingPlan& plan, int line, FileReport& report) {
  for (std::size_t c = 0; c < plan.sensors.size(); ++c) {
    check_column(plan.sensors[c], trial.measured, static_cast<Eigen::Index>(c), false, line, report);
    check_velocity(trial, plan, c, line, report);
  }
  for (std::size_t c = 0; c < plan.commands.size(); ++c)
    check_column(plan.commands[c], trial.commands.series, static_cast<Eigen::Index>(c), true, line, report);
}

}  // namespace lacuna
