#include "report/history_text.h"

#include "foundation/counted.h"
#include "foundation/csv_cell.h"
#include "foundation/unit.h"
#include "report/figure.h"
#include "report/file_name.h"
#include "report/horizon_text.h"
#include "report/setup_report.h"
#include "report/text_table.h"
#include "report/times_floor_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kBarWidth = 24;

std::vector<std::string> channels_of(const std::vector<HistoryRow>& rows) {
  std::vector<std::string> channels;
  for (const HistoryRow& row : rows)
    if (!row.channel.empty() && std::find(channels.begin(), channels.end(), row.channel) == channels.end())
      channels.push_back(row.channel);
  return channels;
}

std::vector<HistoryRow> rows_of(const std::vector<HistoryRow>& rows, const std::string& channel) {
  std::vector<HistoryRow> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen),
               [&](const HistoryRow& row) { return row.channel == channel || row.channel.empty(); });
  return chosen;
}

std::string error_quantity(double value, const std::string& unit) {
  return std::isfinite(value) ? format_quantity(value, unit) : "-";
}

/// The row's bar; where other rows have a held-out error and this one has none, it says what it counts.
std::string bar(const HistoryRow& row, double largest, bool held_out_known) {
  if (row.failed_trials > 0) return counted(static_cast<std::size_t>(row.failed_trials), "trial") + " failed";
  if (!row.fitted && row.channel.empty()) return "not fitted";
  if (!std::isfinite(row.times_floor))
    return std::isfinite(row.fit_rmse) || std::isfinite(row.held_out_rmse) ? "floor not known" : "not compared";
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
  std::vector<std::vector<std::string>> table = {{"rev", channel, "fit", "held out", "× floor", ""}};
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

/// By revision, errors of predictions over each length, and what they are of the first revision's; empty where none is
/// stored.
std::string horizon_table(const std::vector<HistoryRow>& rows, const std::string& channel) {
  const HistoryRow* first = nullptr;
  for (const HistoryRow& row : rows)
    if (!first && !row.horizons.empty()) first = &row;
  if (!first) return "";
  std::vector<std::string> head = {"rev", channel + " over"};
  for (const HorizonRow& one : first->horizons) head.insert(head.end(), {fmt::format("{:g} s", one.horizon), ""});
  std::vector<std::vector<std::string>> table = {head};
  for (const bool held_out : {false, true})
    for (const HistoryRow& row : rows) {
      std::vector<std::string> cells = {std::to_string(row.number), held_out ? "held out" : "fit"};
      bool is_known = false;
      for (const HorizonRow& then : first->horizons) {
        const double error = error_over(row, then.horizon, held_out);
        is_known = is_known || std::isfinite(error);
        const std::string ratio = error_ratio_text(error, error_over(*first, then.horizon, held_out));
        cells.insert(cells.end(), {error_quantity(error, row.unit), &row == first ? "" : ratio});
      }
      if (is_known) table.push_back(cells);
    }
  return text_table(table, 2);
}

Figure figure_of(const std::vector<HistoryRow>& rows, const std::string& channel, const std::string& title) {
  Series fit{"fit", Mark::line_points, kBlue, {}, {}, {}}, held_out{"held out", Mark::line_points, kOrange, {}, {}, {}};
  Panel panel;
  double floor = kNotKnown;
  for (const HistoryRow& row : rows) {
    const auto x = static_cast<double>(panel.x_names.size());
    panel.x_names.push_back(fmt::format("{} {}", row.number, row.change));
    panel.y_label = "RMSE of " + channel + " [" + row.unit + "]";
    fit.x.push_back(x);
    fit.y.push_back(row.fit_rmse);
    held_out.x.push_back(x);
    held_out.y.push_back(row.held_out_rmse);
    if (std::isfinite(row.floor)) floor = row.floor;
  }
  panel.series = {fit, held_out};
  if (std::isfinite(floor)) panel.series.push_back({"noise floor", Mark::level, kGrey, {}, {floor}, {}});
  return {title, "", {panel}};
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
  return text + fmt::format("held-out looks {}\n", held_out_looks) + setups_text(setups);
}

std::string history_json(const std::vector<HistoryRow>& rows, int held_out_looks, const std::string& missing,
                         const std::string& next, const std::vector<KnownSetup>& setups) {
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
  };
  nlohmann::ordered_json revisions = nlohmann::ordered_json::array();
  for (const HistoryRow& row : rows) {
    nlohmann::ordered_json horizons = nlohmann::ordered_json::array();
    for (const HorizonRow& one : row.horizons)
      horizons.push_back(
          {{"horizon_s", one.horizon}, {"fit_rmse", one.fit_rmse}, {"held_out_rmse", one.held_out_rmse}});
    revisions.push_back({{"revision", row.number},
                         {"parent", row.parent ? nlohmann::ordered_json(*row.parent) : nlohmann::ordered_json(nullptr)},
                         {"change", row.change},
                         {"current", row.current},
                         {"fitted", row.fitted},
                         {"channel", row.channel},
                         {"unit", row.unit},
                         {"fit_rmse", row.fit_rmse},
                         {"held_out_rmse", row.held_out_rmse},
                         {"floor", row.floor},
                         {"times_floor", row.times_floor},
                         {"failed_trials", row.failed_trials},
                         {"horizons", horizons}});
  }
  return nlohmann::ordered_json{{"held_out_looks", held_out_looks},
                                {"missing", text_or_null(missing)},
                                {"next", text_or_null(next)},
                                {"setups", setups_json(setups)},
                                {"revisions", revisions}}
             .dump(2) +
         "\n";
}

std::string history_csv(const std::vector<HistoryRow>& rows) {
  std::string text =
      "revision,parent,change,current,channel,unit,fit_rmse,held_out_rmse,floor,times_floor,failed_trials\n";
  for (const HistoryRow& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", row.number, row.parent ? std::to_string(*row.parent) : "",
                        csv_cell(row.change), row.current ? 1 : 0, csv_cell(row.channel), csv_cell(row.unit),
                        row.fit_rmse, row.held_out_rmse, row.floor, row.times_floor, row.failed_trials);
  return text;
}

std::vector<std::filesystem::path> draw_history(const std::vector<HistoryRow>& rows, const std::string& title,
                                                const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  FileNames names;
  for (const std::string& channel : channels_of(rows)) {
    files.push_back(folder / names.next("history-" + channel + ".svg"));
    write_svg(figure_of(rows_of(rows, channel), channel, title), files.back());
  }
  return files;
}

}  // namespace lacuna
