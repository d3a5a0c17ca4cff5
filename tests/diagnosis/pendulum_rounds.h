#pragma once

#include "config/experiment_reader.h"
#include "diagnosis/recorded_pendulum.h"
#include "diagnosis/rounds/cut_trials.h"
#include "diagnosis/rounds/round.h"
#include "plugins/built_catalog.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lacuna {

/// Rounds of a pendulum that its model is fitted to, with two recordings of 6 s.
class PendulumRounds : public testing::Test {
 protected:
  PendulumRounds() {
    experiment_.engine.step = 0.01;
    experiment_.engine.substeps = 8;
    experiment_.noise = {};
    experiment_.model.effects = {};
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    model_ = plain(experiment_, built_catalog(), definition.start_values());
  }

  Round round_of(const Contender& contender, const PendulumTruth& truth, const std::vector<std::string>& among) {
    const std::vector<Trial> trials = {recorded(truth, "multi.csv", multisine, 6.0, 3),
                                       recorded(truth, "steps.csv", steps, 6.0, 4)};
    const BaseSolution start = cut_trials({contender.definition, *contender.model, trials, contender.values, 0.0, 2});
    return run_round({built_catalog(), contender, start, Moving::all, among, 1, 2, meter_});
  }

  Experiment experiment_ = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  Contender model_;
  const ProgressCallback nobody_;
  ProgressMeter meter_{nobody_};
};

}  // namespace lacuna
