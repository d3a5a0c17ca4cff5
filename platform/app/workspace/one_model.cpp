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

FitResult fit_of(ExperimentWorkflow& workflow) {
  const OpenExperiment& opened = workflow.opened();
  const bool is_fitted = !opened.definition.free.empty() && opened.count(false) > 0;
  return is_fitted ? workflow.fit_model().result : as_written(opened.definition);
}

/// The trial that is meant; null: a new test is. Throws `BadInput` for one that is held out.
const Trial* named_trial(const OpenExperiment& opened, const AskedTest& asked) {
  for (const Trial& trial : opened.trials) {
    if (trial.name != asked.test) continue;
    if (trial.held_out)
      throw_problem(
          {},
          fmt::format("--test {}: this trial is held out; only lacuna compare may read it, because it counts how often "
                      "held-out trials are compared",
                      asked.test));
    if (asked.setup || !asked.duration.empty())
      throw_problem(
          {}, fmt::format("--test {}: a trial has a setup and a duration already; leave out --setup and --duration",
                          asked.test));
    return &trial;
  }
  return nullptr;
}

void add_trials(ExperimentWorkflow& workflow, const FitResult& fit, const std::vector<Trial>& trials,
                ModelPrediction& prediction) {
  const OpenExperiment& opened = workflow.opened();
  const Comparison compared = compare({.definition = opened.definition,
                                       .model = *opened.model,
                                       .trials = trials,
                                       .noise = opened.experiment.noise,
                                       .values = fit.parameters(),
                                       .work = workflow.work()});
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialComparison& one = compared.trials[i];
    if (one.valid) {
      prediction.parts.push_back({one.trial, one.times, trials[i].measured.channels, one.predicted, one.measured});
      for (const ChannelScore& score : one.channels) prediction.parts.back().rmse.push_back(score.rmse);
    } else
      prediction.failed.push_back(fmt::format("{} cannot be simulated: {}", one.trial, one.reason));
  }
}

void add_test(const ExperimentWorkflow& workflow, const FitResult& fit, const AskedTest& asked,
              ModelPrediction& prediction) {
  const OpenExperiment& opened = workflow.opened();
  const Experiment& experiment = opened.experiment;
  const KnownSetup setup = asked_setup(asked, experiment, opened.definition);
  const TestSpace space = test_space(opened.definition.structure.robot, experiment.engine, 0.0);
  Test test = read_test(asked, space, *opened.catalog);
  test.setup = setup.name();
  if (any_is_set(known_setups(opened.definition, experiment.target.recording))) prediction.setup = setup;
  prediction.setup_is_asked = asked.setup.has_value();
  check_step_count(experiment, test.duration, "of the test");
  const std::vector<double> times = sample_times(experiment.engine, test.duration);
  const TestPredictor predictor(*opened.model, times, {1, opened.stop}, &opened.definition);
  TestPrediction predicted;
  std::uint64_t steps = 0;
  std::string reason;
  if (predictor.predict({.values = fit.parameters()}, test, 0, predicted, steps, reason))
    prediction.parts.push_back(
        {asked.test, Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size())),
         opened.model->channels(), predicted.sensors.samples});
  else
    prediction.failed.push_back("the model cannot carry out the test: " + reason);
}

}  // namespace

ModelPrediction predict_by_one_model(ExperimentWorkflow& workflow, const AskedTest& asked) {
  const OpenExperiment& opened = workflow.opened();
  const Trial* trial = named_trial(opened, asked);
  if (asked.test.empty() && opened.count(false) == 0)
    throw_problem({opened.experiment.file.string()},
                  fmt::format("{} has no fit trial to simulate. Say which test: --test "
                              "\"multisine ACTUATOR ...\", written as for lacuna trial",
                              opened.experiment.name));
  const FitResult fit = fit_of(workflow);
  ModelPrediction prediction{.experiment = opened.experiment.name,
                             .revision = workflow.revision().number,
                             .fitted_values = opened.count(false) > 0 ? opened.definition.free.size() : 0,
                             .test = asked.test,
                             .setup = {},
                             .held_out = opened.count(true),
                             .parts = {},
                             .failed = {}};
  if (trial)
    add_trials(workflow, fit, {*trial}, prediction);
  else if (asked.test.empty())
    add_trials(workflow, fit, opened.fit_trials(), prediction);
  else
    add_test(workflow, fit, asked, prediction);
  if (prediction.parts.empty()) throw Error(fmt::format("{}", prediction.failed.front()));
  return prediction;
}

}  // namespace lacuna
