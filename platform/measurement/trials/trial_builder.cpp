#include "measurement/trials/trial_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// By central differences between known samples, one-sided at the ends. A position integrated from them by the
/// trapezium rule equals the measured one.
void differentiate(const Eigen::VectorXd& times, Eigen::Ref<Eigen::VectorXd, 0, Eigen::InnerStride<>> values) {
  std::vector<Eigen::Index> known;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (std::isfinite(values(i))) known.push_back(i);
  const Eigen::VectorXd before = values;
  values.setConstant(std::nan(""));
  for (std::size_t k = 0; known.size() > 1 && k < known.size(); ++k) {
    const Eigen::Index from = known[k > 0 ? k - 1 : 0], to = known[std::min(k + 1, known.size() - 1)];
    values(known[k]) = (before(to) - before(from)) / (times(to) - times(from));
  }
}

TimeSeries take_columns(const std::vector<PlannedColumn>& planned, std::size_t first_column, const CsvTable& table,
                        const TrialClock& clock) {
  TimeSeries series;
  const auto rows = static_cast<Eigen::Index>(clock.rows.size());
  series.times = Eigen::Map<const Eigen::VectorXd>(clock.times.data(), rows);
  series.samples.resize(rows, static_cast<Eigen::Index>(planned.size()));
  for (std::size_t c = 0; c < planned.size(); ++c) {
    series.channels.push_back(planned[c].channel);
    const std::vector<double>& column = table.columns[first_column + c];
    for (Eigen::Index i = 0; i < rows; ++i)
      series.samples(i, static_cast<Eigen::Index>(c)) =
          column[clock.rows[static_cast<std::size_t>(i)]] * planned[c].factor + planned[c].mapping->offset;
    if (planned[c].mapping->derivative) differentiate(series.times, series.samples.col(static_cast<Eigen::Index>(c)));
  }
  return series;
}

std::vector<double> declared_noise(const std::vector<PlannedColumn>& planned) {
  std::vector<double> noise;
  for (const PlannedColumn& column : planned) noise.push_back(column.mapping->noise);
  return noise;
}

void mask_readings(TimeSeries& measured, const std::vector<TimeRange>& mask, double origin) {
  if (mask.empty()) return;
  for (Eigen::Index i = 0; i < measured.times.size(); ++i)
    if (is_in(mask, origin + measured.times[i])) measured.samples.row(i).setConstant(std::nan(""));
}

/// Values between two known samples, or after the last one.
void fill_between(TimeSeries& series, Eigen::Index channel, Eigen::Index from, Eigen::Index to, Hold hold) {
  const double before = series.samples(from, channel);
  const bool open = to == series.times.size();
  for (Eigen::Index i = from + 1; i < to; ++i) {
    const double share = hold == Hold::first_order && !open
                             ? (series.times[i] - series.times[from]) / (series.times[to] - series.times[from])
                             : 0.0;
    series.samples(i, channel) = share == 0.0 ? before : before + share * (series.samples(to, channel) - before);
  }
}

void fill_commands(CommandSeries& commands, const std::vector<PlannedColumn>& planned, const CsvTable& table,
                   const TrialClock& clock, FileReport& report) {
  TimeSeries& series = commands.series;
  for (Eigen::Index c = 0; c < series.samples.cols(); ++c) {
    if (std::isnan(series.samples(0, c))) {
      report.problem("first command", table.lines[clock.rows.front()], [&] {
        return fmt::format(
            "command column `{}` has no value in the trial's first row, so the command is not known; "
            "start later with target.time.use",
            planned[static_cast<std::size_t>(c)].mapping->column);
      });
      continue;
    }
    Eigen::Index known = 0;
    for (Eigen::Index i = 1; i <= series.times.size(); ++i) {
      if (i < series.times.size() && std::isnan(series.samples(i, c))) continue;
      fill_between(series, c, known, i, commands.hold);
      known = i;
    }
  }
}

/// Missing: as before. Called with 0 before gaps are filled, and with NaN after.
void switch_off(const RecordingPlan& plan, const CsvTable& table, const TrialClock& clock, double off,
                TimeSeries& commands) {
  for (std::size_t s = 0; s < plan.switches.size(); ++s) {
    const std::size_t column = plan.sensors.size() + plan.commands.size() + plan.references.size() + s;
    const auto command = static_cast<Eigen::Index>(plan.switches[s].command);
    bool is_on = true;
    for (std::size_t i = 0; i < clock.rows.size(); ++i) {
      const double value = table.columns[column][clock.rows[i]];
      if (std::isfinite(value)) is_on = value != 0.0;
      if (!is_on) commands.samples(static_cast<Eigen::Index>(i), command) = off;
    }
  }
}

}  // namespace

Trial build_trial(const RecordingPlan& plan, const RecordingSource& source, const CsvTable& table,
                  const TrialClock& clock, FileReport& report) {
  Trial trial;
  trial.measured = take_columns(plan.sensors, 0, table, clock);
  mask_readings(trial.measured, source.mask, clock.origin);
  trial.commands.series = take_columns(plan.commands, plan.sensors.size(), table, clock);
  trial.commands.hold = source.hold;
  trial.commands.before = plan.commanded_before;
  switch_off(plan, table, clock, 0.0, trial.commands.series);
  fill_commands(trial.commands, plan.commands, table, clock, report);
  trial.commands.may_be_off = !plan.switches.empty();
  switch_off(plan, table, clock, std::nan(""), trial.commands.series);
  if (!plan.laws.empty()) {
    const std::size_t first = plan.sensors.size() + plan.commands.size();
    CommandSeries references{take_columns(plan.references, first, table, clock), source.hold};
    fill_commands(references, plan.references, table, clock, report);
    trial.controller = std::make_shared<RecordedController>(
        plan.laws, RecordedSignals{references.series, trial.commands, plan.actuator_of, trial.measured});
  }
  trial.closed_loop = source.by_controllers && trial.controller != nullptr;
  trial.initial = plan.initial;
  trial.sensor_noise = declared_noise(plan.sensors);
  trial.command_noise = declared_noise(plan.commands);
  return trial;
}

void take_commands_before(const RecordingPlan& plan, const CsvTable& table, std::size_t row, Trial& trial) {
  for (std::size_t c = 0; c < plan.commands.size(); ++c) {
    const double known = table.columns[plan.sensors.size() + c][row];
    if (!std::isfinite(known) || plan.commands[c].mapping->derivative) continue;
    trial.commands.before[c] = known * plan.commands[c].factor + plan.commands[c].mapping->offset;
  }
}

}  // namespace lacuna
