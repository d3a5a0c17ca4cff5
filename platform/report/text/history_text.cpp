#include "report/text/history_text.h"

#include "foundation/text/counted.h"
#include "foundation/text/figure_text.h"
#include "foundation/unit.h"
#include "report/text/history_rows.h"
#include "report/text/horizon_text.h"
#include "report/text/setups_text.h"
#include "report/text/text_table.h"
#include "report/text/times_floor_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kBarWidth = 24;

std::string error_quantity(double value, const std::string& unit) {
  return std::isfinite(value) ? format_quantity(value, unit) : "-";
}

/// The row's bar; where other rows have a held-out error and this one has none, it says what it counts.
std::string bar(const HistoryRow& row, double largest, bool held_out_known) {
  if (row.failed_trials > 0) return counted(static_cast<std::size_t>(row.failed_trials), "trial") + " failed";
  if (!row.fitted && row.channel.empty()) return "not fitted";
  if (!std::isfinite(row.times_floor))
    return std::isfinite(row.fit_rmse) || std::isfinite(row.held_out_rmse) ? "noise floor not known" : "not compared";
  const std::string drawn = text_bar(row.times_floor / largest, kBarWidth);
  return held_out_known && !std::isfinite(row.held_out_rmse) ? drawn + " fit files" : drawn;
}

std::string channel_table(const std::vector<HistoryRow>& rows, const std::string& channel) {
  double largest = 0.0;
  const HistoryRow* with_floor = nullptr;
  bool held_out_known = false;
  for (const HistoryRow& row : rows) {
    if (std::isfinite(row.times_floor)) largest = std::max(largest, row.times_floor);
    if (std::isfinite(row.floor)) with_floor = &row;
    held_out_known = held_out_known || std::isfinite(row.held_out_rmse);
  }
  std::vector<std::vector<std::string>> table = {
      {"rev", channel, "fit", "held out", held_out_known ? "held out × floor" : "× floor", ""}};
  std::vector<std::string> bars = {""};
  for (const HistoryRow& row : rows) {
    table.push_back({fmt::format("{}{}", row.number, row.current ? "*" : ""), row.change,
                     error_quantity(row.fit_rmse, row.unit), error_quantity(row.held_out_rmse, row.unit),
                     times_floor_text(row.times_floor)});
    bars.push_back(bar(row, largest, held_out_known));
  }
  if (with_floor) {
    table.push_back({"", "floor", "", error_quantity(with_floor->floor, with_floor->unit), "1.0"});
    bars.push_back(text_bar(1.0 / std::max(largest, 1.0), kBarWidth));
  }
  // The bars stand to the left of their own column, so they are set after the table.
  std::string text, aligned = text_table(table, 2);
  for (std::size_t i = 0, begin = 0; i < bars.size(); ++i) {
    const std::size_t end = aligned.find('\n', begin);
    text += aligned.substr(begin, end - begin) + (bars[i].empty() ? "" : "  " + bars[i]) + '\n';
    begin = end + 1;
  }
  return text;
}

double error_over(const HistoryRow& row, double horizon, bool held_out) {
  for (const HorizonRow& one : row.horizons)
    if (one.horizon == horizon) return held_out ? one.held_out_rmse : one.fit_rmse;
  return kNotKnown;
}

/// By revision, errors of predictions over each length, and how they differ from the first revision's; empty where none
/// is stored.
std::string horizon_table(const std::vector<HistoryRow>& rows, const std::string& channel) {
  const HistoryRow* first = nullptr;
  for (const HistoryRow& row : rows)
    if (!first && !row.horizons.empty()) first = &row;
  if (!first) return "";
  std::vector<std::string> head = {"rev", channel};
  for (const HorizonRow& one : first->horizons)
    head.insert(head.end(), {fmt::format("{:g} s segments", one.horizon), ""});
  std::vector<std::vector<std::string>> table = {head};
  for (const bool held_out : {false, true})
    for (const HistoryRow& row : rows) {
      std::vector<std::string> cells = {std::to_string(row.number), held_out ? "held out" : "fit"};
      bool is_known = false;
      for (const HorizonRow& then : first->horizons) {
        const double error = error_over(row, then.horizon, held_out);
        is_known = is_known || std::isfinite(error);
        const std::string change = error_change_text(error, error_over(*first, then.horizon, held_out));
        cells.insert(cells.end(), {error_quantity(error, row.unit), &row == first ? "" : change});
      }
      if (is_known) table.push_back(cells);
    }
  return text_table(table, 2);
}

}  // namespace

std::string history_text(const std::vector<HistoryRow>& rows, int held_out_looks,
                         const std::vector<KnownSetup>& setups) {
  std::string text;
  for (const std::string& channel : channels_of(rows)) {
    const std::vector<HistoryRow> own = rows_of(rows, channel);
    text += channel_table(own, channel) + horizon_table(own, channel);
  }
  if (text.empty()) text = channel_table(rows, "never compared");
  return text + "held-out trials compared " + counted(static_cast<std::size_t>(held_out_looks), "time") + "\n" +
         setups_text(setups);
}

}  // namespace lacuna
