#include "report/text/comparison_text.h"

#include "data_checks/data_checks.h"
#include "foundation/text/counted.h"
#include "foundation/text/unit_text.h"
#include "foundation/unit.h"
#include "report/text/bound_text.h"
#include "report/text/horizon_text.h"
#include "report/text/interval_text.h"
#include "report/text/setups_text.h"
#include "report/text/text_table.h"
#include "report/text/times_floor_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// Share of the noise floor below which the initial-state uncertainty is not printed.
constexpr double kStartWorthASay = 0.1;

std::string quantity(double value, const std::string& unit) {
  return std::isfinite(value) ? format_quantity(value, unit) : "-";
}

std::string heading_line(const ComparisonHeading& heading, const Comparison& comparison, const FitResult& fit) {
  const auto held_out = static_cast<std::size_t>(
      std::count_if(comparison.trials.begin(), comparison.trials.end(), [](const auto& t) { return t.held_out; }));
  std::string line = heading.experiment + " · " + counted(comparison.trials.size() - held_out, "fit trial");
  if (held_out > 0)
    line += fmt::format(", {} (compared {})", counted(held_out, "held-out trial"),
                        counted(static_cast<std::size_t>(heading.look), "time"));
  if (!heading.refitted) return line + " · values as written, not fitted\n";
  line += " · refitted " + counted(fit.values.size(), "value");
  return line + (heading.reused ? " (fit from the database)\n" : fmt::format(", {:.1f} s\n", heading.fit_seconds));
}

/// The floor of a file is printed if it differs from that of all fit files by this factor.
constexpr double kAnotherFloor = 1.5;

/// The floor of the file in words, if it differs from `floor`.
std::string own_floor(const ChannelScore& score, double floor) {
  const double times = score.floor / floor;
  if (!(times > kAnotherFloor || times < 1.0 / kAnotherFloor)) return "";
  return fmt::format(" (floor {})", quantity(score.floor, score.unit));
}

std::vector<std::string> trial_row(const TrialComparison& trial, const ChannelScore& score, double floor) {
  const std::string kind = trial.held_out ? " held out" : " fit";
  if (!trial.valid) return {kind, trial.trial, "invalid", "-", "-", "-"};
  return {kind,
          trial.trial,
          quantity(score.rmse, score.unit),
          times_floor_text(score.times_floor) + own_floor(score, floor),
          quantity(score.max_error, score.unit),
          std::isfinite(score.max_error_time) ? fmt::format("{:.2f} s", score.max_error_time) : "-"};
}

std::string horizons_line(const Comparison& comparison, const std::string& channel, const std::string& unit) {
  std::string line;
  for (const double horizon : horizons_of(comparison)) {
    const double fit = restarted_error(comparison, channel, horizon, false);
    const double held_out = restarted_error(comparison, channel, horizon, true);
    line += fmt::format("{}{:.3g} s segments: fit {}", line.empty() ? "" : " · ", horizon, quantity(fit, unit));
    if (std::isfinite(held_out)) line += ", held out " + quantity(held_out, unit);
  }
  if (line.empty()) return "";
  if (std::isfinite(comparison.start_horizon))
    line += fmt::format(" · effect of the initial-state uncertainty stays below twice the noise for {:.2g} s",
                        comparison.start_horizon);
  return line + "\n";
}

std::string floor_line(const Comparison& comparison, const PooledScore& pooled) {
  std::string line = "noise floor " + quantity(pooled.floor, pooled.unit);
  if (!pooled.floor_origin.empty()) line += " (" + pooled.floor_origin + ")";
  double numerical = 0.0;
  for (const PooledScore& other : comparison.pooled)
    if (other.channel == pooled.channel && other.numerical) numerical = std::max(numerical, *other.numerical);
  if (pooled.from_start > kStartWorthASay * pooled.floor)
    line += " · effect of the initial-state uncertainty " + quantity(pooled.from_start, pooled.unit);
  return line + " · numerical error " + quantity(numerical, pooled.unit) + "\n";
}

std::string as_written_line(const Comparison& comparison, const PooledScore& pooled) {
  std::string line = "with the values as written: fit " + quantity(pooled.rmse_as_written, pooled.unit);
  for (const PooledScore& other : comparison.pooled)
    if (other.channel == pooled.channel && other.held_out)
      line += ", held out " + quantity(other.rmse_as_written, other.unit);
  return line + "\n";
}

std::string channel_block(const ComparisonHeading& heading, const Comparison& comparison, const PooledScore& pooled) {
  std::vector<std::vector<std::string>> rows = {{pooled.channel, "", "RMSE", "× floor", "worst", "at"}};
  for (const TrialComparison& trial : comparison.trials)
    if (const ChannelScore* score = score_of(trial, pooled.channel))
      rows.push_back(trial_row(trial, *score, pooled.floor));
  std::string text =
      text_table(rows, 2) + floor_line(comparison, pooled) + horizons_line(comparison, pooled.channel, pooled.unit);
  if (heading.refitted) text += as_written_line(comparison, pooled);
  return text;
}

}  // namespace

std::string comparison_text(const ComparisonHeading& heading, const Comparison& comparison, const FitResult& fit) {
  std::string text = heading_line(heading, comparison, fit) + setups_text(heading.setups);
  std::vector<std::string> shown;
  for (const PooledScore& pooled : comparison.pooled) {
    if (std::find(shown.begin(), shown.end(), pooled.channel) != shown.end()) continue;
    shown.push_back(pooled.channel);
    text += channel_block(heading, comparison, pooled);
  }
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text;
}

std::string cross_check_text(const CrossCheck& check) {
  std::string text =
      fmt::format("cross-check with {} ({} integration steps per step, extrapolated to infinitely many):\n",
                  check.engine, check.substeps);
  for (const EngineDistance& one : check.channels)
    text += fmt::format("  {}: difference {}, {:.2g} × the error of the model\n", one.channel,
                        quantity(one.apart, one.unit), one.apart / one.error);
  for (const std::string& reason : check.left_out) text += "  left out: " + reason + "\n";
  return text;
}

std::string fit_text(const FitResult& fit) {
  std::vector<std::vector<std::string>> rows;
  for (const FittedValue& value : fit.values) {
    const IntervalText text = interval_text(value);
    rows.push_back({value.address, text.value, value.unit == "1" ? "" : unit_text(value.unit), text.interval,
                    "from " + quantity(value.start, "1")});
  }
  std::string text = text_table(rows, 1) + bound_text(fit);
  for (const std::string& sentence : fit.cannot_tell) text += sentence + "\n";
  for (const std::string& note : fit.notes) text += "note: " + note + "\n";
  return text;
}

std::string data_checks_text(const std::vector<DataWarning>& doubts) {
  std::string text;
  for (const std::string& fault : faults_among(doubts)) text += "data check failed: " + fault + "\n";
  if (!text.empty())
    text += "correct the data first: the fitted values and the verdict of lacuna diagnose may be wrong\n";
  for (const std::string& limit : limits_among(doubts)) text += "note: " + limit + "\n";
  return text;
}

}  // namespace lacuna
