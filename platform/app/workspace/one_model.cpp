#include "app/workspace/one_model.h"

#include "evaluation/prediction/step_count.h"
#include "evaluation/prediction/target_simulator.h"
#include "evaluation/prediction/test_predictor.h"
#include "evaluation/prediction/test_space.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

FitResult fit_of(Workbench& bench) {
  const Rig& rig = bench.rig();
  const bool is_fitted = !rig.definition.free.empty() && rig.count(false) > 0;
  return is_fitted ? bench.fit_model().result : as_written(rig.definition);
}

/// The trial that is meant; null: a new test is. Throws `BadInput` for one that is held out.
const Trial* named_trial(const Rig& rig, const AskedTest& asked) {
  for (const Trial& trial : rig.trials) {
    if (trial.name != asked.test) continue;
    if (trial.held_out)
      throw_problem(
          {},
          fmt::format("--test {}: this trial is held out; only lacuna compare may read it, because it counts the looks",
                      asked.test));
    if (asked.setup || !asked.duration.empty())
      throw_problem(
          {}, fmt::format("--test {}: a trial has a setup and a duration already; leave out --setup and --duration",
                          asked.test));
    return &trial;
  }
  return nullptr;
}

void add_trials(Workbench& bench, const FitResult& fit, const std::vector<Trial>& trials, ModelPrediction& prediction) {
  const Rig& rig = bench.rig();
  const Comparison compared = compare({.definition = rig.definition,
                                       .model = *rig.model,
                                       .trials = trials,
                                       .noise = rig.experiment.noise,
                                       .values = fit.parameters(),
                                       .threads = bench.threads()});
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialComparison& one = compared.trials[i];
    if (one.valid) {
      prediction.parts.push_back({one.trial, one.times, trials[i].measured.channels, one.predicted, one.measured});
      for (const ChannelScore& score : one.channels) prediction.parts.back().rmse.push_back(score.rmse);
    } else
      prediction.failed.push_back(fmt::format("{} cannot be simulated: {}", one.trial, one.reason));
  }
}

void add_test(const Workbench& bench, const FitResult& fit, const AskedTest& asked, ModelPrediction& prediction) {
  const Rig& rig = bench.rig();
  const Experiment& experiment = rig.experiment;
  const KnownSetup setup = asked_setup(asked, experiment, rig.definition);
  const TestSpace space = test_space(rig.definition.structure.robot, experiment.engine, 0.0);
  Test test = read_test(asked, space, *rig.catalog);
  test.setup = setup.name();
  if (any_is_set(known_setups(rig.definition, experiment.target.recording))) prediction.setup = setup;
  prediction.setup_is_asked = asked.setup.has_value();
  check_step_count(experiment, test.duration, "of the test");
  const std::vector<double> times = sample_times(experiment.engine, test.duration);
  const TestPredictor predictor(*rig.model, times, 1, &rig.definition);
  TestPrediction predicted;
  std::uint64_t steps = 0;
  std::string reason;
  if (predictor.predict({.values = fit.parameters()}, test, 0, predicted, steps, reason))
    prediction.parts.push_back(
        {asked.test, Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size())),
         rig.model->channels(), predicted.sensors.samples});
  else
    prediction.failed.push_back("the model cannot carry out the test: " + reason);
}

}  // namespace

ModelPrediction predict_by_one_model(Workbench& bench, const AskedTest& asked) {
  const Rig& rig = bench.rig();
  const Trial* trial = named_trial(rig, asked);
  if (asked.test.empty() && rig.count(false) == 0)
    throw_problem({rig.experiment.file.string()}, fmt::format("{} has no fit trial to simulate. Say which test: --test "
                                                              "\"multisine ACTUATOR ...\", written as for lacuna trial",
                                                              rig.experiment.name));
  const FitResult fit = fit_of(bench);
  ModelPrediction prediction{.experiment = rig.experiment.name,
                             .revision = bench.revision().number,
                             .fitted_values = rig.count(false) > 0 ? rig.definition.free.size() : 0,
                             .test = asked.test,
                             .setup = {},
                             .held_out = rig.count(true),
                             .parts = {},
                             .failed = {}};
  if (trial)
    add_trials(bench, fit, {*trial}, prediction);
  else if (asked.test.empty())
    add_trials(bench, fit, rig.fit_trials(), prediction);
  else
    add_test(bench, fit, asked, prediction);
  if (prediction.parts.empty()) throw Error(fmt::format("{}", prediction.failed.front()));
  return prediction;
}

}  // namespace lacuna
