#include "report/figures/comparison_pictures.h"

#include "foundation/text/csv_cell.h"
#include "foundation/files/whole_file.h"
#include "report/figures/figure.h"
#include "report/text/times_floor_text.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

std::vector<double> column(const TimeSeries::Samples& samples, Eigen::Index channel) {
  std::vector<double> values(static_cast<std::size_t>(samples.rows()));
  for (Eigen::Index i = 0; i < samples.rows(); ++i) values[static_cast<std::size_t>(i)] = samples(i, channel);
  return values;
}

Figure figure_of(const TrialComparison& trial, std::size_t channel, const std::string& title) {
  const ChannelScore& score = trial.channels[channel];
  const auto index = static_cast<Eigen::Index>(channel);
  const std::vector<double> times(trial.times.data(), trial.times.data() + trial.times.size());
  const Series measured{"measured", Mark::line, kGrey, times, column(trial.measured, index), {}, kBroad};
  const Series predicted{"predicted", Mark::line, kBlue, times, column(trial.predicted, index), {}};
  const Series residual{"measured − predicted, " + times_floor_text(score.times_floor) + " × floor",
                        Mark::line,
                        kOrange,
                        times,
                        column(trial.residuals, index),
                        {}};
  Panel below{"residual [" + score.unit + "]", {}, 1.0, {}};
  if (std::isfinite(score.floor) && !times.empty())
    below.series.push_back({"± floor",
                            Mark::band,
                            kGrey,
                            {times.front(), times.back()},
                            {-score.floor, -score.floor},
                            {score.floor, score.floor}});
  below.series.push_back(residual);
  return {title + " · " + trial.trial + (trial.held_out ? " (held out)" : ""),
          "time [s]",
          {{score.channel + " [" + score.unit + "]", {measured, predicted}, 1.6, {}}, below}};
}

}  // namespace

std::vector<std::filesystem::path> draw_comparison(const Comparison& comparison, const std::string& title,
                                                   const std::filesystem::path& folder, FileNames& names,
                                                   const Stop& stop) {
  std::vector<std::filesystem::path> files;
  for (const TrialComparison& trial : comparison.trials)
    for (std::size_t channel = 0; channel < trial.channels.size(); ++channel) {
      files.push_back(folder / names.next(trial.trial + "-" + trial.channels[channel].channel + ".svg"));
      write_svg(figure_of(trial, channel, title), files.back(), stop);
    }
  return files;
}

std::vector<std::filesystem::path> write_predictions(const Comparison& comparison, const std::filesystem::path& folder,
                                                     FileNames& names) {
  std::filesystem::create_directories(folder);
  std::vector<std::filesystem::path> files;
  for (const TrialComparison& trial : comparison.trials) {
    files.push_back(folder / names.next(trial.trial + "-predictions.csv"));
    WholeFile file(files.back(), Link::replaced);
    std::ostream& stream = file.stream();
    stream << "time_s";
    for (const ChannelScore& score : trial.channels)
      for (const char* what : {"measured", "predicted", "residual"})
        stream << ',' << csv_cell(fmt::format("{} {} [{}]", score.channel, what, score.unit));
    stream << '\n';
    for (Eigen::Index i = 0; i < trial.times.size(); ++i) {
      stream << fmt::format("{}", trial.times[i]);
      for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(trial.channels.size()); ++c)
        stream << fmt::format(",{},{},{}", trial.measured(i, c), trial.predicted(i, c), trial.residuals(i, c));
      stream << '\n';
    }
    file.publish();
  }
  return files;
}

}  // namespace lacuna
