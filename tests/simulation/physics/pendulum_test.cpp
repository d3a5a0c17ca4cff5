#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::pendulum_test {
namespace {

constexpr double kMass = 0.7, kLength = 0.4, kInertia = 0.02;
const double kRate = pendulum_rate(kMass, kLength, kInertia);  // 1/s²

SimulationRun swing(double amplitude, double step) {
  SimulationRun run(pendulum(kMass, kLength, kInertia), step);
  run.from({amplitude}, {0.0});
  return run;
}

TEST(Pendulum, SwingsHarmonicallyAtSmallAmplitude) {
  constexpr double kAmplitude = 1e-3, kEnd = 1.2;
  const double expected = kAmplitude * std::cos(std::sqrt(kRate) * kEnd);
  const auto error = [&](double step) { return swing(kAmplitude, step).last("position", kEnd) - expected; };
  expect_convergence(error, 4e-3, 0.01 * kAmplitude);
}

TEST(Pendulum, AgreesWithAnIndependentIntegrationAtLargeAmplitude) {
  constexpr double kAmplitude = 2.5, kEnd = 0.6;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    dx = {x[1], -kRate * std::sin(x[0])};
  };
  const ReferenceState expected = integrate_smooth(motion, {kAmplitude, 0.0}, {0.0, kEnd}).back();
  const auto position_error = [&](double step) { return swing(kAmplitude, step).last("position", kEnd) - expected[0]; };
  const auto velocity_error = [&](double step) { return swing(kAmplitude, step).last("velocity", kEnd) - expected[1]; };
  expect_convergence(position_error, 1e-3, 0.02);
  // From rest the scheme is a leapfrog, whose velocity at the end of a step is of second order.
  constexpr double kVelocityError = 2e-3;  // rad/s of 4
  EXPECT_LE(std::abs(velocity_error(1e-3)), kVelocityError);
  EXPECT_LE(std::abs(velocity_error(2.5e-4)), kVelocityError / 4);
}

/// The time between the first and the last upward passage through zero, divided by the turns between.
double measured_period(const TimeSeries& readings) {
  const Eigen::VectorXd q = column(readings, "position");
  std::vector<double> passages;
  for (Eigen::Index i = 1; i < q.size(); ++i)
    if (q(i - 1) < 0.0 && q(i) >= 0.0)
      passages.push_back(readings.times(i) - (readings.times(i) - readings.times(i - 1)) * q(i) / (q(i) - q(i - 1)));
  return (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

TEST(Pendulum, PeriodAtLargeAmplitudeIsTheEllipticIntegral) {
  constexpr double kAmplitude = 2.5, kEnd = 10.0;
  const double period = 4.0 * std::comp_ellint_1(std::sin(kAmplitude / 2)) / std::sqrt(kRate);
  constexpr double kPeriodError = 5e-3;  // of the period, at a millisecond
  const auto error = [&](double step) {
    const int samples = static_cast<int>(std::lround(kEnd / step));
    return measured_period(swing(kAmplitude, step).run(evenly_spaced(kEnd, samples)).readings) / period - 1.0;
  };
  EXPECT_LE(std::abs(error(1e-3)), kPeriodError);
  EXPECT_LE(std::abs(error(2.5e-4)), kPeriodError / 4);
}

TEST(Pendulum, SubstepsAreAsGoodAsShorterSteps) {
  SimulationRun substeps = swing(2.0, 4e-3);
  substeps.engine.substeps = 4;
  constexpr double kSameMethod = 1e-9;
  EXPECT_NEAR(substeps.last("position", 1.0), swing(2.0, 1e-3).last("position", 1.0), kSameMethod);
}

}  // namespace
}  // namespace lacuna::pendulum_test
