#include "evaluation/model/hidden_truth.h"

#include "config/experiment_reader.h"
#include "evaluation/prediction/target_simulator.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kExperiment = R"(
[experiment]
name = "hidden"
[target]
kind = "simulated"
robot = "quadruped"
set = { "body.torso.mass" = 2.5 }
hidden = { "body.*_lower.mass" = { uniform = [1.0, 7.0] } }
effects = [{ id = "grease", effect = "viscous_friction", where = "joint.*", start = { damping = 0.3 } }]
noise = { "sensor.angle*" = 0.01 }
[model]
robot = "quadruped"
free = { "body.*.mass" = [1.0, 7.0] }
effects = [{ id = "grease", effect = "viscous_friction", where = "joint.*" }]
[engine]
step = 0.01
contact = { stiffness = 2e4, damping = 300.0 }
)";

Experiment experiment(const std::vector<std::string>& overrides = {}) {
  return read_experiment_text(kExperiment, std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "experiments/x.toml",
                              overrides);
}

TEST(HiddenTruth, IsDrawnWithinItsBoundsByItsSeed) {
  const Experiment file = experiment();
  const ModelDefinition target = define_target(file, built_catalog());
  ASSERT_EQ(target.free.size(), 4U);
  const std::vector<double> hidden = draw_hidden_values(target, file.target.simulated, 1);
  for (const double value : hidden) {
    EXPECT_GE(value, 1.0);
    EXPECT_LE(value, 7.0);
  }
  EXPECT_EQ(draw_hidden_values(target, file.target.simulated, 2), hidden) << "redraw is never";
  const Experiment redrawn = experiment({"target.redraw=replicate"});
  EXPECT_NE(draw_hidden_values(target, redrawn.target.simulated, 1),
            draw_hidden_values(target, redrawn.target.simulated, 2));
  const Experiment other = experiment({"target.hidden_seed=2"});
  EXPECT_NE(draw_hidden_values(target, other.target.simulated, 1), hidden);
}

TEST(HiddenTruth, OfAModelIsHiddenOrSetOrTheRobotsOwn) {
  const Experiment file = experiment();
  const ModelDefinition target = define_target(file, built_catalog()), model = define_model(file, built_catalog());
  const std::vector<double> hidden = {2.0, 3.0, 4.0, 5.0};
  const std::vector<double> truth = true_values(model, target, hidden);
  ASSERT_EQ(truth.size(), 10U);
  EXPECT_EQ(truth[0], 2.5);  // torso, as the target sets it
  EXPECT_EQ(truth[1], 2.0);  // the first lower leg
  EXPECT_EQ(truth[2], 1.0);  // its upper leg has the robot's own mass
  EXPECT_EQ(truth[9], 0.3);  // the target's friction
  const Experiment without = experiment({"target.effects=[]"});
  EXPECT_TRUE(std::isnan(true_values(model, define_target(without, built_catalog()), hidden)[9]));
}

TEST(HiddenTruth, ATargetMayBeIntegratedInFinerSteps) {
  const Experiment finer = experiment({"target.substeps=4"});
  EXPECT_EQ(define_target(finer, built_catalog()).engine.substeps, 4);
  EXPECT_EQ(define_model(finer, built_catalog()).engine.substeps, 0);
  EXPECT_EQ(define_target(experiment({"engine.substeps=3"}), built_catalog()).engine.substeps, 3);
}

TEST(HiddenTruth, PatternsThatMatchNothingAreNamedAtTheirPlace) {
  EXPECT_THAT(
      [] {
        define_target(experiment({"target.noise.'sensor.angel*'=0.1", "target.hidden.'body.*.mas'={uniform=[1,2]}"}),
                      built_catalog());
      },
      ThrowsMessage<BadInput>(AllOf(HasSubstr("target.noise.sensor.angel*"), HasSubstr("target.hidden.body.*.mas"),
                                    HasSubstr("matches no value"))));
}

/// All commands zero.
class Rest : public Controller {
 public:
  void act(double, std::span<const double>, std::span<double>, std::span<double> commands) const override {
    for (double& command : commands) command = 0.0;
  }
};

TEST(TargetSimulator, NoiseIsThatOfItsTrialAndOfTheSensorsNamed) {
  const ModelDefinition target = define_target(experiment(), built_catalog());
  TargetSimulator simulator(target, {2.0, 3.0, 4.0, 5.0}, 1);
  const lacuna::Test test{std::make_shared<const Rest>(), 1.0, {}};
  const auto trial = [&](std::uint64_t number) {
    simulator.begin_trial(number);
    return simulator.simulate(test);
  };
  const Trial first = trial(0), again = trial(0), second = trial(1);
  EXPECT_EQ(first.measured.samples, again.measured.samples);
  EXPECT_NE(first.measured.samples, second.measured.samples);
  ASSERT_EQ(first.measured.times.size(), 101);
  const TimeSeries::Samples difference = first.measured.samples - second.measured.samples;
  for (Eigen::Index channel = 0; channel < 4; ++channel) EXPECT_EQ(difference.col(channel).cwiseAbs().maxCoeff(), 0.0);
  for (Eigen::Index channel = 4; channel < 8; ++channel) {
    const double deviation = std::sqrt(difference.col(channel).squaredNorm() / 101.0 / 2.0);
    EXPECT_NEAR(deviation, 0.01, 0.003);  // four standard deviations of an estimate from 101 differences
    EXPECT_EQ(first.sensor_noise[static_cast<std::size_t>(channel)], 0.01);
  }
  EXPECT_EQ(first.commands.series.samples.cwiseAbs().maxCoeff(), 0.0);
}

TEST(TargetSimulator, TracksTheCentreOfMass) {
  const ModelDefinition target = define_target(experiment(), built_catalog());
  const TargetSimulator simulator(target, {3.0, 3.0, 3.0, 3.0}, 1);
  const Trial trial = simulator.simulate({std::make_shared<const Rest>(), 0.02, {}});
  ASSERT_EQ(trial.centre_of_mass.samples.rows(), 3);
  // By hand: torso 2.5 kg and four lower legs of 3 kg at 0.85 m, four upper legs of 1 kg at 1.225 m; all symmetric.
  const double height = ((2.5 + 12.0) * 0.85 + 4.0 * 1.225) / 18.5;
  EXPECT_NEAR(trial.centre_of_mass.samples(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(trial.centre_of_mass.samples(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(trial.centre_of_mass.samples(0, 2), height, 1e-12);
}

}  // namespace
}  // namespace lacuna
