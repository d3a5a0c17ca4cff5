#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::testing {
namespace {

constexpr double kStep = 0.01;

/// The cart at 1 m/s from −0.5 m: its place is a ramp that is known between steps, too.
class Ramp : public ::testing::Test {
 protected:
  Ramp() : robot_(cart()) {
    options_.start.positions = {-0.5};
    options_.start.velocities = {1.0};
  }
  Eigen::VectorXd places(const std::vector<double>& times, const std::vector<PlacedEffect>& effects = {}) {
    Rig rig(ModelStructure{.robot = robot_, .effects = effects, .parameters = {}}, settings_);
    rig.options = options_;
    rig.run(constant("motor", 0.0), times);
    EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
    return rig.result.readings.samples.col(0);
  }
  RobotSpec robot_;
  SimulationOptions options_;
  EngineSettings settings_ = step_of(kStep);
};

TEST_F(Ramp, OutputsBetweenStepsAreInterpolated) {
  const std::vector<double> times{0.0, 0.0033, 0.01, 0.0171, 0.0199, 0.3};
  const Eigen::VectorXd read = places(times);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(read[static_cast<Eigen::Index>(i)], times[i] - 0.5, 1e-12);
}

TEST_F(Ramp, AStartTimeShiftsTheClockOnly) {
  options_.start_time = 100.0;
  EXPECT_NEAR(places({100.0, 100.123})[1], 0.123 - 0.5, 1e-10);
}

TEST_F(Ramp, DelayedReadingsStartAtTheInitialOne) {
  robot_.sensors[0].delay = 0.0234;
  const std::vector<double> times{0.0, 0.01, 0.05, 0.1234};
  const Eigen::VectorXd read = places(times);
  EXPECT_NEAR(read[0], -0.5, 1e-12);
  EXPECT_NEAR(read[1], -0.5, 1e-12);
  EXPECT_NEAR(read[2], 0.05 - 0.0234 - 0.5, 1e-12);
  EXPECT_NEAR(read[3], 0.1234 - 0.0234 - 0.5, 1e-12);
}

TEST_F(Ramp, StepRoundingDelaysReadingsByWholeSteps) {
  robot_.sensors[0].delay = 0.0234;
  settings_.delay_rounding = DelayRounding::step;
  EXPECT_NEAR(places({0.1})[0], 0.08 - 0.5, 1e-12);
}

TEST_F(Ramp, ScaleComesBeforeOffset) {
  robot_.sensors[0].scale = 2.0;
  robot_.sensors[0].offset = 0.1;
  EXPECT_NEAR(places({0.2})[0], 2.0 * -0.3 + 0.1, 1e-12);
}

TEST_F(Ramp, EffectsComeBeforeScaleAndOffset) {
  class Plus : public Lag {
   public:
    Plus() : Lag(false) {}
    int state_size(const EffectContext&) const override { return 0; }
    void sense(std::span<double> channels, int, const StepView&, const EffectContext&,
               std::span<double>) const override {
      channels[0] += 1.0;
    }
  };
  const Plus plus;
  robot_.sensors[0].scale = 2.0;
  robot_.sensors[0].offset = 0.1;
  EXPECT_NEAR(places({0.2}, {place("plus", plus, ElementKind::sensor, {0}, {0.0})})[0], 2.0 * (-0.3 + 1.0) + 0.1,
              1e-12);
}

TEST_F(Ramp, QuantisersRoundAndOnlyWhereImperfectionsAreAskedFor) {
  robot_.sensors[0].quantum = 0.04;
  EXPECT_NEAR(places({0.07})[0], -0.43, 1e-12);
  options_.imperfections = SensorImperfections{};
  EXPECT_NEAR(places({0.07})[0], -0.44, 1e-12);
}

TEST_F(Ramp, NoiseHasTheDeclaredSizeAndNoMean) {
  robot_.sensors[0].noise = 0.01;
  options_.imperfections = SensorImperfections{.seed = 11};
  constexpr int kSamples = 20000;
  settings_.step = 0.001;
  const std::vector<double> times = grid(0.0, kSamples * 0.001, 0.001);
  Eigen::VectorXd noise = places(times);
  for (Eigen::Index i = 0; i < noise.size(); ++i) noise[i] -= static_cast<double>(i) * 0.001 - 0.5;
  const double n = static_cast<double>(noise.size());
  const double deviation = std::sqrt(noise.squaredNorm() / n);
  const double neighbours = noise.head(kSamples).dot(noise.tail(kSamples)) / noise.squaredNorm();
  // Four standard errors of each estimate.
  EXPECT_NEAR(noise.mean(), 0.0, 4.0 * 0.01 / std::sqrt(n));
  EXPECT_NEAR(deviation, 0.01, 4.0 * 0.01 / std::sqrt(2.0 * n));
  EXPECT_NEAR(neighbours, 0.0, 4.0 / std::sqrt(n));
}

TEST_F(Ramp, StopWhenEndsTheSimulationThere) {
  Rig rig(robot_, settings_);
  rig.options = options_;
  rig.options.stop_when = [](std::size_t sample, std::span<const double> readings) {
    EXPECT_EQ(readings.size(), 3U);
    return sample == 2;
  };
  rig.run(constant("motor", 0.0), {0.0, 0.05, 0.1, 0.2, 5.0});
  EXPECT_EQ(rig.result.ending, Ending::stopped);
  EXPECT_EQ(rig.result.steps, 10U);
  EXPECT_FALSE(std::isnan(rig.result.readings.samples(2, 0)));
  EXPECT_TRUE(std::isnan(rig.result.readings.samples(3, 0)));
}

TEST_F(Ramp, SubstepsDivideTheStep) {
  settings_.substeps = 5;
  Rig rig(robot_, settings_);
  rig.run(constant("motor", 0.0), {0.0, 0.1});
  EXPECT_EQ(rig.result.steps, 50U);
}

}  // namespace
}  // namespace lacuna::testing
