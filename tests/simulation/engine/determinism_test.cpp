#include "foundation/parallel.h"
#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

class Determinism : public ::testing::TestWithParam<std::string> {
 protected:
  Determinism() {
    structure_.robot = everything_for(GetParam());
    settings_.engine = GetParam();
    structure_.effects = {place("wear", wear_, ElementKind::joint, {0}, {0.05})};
    structure_.parameters = {{.address = "body.box.mass", .lower = 1.0, .upper = 7.0},
                             {.address = "sensor.box_touch.delay", .lower = 0.0, .upper = 0.05}};
    model_ = compile(structure_, settings_);
    options_.output_times = times_;
    options_.end_time = times_.back();
    options_.save_final_state = true;
  }

  SimulationResult run(Workspace& workspace, double mass) const {
    SimulationResult result;
    model_->simulate(std::vector{mass, 0.01 * mass / 7.0}, test_, options_, workspace, result);
    EXPECT_EQ(result.ending, Ending::completed) << result.reason;
    return result;
  }

  WearingFriction wear_;
  ModelStructure structure_;
  EngineSettings settings_ = step_of(0.001);
  const lacuna::Test test_ = shake();
  const std::vector<double> times_ = grid(0.0, 0.3, 0.01);
  SimulationOptions options_;
  std::unique_ptr<CompiledModel> model_;
};

INSTANTIATE_TEST_SUITE_P(Engines, Determinism, ::testing::ValuesIn(engines()),
                         [](const auto& test) { return test.param; });

TEST_P(Determinism, AReusedWorkspaceGivesTheBitsOfAFreshOne) {
  const auto used = model_->make_workspace();
  run(*used, 5.0);
  run(*used, 1.5);
  const auto fresh = model_->make_workspace();
  const SimulationResult first = run(*used, 3.0), second = run(*fresh, 3.0);
  EXPECT_EQ(first.readings.samples, second.readings.samples);
  EXPECT_EQ(first.final_state, second.final_state);
}

TEST_P(Determinism, ThreadsGiveTheBitsOfOneThread) {
  constexpr std::size_t kRuns = 16;
  constexpr int kThreads = 4;
  std::vector<State> alone(kRuns), together(kRuns);
  const auto mass = [](std::size_t i) { return 1.0 + 0.3 * static_cast<double>(i); };
  const auto workspace = model_->make_workspace();
  for (std::size_t i = 0; i < kRuns; ++i) alone[i] = run(*workspace, mass(i)).final_state;
  std::vector<std::unique_ptr<Workspace>> workspaces(kThreads);
  for (auto& each : workspaces) each = model_->make_workspace();
  parallel_for(kRuns, kThreads, [&](std::size_t i, int worker) {
    together[i] = run(*workspaces[static_cast<std::size_t>(worker)], mass(i)).final_state;
  });
  EXPECT_EQ(alone, together);
  EXPECT_NE(alone[0], alone[1]);
}

TEST_P(Determinism, TheOrderOfTheEffectListDoesNotMatter) {
  const CommandArithmetic add(CommandStage::offset, false), multiply(CommandStage::gain, true);
  ModelStructure one = structure_, other = structure_;
  one.effects = {place("a_offset", add, ElementKind::actuator, {0}, {0.3}),
                 place("b_gain", multiply, ElementKind::actuator, {0}, {1.5}), structure_.effects[0]};
  other.effects = {one.effects[2], one.effects[1], one.effects[0]};
  one.parameters = other.parameters = {};
  Rig first(one, settings_), second(other, settings_);
  first.options.save_final_state = second.options.save_final_state = true;
  first.run(test_, times_);
  second.run(test_, times_);
  EXPECT_EQ(first.result.final_state, second.result.final_state);
}

TEST_P(Determinism, NoiseBelongsToSeedAndTimeAlone) {
  structure_.robot.sensors[1].noise = 0.1;
  structure_.parameters = {};
  Rig rig(structure_, settings_);
  rig.options.imperfections = SensorImperfections{.seed = 5};
  const auto dense = rig.run(test_, grid(0.0, 0.3, 0.01)).readings.samples;
  const auto sparse = rig.run(test_, {0.1, 0.2}).readings.samples;
  EXPECT_EQ(dense.row(10), sparse.row(0));
  EXPECT_EQ(dense.row(20), sparse.row(1));
  rig.options.imperfections = SensorImperfections{.seed = 6};
  EXPECT_NE(rig.run(test_, {0.1, 0.2}).readings.samples(0, 1), sparse(0, 1));
}

}  // namespace
}  // namespace lacuna::testing
