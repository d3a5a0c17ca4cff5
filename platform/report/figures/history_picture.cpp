#include "report/figures/history_picture.h"

#include "report/figures/figure.h"
#include "report/figures/file_name.h"
#include "report/text/history_rows.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

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

std::vector<std::filesystem::path> draw_history(const std::vector<HistoryRow>& rows, const std::string& title,
                                                const std::filesystem::path& folder, const Stop& stop) {
  std::vector<std::filesystem::path> files;
  FileNames names;
  for (const std::string& channel : channels_of(rows)) {
    files.push_back(folder / names.next("history-" + channel + ".svg"));
    write_svg(figure_of(rows_of(rows, channel), channel, title), files.back(), stop);
  }
  return files;
}

}  // namespace lacuna
