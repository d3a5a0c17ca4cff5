#include "horizons/horizon_fit.h"

#include "fitting/seeded_noise.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace lacuna::horizon_fit_test {
namespace {

constexpr double kInertia = 0.02, kDamping = 0.05, kNoise = 1e-3;

/// A driven pendulum whose inertia and damping are not known.
ModelDefinition pendulum_definition() {
  ModelDefinition definition;
  definition.structure.robot = pendulum(1.0, 0.3, 1e-3);
  definition.structure.robot.sensors = {make_sensor("position", SensorKind::joint_position, "joint")};
  definition.engine = {.engine = "articulated", .step = 0.01, .substeps = 2};
  definition.free = {{"joint.joint.armature", "kg*m^2", 0.0, 0.2, 0.0},
                     {"joint.joint.damping", "N*m*s/rad", 0.0, 1.0, 0.0}};
  definition.structure.parameters = {{"joint.joint.armature", 0.0, 0.2}, {"joint.joint.damping", 0.0, 1.0}};
  return definition;
}

Trial recorded(const ModelDefinition& definition, double phase, bool held_out) {
  std::vector<double> times, torques;
  for (int i = 0; i <= 1200; ++i) {
    times.push_back(0.01 * i);
    torques.push_back(std::sin(2.1 * times.back() + phase) + 0.7 * std::sin(5.3 * times.back()));
  }
  SimulationRun run(definition.structure.robot);
  run.structure = definition.structure;
  run.engine = definition.engine;
  run.parameters = {kInertia, kDamping};
  run.command("motor", times, torques, Hold::zero_order);
  Trial trial;
  trial.name = held_out ? "held out" : "fit";
  trial.commands = std::get<CommandSeries>(run.test.drive);
  trial.measured = run.run(times).readings;
  trial.held_out = held_out;
  SeededNoise random(held_out ? 2 : 1, 0);
  for (double& reading : trial.measured.samples.reshaped()) reading += kNoise * random.normal();
  return trial;
}

class HorizonFits : public testing::Test {
 protected:
  HorizonFits()
      : definition(pendulum_definition()),
        model(compile(definition.structure, definition.engine)),
        predictor(*model, {recorded(definition, 0.3, false), recorded(definition, 1.1, true)}, 2),
        noise(sensor_noise(definition.structure.robot, predictor.trials())),
        states(definition.structure.robot, predictor, noise),
        starts(states, predictor.trials()),
        space(definition.free) {}

  LadderTask task(const std::vector<double>& values, bool held_out = false) const {
    return {definition.structure.robot, predictor, states, starts, noise, values, held_out};
  }

  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  TrialPredictor predictor;
  std::vector<ChannelNoise> noise;
  StartStates states;
  SmoothedStarts starts;
  ParameterSpace space;
};

TEST_F(HorizonFits, TheLadderReachesFromTenSamplesToWholeTrials) {
  const std::vector<double> truth = {kInertia, kDamping};
  const Ladder ladder = build_ladder(task(truth));
  ASSERT_EQ(ladder.rungs.size(), 5u);
  EXPECT_NEAR(ladder.rungs.front().length, 0.1, 1e-9);
  EXPECT_NEAR(ladder.rungs.back().length, 12.0, 1e-9);
  EXPECT_EQ(ladder.rungs.front().segments.size(), 60u);
  for (const Rung& rung : ladder.rungs) {
    EXPECT_GT(rung.floor[0], 0.5 * kNoise * kNoise);
    EXPECT_TRUE(rung.counts[0]);
  }
}

/// At every horizon a fitted model that is right is off by the floor, on data that the fit has not seen.
TEST_F(HorizonFits, FindsTheValuesAndReachesTheFloor) {
  const std::vector<double> start = definition.start_values();
  const Ladder ladder = build_ladder(task(start));
  const HorizonErrors before = errors_on(ladder, predictor, space, start);
  const HorizonFit fit = fit_to_ladder(ladder, predictor, space, start);
  ASSERT_TRUE(before.valid && fit.errors.valid);
  EXPECT_LT(fit.errors.cost, before.cost - 1.0);
  EXPECT_NEAR(fit.values[0], kInertia, 0.01 * kInertia);
  EXPECT_NEAR(fit.values[1], kDamping, 0.02 * kDamping);
  const HorizonErrors held_out = errors_on(same_ladder(ladder, task(start, true)), predictor, space, fit.values);
  ASSERT_TRUE(held_out.valid);
  for (std::size_t r = 0; r < ladder.rungs.size(); ++r) {
    const double floor = kNoise * kNoise + ladder.rungs[r].start_share[0];
    EXPECT_LT(held_out.mean_square[r][0], 2.0 * floor) << ladder.rungs[r].length;
  }
}

TEST_F(HorizonFits, AWrongValueCostsOnDataThatWereHeldOut) {
  const std::vector<double> truth = {kInertia, kDamping}, wrong = {kInertia, 1.5 * kDamping};
  const Ladder held_out = same_ladder(build_ladder(task(truth)), task(truth, true));
  EXPECT_GT(errors_on(held_out, predictor, space, wrong).cost, errors_on(held_out, predictor, space, truth).cost + 0.5);
}

}  // namespace
}  // namespace lacuna::horizon_fit_test
