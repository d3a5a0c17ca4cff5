#include "report/text/prediction_text.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"
#include "report/text/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kWorthASay = 1.05;  // a factor below is as good as 1

std::string share_text(double share) { return std::isfinite(share) ? fmt::format("{:.0f} %", 100.0 * share) : "-"; }

std::string share_text(const Coverage& coverage) {
  if (coverage.lower == coverage.upper) return share_text(coverage.share);  // all trials say the same
  return fmt::format("{} [{}, {}]", share_text(coverage.share), share_text(coverage.lower), share_text(coverage.upper));
}

std::string title_line(const PredictionReport& report) {
  std::string line = fmt::format("{} · run {}, pass {} · {} · {}", report.experiment, report.run, report.pass,
                                 counted(report.prediction.models, "model"), report.test);
  if (report.setup)
    line += " · " + setup_text(*report.setup) + (report.setup_is_asked ? "" : " (the first recording's)");
  if (report.measured)
    line += fmt::format(
        " · carried out as trial {}, {}", report.measured->trial,
        report.measured->fitted ? "to which the models were fitted" : "to which the models were not fitted");
  return line + "\n";
}

std::vector<std::string> channel_row(const PredictionReport& report, std::size_t channel) {
  const Channel& named = report.prediction.channels[channel];
  const auto half_width = report.prediction.band.half_width.col(static_cast<Eigen::Index>(channel));
  Eigen::Index widest = 0;
  const double most = half_width.maxCoeff(&widest);
  const double usual = std::sqrt(half_width.squaredNorm() / static_cast<double>(half_width.size()));
  std::vector<std::string> row = {named.name, format_quantity(usual, named.unit), format_quantity(most, named.unit),
                                  fmt::format("{:.2f} s", report.prediction.times(widest))};
  if (!report.support.enough()) return row;
  const ChannelSupport& support = report.support.channels[channel];
  row.push_back(share_text(support.inside.share));
  row.push_back(fmt::format("{:.2g}", support.widening()));
  return row;
}

std::string band_table(const PredictionReport& report) {
  std::vector<std::vector<std::string>> table = {{"channel", "95 % band ±", "at most ±", "at"}};
  if (report.support.enough()) {
    table.front().emplace_back("new trials inside");
    table.front().emplace_back("× spread");
  }
  for (std::size_t c = 0; c < report.prediction.channels.size(); ++c) table.push_back(channel_row(report, c));
  return text_table(table);
}

std::string structure_table(const PredictionReport& report) {
  if (report.structures.size() < 2) return {};
  std::vector<std::vector<std::string>> table = {{"structure", "models"}};
  for (const auto& [name, models] : report.structures)
    table.push_back({name.empty() ? "-" : name, std::to_string(models)});
  return text_table(table);
}

/// "2.3", or "1.2 to 2.3" of several channels.
std::string widenings(const BandSupport& support) {
  std::vector<std::string> factors;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const ChannelSupport& channel : support.channels) {
    if (channel.trials == 0) continue;
    least = std::min(least, channel.widening());
    most = std::max(most, channel.widening());
  }
  const std::string from = fmt::format("{:.2g}", least), to = fmt::format("{:.2g}", most);
  return from == to ? to : from + " to " + to;
}

bool is_widened(const BandSupport& support) {
  return std::any_of(support.channels.begin(), support.channels.end(),
                     [](const ChannelSupport& channel) { return channel.widening() >= kWorthASay; });
}

std::string too_few(std::size_t trials) {
  return fmt::format(
      "uncalibrated: {} predicted before a model was fitted to {}, and a calibration takes {}; the band is the spread "
      "of the models and the sensor noise\n",
      counted(trials, "trial") + (trials == 1 ? " was" : " were"), trials == 1 ? "it" : "them", kFewestHeldOut);
}

std::string support_lines(const PredictionReport& report) {
  const BandSupport& support = report.support;
  if (!support.enough()) return too_few(support.all.trials);
  const bool single = report.prediction.models == 1;
  std::string text =
      fmt::format("{} were predicted before a model was fitted to them: {} of the readings lie within the 95 % band\n",
                  counted(support.all.trials, "trial"), share_text(support.all.inside));
  if (!is_widened(support))
    return text + (single ? "the band is the sensor noise\n"
                          : "the spread of the models matches their errors: the band is not widened\n");
  return text + fmt::format(
                    "{} × {}. Cross-validated (factor from the other trials): the band contains {} of the "
                    "readings of a trial\n",
                    (single ? "the model is less accurate than the sensor noise suggests: the band is widened to "
                            : "the models are less accurate than their spread suggests: the band is widened to ") +
                        widenings(support),
                    single ? "the noise" : "the spread", share_text(support.widened));
}

std::string minded_lines(const PredictionReport& report) {
  const EnsemblePrediction& prediction = report.prediction;
  std::string text;
  if (!prediction.lost.empty())
    text += fmt::format("{} of {} cannot simulate the test and {} left out: {}\n", prediction.lost.size(),
                        counted(prediction.models + prediction.lost.size(), "model"),
                        prediction.lost.size() == 1 ? "is" : "are", prediction.lost.front().reason);
  if (report.refuted > 0)
    text += fmt::format("{} with more than twice the best model's error on the trials so far {} left out\n",
                        counted(report.refuted, "model"), report.refuted == 1 ? "is" : "are");
  if (!report.unscored.empty())
    text += fmt::format("the models were never scored on {} (estimation.sensors)\n", fmt::join(report.unscored, ", "));
  if (report.copies > 0)
    text += fmt::format("{} of {} {} of another and {} not count; for more variety, use several estimation.restarts\n",
                        report.copies, counted(report.copies + prediction.models + prediction.lost.size(), "model"),
                        report.copies == 1 ? "is a copy" : "are copies", report.copies == 1 ? "does" : "do");
  if (prediction.models == 1)
    text +=
        "a single model has no spread, so the band contains only noise; to keep more models of a run: "
        "estimation.ensemble = 8\n";
  for (std::size_t c = 0; c < report.noise.size(); ++c)
    if (!std::isfinite(report.noise[c]))
      text += fmt::format("no trial measured {}, so its band contains no sensor noise\n", prediction.channels[c].name);
  for (std::size_t c = 0; c < report.support.channels.size(); ++c)
    if (report.support.enough() && std::isinf(report.support.channels[c].factor))
      text +=
          fmt::format("{}: readings differ from all models where the band has no width, so no factor can correct it\n",
                      prediction.channels[c].name);
  return text;
}

}  // namespace

std::string prediction_text(const PredictionReport& report) {
  return title_line(report) + band_table(report) + structure_table(report) + support_lines(report) +
         minded_lines(report);
}

}  // namespace lacuna
