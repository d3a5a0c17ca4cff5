#include "report/json/comparison_json.h"

#include "documents/setup_json.h"
#include "foundation/text/csv_cell.h"
#include "report/json/where_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

ordered_json optional_number(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json document(const ChannelScore& score) {
  return {{"channel", score.channel},
          {"unit", score.unit},
          {"samples", score.samples},
          {"rmse", score.rmse},
          {"floor", score.floor},
          {"times_floor", score.times_floor},
          {"normalised_rmse", score.normalised_rmse},
          {"bias", score.bias},
          {"theil_u", score.parts.theil_u},
          {"bias_share", score.parts.bias_share},
          {"magnitude_share", score.parts.magnitude_share},
          {"form_share", score.parts.form_share},
          {"sprague_geers_magnitude", score.parts.sprague_geers_magnitude},
          {"sprague_geers_phase", score.parts.sprague_geers_phase},
          {"max_error", score.max_error},
          {"max_error_time_s", score.max_error_time},
          {"from_start", score.from_start},
          {"rmse_as_written", score.rmse_as_written},
          {"numerical", optional_number(score.numerical)}};
}

ordered_json document(const TrialComparison& trial) {
  ordered_json channels = ordered_json::array(), horizons = ordered_json::array();
  for (const ChannelScore& score : trial.channels) channels.push_back(document(score));
  for (const HorizonScore& score : trial.horizons)
    horizons.push_back({{"horizon_s", score.horizon}, {"automatic", score.automatic}, {"rmse", score.rmse}});
  return {{"trial", trial.trial},   {"held_out", trial.held_out}, {"valid", trial.valid},
          {"reason", trial.reason}, {"channels", channels},       {"horizons", horizons}};
}

ordered_json document(const PooledScore& score) {
  return {{"channel", score.channel},
          {"unit", score.unit},
          {"held_out", score.held_out},
          {"failed_trials", score.failed_trials},
          {"rmse", score.rmse},
          {"floor", score.floor},
          {"times_floor", score.times_floor},
          {"from_start", score.from_start},
          {"rmse_as_written", score.rmse_as_written},
          {"numerical", optional_number(score.numerical)},
          {"floor_origin", score.floor_origin}};
}

ordered_json document(const FittedValue& value) {
  return {{"address", value.address},
          {"unit", value.unit},
          {"start", value.start},
          {"value", value.value},
          {"standard_error", value.standard_error},
          {"ci95", {value.lower_95, value.upper_95}},
          {"at_bound", value.at_lower_bound || value.at_upper_bound},
          {"identified", value.identified}};
}

ordered_json document(const FitResult& fit) {
  ordered_json values = ordered_json::array(), stages = ordered_json::array();
  for (const FittedValue& value : fit.values) values.push_back(document(value));
  for (const FitStage& stage : fit.stages)
    stages.push_back({{"name", stage.name},
                      {"converged", stage.converged},
                      {"residual_over_noise", stage.residual},
                      {"values", stage.values}});
  return {{"values", values}, {"stages", stages}, {"cannot_tell", fit.cannot_tell}, {"notes", fit.notes}};
}

ordered_json document(const CrossCheck& check) {
  ordered_json channels = ordered_json::array();
  for (const EngineDistance& one : check.channels)
    channels.push_back({{"channel", one.channel}, {"unit", one.unit}, {"apart", one.apart}, {"error", one.error}});
  return {{"engine", check.engine}, {"substeps", check.substeps}, {"channels", channels}, {"left_out", check.left_out}};
}

}  // namespace

std::string comparison_json(const ComparisonHeading& heading, const Comparison& comparison, const FitResult& fit,
                            const WhereItFails& where, const std::string& advice) {
  ordered_json trials = ordered_json::array(), pooled = ordered_json::array();
  for (const TrialComparison& trial : comparison.trials) trials.push_back(document(trial));
  for (const PooledScore& score : comparison.pooled) pooled.push_back(document(score));
  ordered_json whole = {{"experiment", heading.experiment},
                        {"held_out_look", heading.look},
                        {"refitted", heading.refitted},
                        {"fit", document(fit)},
                        {"pooled", pooled},
                        {"trials", trials},
                        {"setups", setups_json(heading.setups)},
                        {"findings", findings_json(where)},
                        {"where", where_json(where)},
                        {"notes", comparison.notes}};
  if (!advice.empty()) whole["advice"] = advice.substr(0, advice.find_last_not_of('\n') + 1);
  if (comparison.cross_check) whole["cross_check"] = document(*comparison.cross_check);
  return whole.dump(2) + "\n";
}

std::string fit_json(const std::string& experiment, const FitResult& fit) {
  ordered_json whole = document(fit);
  whole["experiment"] = experiment;
  return whole.dump(2) + "\n";
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text =
      "trial,held_out,channel,unit,samples,rmse,floor,times_floor,bias,max_error,max_error_time_s,normalised_rmse,"
      "theil_u,bias_share,magnitude_share,form_share,sprague_geers_magnitude,sprague_geers_phase\n";
  for (const TrialComparison& trial : comparison.trials)
    for (const ChannelScore& s : trial.channels)
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(trial.trial),
                          trial.held_out ? 1 : 0, csv_cell(s.channel), csv_cell(s.unit), s.samples, s.rmse, s.floor,
                          s.times_floor, s.bias, s.max_error, s.max_error_time, s.normalised_rmse, s.parts.theil_u,
                          s.parts.bias_share, s.parts.magnitude_share, s.parts.form_share,
                          s.parts.sprague_geers_magnitude, s.parts.sprague_geers_phase);
  return text;
}

}  // namespace lacuna
