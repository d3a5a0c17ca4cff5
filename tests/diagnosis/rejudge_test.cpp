#include "diagnosis/rejudge.h"

#include "config/experiment_reader.h"
#include "diagnosis/cut_trials.h"
#include "diagnosis/ranking.h"
#include "diagnosis/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kFriction = 0.02;  ///< N·m, hidden

/// A pendulum with dry friction, for which drag was taken first.
class RejudgedFriction : public testing::Test {
 protected:
  RejudgedFriction() {
    experiment_.engine.step = 0.01;
    experiment_.engine.substeps = 8;
    experiment_.noise = {};
    experiment_.model.effects = {};
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    model_ = plain(experiment_, built_catalog(), definition.start_values(), 8);
  }

  Round round_of(const Contender& contender) {
    const PendulumTruth truth = {.inertia = 0.03, .damping = 0.02, .friction = kFriction};
    const std::vector<Trial> trials = {recorded(truth, "multi.csv", multisine, 6.0, 3),
                                       recorded(truth, "steps.csv", steps, 6.0, 4)};
    const BaseSolution start = cut_trials({contender.definition, *contender.model, trials, contender.values, 0.0, 2});
    return run_round({built_catalog(), contender, start, Moving::all, among_, 1, 2, meter_});
  }

  const std::vector<std::string> among_ = {"coulomb_friction", "quadratic_drag"};
  Experiment experiment_ = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  Contender model_;
  const ProgressCallback nobody_;
  ProgressMeter meter_{nobody_};
};

TEST_F(RejudgedFriction, IsBetterAfterAllAndGoesOnFromWhereItWasRefitted) {
  const Round first = round_of(model_);
  ASSERT_EQ(first.rivals.size(), 2U);
  const auto of = [&](const std::string& effect) {
    const auto found = std::find_if(first.rivals.begin(), first.rivals.end(), [&](const Rival& rival) {
      return first.hypotheses[rival.hypothesis].entry.effect == effect;
    });
    return static_cast<std::size_t>(found - first.rivals.begin());
  };
  const std::size_t friction = of("coulomb_friction"), drag = of("quadratic_drag");
  SearchStep step = step_of(model_, first, drag);
  const Contender wrong = with_effect_of(step.rivals[drag], step, model_, built_catalog());
  const Round now = round_of(wrong);
  step.rivals[friction].values.back() = 0.5 * kFriction;

  const Rejudged again = rejudge({step, model_, built_catalog(), now, 1, 2});
  ASSERT_EQ(again.better, friction);
  ASSERT_EQ(again.values.size(), step.rivals[friction].values.size());
  EXPECT_NEAR(again.values.back(), kFriction, 0.05 * kFriction);
}

}  // namespace
}  // namespace lacuna
