#include "measurement/trials/recorded_controller.h"

#include "measurement_fixture.h"

#include <array>

namespace lacuna {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

/// One law of 8 N·m/rad and 0.5 N·m·s/rad on the angle, of which 0.1 s pass from sample to sample.
class ARecordedController : public testing::Test {
 protected:
  RecordingSource source() {
    RecordingSource source =
        pendulum_source(folder_.write("run.csv", "t,q,u,wanted_deg\n0,0.1,1,90\n0.1,0.2,2,90\n0.2,0.4,3,180\n"));
    ControllerMapping mapping;
    mapping.actuator = mapping.reference.channel = "motor";
    mapping.sensor = "angle";
    mapping.reference.column = "wanted_deg";
    mapping.reference.unit = "deg";
    mapping.proportional = 8.0;
    mapping.proportional_unit = "N*m/rad";
    mapping.derivative = 0.5;
    mapping.derivative_unit = "N*m*s/rad";
    mapping.location = {"rig.toml", 11, 1};
    source.controllers = {mapping};
    return source;
  }
  const RecordedController& read() {
    recording_ = read_pendulum(source());
    return dynamic_cast<const RecordedController&>(*recording_.trials.front().controller);
  }

  TestFolder folder_;
  Recording recording_;
};

constexpr double kRight = M_PI / 2.0;

TEST_F(ARecordedController, MakesItsCommandsOfTheRecordedReadings) {
  const Eigen::VectorXd commands = read().of_recorded_readings(0);
  EXPECT_THAT(std::vector<double>(commands.begin(), commands.end()),
              ElementsAre(DoubleEq(8.0 * (kRight - 0.1)), DoubleEq(8.0 * (kRight - 0.2) - 0.5 * 0.1 / 0.1),
                          DoubleEq(8.0 * (2.0 * kRight - 0.4) - 0.5 * 0.2 / 0.1)));
}

/// The controller at work from a state of zeros: its command by time and angle.
auto actor(const RecordedController& controller) {
  std::vector<double> at_none(static_cast<std::size_t>(controller.state_size()), 0.0);
  return [&controller, state = std::move(at_none), commands = std::array{0.0}](double time, double angle) mutable {
    const std::array readings = {angle, 0.0};
    controller.act(time, readings, state, commands);
    return commands[0];
  };
}

/// However often the engine asks: it acts at its samples and holds in between.
TEST_F(ARecordedController, ActsAtTheSamplesOfTheTrial) {
  const RecordedController& controller = read();
  auto act = actor(controller);
  EXPECT_DOUBLE_EQ(act(0.0, 0.3), 8.0 * (kRight - 0.3));
  EXPECT_DOUBLE_EQ(act(0.05, 0.9), 8.0 * (kRight - 0.3));
  EXPECT_DOUBLE_EQ(act(0.1, 0.5), 8.0 * (kRight - 0.5) - 0.5 * 0.2 / 0.1);
}

TEST_F(ARecordedController, BeginsInTheMiddleWithWhatWasMeasuredBefore) {
  const RecordedController& controller = read();
  std::vector<double> state(static_cast<std::size_t>(controller.state_size()), 0.0);
  std::array commands = {0.0};
  const std::array readings = {0.5, 0.0};
  controller.act(0.2, readings, state, commands);
  EXPECT_DOUBLE_EQ(commands[0], 8.0 * (2.0 * kRight - 0.5) - 0.5 * (0.5 - 0.2) / 0.1);
}

/// The integral of the error, at the law's samples; it stands still while the command is at its limit.
TEST_F(ARecordedController, IntegratesWithinItsLimit) {
  RecordingSource with_integral = source();
  ControllerMapping& law = with_integral.controllers.front();
  law.derivative = 0.0;
  law.integral = 20.0;
  law.integral_unit = "N*m/(rad*s)";
  law.limit = 12.0;
  const Recording recording = read_pendulum(with_integral);
  const auto& controller = dynamic_cast<const RecordedController&>(*recording.trials.front().controller);
  auto act = actor(controller);
  EXPECT_NEAR(act(0.0, kRight - 0.1), 1.0, 1e-12) << "it begins with what was commanded";
  EXPECT_NEAR(act(0.1, kRight - 0.2), 0.2 + 1.6, 1e-12) << "0.2 of the integral";
  EXPECT_EQ(act(0.2, 0.0), 12.0);
}

TEST_F(ARecordedController, SmoothsWhatItsDerivativeSees) {
  RecordingSource smooth = source();
  smooth.controllers.front().proportional = 0.0;
  smooth.controllers.front().filter = 0.1;
  const Recording recording = read_pendulum(smooth);
  const auto& controller = dynamic_cast<const RecordedController&>(*recording.trials.front().controller);
  const Eigen::VectorXd made = controller.of_recorded_readings(0);
  EXPECT_NEAR(made(1), -0.5 * (1.0 - std::exp(-1.0)) * 0.1 / 0.1, 1e-12);
}

TEST_F(ARecordedController, DrivesModelsWhereTheSourceSaysSo) {
  RecordingSource driven = source();
  EXPECT_FALSE(read_pendulum(driven).trials.front().closed_loop);
  driven.by_controllers = true;
  EXPECT_TRUE(read_pendulum(driven).trials.front().closed_loop);
}

TEST_F(ARecordedController, IsRefusedWithoutItsColumnsAndInOtherUnits) {
  RecordingSource wrong = source();
  wrong.controllers.front().sensor = "rate";
  EXPECT_THAT(complaint_of(wrong),
              HasSubstr("the controller of motor reads `rate`, which has no column in target.sensors"));
  wrong = source();
  wrong.controllers.front().actuator = "wheel";
  EXPECT_THAT(complaint_of(wrong), HasSubstr("names the actuator `wheel`, which has no column in target.commands"));
  wrong = source();
  wrong.controllers.front().derivative_unit = "N*m/rad";
  EXPECT_THAT(complaint_of(wrong),
              HasSubstr("derivative of the controller of motor turns rad into N*m, so its unit is N*m*s/rad"));
  wrong = source();
  wrong.controllers.front().reference.column = "nowhere";
  EXPECT_THAT(complaint_of(wrong), HasSubstr("no column `nowhere`"));
}

}  // namespace
}  // namespace lacuna
