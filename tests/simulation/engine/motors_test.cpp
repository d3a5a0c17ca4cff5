#include "simulation/engine/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::testing {
namespace {

constexpr double kConstant = 0.3, kResistance = 5.0, kSupply = 7.0;  // N·m/A, Ohm, V

/// A wheel on a hinge, without gravity, turned by a motor on a voltage.
RobotSpec wheel(ActuatorKind kind) {
  RobotSpec robot = pendulum();
  robot.gravity.setZero();
  robot.actuators[0].kind = kind;
  robot.actuators[0].motor = {.torque_constant = kConstant, .resistance = kResistance, .supply = kSupply};
  robot.sensors.push_back(sensor("drive", SensorKind::drive_force, "hinge"));
  return robot;
}

constexpr double kInertia = 1.0 / 3.0;  ///< of the rod about its hinge, kg·m²

Eigen::VectorXd read(Rig& rig, const std::string& channel) {
  const auto& channels = rig.result.readings.channels;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (channels[c].name == channel) return rig.result.readings.samples.col(static_cast<Eigen::Index>(c));
  return {};
}

/// J·dw/dt = kt·(U − kt·w)/R has the solution w = U/kt·(1 − exp(−kt²/(R·J)·t)).
TEST(Motors, AVoltageBringsAWheelToTheSpeedOfItsBackEmf) {
  const RobotSpec robot = wheel(ActuatorKind::voltage);
  Rig rig(robot, step_of(0.001));
  const std::vector<double> times = grid(0.0, 2.0, 0.1);
  rig.run(constant("motor", 2.0), times);
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  const double rate = kConstant * kConstant / (kResistance * kInertia);
  const Eigen::VectorXd speed = read(rig, "rate"), torque = read(rig, "drive");
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(speed(static_cast<Eigen::Index>(i)), 2.0 / kConstant * (1.0 - std::exp(-rate * times[i])), 1e-6);
  EXPECT_NEAR(torque(10), kConstant * (2.0 - kConstant * speed(10)) / kResistance, 1e-4);
}

TEST(Motors, TheDutyLimitBoundsTheVoltage) {
  RobotSpec robot = wheel(ActuatorKind::voltage);
  robot.actuators[0].motor.duty_limit = 0.5;
  Rig limited(robot, step_of(0.001)), within(robot, step_of(0.001));
  const std::vector<double> times = grid(0.0, 1.0, 0.1);
  limited.run(constant("motor", 100.0), times);
  within.run(constant("motor", 3.5), times);
  EXPECT_EQ(limited.result.readings.samples, within.result.readings.samples);
}

/// A servo's law is a spring and damper until its duty is at the limit, whatever the back-EMF.
TEST(Motors, AVoltageServoIsASpringAndDamperWithinItsDuty) {
  RobotSpec robot = wheel(ActuatorKind::voltage_servo);
  robot.actuators[0].kp = 400.0;
  robot.actuators[0].motor.gain_unit = 0.001;
  RobotSpec equivalent = robot;
  equivalent.actuators[0].kind = ActuatorKind::position_servo;
  equivalent.actuators[0].kp = 400.0 * 0.001 * kSupply * kConstant / kResistance;
  equivalent.joints[0].damping += kConstant * kConstant / kResistance;
  const std::vector<double> times = grid(0.0, 2.0, 0.05);
  Rig servo(robot, step_of(0.001)), spring(equivalent, step_of(0.001));
  servo.run(constant("motor", 0.5), times);
  spring.run(constant("motor", 0.5), times);
  EXPECT_LT((read(servo, "angle") - read(spring, "angle")).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Motors, AtItsDutyLimitAServoIsAMotorOnThatVoltage) {
  RobotSpec robot = wheel(ActuatorKind::voltage_servo);
  robot.actuators[0].kp = 1e6;
  robot.actuators[0].motor.duty_limit = 0.4;
  Rig servo(robot, step_of(0.001)), motor(wheel(ActuatorKind::voltage), step_of(0.001));
  const std::vector<double> times = grid(0.0, 0.5, 0.05);
  servo.run(constant("motor", 100.0), times);
  motor.run(constant("motor", 0.4 * kSupply), times);
  EXPECT_LT((read(servo, "angle") - read(motor, "angle")).cwiseAbs().maxCoeff(), 1e-9);
}

/// Between two looks at its position a servo holds its torque, and a mass under it falls freely.
TEST(Motors, AServoWithASampleTimeHoldsItsVoltage) {
  RobotSpec robot = wheel(ActuatorKind::voltage_servo);
  MotorSpec& motor = robot.actuators[0].motor;
  robot.actuators[0].kp = 400.0;
  motor.gain_unit = 0.001;
  motor.back_emf = 0.0;
  motor.sample_time = 0.02;
  Rig servo(robot, step_of(0.001));
  servo.run(constant("motor", 0.5), grid(0.0, 1.0, 0.02));
  ASSERT_EQ(servo.result.ending, Ending::completed) << servo.result.reason;
  const Eigen::VectorXd angle = read(servo, "angle");
  const double stiffness = 400.0 * 0.001 * kSupply * kConstant / kResistance;
  double q = 0.0, v = 0.0;
  for (Eigen::Index i = 0; i < angle.size(); ++i) {
    EXPECT_NEAR(angle(i), q, 1e-9) << i;
    const double acceleration = stiffness * (0.5 - q) / kInertia;
    q += 0.02 * v + 0.5 * 0.02 * 0.02 * acceleration;
    v += 0.02 * acceleration;
  }
}

/// What it holds is part of the state: a motion goes on from the middle of a sample as it would have.
TEST(Motors, AServoWithASampleTimeGoesOnFromWhereItWas) {
  RobotSpec robot = wheel(ActuatorKind::voltage_servo);
  robot.actuators[0].kp = 400.0;
  robot.actuators[0].motor.gain_unit = 0.001;
  robot.actuators[0].motor.sample_time = 0.02;
  Rig whole(robot, step_of(0.001)), parts(robot, step_of(0.001));
  whole.run(constant("motor", 0.5), grid(0.0, 1.0, 0.1));
  parts.options.save_final_state = true;
  parts.run(constant("motor", 0.5), std::vector<double>{0.0, 0.509});
  ASSERT_EQ(parts.result.ending, Ending::completed) << parts.result.reason;
  const State saved = parts.result.final_state;
  parts.options.from = &saved;
  parts.workspace = parts.model->make_workspace();
  parts.run(constant("motor", 0.5), std::vector<double>{0.6, 1.0});
  ASSERT_EQ(parts.result.ending, Ending::completed) << parts.result.reason;
  EXPECT_EQ(read(parts, "angle")(0), read(whole, "angle")(6));
  EXPECT_EQ(read(parts, "angle")(1), read(whole, "angle")(10));
}

/// While its torque is off a servo exerts nothing, no back-EMF either.
TEST(Motors, AServoThatIsOffExertsNothing) {
  RobotSpec robot = wheel(ActuatorKind::voltage_servo);
  robot.actuators[0].kp = 1.0;
  Rig rig(robot, step_of(0.001));
  rig.options.start = {{0.0}, {3.0}};
  lacuna::Test test = series("motor", {0.0, 0.5, 1.0}, {std::nan(""), std::nan(""), 0.0});
  std::get<CommandSeries>(test.drive).may_be_off = true;
  rig.run(test, grid(0.0, 1.5, 0.1));
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  const Eigen::VectorXd speed = read(rig, "rate"), torque = read(rig, "drive");
  EXPECT_NEAR(speed(9), 3.0, 1e-12);
  EXPECT_EQ(torque(9), 0.0);
  EXPECT_LT(speed(15), 2.9);
}

/// What imposes a motion works against inertia, damping and dry friction, which turns round with it.
TEST(Motors, AnImposedMotionNeedsTheForceOfEverythingElse) {
  RobotSpec robot = wheel(ActuatorKind::motion);
  robot.joints[0].damping = 0.7;
  robot.joints[0].dry_friction = 0.2;
  const std::vector<double> times = grid(0.0, 3.0, 0.005);
  std::vector<double> velocities;
  for (const double t : times) velocities.push_back(std::cos(4.0 * t));
  Rig rig(robot, step_of(0.005));
  rig.run(series("motor", times, velocities, Hold::first_order), times);
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  const Eigen::VectorXd angle = read(rig, "angle"), rate = read(rig, "rate"), drive = read(rig, "drive");
  for (Eigen::Index i = 2; i < rate.size(); ++i) {
    const double t = times[static_cast<std::size_t>(i)], middle = t - 0.0025;
    EXPECT_NEAR(rate(i), std::cos(4.0 * t), 1e-4);
    EXPECT_NEAR(angle(i), 0.25 * std::sin(4.0 * t), 1e-4);
    if (std::abs(std::cos(4.0 * middle)) < 0.02) continue;  // it turns round
    const double expected = -4.0 * kInertia * std::sin(4.0 * middle) + 0.7 * std::cos(4.0 * middle) +
                            std::copysign(0.2, std::cos(4.0 * middle));
    EXPECT_NEAR(drive(i), expected, 1e-3) << t;
  }
}

TEST(Motors, TheOtherEngineRefusesThem) {
  for (const ActuatorKind kind : {ActuatorKind::voltage, ActuatorKind::voltage_servo, ActuatorKind::motion}) {
    EngineSettings settings = step_of(0.001);
    settings.engine = "ode";
    ModelStructure structure{.robot = wheel(kind), .effects = {}, .parameters = {}};
    EXPECT_THROW(compile(structure, settings), Error);
  }
}

}  // namespace
}  // namespace lacuna::testing
