#include "report/figures/prediction_picture.h"

#include "foundation/text/counted.h"
#include "report/figures/thinning.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr std::size_t kBandColumns = 500;  // of pixels, in each of which a band has a few corners
constexpr double kThinnest = 1e-6;         // of the values: a thinner band would make an axis of nothing but it
constexpr int kMostBelowEachOther = 3;
constexpr int kPanelHeight = 210, kRoomAround = 130;  // px

std::vector<double> listed(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

std::vector<double> at(const std::vector<double>& values, const std::vector<std::size_t>& places) {
  std::vector<double> chosen;
  for (const std::size_t i : places) chosen.push_back(values[i]);
  return chosen;
}

/// With the extremes of both of its edges.
Series band_series(const std::vector<double>& times, const std::vector<double>& lower, const std::vector<double>& upper,
                   const std::string& label) {
  std::vector<std::size_t> places = thinned(lower, kBandColumns);
  const std::vector<std::size_t> others = thinned(upper, kBandColumns);
  places.insert(places.end(), others.begin(), others.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return {label, Mark::band, kBlue, at(times, places), at(lower, places), at(upper, places)};
}

/// Readings of a channel, where it was measured.
void add_measured(const TimeSeries& measured, const std::string& channel, Panel& panel) {
  for (std::size_t c = 0; c < measured.channels.size(); ++c)
    if (measured.channels[c].name == channel)
      panel.series.push_back({"measured",
                              Mark::line,
                              kOrange,
                              listed(measured.times),
                              listed(measured.samples.col(static_cast<Eigen::Index>(c))),
                              {},
                              kBroad});
}

Panel prediction_panel(const PredictionReport& report, std::size_t channel) {
  const EnsemblePrediction& prediction = report.prediction;
  const auto column = static_cast<Eigen::Index>(channel);
  const Eigen::VectorXd mean = prediction.band.mean.col(column), half_width = prediction.band.half_width.col(column);
  const std::vector<double> times = listed(prediction.times);
  Panel panel{prediction.channels[channel].name + " [" + prediction.channels[channel].unit + "]", {}, 1.0, {}};
  if (half_width.maxCoeff() > kThinnest * mean.cwiseAbs().maxCoeff())
    panel.series.push_back(band_series(times, listed(mean - half_width), listed(mean + half_width),
                                       report.support.enough() ? "95 % band" : "95 % band, uncalibrated"));
  if (report.measured) add_measured(report.measured->measured, prediction.channels[channel].name, panel);
  panel.series.push_back(
      {"mean of " + counted(prediction.models, "model"), Mark::line, kBlue, times, listed(mean), {}});
  return panel;
}

/// Two columns, whose panels are named below and have one legend.
void put_side_by_side(Figure& figure) {
  figure.columns = 2;
  const auto legend = std::max_element(figure.panels.begin(), figure.panels.end(), [](const Panel& a, const Panel& b) {
    return a.series.size() < b.series.size();
  });
  for (Panel& panel : figure.panels) {
    panel.x_label = panel.y_label + ", time [s]";
    panel.y_label.clear();
    if (&panel != &*legend)
      for (Series& series : panel.series) series.label.clear();
  }
}

}  // namespace

Figure prediction_figure(const PredictionReport& report) {
  Figure figure{fmt::format("{}, run {} · {}", report.experiment, report.run, report.test), "time [s]", {}};
  for (std::size_t c = 0; c < report.prediction.channels.size(); ++c)
    figure.panels.push_back(prediction_panel(report, c));
  const int panels = static_cast<int>(figure.panels.size());
  if (panels > kMostBelowEachOther) put_side_by_side(figure);
  figure.height = kRoomAround + kPanelHeight * ((panels + figure.columns - 1) / figure.columns);
  return figure;
}

}  // namespace lacuna
