#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna::double_pendulum_test {
namespace {

constexpr double kMass = 0.5, kLength = 0.3, kInertia = 0.01;
constexpr double kInner = kInertia + 2.0 * kMass * kLength * kLength;
constexpr double kOuter = kInertia + kMass * kLength * kLength;
constexpr double kCoupling = kMass * kLength * kLength;
constexpr double kWeight = kMass * kGravity * kLength;

/// a, b: angles of the links against the vertical; the state is (a, b, da/dt, db/dt). Lagrange's equations.
void motion(const ReferenceState& x, ReferenceState& dx, double) {
  const double c = std::cos(x[0] - x[1]), s = std::sin(x[0] - x[1]);
  const double right_a = -kCoupling * s * x[3] * x[3] - 2.0 * kWeight * std::sin(x[0]);
  const double right_b = kCoupling * s * x[2] * x[2] - kWeight * std::sin(x[1]);
  const double determinant = kInner * kOuter - kCoupling * kCoupling * c * c;
  dx = {x[2], x[3], (kOuter * right_a - kCoupling * c * right_b) / determinant,
        (kInner * right_b - kCoupling * c * right_a) / determinant};
}

double energy(double a, double b, double va, double vb) {
  return 0.5 * kInner * va * va + 0.5 * kOuter * vb * vb + kCoupling * std::cos(a - b) * va * vb -
         2.0 * kWeight * std::cos(a) - kWeight * std::cos(b);
}

SimulationRun release(double step) {
  SimulationRun run(double_pendulum(kMass, kLength, kInertia), step);
  run.from({1.8, -0.9}, {0.0, 0.0});
  return run;
}

TEST(DoublePendulum, AgreesWithAnIndependentIntegration) {
  constexpr double kEnd = 0.6;
  const ReferenceState expected = integrate_smooth(motion, {1.8, 0.9, 0.0, 0.0}, {0.0, kEnd}).back();
  expect_convergence([&](double step) { return release(step).last("q1", kEnd) - expected[0]; }, 5e-4, 0.02);
  expect_convergence([&](double step) { return release(step).last("q2", kEnd) - (expected[1] - expected[0]); }, 5e-4,
                     0.04);
}

/// The largest deviation of the energy in 5 s, as a share of what was there to swing with.
double energy_drift(double step) {
  const TimeSeries readings = release(step).run(evenly_spaced(5.0, 500)).readings;
  const Eigen::VectorXd q1 = column(readings, "q1"), q2 = column(readings, "q2");
  const Eigen::VectorXd v1 = column(readings, "v1"), v2 = column(readings, "v2");
  const double start = energy(q1(0), q1(0) + q2(0), 0.0, 0.0);
  double drift = 0.0;
  for (Eigen::Index i = 0; i < q1.size(); ++i)
    drift = std::max(drift, std::abs(energy(q1(i), q1(i) + q2(i), v1(i), v1(i) + v2(i)) - start));
  return drift / (start + 3.0 * kWeight);
}

TEST(DoublePendulum, EnergyDriftShrinksWithTheStep) {
  constexpr double kDriftAtAMillisecond = 0.03;
  EXPECT_LE(energy_drift(1e-3), kDriftAtAMillisecond);
  EXPECT_LE(energy_drift(2.5e-4), kDriftAtAMillisecond / 3);
}

}  // namespace
}  // namespace lacuna::double_pendulum_test
