#include "fitting/starts/start_states.h"
#include "support/robots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace lacuna::free_reading_test {
namespace {

constexpr double kInterval = 0.005;
constexpr Eigen::Index kFlight = 101;  ///< readings

/// A brick with its centre of mass off its frame's origin, which flies and tumbles.
RobotSpec brick() {
  RobotSpec robot = floating_body(0.4, {.xx = 1e-3, .yy = 2e-3, .zz = 3e-3});
  robot.bodies[0].com = {0.01, -0.02, 0.03};
  robot.bodies[0].position = {0.1, 0.2, 0.3};
  robot.gravity = {0.0, 0.0, -kGravity};
  JointSpec joint;
  joint.name = "flight";
  joint.kind = JointKind::free;
  joint.child = "body";
  robot.joints = {joint};
  return robot;
}

const StartState kStart = {{0.5, -0.4, 1.2, 0.3, -2.0, 1.0}, {1.0, 0.5, 2.0, 3.0, -4.0, 5.0}};

Trial flown(const CompiledModel& model, double from = 0.0) {
  SimulationOptions options;
  options.start = kStart;
  options.end_time = kInterval * static_cast<double>(kFlight - 1);
  const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced(kFlight, from, options.end_time);
  options.output_times = {times.data(), static_cast<std::size_t>(kFlight)};
  const std::unique_ptr<Workspace> workspace = model.make_workspace();
  SimulationResult result;
  model.simulate({}, Test{CommandSeries{}, options.end_time, {}}, options, *workspace, result);
  EXPECT_EQ(result.ending, Ending::completed) << result.reason;
  Trial trial;
  trial.measured = result.readings;
  return trial;
}

class FreeStart : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<CompiledModel> model_ =
      compile({.robot = brick(), .effects = {}, .parameters = {}}, {.engine = GetParam(), .step = 1e-3, .substeps = 1});
};

TEST_P(FreeStart, HasSixCoordinates) {
  ASSERT_EQ(model_->coordinates().size(), 6u);
  EXPECT_EQ(model_->coordinates()[2].name, "joint.flight.3");
  EXPECT_EQ(model_->coordinates()[2].unit, "m");
  EXPECT_EQ(model_->coordinates()[3].unit, "rad");
}

TEST_P(FreeStart, IsReadOffPoses) {
  const std::vector<ChannelNoise> noise = [&] {
    std::vector<ChannelNoise> all;
    for (const Channel& channel : model_->channels()) {
      ChannelNoise one;
      one.channel = channel.name;
      one.deviation = 1e-5;
      all.push_back(one);
    }
    return all;
  }();
  const TrialPredictor predictor(*model_, {flown(*model_)}, {1});
  const StartStates states(brick(), predictor, noise);
  EXPECT_TRUE(states.reconstructible(0));
  const StartEstimate estimate = states.from_samples(predictor.whole(0), 0);
  for (int index = 0; index < 12; ++index) {
    EXPECT_NEAR(component(estimate.start, index), component(kStart, index), index < 6 ? 1e-3 : 0.1) << index;
    EXPECT_TRUE(estimate.tells(index)) << index;
  }
}

/// What it is read to be leads where it went.
TEST_P(FreeStart, LeadsToTheMeasuredMotion) {
  const TrialPredictor predictor(*model_, {flown(*model_)}, {1});
  Prediction prediction;
  predictor.predict(predictor.whole(0), {}, kStart, 0, prediction);
  ASSERT_TRUE(prediction.valid) << prediction.reason;
  EXPECT_LT((prediction.samples - predictor.trials()[0].measured.samples).cwiseAbs().maxCoeff(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Engines, FreeStart, testing::Values("articulated", "ode"));

/// Both engines fly alike: the centre of mass on a parabola, in every orientation.
TEST(FreeStart, TheCentreOfMassFliesOnAParabola) {
  for (const char* engine : {"articulated", "ode"}) {
    const std::unique_ptr<CompiledModel> model =
        compile({.robot = brick(), .effects = {}, .parameters = {}}, {.engine = engine, .step = 1e-3, .substeps = 1});
    const Trial trial = flown(*model);
    const Eigen::Index last = kFlight - 1;
    const double t = trial.measured.times(last);
    const auto row = trial.measured.samples.row(last);
    const Eigen::Vector3d origin = row.segment(0, 3).transpose();
    Eigen::Quaterniond turn;
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c)
      if (trial.measured.channels[c].name == "orientation.w") {
        const auto at = static_cast<Eigen::Index>(c);
        turn = Eigen::Quaterniond(row(at), row(at + 1), row(at + 2), row(at + 3));
      }
    const RobotSpec robot = brick();
    const Eigen::Vector3d com = origin + turn * robot.bodies[0].com;
    const Eigen::Vector3d start = robot.bodies[0].position + robot.bodies[0].com + Eigen::Vector3d(0.5, -0.4, 1.2);
    const Eigen::Vector3d expected =
        start + t * Eigen::Vector3d(1.0, 0.5, 2.0) - 0.5 * kGravity * t * t * Eigen::Vector3d::UnitZ();
    EXPECT_LT((com - expected).norm(), 5e-3) << engine;  // ode: first order
  }
}

}  // namespace
}  // namespace lacuna::free_reading_test
