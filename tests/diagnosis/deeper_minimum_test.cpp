#include "diagnosis/deeper_minimum.h"

#include "config/experiment_reader.h"
#include "diagnosis/cut_trials.h"
#include "diagnosis/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// A pendulum with dry friction that its model lacks, and a round that has looked for it.
class DeeperMinimum : public testing::Test {
 protected:
  DeeperMinimum() {
    experiment_.engine.step = 0.01;
    experiment_.engine.substeps = 8;
    experiment_.noise = {};
    experiment_.model.effects = {};
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    model_ = plain(experiment_, built_catalog(), definition.start_values(), 8);
    const std::vector<Trial> trials = {recorded(kTruth, "multi.csv", multisine, 6.0, 3),
                                       recorded(kTruth, "steps.csv", steps, 6.0, 4)};
    const BaseSolution start = cut_trials({model_.definition, *model_.model, trials, model_.values, 0.0, 2});
    round_.emplace(run_round({built_catalog(), model_, start, Moving::all, {"coulomb_friction"}, 1, 2, meter_}));
  }

  static constexpr PendulumTruth kTruth = {.inertia = 0.03, .damping = 0.02, .friction = 0.02};
  Experiment experiment_ = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  Contender model_;
  const ProgressCallback nobody_;
  ProgressMeter meter_{nobody_};
  std::optional<Round> round_;
};

TEST_F(DeeperMinimum, IsNotWhatAnEffectExplains) {
  ASSERT_GT(round_->rivals.at(0).gain.value, 100.0);
  EXPECT_FALSE(deeper_minimum(model_, *round_, 2));
}

/// As where the model's own fit had ended beside its minimum, and an effect's had not.
TEST_F(DeeperMinimum, IsFoundFromWhereAnEffectEnded) {
  const Refit at_minimum = round_->fit;
  const double explained = at_minimum.deviance - round_->rivals.at(0).fit.deviance;
  round_->fit.deviance += 10.0 * explained;
  for (double& value : round_->fit.values) value *= 1.5;
  const std::optional<Refit> deeper = deeper_minimum(model_, *round_, 2);
  ASSERT_TRUE(deeper);
  EXPECT_NEAR(deeper->deviance, at_minimum.deviance, 0.01 * explained);
  for (std::size_t i = 0; i < at_minimum.values.size(); ++i)
    EXPECT_NEAR(deeper->values[i], at_minimum.values[i], 0.01 * at_minimum.values[i]);
}

}  // namespace
}  // namespace lacuna
