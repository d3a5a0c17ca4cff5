#include "report/json/prediction_data.h"

#include "documents/setup_json.h"
#include "foundation/text/csv_cell.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson number_or_null(double value) { return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr); }

template <class Values>
OrderedJson numbers_of(const Values& values) {
  OrderedJson list = OrderedJson::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

OrderedJson coverage_json(const Coverage& coverage) {
  return {{"share", number_or_null(coverage.share)},
          {"ci95", {number_or_null(coverage.lower), number_or_null(coverage.upper)}}};
}

OrderedJson support_json(const ChannelSupport& support) {
  return {{"trials", support.trials},
          {"inside", coverage_json(support.inside)},
          {"error", number_or_null(support.error)},
          {"factor", number_or_null(support.factor)},
          {"widening", support.widening()}};
}

OrderedJson channel_json(const PredictionReport& report, std::size_t channel) {
  const EnsembleBand& band = report.prediction.band;
  const auto column = static_cast<Eigen::Index>(channel);
  OrderedJson json = {{"channel", report.prediction.channels[channel].name},
                      {"unit", report.prediction.channels[channel].unit},
                      {"noise", number_or_null(report.noise[channel])}};
  if (channel < report.support.channels.size()) json["held_out"] = support_json(report.support.channels[channel]);
  json["mean"] = numbers_of(band.mean.col(column));
  json["half_width"] = numbers_of(band.half_width.col(column));
  return json;
}

OrderedJson held_out_json(const BandSupport& support) {
  OrderedJson json = support_json(support.all);
  json.erase("widening");  // which each channel has of its own
  json["calibrated"] = support.enough();
  json["inside_widened"] = coverage_json(support.widened);
  json["by_trial"] = OrderedJson::array();
  for (const HeldOutTrial& trial : support.trials)
    json["by_trial"].push_back({{"trial", trial.number}, {"pass", trial.pass}});
  return json;
}

}  // namespace

std::string prediction_json(const PredictionReport& report) {
  const EnsemblePrediction& prediction = report.prediction;
  OrderedJson json = {
      {"experiment", report.experiment}, {"run", report.run},          {"pass", report.pass}, {"test", report.test},
      {"duration", report.duration},     {"models", prediction.models}};
  json["setup"] = report.setup ? setup_json(*report.setup) : OrderedJson(nullptr);
  json["copies"] = report.copies;
  json["refuted"] = report.refuted;
  json["lost_models"] = OrderedJson::array();
  for (const LostModel& lost : prediction.lost)
    json["lost_models"].push_back({{"model", lost.number}, {"reason", lost.reason}});
  json["structures"] = OrderedJson::array();
  for (const auto& [name, models] : report.structures)
    json["structures"].push_back({{"structure", name}, {"models", models}});
  json["held_out"] = held_out_json(report.support);
  json["trial"] = report.measured ? OrderedJson(report.measured->trial) : OrderedJson(nullptr);
  json["times"] = numbers_of(prediction.times);
  json["channels"] = OrderedJson::array();
  for (std::size_t c = 0; c < prediction.channels.size(); ++c) json["channels"].push_back(channel_json(report, c));
  return json.dump(2) + "\n";
}

std::string prediction_csv(const EnsemblePrediction& prediction) {
  std::string text = "t [s]";
  for (const Channel& channel : prediction.channels)
    for (const char* what : {"mean", "lower", "upper"})
      text += "," + csv_cell(fmt::format("{} {} [{}]", channel.name, what, channel.unit));
  text += '\n';
  for (Eigen::Index row = 0; row < prediction.times.size(); ++row) {
    text += fmt::format("{:.9g}", prediction.times(row));
    for (Eigen::Index c = 0; c < prediction.band.mean.cols(); ++c) {
      const double mean = prediction.band.mean(row, c), half_width = prediction.band.half_width(row, c);
      text += fmt::format(",{:.9g},{:.9g},{:.9g}", mean, mean - half_width, mean + half_width);
    }
    text += '\n';
  }
  return text;
}

}  // namespace lacuna
