#include "diagnosis/rounds/base_bench.h"

#include "diagnosis/recorded_pendulum.h"
#include "diagnosis/rounds/cut_trials.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kMass = 0.5;  // kg, the true one

/// The recorded pendulum with a free mass, cut, and its problem.
class Settling : public testing::Test {
 protected:
  Settling() {
    rig_.definition.structure.parameters = {{"body.arm.mass", 0.1, 2.0}};
    rig_.definition.free = {{.address = "body.arm.mass", .unit = "kg", .lower = 0.1, .upper = 2.0, .start = kMass}};
    rig_.model = compile(rig_.definition.structure, rig_.definition.engine);
  }

  /// The mass on which the model settles.
  double settled(double mass, Moving moving) {
    rig_.values = {mass};
    BaseSolution base = cut_trials({.definition = rig_.definition,
                                    .model = *rig_.model,
                                    .trials = rig_.trials,
                                    .values = rig_.values,
                                    .segment = 1.0});
    base.values = rig_.values;
    const TrialPredictor predictor(*rig_.model, base.trials, 1);
    const ParameterSpace space(rig_.definition.free);
    ShootingProblem problem(predictor, space, base.segments, base.noise);
    EXPECT_TRUE(settle(problem, space, base, moving));
    return base.values.front();
  }

  RecordedPendulum rig_;
};

TEST_F(Settling, HoldsAFittedValueWhereOthersAreLittleBetter) {
  const double near = kMass * 1.001;
  EXPECT_EQ(settled(near, Moving::if_needed), near);
  EXPECT_NE(settled(near, Moving::all), near);
}

TEST_F(Settling, MovesAValueThatIsFarOff) { EXPECT_NEAR(settled(kMass * 1.3, Moving::if_needed), kMass, 0.02 * kMass); }

}  // namespace
}  // namespace lacuna
