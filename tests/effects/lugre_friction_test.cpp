#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::lugre_friction_test {
namespace {

constexpr double kMass = 1.0;
constexpr double kSigma0 = 2000.0, kSigma1 = 20.0, kSigma2 = 0.4;
constexpr double kCoulomb = 1.0, kStiction = 1.5, kStribeck = 0.05;

std::vector<double> lugre_values() { return {kCoulomb, kStiction - kCoulomb, kStribeck, kSigma0, kSigma1, kSigma2}; }

/// The force on the mass: it grows past break-away, turns round, and rests below break-away.
const std::vector<double> kTimes{0.0, 0.5, 1.0, 1.4};
const std::vector<double> kForces{0.0, 3.0, -3.0, 0.0};

double force_at(double time) {
  for (std::size_t i = 1; i < kTimes.size(); ++i)
    if (time <= kTimes[i])
      return kForces[i - 1] + (kForces[i] - kForces[i - 1]) * (time - kTimes[i - 1]) / (kTimes[i] - kTimes[i - 1]);
  return kForces.back();
}

/// The equations as published; the state is (q, v, z).
void lugre_motion(const ReferenceState& x, ReferenceState& dx, double time) {
  const double v = x[1], z = x[2];
  const double g = kCoulomb + (kStiction - kCoulomb) * std::exp(-(v / kStribeck) * (v / kStribeck));
  const double bristle_rate = v - kSigma0 * std::abs(v) / g * z;
  const double friction = kSigma0 * z + kSigma1 * bristle_rate + kSigma2 * v;
  dx = {v, (force_at(time) - friction) / kMass, bristle_rate};
}

SimulationRun pushed(double step) {
  SimulationRun run(one_joint(JointKind::slider, kMass), step);
  run.command("motor", kTimes, kForces, Hold::first_order);
  run.place(built_catalog().get<PhysicalEffect>("lugre_friction"), ElementKind::joint, {0}, lugre_values());
  return run;
}

TEST(LugreFriction, AgreesWithAnIndependentIntegration) {
  for (const double end : {0.35, 0.8, 1.3}) {
    const ReferenceState expected = integrate_in_steps(lugre_motion, {0.0, 0.0, 0.0}, {0.0, end}, 5e-5).back();
    const auto error = [&](double step) { return pushed(step).last("position", end) - expected[0]; };
    constexpr double kPositionError = 5e-3;  // m of 0.4
    expect_convergence(error, 1e-3, kPositionError);
  }
}

TEST(LugreFriction, BendsElasticallyBeforeItBreaksAway) {
  constexpr double kPush = 0.5 * kCoulomb, kEnd = 0.2;
  const Derivative pushed_gently = [](const ReferenceState& x, ReferenceState& dx, double) {
    lugre_motion(x, dx, 0.0);
    dx[1] += kPush / kMass;
  };
  const double expected = integrate_in_steps(pushed_gently, {0.0, 0.0, 0.0}, {0.0, kEnd}, 5e-5).back()[0];
  EXPECT_LT(expected, 3.0 * kPush / kSigma0);  // a spring's deflection and a little creep
  const auto error = [&](double step) {
    return pushed(step).command("motor", kPush).last("position", kEnd) - expected;
  };
  constexpr double kBendError = 3e-5;  // m of 3e-4
  EXPECT_LE(std::abs(error(1e-3)), kBendError);
  EXPECT_LE(std::abs(error(1.25e-4)), kBendError / 6);
}

TEST(LugreFriction, IsStableWhenItsBristlesAreStiff) {
  SimulationRun run(one_joint(JointKind::slider, kMass), 1e-3);
  run.place(built_catalog().get<PhysicalEffect>("lugre_friction"), ElementKind::joint, {0},
            {4.0, 0.0, 0.01, 1e7, 1e3, 0.0});
  // With stiff bristles it is Coulomb's friction: v²m/(2Fc).
  EXPECT_NEAR(run.from({0.0}, {1.0}).last("position", 2.0), 1.0 / 8.0, 2e-3);
}

TEST(LugreFriction, OfAViscousFilmAloneIsViscousFriction) {
  SimulationRun film(one_joint(JointKind::slider, kMass)), viscous = film;
  film.place(built_catalog().get<PhysicalEffect>("lugre_friction"), ElementKind::joint, {0},
             {0.0, 0.0, 0.01, kSigma0, kSigma1, kSigma2});
  viscous.place(built_catalog().get<PhysicalEffect>("viscous_friction"), ElementKind::joint, {0}, {kSigma2});
  EXPECT_NEAR(film.from({0.0}, {1.0}).last("position", 1.0), viscous.from({0.0}, {1.0}).last("position", 1.0),
              kRounding);
}

TEST(LugreFriction, ContinuesBitIdenticallyAfterARestore) {
  SimulationRun run = pushed(1e-3);
  run.structure.robot.sensors[0].delay = 0.0043;
  run.structure.robot.sensors[1].noise = 0.01;
  run.imperfections = SensorImperfections{.seed = 5};
  expect_same_bits_after_restore(run, evenly_spaced(1.2, 60), 33);
}

}  // namespace
}  // namespace lacuna::lugre_friction_test
