#include "support/kick.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::free_motion_test {
namespace {

const InertiaSpec kRound{.xx = 1.0, .yy = 1.0, .zz = 1.0};

TEST(FreeFall, VelocityIsExactAndPositionOfFirstOrder) {
  constexpr double kEnd = 1.0;
  const double fallen = 0.5 * kGravity * kEnd * kEnd;
  const auto error = [&](double step) {
    const SimulationRun fall(floating_body(2.0, kRound), step);
    EXPECT_NEAR(fall.last("velocity.z", kEnd), -kGravity * kEnd, kRounding);
    return fall.last("position.z", kEnd) + fallen;
  };
  // Semi-implicit Euler falls g·h·t/2 too far.
  const double step = 1e-3, bound = 1.01 * kGravity * step * kEnd / 2;
  expect_convergence(error, step, bound);
}

TEST(FreeFall, DoesNotDependOnTheMass) {
  const SimulationRun light(floating_body(0.1, kRound)), heavy(floating_body(100.0, kRound));
  EXPECT_NEAR(light.last("position.z", 0.5), heavy.last("position.z", 0.5), kRounding);
}

TEST(Projectile, FliesAParabola) {
  constexpr double kMass = 2.0, kEnd = 0.8;
  const Eigen::Vector3d velocity(3.0, -1.0, 4.0);
  const Eigen::Vector3d gravity(0.0, 0.0, -kGravity);
  const Eigen::Vector3d landing = velocity * kEnd + 0.5 * gravity * kEnd * kEnd;
  const Kick kick;
  const auto error = [&](double step) {
    SimulationRun throw_run(floating_body(kMass, kRound), step);
    throw_run.engine.engine = "ode";  // a step's force moves it for the whole of that step
    const Eigen::Vector3d impulse = kMass * velocity;
    throw_run.place(kick, ElementKind::body, {0}, {impulse.x(), impulse.y(), impulse.z(), 0, 0, 0});
    const TimeSeries readings = throw_run.run({0.0, kEnd}).readings;
    EXPECT_NEAR((last_vector(readings, "velocity") - velocity - gravity * kEnd).norm(), 0.0, kRounding);
    const Eigen::Vector3d difference = last_vector(readings, "position") - landing;
    EXPECT_NEAR(difference.x(), 0.0, kRounding);
    EXPECT_NEAR(difference.y(), 0.0, kRounding);
    return difference.z();
  };
  const double step = 1e-3;
  expect_convergence(error, step, 1.01 * kGravity * step * kEnd / 2);
}

/// A top that spins without torque: its axis goes round the fixed angular momentum at |L|/I⊥.
struct Top {
  double across = 0.4, along = 0.25;  ///< moments of inertia, kg·m²
  Eigen::Vector3d spin{1.5, 0.0, 6.0};
  Eigen::Vector3d momentum() const { return {across * spin.x(), across * spin.y(), along * spin.z()}; }

  Eigen::AngleAxisd precession(double time) const {
    return {momentum().norm() / across * time, momentum().normalized()};
  }
  Eigen::Quaterniond orientation(double time) const {
    const double own_rate = spin.z() * (across - along) / across;
    return Eigen::Quaterniond(precession(time)) *
           Eigen::Quaterniond(Eigen::AngleAxisd(own_rate * time, Eigen::Vector3d::UnitZ()));
  }
};

SimulationRun spinning(const Top& top, const Kick& kick, double step) {
  RobotSpec robot = floating_body(1.0, {.xx = top.across, .yy = top.across, .zz = top.along});
  robot.gravity.setZero();
  SimulationRun run(robot, step);
  const Eigen::Vector3d l = top.momentum();
  run.place(kick, ElementKind::body, {0}, {0, 0, 0, l.x(), l.y(), l.z()});
  return run;
}

Eigen::Quaterniond orientation_at_end(const TimeSeries& readings) {
  const auto value = [&](const char* part) { return column(readings, std::string("orientation.") + part)(1); };
  return {value("w"), value("x"), value("y"), value("z")};
}

TEST(TorqueFreeTop, PrecessesAboutItsAngularMomentum) {
  constexpr double kEnd = 1.0;
  const Top top;
  const Kick kick;
  const auto error = [&](double step) {
    const TimeSeries readings = spinning(top, kick, step).run({0.0, kEnd}).readings;
    return orientation_at_end(readings).angularDistance(top.orientation(kEnd));
  };
  constexpr double kOrientationError = 0.02;  // rad at a millisecond, after a turn
  expect_convergence(error, 1e-3, kOrientationError);
}

TEST(TorqueFreeTop, AngularVelocityGoesRoundInTheWorldFrame) {
  constexpr double kEnd = 0.7;
  const Top top;
  const Kick kick;
  const auto error = [&](double step) {
    const TimeSeries readings = spinning(top, kick, step).run({0.0, kEnd}).readings;
    return (last_vector(readings, "spin") - top.precession(kEnd) * top.spin).norm();
  };
  constexpr double kSpinError = 0.05;  // rad/s of 6.2
  expect_convergence(error, 1e-3, kSpinError);
}

}  // namespace
}  // namespace lacuna::free_motion_test
