#include "fitting/fit.h"
#include "fitting/numerics/seeded_noise.h"
#include "support/robots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace lacuna::glider_test {
namespace {

constexpr double kMass = 0.3;        // kg
constexpr double kPeriod = 2.5;      // s
constexpr double kDamping = 0.0137;  // N·s/m: the amplitude falls by 6 % a period
constexpr double kNoise = 2e-4;      // m
constexpr double kInterval = 0.05;   // s: 50 readings a period

const double kStiffness = kMass * std::pow(2.0 * M_PI / kPeriod, 2);

/// A glider on an air track between two springs, let go `amplitude` m from where they are slack, for a minute: the
/// solution of its equation of motion, read with noise.
Trial let_go(double amplitude, std::uint64_t seed) {
  const double decay = 0.5 * kDamping / kMass, rate = std::sqrt(kStiffness / kMass - decay * decay);
  Trial trial;
  trial.name = "glider";
  trial.measured.channels = {{"position", "m"}};
  trial.measured.times = Eigen::VectorXd::LinSpaced(1201, 0.0, 60.0);
  trial.measured.samples.resize(1201, 1);
  trial.sensor_noise = {kNoise};
  trial.commands.series.channels = {};
  SeededNoise random(seed, 0);
  for (Eigen::Index i = 0; i < 1201; ++i) {
    const double t = trial.measured.times(i), phase = rate * t;
    trial.measured.samples(i, 0) =
        amplitude * std::exp(-decay * t) * (std::cos(phase) + decay / rate * std::sin(phase)) +
        kNoise * random.normal();
  }
  return trial;
}

FittedValue fitted_damping(const std::string& engine, int substeps) {
  ModelDefinition definition;
  RobotSpec& robot = definition.structure.robot;
  robot = one_joint(JointKind::slider, kMass);
  robot.sensors = {make_sensor("position", SensorKind::joint_position, "joint")};
  robot.actuators.clear();
  robot.joints[0].stiffness = kStiffness;
  definition.engine = {.engine = engine, .step = kInterval, .substeps = substeps};
  definition.free = {{{"joint.joint.stiffness", "N/m", 1.0, 4.0, 1.9, Scale::linear}, ""},
                     {{"joint.joint.damping", "N*s/m", 0.0, 1.0, 0.01, Scale::linear}, ""}};
  for (const FreeValue& value : definition.free)
    definition.structure.parameters.push_back({value.address, value.lower, value.upper});
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::vector<Trial> trials = {let_go(0.2, 1), let_go(0.12, 2)};
  FitSection options;
  options.starts = 1;
  return fit({definition, *model, trials, options, 1, {2}}).values[1];
}

TEST(Glider, ShowsItsDampingAtFiftyStepsAPeriod) {
  const FittedValue value = fitted_damping("articulated", 1);
  EXPECT_NEAR(value.value, kDamping, 0.01 * kDamping);
  RecordProperty("damping", std::to_string(value.value));
}

/// Its implicit spring damps by stiffness × step.
TEST(Glider, HidesItsDampingAtAThousandStepsAPeriodOfFirstOrder) {
  EXPECT_LT(fitted_damping("ode", 20).value, 0.8 * kDamping);
}

}  // namespace
}  // namespace lacuna::glider_test
