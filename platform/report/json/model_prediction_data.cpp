#include "report/json/model_prediction_data.h"

#include "documents/setup_json.h"
#include "foundation/text/csv_cell.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using PredictionJson = nlohmann::ordered_json;

template <class Values>
PredictionJson known_numbers(const Values& values) {
  PredictionJson list = PredictionJson::array();
  for (const double value : values)
    list.push_back(std::isfinite(value) ? PredictionJson(value) : PredictionJson(nullptr));
  return list;
}

PredictionJson part_json(const PredictedPart& part) {
  PredictionJson channels = PredictionJson::array();
  for (std::size_t c = 0; c < part.channels.size(); ++c) {
    const auto column = static_cast<Eigen::Index>(c);
    PredictionJson one = {{"channel", part.channels[c].name},
                          {"unit", part.channels[c].unit},
                          {"predicted", known_numbers(part.predicted.col(column))}};
    one["measured"] = part.measured.size() > 0 ? known_numbers(part.measured.col(column)) : PredictionJson(nullptr);
    channels.push_back(std::move(one));
  }
  return {{"name", part.name}, {"times", known_numbers(part.times)}, {"channels", channels}};
}

/// Of all parts, each once.
std::vector<Channel> channels_of_parts(const ModelPrediction& prediction) {
  std::vector<Channel> channels;
  for (const PredictedPart& part : prediction.parts)
    for (const Channel& channel : part.channels)
      if (std::none_of(channels.begin(), channels.end(), [&](const Channel& one) { return one.name == channel.name; }))
        channels.push_back(channel);
  return channels;
}

std::string cell_of(const TimeSeries::Samples& samples, const PredictedPart& part, const Channel& channel,
                    Eigen::Index row) {
  for (std::size_t c = 0; c < part.channels.size(); ++c)
    if (part.channels[c].name == channel.name && samples.size() > 0) {
      const double value = samples(row, static_cast<Eigen::Index>(c));
      return std::isfinite(value) ? fmt::format("{:.9g}", value) : "";
    }
  return "";
}

}  // namespace

std::string model_prediction_json(const ModelPrediction& prediction) {
  PredictionJson json = {{"experiment", prediction.experiment},
                         {"revision", prediction.revision},
                         {"fitted", prediction.fitted_values > 0},
                         {"models", 1}};
  json["test"] = prediction.test.empty() ? PredictionJson(nullptr) : PredictionJson(prediction.test);
  json["setup"] = prediction.setup ? setup_json(*prediction.setup) : PredictionJson(nullptr);
  json["failed"] = prediction.failed;
  json["predictions"] = PredictionJson::array();
  for (const PredictedPart& part : prediction.parts) json["predictions"].push_back(part_json(part));
  return json.dump(2) + "\n";
}

std::string model_prediction_csv(const ModelPrediction& prediction) {
  const std::vector<Channel> channels = channels_of_parts(prediction);
  const bool measured =
      prediction.test.empty() || std::any_of(prediction.parts.begin(), prediction.parts.end(),
                                             [](const PredictedPart& part) { return part.measured.size() > 0; });
  std::string text = measured ? "trial,t [s]" : "test,t [s]";
  for (const Channel& channel : channels) {
    text += "," + csv_cell(fmt::format("{} predicted [{}]", channel.name, channel.unit));
    if (measured) text += "," + csv_cell(fmt::format("{} measured [{}]", channel.name, channel.unit));
  }
  text += '\n';
  for (const PredictedPart& part : prediction.parts)
    for (Eigen::Index row = 0; row < part.times.size(); ++row) {
      text += csv_cell(part.name) + fmt::format(",{:.9g}", part.times(row));
      for (const Channel& channel : channels) {
        text += "," + cell_of(part.predicted, part, channel, row);
        if (measured) text += "," + cell_of(part.measured, part, channel, row);
      }
      text += '\n';
    }
  return text;
}

}  // namespace lacuna
