#include "search/search_data.h"

#include "config/decided.h"
#include "prediction/reading_noise.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFineEnough = 0.02;  ///< nats by which halving the integration step may change the cost
constexpr int kMostSubsteps = 64;
constexpr double kMostSamples = 1500.0;  ///< per length and channel; further samples add little
constexpr double kMostStretches = 80.0;  ///< per length: two in each block of time
constexpr std::size_t kFewStretches = 40;
constexpr std::size_t kMostSteps = 300;
constexpr double kReadingsOfAValue = 8.0;  ///< with fewer per value a gain cannot be told from chance

Experiment coarse(Experiment experiment) {
  if (substeps_decided(experiment)) experiment.engine.substeps = 1;
  return experiment;
}

/// Every length covers the same share of the recordings.
std::size_t most_stretches(const std::vector<Trial>& trials, const std::vector<double>& lengths, double most_samples) {
  double samples = 0.0, seconds = 0.0;
  for (const Trial& trial : trials) {
    if (trial.held_out) continue;
    samples += static_cast<double>(trial.measured.times.size());
    seconds += trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0);
  }
  const double share = std::min(1.0, most_samples / samples);
  return static_cast<std::size_t>(std::clamp(std::ceil(share * seconds / lengths.front()), 1.0, kMostStretches));
}

std::vector<FreeValue> values_of(const ModelDefinition& definition, bool timing, const TimingRange& timing_range) {
  return timing ? with_timing(definition.free, timing_range) : definition.free;
}

}  // namespace

ModelContext::ModelContext(const ModelDefinition& definition, const CompiledModel& model,
                           const std::vector<Trial>& trials, bool timing, const Work& work,
                           const TimingRange& timing_range)
    : predictor_(model, trials, work, timing ? Timing::fitted : Timing::as_recorded),
      space_(values_of(definition, timing, timing_range)) {}

bool changes_readings(const ModelDefinition& definition) {
  const auto on_sensor = [](const EffectEntry& entry) {
    return !entry.where.empty() && entry.where.front().starts_with("sensor.");
  };
  const auto of_sensor = [](const FreeValue& free) { return free.address.starts_with("sensor."); };
  return std::any_of(definition.effects.begin(), definition.effects.end(), on_sensor) ||
         std::any_of(definition.free.begin(), definition.free.end(), of_sensor);
}

SearchData::SearchData(const EffectSearchTask& task)
    : task_(task),
      scales_(data_scales(task.trials)),
      timing_(longest_command_interval(task.trials) > 0.0),
      plain_(lacuna::plain(coarse(task.experiment), task.catalog, task.values)) {
  if (timing_) plain_.values.push_back(0.0);
  reader_ = plain_;
  noise_ = sensor_noise(plain_.definition.structure.robot, task_.trials);
  readings_ = std::make_unique<ModelContext>(reader_.definition, *reader_.model, task_.trials, timing_,
                                             Work{1, task.work.stop});
  states_ = std::make_unique<StartStates>(reader_.definition.structure.robot, readings_->predictor(), noise_);
  starts_ = std::make_unique<SmoothedStarts>(*states_, readings_->predictor().trials());
  noise_ = noise_of_readings(*starts_, readings_->predictor().trials(), noise_);
  build_ladders();
  choose_substeps();
  acceleration_steps_ = lacuna::acceleration_steps(source(bench_for(plain_)), plain_.definition.engine, kMostSteps);
}

double SearchData::readings() const {
  double readings = 0.0;
  for (const Trial& trial : task_.trials)
    if (!trial.held_out) readings += static_cast<double>(trial.measured.samples.array().isFinite().count());
  return readings;
}

bool SearchData::tells(double values) const { return kReadingsOfAValue * values <= readings(); }

void SearchData::bound(std::vector<Hypothesis>& hypotheses) const {
  for (Hypothesis& one : hypotheses) {
    bound_by_resolution(one.placed, scales_, one.definition.free);
    for (std::size_t i = 0; i < one.own.size(); ++i) {
      const FreeValue& free = one.definition.free[one.own[i]];
      one.neutral[i] = std::clamp(one.neutral[i], free.lower, free.upper);
      one.defaults[i] = std::clamp(one.defaults[i], free.lower, free.upper);
    }
  }
}

LadderSource SearchData::source(const ModelContext& context) const {
  return {plain_.definition.structure.robot, context.predictor(), *states_, *starts_, noise_};
}

PredictionLadder SearchData::held_out() const {
  const ModelContext context = bench_for(plain_);
  LadderSource held_out = source(context);
  held_out.held_out = true;
  return ladder_of(held_out, ladder_.lengths, static_cast<std::size_t>(kMostStretches));
}

void SearchData::build_ladders() {
  const ModelContext context = bench_for(plain_);
  const LadderSource fitted = source(context);
  const std::vector<double> lengths = prediction_lengths(fitted, context.space(), plain_.values);
  ladder_ = ladder_of(fitted, lengths, most_stretches(task_.trials, lengths, kMostSamples / root_of_channels(noise_)));
  deciding_ = shorter(ladder_, kDecidingLengths);
  if (ladder_.stretches.empty())
    throw NothingPredictable("no prediction can be evaluated: the recordings are too short; record longer ones");
}

/// Doubles the number of integration steps until the cost of the model as it is stays the same. With ground contact the
/// error follows no order of the step, so the step is kept.
void SearchData::choose_substeps() {
  const ModelContext first = bench_for(plain_);
  const PredictionLadder few = ladder_of(source(first), deciding_.lengths, kFewStretches);
  const auto residuals_of = [&](const AugmentedModel& model, std::vector<Eigen::VectorXd>& residuals) {
    const ModelContext context = bench_for(model);
    LadderPredictions predictions(few, context.predictor(), context.space(), *starts_,
                                  changes_readings(model.definition));
    return predictions.residuals(predictions.at_smoothed_starts(context.space().to_coordinates(model.values)),
                                 residuals);
  };
  const int start = std::max(1, plain_.definition.engine.substeps);
  std::vector<Eigen::VectorXd> now, then;
  bool is_valid = residuals_of(plain_, now);
  const int most = plain_.definition.structure.robot.contact.ground ? start : kMostSubsteps * start;
  for (int substeps = 2 * start; substeps <= most; substeps *= 2) {
    AugmentedModel finer = plain_;
    finer.experiment.engine.substeps = substeps;
    finer.definition = define_model(finer.experiment, task_.catalog);
    finer.model = compile(finer.definition.structure, finer.definition.engine);
    const bool is_next_valid = residuals_of(finer, then);
    double change = 0.0, size = 0.0;
    if (is_valid && is_next_valid)
      for (std::size_t k = 0; k < now.size(); ++k) {
        change += (now[k] - then[k]).squaredNorm();
        size += std::max(now[k].squaredNorm(), static_cast<double>(now[k].size()));
      }
    if (is_valid && is_next_valid && change < kFineEnough * size) return;
    plain_ = finer;
    now = then;
    is_valid = is_next_valid;
  }
  if (!is_valid)
    throw NothingPredictable(
        "the model cannot be simulated from the initial states of the recordings; check its parameter values");
}

}  // namespace lacuna
