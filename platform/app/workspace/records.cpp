#include "app/workspace/records.h"

#include "documents/diagnosis_json.h"
#include "evaluation/model/possible_values.h"
#include "foundation/effect_at_place.h"
#include "storage/core/canonical_text.h"

#include <optional>
#include <utility>

namespace lacuna {

RevisionRecord revision_record(const OpenExperiment& opened) {
  RevisionRecord record;
  record.robot = opened.definition.structure.robot.name;
  record.robot_text = canonical_text(opened.definition.structure.robot);
  for (const FreeValue& value : opened.definition.free)
    record.free.push_back({value.address, value.unit, value.lower, value.upper, value.start});
  record.effects = opened.definition.effects;
  record.engine = opened.definition.engine;
  record.fit_data_digest = digest_of_trials(opened.trials);
  return record;
}

TrialRecord trial_record(const Trial& trial, const ModelDefinition& definition) {
  std::vector<std::string> units;
  for (const Setup::Value& value : trial.setup.values) units.push_back(unit_of_value(definition, value.address));
  const Eigen::VectorXd& times = trial.measured.times;
  return {.name = trial.name,
          .file = trial.name,
          .digest = digest_of(trial),
          .held_out = trial.held_out,
          .duration = times.size() > 0 ? times[times.size() - 1] - times[0] : 0.0,
          .samples = times.size(),
          .setup = trial.setup,
          .setting_units = std::move(units)};
}

namespace {

AtBound bound_of(const FittedValue& value) {
  if (value.at_lower_bound) return AtBound::lower;
  return value.at_upper_bound ? AtBound::upper : AtBound::neither;
}

FitStageRecord stage_record(const FitStage& stage) {
  return {stage.name,       stage.segment,   stage.segments, stage.starts, stage.agreeing,
          stage.iterations, stage.converged, stage.residual, stage.values};
}

FitStage fit_stage(const FitStageRecord& record) {
  return {.name = record.name,
          .segment = record.segment,
          .segments = static_cast<int>(record.segments),
          .starts = static_cast<int>(record.starts),
          .agreeing = static_cast<int>(record.agreeing),
          .iterations = static_cast<int>(record.iterations),
          .converged = record.converged,
          .residual = record.residual,
          .values = record.values};
}

ScoreRecord free_run_record(TrialId trial, const ChannelScore& score) {
  return {.trial = trial,
          .channel = score.channel,
          .unit = score.unit,
          .samples = static_cast<std::int64_t>(score.samples),
          .rmse = score.rmse,
          .normalised_rmse = score.normalised_rmse,
          .bias = score.bias,
          .max_error = score.max_error,
          .max_error_time = score.max_error_time,
          .floor = score.floor,
          .numerical_error = score.numerical.value_or(kNotKnown),
          .as_written_rmse = score.rmse_as_written};
}

void add_scores(TrialId id, const TrialComparison& trial, ComparisonRecord& record) {
  for (std::size_t channel = 0; channel < trial.channels.size(); ++channel) {
    const ChannelScore& score = trial.channels[channel];
    record.scores.push_back(free_run_record(id, score));
    for (const HorizonScore& horizon : trial.horizons) {
      if (horizon.automatic) continue;  // its length differs from trial to trial
      record.scores.push_back({.trial = id,
                               .channel = score.channel,
                               .unit = score.unit,
                               .horizon = horizon.horizon,
                               .rmse = horizon.rmse.at(channel)});
    }
  }
}

}  // namespace

FitRecord fit_record(const FitResult& fit, const FitSection& options, const std::string& settings) {
  FitRecord record;
  record.settings = settings;
  record.method = options.method;
  record.loss = options.loss;
  record.loss_scale = options.loss_scale;
  record.samples = static_cast<std::int64_t>(fit.samples);
  record.simulations = static_cast<std::int64_t>(fit.simulations);
  record.invalid_simulations = static_cast<std::int64_t>(fit.invalid_simulations);
  record.starts = fit.starts;
  record.agreeing = fit.agreeing;
  record.correlation_time = fit.correlation_time;
  for (const FitStage& stage : fit.stages) record.stages.push_back(stage_record(stage));
  if (!fit.stages.empty()) {
    record.converged = fit.stages.back().converged;
    record.residual = fit.stages.back().residual;
  }
  for (const FittedValue& value : fit.values)
    record.values.push_back({value.address, value.unit, value.start, value.value, value.standard_error, value.lower_95,
                             value.upper_95, bound_of(value), value.identified});
  record.covariance = fit.covariance;
  record.cannot_tell = fit.cannot_tell;
  record.notes = fit.notes;
  record.seconds = fit.seconds;
  return record;
}

FitResult fit_result(const FitRecord& record) {
  FitResult fit;
  for (const FittedValueRecord& stored : record.values)
    fit.values.push_back({.address = stored.address,
                          .unit = stored.unit,
                          .start = stored.start,
                          .value = stored.value,
                          .standard_error = stored.standard_error,
                          .lower_95 = stored.lower,
                          .upper_95 = stored.upper,
                          .at_lower_bound = stored.at_bound == AtBound::lower,
                          .at_upper_bound = stored.at_bound == AtBound::upper,
                          .identified = stored.identifiable});
  for (const FitStageRecord& stage : record.stages) fit.stages.push_back(fit_stage(stage));
  fit.covariance = record.covariance;
  fit.cannot_tell = record.cannot_tell;
  fit.notes = record.notes;
  fit.starts = static_cast<int>(record.starts);
  fit.agreeing = static_cast<int>(record.agreeing);
  fit.samples = static_cast<std::size_t>(record.samples);
  fit.simulations = static_cast<std::uint64_t>(record.simulations);
  fit.invalid_simulations = static_cast<std::uint64_t>(record.invalid_simulations);
  fit.correlation_time = record.correlation_time;
  fit.seconds = record.seconds;
  return fit;
}

ComparisonRecord comparison_record(const Comparison& comparison, const std::vector<TrialId>& trials) {
  ComparisonRecord record;
  record.seconds = comparison.seconds;
  record.findings = comparison.notes;
  for (std::size_t t = 0; t < comparison.trials.size(); ++t) add_scores(trials.at(t), comparison.trials[t], record);
  for (std::size_t t = 0; t < comparison.floors.size(); ++t)
    for (const FloorValue& floor : comparison.floors[t].channels)
      record.floors.push_back({trials.at(t), floor.channel, floor.unit, floor.total, floor.sensor, floor.input,
                               floor.process, floor.origin});
  return record;
}

DiagnosisRecord diagnosis_record(const Diagnosis& diagnosis, const std::string& settings) {
  const std::optional<DiagnosisMethod>& method = diagnosis.method;
  DiagnosisRecord record{.settings = settings,
                         .verdict = std::string(to_string(diagnosis.verdict)),
                         .method = method ? std::optional(std::string(to_string(*method))) : std::nullopt,
                         .probability = diagnosis.probability,
                         .calibrated = diagnosis.calibrated,
                         .chance = diagnosis.p_by_chance.value_or(kNotKnown),
                         .hypotheses = static_cast<std::int64_t>(diagnosis.hypotheses),
                         .base_times_floor = kNotKnown,
                         .base_fitted_times_floor = method ? diagnosis.base_times_floor : kNotKnown,
                         .document = diagnosis_json(diagnosis),
                         .candidates = {}};
  for (const RankedModel& model : diagnosis.ranking) {
    CandidateRecord candidate{.effects = {},
                              .look_alikes = model.look_alikes,
                              .gain = model.gain.value,
                              .gain_lower = model.gain.lower_95,
                              .gain_upper = model.gain.upper_95,
                              .times_floor = kNotKnown,
                              .fitted_times_floor = model.times_floor,
                              .probability = kNotKnown,
                              .values = {}};
    for (const FoundEffect& effect : model.effects) {
      candidate.effects.push_back(to_string(EffectAtPlace{effect.effect, effect.where}));
      for (const FoundParameter& one : effect.parameters)
        candidate.values.push_back(
            {effect.effect, effect.where, one.name, one.unit, one.value, one.lower_95, one.upper_95});
    }
    record.candidates.push_back(std::move(candidate));
  }
  return record;
}

TimeSeries predicted_series(const Trial& trial, const TrialComparison& comparison) {
  return {trial.measured.channels, trial.measured.times, comparison.predicted};
}

}  // namespace lacuna
