#include "report/json/history_json.h"

#include "documents/setup_json.h"
#include "foundation/text/csv_cell.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lacuna {

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

}  // namespace lacuna
