#include "report/text/model_prediction.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"
#include "report/text/text_table.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

std::string model_title(const ModelPrediction& prediction) {
  const std::string values = prediction.fitted_values > 0
                                 ? "fitted model, " + counted(prediction.fitted_values, "free value")
                                 : std::string("model with its values as written");
  std::string line =
      fmt::format("{} · revision {} · {} · {}", prediction.experiment, prediction.revision, values,
                  prediction.test.empty() ? counted(prediction.parts.size(), "fit trial") : prediction.test);
  if (prediction.setup)
    line += " · " + setup_text(*prediction.setup) + (prediction.setup_is_asked ? "" : " (the first recording's)");
  return line + "\n";
}

}  // namespace

std::string model_prediction_text(const ModelPrediction& prediction) {
  bool any_measured = false;
  for (const PredictedPart& part : prediction.parts) any_measured = any_measured || part.measured.size() > 0;
  std::vector<std::vector<std::string>> table = {{any_measured ? "trial" : "test", "channel", "least", "greatest"}};
  if (any_measured) table.front().emplace_back("RMS error");
  for (const PredictedPart& part : prediction.parts)
    for (std::size_t c = 0; c < part.channels.size(); ++c) {
      const auto column = static_cast<Eigen::Index>(c);
      const std::string& unit = part.channels[c].unit;
      table.push_back({part.name, part.channels[c].name, format_quantity(part.predicted.col(column).minCoeff(), unit),
                       format_quantity(part.predicted.col(column).maxCoeff(), unit)});
      if (!any_measured) continue;
      const double error = c < part.rmse.size() ? part.rmse[c] : std::nan("");
      table.back().push_back(std::isfinite(error) ? format_quantity(error, unit) : "–");
    }
  std::string text = model_title(prediction) + text_table(table, 2);
  for (const std::string& failed : prediction.failed) text += failed + "\n";
  text += "A single model has no spread, so this prediction has no uncertainty band.\n";
  if (prediction.test.empty() && prediction.held_out > 0)
    text += fmt::format(
        "{} left out: only lacuna compare reads held-out trials, because it counts how often they are compared.\n",
        prediction.held_out == 1 ? "1 held-out trial is" : counted(prediction.held_out, "held-out trial") + " are");
  return text;
}

}  // namespace lacuna
