#include "report/text/change_text.h"

#include "foundation/text/figure_text.h"
#include "foundation/text/unit_text.h"
#include "foundation/unit.h"
#include "report/text/bound_text.h"
#include "report/text/error_text.h"
#include "report/text/horizon_text.h"
#include "report/text/interval_text.h"
#include "report/text/text_table.h"
#include "report/text/times_floor_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kNoticed = 0.01;  ///< share that an error rises by

const PooledScore* fit_score(const Comparison& comparison, const std::string& channel) {
  const auto found = std::find_if(comparison.pooled.begin(), comparison.pooled.end(),
                                  [&](const PooledScore& s) { return s.channel == channel && !s.held_out; });
  return found == comparison.pooled.end() ? nullptr : &*found;
}

const FittedValue* value_at(const FitResult& fit, const std::string& address) {
  const auto found =
      std::find_if(fit.values.begin(), fit.values.end(), [&](const FittedValue& v) { return v.address == address; });
  return found == fit.values.end() ? nullptr : &*found;
}

/// Empty where the two were not predicted over that length.
std::vector<std::string> horizon_row(const RevisionErrors& before, const RevisionErrors& after,
                                     const PooledScore& channel, double horizon) {
  const double then = restarted_error(before.comparison, channel.channel, horizon, false);
  const double now = restarted_error(after.comparison, channel.channel, horizon, false);
  if (!std::isfinite(then) || !std::isfinite(now)) return {};
  return {fmt::format(" {:g} s segments", horizon),
          format_quantity(then, channel.unit) + " →",
          format_quantity(now, channel.unit),
          "",
          "",
          error_change_text(now, then)};
}

std::string error_rows(const RevisionErrors& before, const RevisionErrors& after) {
  std::vector<std::vector<std::string>> rows = {{"fit files", "RMSE", "", "× floor", "", "change"}};
  for (const PooledScore& now : after.comparison.pooled) {
    const PooledScore* then = fit_score(before.comparison, now.channel);
    if (now.held_out || !then) continue;
    rows.push_back({now.channel, error_text(*then) + " →", error_text(now), times_floor_text(then->times_floor) + " →",
                    times_floor_text(now.times_floor), error_change_text(now.rmse, then->rmse)});
    for (const double horizon : horizons_of(after.comparison, false))
      if (std::vector<std::string> row = horizon_row(before, after, now, horizon); !row.empty())
        rows.push_back(std::move(row));
  }
  return text_table(rows);
}

std::string value_rows(const RevisionErrors& before, const RevisionErrors& after) {
  std::vector<std::vector<std::string>> rows;
  for (const FittedValue& now : after.fit.values) {
    const FittedValue* then = value_at(before.fit, now.address);
    const IntervalText text = interval_text(now);
    rows.push_back({now.address, then ? interval_text(*then).value + " →" : "new", text.value,
                    now.unit == "1" ? "" : unit_text(now.unit), text.interval});
  }
  return text_table(rows);
}

nlohmann::ordered_json errors(const RevisionErrors& revision) {
  nlohmann::ordered_json channels = nlohmann::ordered_json::array(), values = nlohmann::ordered_json::array();
  for (const PooledScore& score : revision.comparison.pooled)
    if (!score.held_out)
      channels.push_back({{"channel", score.channel},
                          {"unit", score.unit},
                          {"failed_trials", score.failed_trials},
                          {"rmse", score.rmse},
                          {"floor", score.floor},
                          {"times_floor", score.times_floor}});
  for (const FittedValue& value : revision.fit.values)
    values.push_back({{"address", value.address},
                      {"unit", value.unit},
                      {"value", value.value},
                      {"ci95", {value.lower_95, value.upper_95}}});
  return {{"revision", revision.revision}, {"channels", channels}, {"values", values}};
}

bool has_risen(double before, double after) {
  return std::isfinite(before) && std::isfinite(after) && after > (1.0 + kNoticed) * before;
}

void add_rises(const TrialComparison& before, const TrialComparison& after, std::vector<ErrorRise>& rises) {
  const auto add = [&](const ChannelScore& channel, double horizon, double then, double now) {
    rises.push_back({after.trial, after.held_out, channel.channel, channel.unit, horizon, then, now});
  };
  const std::size_t channels = std::min(before.channels.size(), after.channels.size());
  for (std::size_t c = 0; c < channels; ++c) {
    const ChannelScore &then = before.channels[c], &now = after.channels[c];
    if (before.valid && !after.valid)
      add(now, 0.0, then.rmse, std::numeric_limits<double>::infinity());
    else if (has_risen(then.rmse, now.rmse))
      add(now, 0.0, then.rmse, now.rmse);
    for (const HorizonScore& later : after.horizons)
      for (const HorizonScore& earlier : before.horizons)
        if (!later.automatic && !earlier.automatic && later.horizon == earlier.horizon &&
            has_risen(earlier.rmse[c], later.rmse[c]))
          add(now, later.horizon, earlier.rmse[c], later.rmse[c]);
  }
}

std::string rises_text(const std::vector<ErrorRise>& rises, const std::string& undo) {
  if (rises.empty()) return "";
  std::vector<std::vector<std::string>> rows = {{"increased errors", "", "", "RMSE", ""}};
  for (const ErrorRise& rise : rises)
    rows.push_back({rise.channel, (rise.held_out ? "held out " : "") + rise.trial,
                    rise.horizon > 0.0 ? fmt::format("{:g} s segments", rise.horizon) : "free run",
                    format_quantity(rise.before, rise.unit) + " →",
                    std::isfinite(rise.after) ? format_quantity(rise.after, rise.unit) : "cannot be simulated"});
  return text_table(rows) + (undo.empty() ? "" : fmt::format("to undo the change: {}\n", undo));
}

nlohmann::ordered_json document(const ErrorRise& rise) {
  return {{"trial", rise.trial},
          {"held_out", rise.held_out},
          {"channel", rise.channel},
          {"unit", rise.unit},
          {"horizon_s", rise.horizon > 0.0 ? nlohmann::ordered_json(rise.horizon) : nlohmann::ordered_json(nullptr)},
          {"before", rise.before},
          {"after", rise.after}};
}

}  // namespace

std::vector<ErrorRise> error_rises(const Comparison& before, const Comparison& after) {
  std::vector<ErrorRise> rises;
  for (const TrialComparison& now : after.trials) {
    const auto then = std::find_if(before.trials.begin(), before.trials.end(), [&](const TrialComparison& trial) {
      return trial.trial == now.trial && trial.held_out == now.held_out;
    });
    if (then != before.trials.end()) add_rises(*then, now, rises);
  }
  return rises;
}

std::string change_text(const RevisionErrors& before, const RevisionErrors& after, const std::string& undo) {
  std::string text = fmt::format("revision {} → {}\n", before.revision, after.revision);
  text += error_rows(before, after) + value_rows(before, after) + bound_text(after.fit);
  for (const std::string& sentence : after.fit.cannot_tell) text += sentence + "\n";
  return text + rises_text(error_rises(before.comparison, after.comparison), undo);
}

std::string change_json(const std::string& change, const RevisionErrors& before, const RevisionErrors& after,
                        const std::string& undo) {
  nlohmann::ordered_json rises = nlohmann::ordered_json::array();
  for (const ErrorRise& rise : error_rises(before.comparison, after.comparison)) rises.push_back(document(rise));
  nlohmann::ordered_json document = {
      {"change", change}, {"before", errors(before)}, {"after", errors(after)}, {"rises", rises}};
  if (!undo.empty()) document["undo"] = undo;
  return document.dump(2) + "\n";
}

}  // namespace lacuna
