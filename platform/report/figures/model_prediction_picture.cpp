#include "report/figures/model_prediction_picture.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

constexpr std::size_t kMostPredicted = 12;           // panels
constexpr int kOnePanel = 210, kAroundPanels = 130;  // px

std::vector<double> column_of(const TimeSeries::Samples& samples, Eigen::Index column) {
  std::vector<double> values;
  for (Eigen::Index row = 0; row < samples.rows(); ++row) values.push_back(samples(row, column));
  return values;
}

Panel part_panel(const PredictedPart& part, std::size_t channel, bool named) {
  const auto column = static_cast<Eigen::Index>(channel);
  const std::vector<double> times(part.times.begin(), part.times.end());
  Panel panel{
      fmt::format("{}{} [{}]", named ? part.name + ": " : "", part.channels[channel].name, part.channels[channel].unit),
      {},
      1.0,
      {}};
  if (part.measured.size() > 0)
    panel.series.push_back({"measured", Mark::line, kGrey, times, column_of(part.measured, column), {}, kBroad});
  panel.series.push_back({"predicted", Mark::line, kBlue, times, column_of(part.predicted, column), {}});
  return panel;
}

}  // namespace

Figure model_prediction_figure(const ModelPrediction& prediction) {
  Figure figure{fmt::format("{} · revision {}{}", prediction.experiment, prediction.revision,
                            prediction.test.empty() ? "" : " · " + prediction.test),
                "time [s]",
                {}};
  std::size_t all = 0;
  for (const PredictedPart& part : prediction.parts)
    for (std::size_t c = 0; c < part.channels.size(); ++c)
      if (all++ < kMostPredicted) figure.panels.push_back(part_panel(part, c, prediction.parts.size() > 1));
  if (all > kMostPredicted) figure.title += fmt::format(" · {} of {} curves", kMostPredicted, all);
  figure.height = kAroundPanels + kOnePanel * static_cast<int>(figure.panels.size());
  return figure;
}

}  // namespace lacuna
