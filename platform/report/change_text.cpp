#include "report/change_text.h"

#include "report/bound_text.h"
#include "report/error_text.h"
#include "report/interval_text.h"
#include "report/text_table.h"
#include "report/times_floor_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lacuna {
namespace {

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

std::string error_rows(const RevisionErrors& before, const RevisionErrors& after) {
  std::vector<std::vector<std::string>> rows = {{"fit files", "RMSE", "", "× floor", ""}};
  for (const PooledScore& now : after.comparison.pooled) {
    const PooledScore* then = fit_score(before.comparison, now.channel);
    if (now.held_out || !then) continue;
    rows.push_back({now.channel, error_text(*then) + " →", error_text(now), times_floor_text(then->times_floor) + " →",
                    times_floor_text(now.times_floor)});
  }
  return text_table(rows);
}

std::string value_rows(const RevisionErrors& before, const RevisionErrors& after) {
  std::vector<std::vector<std::string>> rows;
  for (const FittedValue& now : after.fit.values) {
    const FittedValue* then = value_at(before.fit, now.address);
    const IntervalText text = interval_text(now);
    rows.push_back({now.address, then ? interval_text(*then).value + " →" : "new", text.value,
                    now.unit == "1" ? "" : now.unit, text.interval});
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

}  // namespace

std::string change_text(const RevisionErrors& before, const RevisionErrors& after) {
  std::string text = fmt::format("revision {} → {}\n", before.revision, after.revision);
  text += error_rows(before, after) + value_rows(before, after) + bound_text(after.fit);
  for (const std::string& sentence : after.fit.cannot_tell) text += sentence + "\n";
  return text;
}

std::string change_json(const std::string& change, const RevisionErrors& before, const RevisionErrors& after) {
  return nlohmann::ordered_json{{"change", change}, {"before", errors(before)}, {"after", errors(after)}}.dump(2) +
         "\n";
}

}  // namespace lacuna
