#include "prediction/start_by_readings.h"

#include "prediction/one_joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kPull = 0.8;         // rad/s²
constexpr Eigen::Index kFirst = 200;  // sample at which the stretch begins
constexpr double kBegin = 0.01 * kFirst;

/// A parabola that was recorded with an ideal sensor, and a model of it whose sensor is another.
class ChangedSensor {
 public:
  explicit ChangedSensor(const std::function<void(SensorSpec&)>& change)
      : rig_(constant_acceleration, {}, {kPull}), predictor_(nullptr) {
    ModelDefinition definition = rig_.definition;
    RobotSpec& robot = definition.structure.robot;
    robot.gravity.setZero();
    robot.joints[0].force = kPull;  // on 1 kg·m²
    change(robot.sensors[0]);
    definition.engine.step = 0.001;
    model_ = compile(definition.structure, definition.engine);
    predictor_ = std::make_unique<TrialPredictor>(*model_, without_commands(rig_.trials), Work{1});
  }

  ChangedStart started(const StartState& start, const WarmUp* warm_up = nullptr) {
    return start_by_readings({rig_.starts, *predictor_, stretch_, values_, warm_up, 0}, start, prediction_);
  }
  /// The first reading of the model, rad.
  double reads(const ChangedStart& changed) {
    predictor_->predict(stretch_, values_, changed.start, 0, prediction_,
                        changed.warm_up ? &*changed.warm_up : nullptr);
    return prediction_.samples(0, 0);
  }
  StartState smoothed(Eigen::Index sample) const { return rig_.starts.at(0, sample).start; }

 private:
  static std::vector<Trial> without_commands(std::vector<Trial> trials) {
    for (Trial& trial : trials) trial.commands.series.samples.setZero();
    return trials;
  }

  OneJointRig rig_;
  std::unique_ptr<CompiledModel> model_;
  std::unique_ptr<TrialPredictor> predictor_;
  const std::vector<double> values_;
  const Stretch stretch_{0, kFirst, kFirst + 50};
  Prediction prediction_;
};

TEST(StartByReadings, IsTheStartItselfForAnIdealSensor) {
  const ChangedStart changed = ChangedSensor([](SensorSpec&) {}).started({{0.7}, {1.5}});
  EXPECT_EQ(changed.start.positions[0], 0.7);
  EXPECT_EQ(changed.start.velocities[0], 1.5);
  EXPECT_FALSE(changed.reads_backwards);
}

TEST(StartByReadings, StandsWhereASensorWithAnOffsetReadsTheStart) {
  ChangedSensor sensor([](SensorSpec& angle) { angle.offset = 0.1; });
  const ChangedStart changed = sensor.started({{0.7}, {1.5}});
  EXPECT_NEAR(changed.start.positions[0], 0.6, 1e-9);
  EXPECT_NEAR(changed.start.velocities[0], 1.5, 1e-6);
  EXPECT_NEAR(sensor.reads(changed), 0.7, 1e-9);
}

TEST(StartByReadings, MovesAtTheSpeedThatASensorOfAnotherScaleReads) {
  ChangedSensor sensor([](SensorSpec& angle) { angle.scale = 2.0; });
  const ChangedStart changed = sensor.started({{0.7}, {1.5}});
  EXPECT_NEAR(changed.start.positions[0], 0.35, 1e-9);
  EXPECT_NEAR(changed.start.velocities[0], 0.75, 1e-6);
}

TEST(StartByReadings, SeesASensorThatReadsBackwards) {
  EXPECT_TRUE(ChangedSensor([](SensorSpec& angle) { angle.scale = -1.0; }).started({{0.7}, {1.5}}).reads_backwards);
}

/// A sensor that hardly follows the joint tells nothing of where it stands.
TEST(StartByReadings, StaysWhereTheReadingDoesNotFollow) {
  const ChangedStart changed = ChangedSensor([](SensorSpec& angle) { angle.scale = 1e-3; }).started({{0.7}, {1.5}});
  EXPECT_EQ(changed.start.positions[0], 0.7);
  EXPECT_EQ(changed.start.velocities[0], 1.5);
  EXPECT_FALSE(changed.reads_backwards);
}

/// The first reading shows the state 50 ms earlier.
TEST(StartByReadings, BeginsLaterByTheDelayOfTheSensor) {
  ChangedSensor sensor([](SensorSpec& angle) { angle.delay = 0.05; });
  const StartState start = sensor.smoothed(kFirst);
  const ChangedStart changed = sensor.started(start);
  const double moved = parabola_at(kPull, kBegin + 0.05).positions[0] - parabola_at(kPull, kBegin).positions[0];
  EXPECT_NEAR(changed.start.positions[0], start.positions[0] + moved, 1e-3);
  EXPECT_FALSE(changed.warm_up);
}

TEST(StartByReadings, BeginsInTheWarmUpWhereThereIsOne) {
  ChangedSensor sensor([](SensorSpec& angle) { angle.delay = 0.05; });
  const WarmUp warm_up{kFirst - 10, sensor.smoothed(kFirst - 10)};
  const ChangedStart changed = sensor.started(sensor.smoothed(kFirst), &warm_up);
  EXPECT_TRUE(std::isnan(changed.start.positions[0]));
  ASSERT_TRUE(changed.warm_up);
  EXPECT_NEAR(static_cast<double>(changed.warm_up->first), kFirst - 5.0, 1.0) << "the last sample before it happened";
  EXPECT_NEAR(sensor.reads(changed), parabola_at(kPull, kBegin).positions[0], 3e-3);
}

}  // namespace
}  // namespace lacuna
