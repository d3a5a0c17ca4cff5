#include "fitting/floor/free_run.h"

#include "fitting/made_problem.h"
#include "foundation/address.h"
#include "support/robots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::free_run_test {
namespace {

using namespace lacuna::analytic;

double free_joint(std::span<const double> p, double, double, double) { return p[0]; }

/// A joint that nothing holds, with one acceleration, read at 200 Hz for `seconds`.
struct Released {
  explicit Released(double noise = kNoise, double seconds = 2.0)
      : made(std::make_unique<OneJointModel>(free_joint),
             define({free_value("acceleration", 1.0, -10.0, 10.0)}, one_joint_robot()),
             {record(OneJointModel(free_joint), {1.0},
                     regular_times(static_cast<Eigen::Index>(200.0 * seconds) + 1, 200.0), {}, {{0.3}, {-0.2}}, noise,
                     3)}) {}
  FreeRun run(double acceleration) const {
    return free_run(made.predictor, made.states, 0, std::vector{acceleration}, 0);
  }
  MadeProblem made;
};

TEST(FreeRunOf, PredictsTheWholeTrialFromTheStartThatItsFirstReadingsTell) {
  const Released joint;
  const FreeRun run = joint.run(1.0);
  EXPECT_NEAR(run.start.start.positions[0], 0.3, 3.0 * run.start.deviation(0));
  EXPECT_EQ(run.first_scored, 11) << "after 50 ms";
  ASSERT_EQ(run.pieces.size(), 1U);
  EXPECT_EQ(run.pieces[0].stretch, joint.made.predictor.whole(0));
  ASSERT_TRUE(run.prediction.valid);
  for (const Eigen::Index row : {0, 200, 400}) {
    const double t = joint.made.predictor.trials()[0].measured.times(row);
    const double expected = run.start.start.positions[0] + run.start.start.velocities[0] * t + 0.5 * t * t;
    EXPECT_NEAR(run.prediction.samples(row, 0), expected, 1e-9) << row;
  }
}

TEST(PredictAgain, KeepsTheStartAndTakesOtherValues) {
  const Released joint;
  const FreeRun run = joint.run(1.0);
  const auto again = [&](double acceleration) {
    return predict_again(joint.made.predictor, 0, run.pieces, std::vector{acceleration}, 0);
  };
  EXPECT_EQ(again(1.0).samples, run.prediction.samples);
  EXPECT_NEAR(again(3.0).samples(400, 0) - run.prediction.samples(400, 0), 0.5 * 2.0 * 4.0, 1e-9);
}

/// The line through N = 11 readings of 50 ms, whose variance is σ²(1/N + (t − 25 ms)²/Sxx), over the time after them.
TEST(EffectOfStart, IsTheUncertaintyOfTheFirstReadingsOverTheScoredTime) {
  const Released joint;
  const FreeRun run = joint.run(1.0);
  const double sxx = 25e-6 * 11.0 * 120.0 / 12.0;
  double squares = 0.0;
  for (Eigen::Index row = 11; row < 401; ++row)
    squares += kNoise * kNoise * (1.0 / 11.0 + std::pow(0.005 * static_cast<double>(row) - 0.025, 2) / sxx);
  const double expected = std::sqrt(squares / 390.0);
  const Eigen::VectorXd found = effect_of_start(joint.made.predictor, 0, std::vector{1.0}, run, 0);
  ASSERT_EQ(found.size(), 1);
  EXPECT_NEAR(found(0), expected, 0.3 * expected) << "eleven readings know their noise to about a fifth";
}

TEST(EffectOfStart, IsNothingWhereTheStartIsGiven) {
  Released joint;
  Trial trial = joint.made.predictor.trials()[0];
  trial.initial = {{InitialKnowledge::given, 0.3, -0.2}};
  const TrialPredictor predictor(*joint.made.model, {trial}, {1});
  const StartStates states(one_joint_robot(), predictor, joint.made.noise);
  const FreeRun run = free_run(predictor, states, 0, std::vector{1.0}, 0);
  EXPECT_EQ(run.first_scored, 0);
  EXPECT_EQ(run.prediction.samples(0, 0), 0.3);
  EXPECT_EQ(effect_of_start(predictor, 0, std::vector{1.0}, run, 0)(0), 0.0);
}

/// Torques that drive three joints of a chain are integrated twice, so the run begins anew every second. Each piece
/// goes on until the next one is scored.
TEST(FreeRunOf, RestartsEverySecondWhereErrorsGrowWithoutBound) {
  const RobotSpec robot = driven_chain(3);
  const std::unique_ptr<CompiledModel> model = compile({robot, {}, {}}, {.step = 0.01, .substeps = 8});
  CommandSeries commands;
  commands.series = {command_channels(robot), regular_times(351, 100.0), TimeSeries::Samples(351, 3)};
  for (const Eigen::Index joint : {0, 1, 2})
    commands.series.samples.col(joint) =
        0.2 * (commands.series.times.array() * (2.0 + static_cast<double>(joint))).sin();
  const std::vector<double> rest(3, 0.0);
  const TrialPredictor predictor(*model, {record(*model, {}, commands.series.times, commands, {rest, rest}, kNoise, 1)},
                                 {1});
  const std::vector<ChannelNoise> noise = sensor_noise(robot, predictor.trials());
  const FreeRun run = free_run(predictor, StartStates(robot, predictor, noise), 0, {}, 0);
  ASSERT_EQ(run.pieces.size(), 4U);
  for (std::size_t k = 1; k < 4; ++k) {
    const RunPiece &piece = run.pieces[k], &before = run.pieces[k - 1];
    EXPECT_EQ(piece.stretch.first, 100 * static_cast<Eigen::Index>(k));
    EXPECT_GE(before.stretch.last, piece.first_scored);
    Prediction alone;
    predictor.predict(piece.stretch, {}, piece.start.start, 0, alone);
    const Eigen::Index row = piece.first_scored + 20;
    EXPECT_EQ(run.prediction.samples.row(row), alone.samples.row(row - piece.stretch.first)) << k;
  }
}

}  // namespace
}  // namespace lacuna::free_run_test
