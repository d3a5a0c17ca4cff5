#include "simulation/engine/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacuna::testing {
namespace {

// ODE is first order: errors are of the size of step·rate.
constexpr double kAngleTolerance = 1e-5;  // rad, small oscillation with a step of 0.1 ms

TEST(ThinSlice, SmallOscillationHasThePeriodOfARod) {
  Rig rig(pendulum(), step_of(1e-4));
  const double omega = std::sqrt(1.5 * 9.81);  // m·g·(L/2)/(m·L²/3), L = 1
  const double period = 2.0 * std::numbers::pi / omega;
  rig.options.start.positions = {0.01};
  const SimulationResult& result = rig.run(constant("motor", 0.0), {0.0, 0.25 * period, 0.5 * period, period});
  ASSERT_EQ(result.ending, Ending::completed) << result.reason;
  EXPECT_NEAR(result.readings.samples(0, 0), 0.01, 1e-12);
  EXPECT_NEAR(result.readings.samples(1, 0), 0.0, kAngleTolerance);
  EXPECT_NEAR(result.readings.samples(2, 0), -0.01, kAngleTolerance);
  EXPECT_NEAR(result.readings.samples(3, 0), 0.01, kAngleTolerance);
  EXPECT_NEAR(result.readings.samples(1, 1), -0.01 * omega, kAngleTolerance);
}

TEST(ThinSlice, ConstantTorqueTurnsPastARevolution) {
  RobotSpec robot = pendulum();
  robot.gravity.setZero();
  Rig rig(robot, step_of(1e-3));
  const SimulationResult& result = rig.run(constant("motor", 2.0), {2.0});
  ASSERT_EQ(result.ending, Ending::completed) << result.reason;
  EXPECT_NEAR(result.readings.samples(0, 0), 12.0, 0.02);  // ½·(2/(1/3))·2², step·rate = 0.012
  EXPECT_NEAR(result.readings.samples(0, 1), 12.0, 0.02);
  EXPECT_NEAR(result.readings.samples(0, 2), 2.0, 1e-9);
}

TEST(ThinSlice, SliderUnderForceIsExactAtStepEnds) {
  for (const std::string& engine : engines()) {
    SCOPED_TRACE(engine);
    EngineSettings settings = step_of(1e-3);
    settings.engine = engine;
    Rig rig(cart(), settings);
    const SimulationResult& result = rig.run(constant("motor", 3.0), {0.5, 1.0});
    ASSERT_EQ(result.ending, Ending::completed) << result.reason;
    // Under a constant acceleration a: v = a·t, and x = ½·a·t², or ½·a·t·(t + h) by ODE's semi-implicit Euler.
    const double late = engine == "ode" ? 1e-3 : 0.0;
    EXPECT_NEAR(result.readings.samples(0, 0), 0.5 * 1.5 * 0.5 * (0.5 + late), 1e-9);
    EXPECT_NEAR(result.readings.samples(1, 0), 0.5 * 1.5 * 1.0 * (1.0 + late), 1e-9);
    EXPECT_NEAR(result.readings.samples(1, 1), 1.5, 1e-9);
  }
}

}  // namespace
}  // namespace lacuna::testing
