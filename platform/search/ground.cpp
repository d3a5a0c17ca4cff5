#include "search/ground.h"

#include "config/decided.h"
#include "diagnosis/refit/timing.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFineEnough = 0.05;  ///< nats that half the integration step may change the cost by
constexpr int kMostSubsteps = 64;
constexpr double kBlocks = 16.0;  ///< of all data, at least

std::vector<FreeValue> values_of(const ModelDefinition& definition, bool timing, const TimingRange& timing_range) {
  return timing ? with_timing(definition.free, timing_range) : definition.free;
}

/// Steps that the program has chosen for free runs over whole recordings are finer than predictions need.
Experiment with_coarse_steps(Experiment experiment) {
  if (substeps_decided(experiment)) experiment.engine.substeps = 1;
  return experiment;
}

}  // namespace

ModelBench::ModelBench(const ModelDefinition& definition, const CompiledModel& model, const std::vector<Trial>& trials,
                       bool timing, int threads, const TimingRange& timing_range)
    : definition_(definition),
      predictor_(model, trials, threads, timing ? Timing::fitted : Timing::as_recorded),
      space_(values_of(definition, timing, timing_range)) {}

Ground::Ground(const MissingTask& task)
    : task_(task),
      timing_(longest_command_interval(task.trials) > 0.0),
      plain_(lacuna::plain(with_coarse_steps(task.experiment), task.catalog, task.values)) {
  if (timing_) plain_.values.push_back(0.0);
  noise_ = sensor_noise(plain_.definition.structure.robot, task_.trials);
  reader_ = plain_;
  readings_ = std::make_unique<ModelBench>(reader_.definition, *reader_.model, task_.trials, timing_, 1);
  states_ = std::make_unique<StartStates>(reader_.definition.structure.robot, readings_->predictor(), noise_);
  starts_ = std::make_unique<SmoothedStarts>(*states_, readings_->predictor().trials());
  bench_ = std::make_unique<ModelBench>(plain_.definition, *plain_.model, task_.trials, timing_, task_.threads);
  ladder_ = build_ladder(task_of(*bench_, plain_.values, false));
  choose_substeps();
  plain_.values = fit_to_ladder(quick(ladder_), bench_->predictor(), bench_->space(), plain_.values).values;
  ladder_ = build_ladder(task_of(*bench_, plain_.values, false));
  choose_substeps();
  fit_ = fit_to_ladder(ladder_, bench_->predictor(), bench_->space(), plain_.values, Climb::whole);
  if (!fit_.errors.valid)
    throw NothingPredictable(
        "no prediction can be judged: either the model cannot be simulated from the starts that the readings tell, or "
        "what moves is no larger than what the starts leave unknown; record faster, with more motion or less noise");
  weigh_by_information(ladder_, bench_->predictor().trials(), fit_.residuals);
  fit_ = fit_to_ladder(ladder_, bench_->predictor(), bench_->space(), fit_.values, Climb::whole);
  plain_.values = fit_.values;
  double longest = 0.0, whole = 0.0;
  for (const Segment& segment : ladder_.rungs.back().segments)
    longest = std::max(longest, duration_of(segment, bench_->predictor().trials()));
  for (const Segment& segment : ladder_.rungs.front().segments)
    whole += duration_of(segment, bench_->predictor().trials());
  block_ = std::max(ladder_.rungs.front().length, std::min(longest, whole / kBlocks));
}

LadderTask Ground::task_of(const ModelBench& bench, const std::vector<double>& values, bool held_out) const {
  return {plain_.definition.structure.robot, bench.predictor(), *states_, *starts_, noise_, values, held_out};
}

Ladder Ground::ladder_for(const ModelBench& bench, bool held_out) const {
  return same_ladder(ladder_, task_of(bench, plain_.values, held_out));
}

/// Doubles the integration steps until that no longer changes what the model as it is costs.
void Ground::choose_substeps() {
  const int first = std::max(1, plain_.definition.engine.substeps);
  const std::vector<double> first_values = plain_.values;
  const Ladder few = quick(ladder_);
  for (int substeps = first;; substeps *= 2) {
    ModelDefinition finer = plain_.definition;
    finer.engine.substeps = 2 * substeps;
    const std::unique_ptr<CompiledModel> model = compile(finer.structure, finer.engine);
    const ModelBench other(finer, *model, task_.trials, timing_, task_.threads);
    const HorizonErrors now = errors_on(few, bench_->predictor(), bench_->space(), plain_.values);
    const HorizonErrors then = errors_on(few, other.predictor(), other.space(), plain_.values);
    const bool is_fine = now.valid && then.valid && std::abs(now.cost - then.cost) < kFineEnough;
    if (is_fine || substeps >= kMostSubsteps * first) return;
    plain_.experiment.engine.substeps = 2 * substeps;
    plain_.definition = define_model(plain_.experiment, task_.catalog);
    plain_.model = compile(plain_.definition.structure, plain_.definition.engine);
    bench_ = std::make_unique<ModelBench>(plain_.definition, *plain_.model, task_.trials, timing_, task_.threads);
    plain_.values = fit_to_ladder(few, bench_->predictor(), bench_->space(), first_values).values;
  }
}

}  // namespace lacuna
